// Makes the page from its parts: one file, that needs nothing else.
//
//   node build.mjs --module FOLDER --output FILE.html [--version X]
//
// FOLDER holds what emscripten made: tripus-module.js and tripus-module.wasm.
import * as esbuild from 'esbuild';
import {readFileSync, writeFileSync, mkdirSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {parseArgs} from 'node:util';
import {gzipSync, constants} from 'node:zlib';

const here = dirname(fileURLToPath(import.meta.url));
const viewer = join(here, '..', 'viewer', 'web');

const {values: options} = parseArgs({options: {
  module: {type: 'string'}, output: {type: 'string'}, version: {type: 'string', default: ''}}});
if (!options.module || !options.output) {
  console.error('usage: node build.mjs --module FOLDER --output FILE.html [--version X]');
  process.exit(2);
}

const text = (...path) => readFileSync(join(...path), 'utf8');
const viewerList = (name) => {
  const found = text(viewer, 'web_assets.cmake').match(new RegExp(`set\\(TRIPUS_WEB_${name}\\s([^)]*)\\)`));
  if (!found) throw new Error(`web_assets.cmake has no list ${name}`);
  return found[1].trim().split(/\s+/);
};

/** The scripts of the viewer are not modules: those of its own pages are one after the other. */
const viewerPlugin = {
  name: 'viewer',
  setup(build) {
    build.onResolve({filter: /^viewer$/}, () => ({path: 'viewer', namespace: 'viewer'}));
    build.onLoad({filter: /.*/, namespace: 'viewer'}, () => {
      const names = viewerList('SCRIPTS').filter((name) => !['dump.js', 'start.js'].includes(name));
      return {contents: names.map((name) => text(viewer, name)).join('\n') + '\nexport {Page, fold, kContextOptions, shown};\n',
              loader: 'js'};
    });
  },
};

/** The front door of the package, on the module that was built. */
const modulePlugin = {
  name: 'module',
  setup(build) {
    build.onResolve({filter: /^tripus$/}, () => ({path: join(here, 'tripus', 'tripus.js'), sideEffects: false}));
    build.onResolve({filter: /^\.\/module\.js$/}, () => ({path: resolve(options.module, 'tripus-module.js'), sideEffects: false}));
  },
};

async function bundle(entry) {
  const {outputFiles} = await esbuild.build({
    entryPoints: [join(here, 'page', entry)], bundle: true, write: false, format: 'iife', target: 'es2022',
    minify: true, legalComments: 'none', charset: 'utf8', plugins: [viewerPlugin, modulePlugin], logLevel: 'warning',
  });
  return outputFiles[0].text;
}

const minified = async (source, loader) => (await esbuild.transform(source, {loader, minify: true, charset: 'utf8'})).code;
/** A script that may stand in a script element. */
const inScript = (source) => source.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');

const shaders = viewerList('SHADERS').map((path) => {
  const name = path.split('/').at(-1);
  return `<script type="x-shader/glsl" id="shader-${name}">${text(viewer, path)}</script>`;
}).join('\n');

const mark = text(here, 'page', 'mark.svg').trim();
const picture = (name) => `data:image/webp;base64,${readFileSync(join(here, 'page', name)).toString('base64')}`;
const styles = text(viewer, 'theme.css') + text(viewer, 'view.css') + text(viewer, 'cards.css') + text(here, 'page', 'page.css');
/** What no script of the page may pass by: it may ask for nothing and send nothing. */
const policy = "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; worker-src blob:; style-src 'unsafe-inline'; "
    + "img-src data: blob:; base-uri 'none'; form-action 'none'";
const filled = (template, values) => template.replaceAll(/\{\{([\w-]+)\}\}/g, (_, key) => {
  if (!(key in values)) throw new Error(`a template asks for ${key}`);
  return values[key];
});
const values = {
  version: options.version,
  icon: encodeURIComponent(mark),
  mark,
  hero: picture('hero.webp'),
  'hero-dark': picture('hero-dark.webp'),
  head: filled(text(viewer, 'head.html'), {
    policy: `<meta http-equiv="Content-Security-Policy" content="${policy}">`, version: options.version, title: 'Tripus',
    style: await minified(styles, 'css')}).trim(),
  stage: text(viewer, 'stage.html'),
  controls: text(viewer, 'controls.html'),
  help: text(viewer, 'help.html'),
  shaders,
  worker: inScript(await bundle('worker.ts')),
  script: inScript(await bundle('main.ts')),
  module: gzipSync(readFileSync(join(options.module, 'tripus-module.wasm')), {level: constants.Z_BEST_COMPRESSION}).toString('base64'),
};
const page = filled(text(here, 'page', 'page.html'), values);
mkdirSync(dirname(options.output), {recursive: true});
writeFileSync(options.output, page);
console.log(`${options.output}: ${(page.length / 1e6).toFixed(2)} MB, ${(values.module.length / 1e6).toFixed(2)} MB of it the module`);
