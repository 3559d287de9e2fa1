// How fast the module for browsers and node is beside the program: processor time, one thread each.
//
//   node bench/module.mjs [PACKAGE] [PROGRAM]       default: build/wasm/tripus, build/release/bin/tripus
import {execFileSync, spawnSync} from 'node:child_process';
import {existsSync, readFileSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '..');
const place = resolve(process.argv[2] ?? join(root, 'build/wasm/tripus'));
const program = resolve(process.argv[3] ?? join(root, 'build/release/bin/tripus'));
for (const [file, script] of [[join(place, 'index.js'), 'scripts/module'], [program, 'scripts/build']]) {
  if (!existsSync(file)) {
    console.error(`module.mjs: there is no ${file}; ${script} makes it`);
    process.exit(2);
  }
}
const {load} = await import(pathToFileURL(join(place, 'index.js')));
const tripus = await load();
const kRounds = 5;

const seconds = ({user, system}) => ((user + system) / 1e6);
const times = (work, rounds = kRounds) => Array.from({length: rounds}, () => {
  const start = process.cpuUsage();
  work();
  return seconds(process.cpuUsage(start));
});
const shown = (list) => list.map((t) => t.toFixed(2)).join(' ');

/** Processor time of children, which node does not tell: by bash's own clock. `set`: the kernels, TRIPUS_SIMD. */
function timeOf(args, set) {
  const {stderr} = spawnSync('bash', ['-c', 'TIMEFORMAT="%U %S"; time "$@" > /dev/null', 'bash', program, ...args],
                             {env: {...process.env, TRIPUS_SIMD: set}});
  return String(stderr).trim().split('\n').pop().split(' ').map(Number).reduce((a, b) => a + b);
}

const path = join(root, 'data/triangulations-4.txt');
const list = readFileSync(path, 'utf8');
const words = ['solve', '--json', '--quiet', '--batch'];
const here = [];
const there = {portable: [], '': []};  // in turn, so that all meet the same machine
for (let round = 0; round < kRounds; ++round) {
  here.push(...times(() => tripus.run([...words, 'list'], {files: {list}}), 1));
  for (const [set, found] of Object.entries(there)) found.push(timeOf([...words, path, '--threads', '1'], set));
}
console.log(`solve, ${list.trim().split('\n').filter((line) => line[0] !== '#').length} lines: module ${shown(here)} s`);
for (const [set, found] of Object.entries(there))
  console.log(`  program, ${set || 'the fastest'} kernels: ${shown(found)} s, rate of the module beside it `
              + `(least times) ${(Math.min(...found) / Math.min(...here)).toFixed(2)}`);

const cover = JSON.parse(execFileSync(program, ['cover', 'cPcbbbihq', '--cyclic', '5000', '--limit', '1', '--json'],
                                      {maxBuffer: 1 << 28}).toString().split('\n')[0]).isosig;
console.log(`solve, 10,000 tetrahedra: module ${shown(times(() => tripus.run(['solve', cover, '--json'])))} s`);
