// The package as somebody finds it: packed, installed into an empty folder, used as its README says, and asked
// nonsense. Every error is a TripusError with the program's words; nothing is left unhandled.
//
//   node newcomer.mjs PACKAGE PROGRAM
//
// PACKAGE: build/wasm/tripus. Exit status 77: there is no module, which ctest calls skipped.
import {execFileSync, spawnSync} from 'node:child_process';
import {copyFileSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const [place, program] = process.argv.slice(2).map((path) => resolve(path));
if (!existsSync(join(place, 'index.js'))) {
  console.log(`skipped: there is no module in ${place}; scripts/module builds it`);
  process.exit(77);
}
let problems = 0;
const complain = (text) => {
  ++problems;
  console.error(text);
};
const expect = (holds, text) => holds || complain(text);
process.on('unhandledRejection', (error) => complain(`unhandled: ${error}`));
process.on('uncaughtException', (error) => complain(`uncaught: ${error}`));

const folder = mkdtempSync(join(tmpdir(), 'tripus-newcomer-'));
const run = (command, ...args) => execFileSync(command, args, {cwd: folder, encoding: 'utf8'});
const [packed] = JSON.parse(run('npm', 'pack', '--json', '--offline', '--pack-destination', folder, place));
expect(packed.files.length === 8, `the package has ${packed.files.map(({path}) => path)}`);
writeFileSync(join(folder, 'package.json'), '{"type": "module"}');
run('npm', 'install', '--silent', '--offline', '--no-audit', '--no-fund', join(folder, packed.filename));
const installed = join(folder, 'node_modules/tripus');

// The README's example, with the values that stand beside it.
const example = readFileSync(join(installed, 'README.md'), 'utf8').split('\n').filter((line) => line.startsWith('    '));
const wanted = example.filter((line) => line.includes('//')).map((line) => line.split('//')[1].trim());
expect(wanted.length === 3, 'the example of the README');
writeFileSync(join(folder, 'example.mjs'), example.map((line) => line.replace(/^ *(M\..*);.*/, 'console.log(JSON.stringify($1));')).join('\n'));
const said = run('node', 'example.mjs').trim().split('\n');
expect(said.join() === wanted.join(), `the README promises ${wanted}, and it is ${said}`);

// Types, as strict as they can be, for node and for browsers.
const compiler = join(here, '../../web/node_modules/.bin/tsc');
copyFileSync(join(here, 'uses_types.ts'), join(folder, 'uses_types.ts'));
if (existsSync(compiler)) {
  for (const choice of ['--module nodenext --lib es2022,dom', '--module esnext --moduleResolution bundler --lib es2022']) {
    const {status, stdout} = spawnSync(compiler, [...`--strict --noUncheckedIndexedAccess --noEmit --types  --target es2022 ${choice}`.split(' '), 'uses_types.ts'],
                                       {cwd: folder, encoding: 'utf8'});
    expect(status === 0, `tsc ${choice}: ${stdout}`);
  }
} else {
  console.log('types were not compiled: scripts/page installs the compiler');
}

// Nonsense.
const {Manifold, TripusError, compiled, load, unpacked} = await import(pathToFileURL(join(installed, 'index.js')));
const tripus = await load();
const M = await Manifold.from('cPcbbbihq');
const flat = await Manifold.from('eLAkbccdddprdk');

/** What a call throws has the kind; a kind of null: it answers. */
async function refuses(name, kind, call, words = '') {
  try {
    await call();
    expect(kind === null, `${name} is answered`);
  } catch (error) {
    expect(error instanceof TripusError && error.kind === kind && error.message.length > 10 && error.message.includes(words),
           `${name}: ${error.stack}`);
  }
}

/** The program's message about a text that a command line can hold. */
const programSays = (text) => spawnSync(program, ['info', text], {encoding: 'utf8'}).stderr.replace(/^tripus: /, '').trim();
for (const text of ['', ' ', 'xyz', 'cPcbbbihz', 'PD: V[1,2', '5_17', 't9g9.1', '@list', '../x', '\u{1F600}', 'cPcbbbihq<b>', 'x'.repeat(1e5)])
  await refuses(text.slice(0, 20), 'invalid-input', () => Manifold.from(text), programSays(text));
for (const text of ['\0', 'cPc\0bbbihq', '--help', '-', 'x'.repeat(1e7), '\ud800', '{"gluings": [[1]]}'])
  await refuses(JSON.stringify(text.slice(0, 20)), 'invalid-input', () => Manifold.from(text));
for (const input of [5, NaN, null, undefined, true, {}, [], ['cPcbbbihq'], () => 1, Symbol('x'), 5n, new Uint8Array(3), {name: 'a'}, {name: 'a', content: 5},
                     {name: 'a', content: new Float64Array(2)}, {name: '', content: 'x'}, {name: 'a\0b', content: 'x'}, {name: '/a', content: 'x'}])
  await refuses(String(input?.name ?? typeof input), 'usage', () => Manifold.from(input));
for (const content of ['', 'x'.repeat(1e7), new Uint8Array(0), new Uint8Array(1e7), new Uint8Array([0x1f, 0x8b, 1, 1])])
  await refuses(`a file of ${content.length}`, 'invalid-input', () => Manifold.from({name: 'a', content}));
for (const options of [5, 'x', true, {timeLimit: 'a'}, {timeLimit: -1}, {timeLimit: NaN}, {stop: 5}, {progress: 'x'}, {files: 5}, {files: {a: 5}}, {files: {'../a': 'x'}}, {stdin: 5}])
  for (const [name, call] of Object.entries({
    from: () => Manifold.from('cPcbbbihq', options), solve: () => M.solve(options), covers: () => M.covers(2, options), simplified: () => M.simplified(options),
    orthospectrum: () => M.orthospectrum(options), run: () => tripus.run(['info', 'cPcbbbihq'], options)})) {
    if (name === 'run' && options.timeLimit !== undefined) continue;  // run() returns what the program says
    await refuses(`${name} with ${JSON.stringify(options)}`, 'usage', call);
  }
await refuses('options of null', null, () => M.solve(null));
for (const args of [undefined, null, 5, 'solve', [5], [null], ['solve', 'cPcbbbihq\0--json']]) await refuses(`run ${args}`, 'usage', () => tripus.run(args));
for (const [verb, inputs, flags] of [[5, 'cPcbbbihq'], ['solve', null], ['solve', []], ['solve', 'cPcbbbihq', 5], ['solve', 'cPcbbbihq', ['--nope']], ['compare', 'cPcbbbihq'],
                                     ['', 'cPcbbbihq'], ['mesh', 'cPcbbbihq'], ['help', 'solve']])
  await refuses(`ask ${verb}`, 'usage', () => tripus.ask(verb, inputs, flags));
for (const [name, [kind, call]] of Object.entries({
  'covers of 0': ['invalid-input', () => M.covers(0)], 'covers of NaN': ['usage', () => M.covers(NaN)], 'covers of null': ['usage', () => M.covers(null)],
  'covers of 1e9': ['invalid-input', () => M.covers(1e9)], 'covers of 2.5': ['usage', () => M.covers(2.5)], 'covers up to x': ['usage', () => M.covers(2, {limit: 'x'})],
  'cells of 1e12': ['usage', () => M.pageData({cells: 1e12})], 'cells of x': ['usage', () => M.pageData({cells: 'x'})], 'a model': ['invalid-input', () => M.pageData({model: 'nope'})],
  'discs of -1': ['usage', () => M.pageData({discs: -1})], 'discs of NaN': ['usage', () => M.pageData({discs: NaN})], 'cells of -5': ['usage', () => M.embedding({cells: -5})],
  'length of x': ['usage', () => M.orthospectrum({length: 'x'})], 'length of 1e6': ['invalid-input', () => M.orthospectrum({length: 1e6})], 'seed of x': ['usage', () => M.simplified({seed: 'x'})],
  'a volume': ['no-metric', () => flat.volume()], 'lengths': ['no-metric', () => flat.lengths], 'a picture': ['no-metric', () => flat.pageData()], 'an embedding': ['no-metric', () => flat.embedding()],
  'arcs': ['no-metric', () => flat.orthospectrum()], 'null': ['usage', () => M.compare(null)], 'a number': ['usage', () => M.isIsometricTo(5)], 'new': ['usage', () => new Manifold()],
  'bytes of 5': ['usage', () => load(5)], 'bytes of null': ['usage', () => load(null)], 'no bytes': ['usage', () => load(new Uint8Array(8))], 'a content of 5': ['usage', () => unpacked(5)]}))
  await refuses(name, kind, call);

// What a callback throws is what the method throws.
const own = new Error('mine');
for (const name of ['stop', 'progress']) {
  try {
    tripus.run(['orthospectrum', 'cPcbbbihq', '--length', '12', '--json'], {[name]: () => { throw own; }});
    complain(`${name}: nothing was thrown`);
  } catch (error) {
    expect(error === own, `${name}: ${error.stack}`);
  }
}

// All the same, it goes on.
expect(M.volume() === (await load(await compiled())).manifold('cPcbbbihq').volume(), 'a second module');
await new Promise((done) => setTimeout(done, 50));  // rejections are told later
rmSync(folder, {recursive: true});
console.log(problems ? `${problems} problems` : 'a newcomer finds nothing broken');
process.exit(problems ? 1 : 0);
