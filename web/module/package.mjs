// Puts the package for node and browsers together: what web/tripus has, and what the compiler made.
//
//   node package.mjs ROOT BUILD
import {copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {constants, gzipSync} from 'node:zlib';

const [root, build] = process.argv.slice(2);
const source = join(root, 'web', 'tripus');
const target = join(build, 'tripus');
const made = join(build, 'bin', 'tripus-module');

rmSync(target, {recursive: true, force: true});
mkdirSync(target, {recursive: true});
for (const name of ['index.js', 'index.d.ts', 'tripus.js', 'README.md'])
  copyFileSync(join(source, name), join(target, name));
copyFileSync(join(root, 'LICENSE'), join(target, 'LICENSE'));
copyFileSync(`${made}.wasm`, join(target, 'tripus.wasm'));

const version = readFileSync(join(root, 'CMakeLists.txt'), 'utf8').match(/project\(tripus VERSION (\S+)/)[1];
writeFileSync(join(target, 'package.json'),
              readFileSync(join(source, 'package.json'), 'utf8').replace('@TRIPUS_VERSION@', version));
writeFileSync(join(target, 'module.js'), `${readFileSync(`${made}.js`, 'utf8')}\nexport default createTripus;\n`);
const wasm = readFileSync(`${made}.wasm`);
const packed = gzipSync(wasm, {level: constants.Z_BEST_COMPRESSION}).toString('base64');
writeFileSync(join(target, 'wasm.js'), `export default '${packed}';\n`);
const million = (size) => `${(size / 1e6).toFixed(2)} MB`;
console.log(`${target}: the module has ${million(wasm.length)}, ${million(packed.length)} as text in the package`);
