// The module answers as the program does: outcomes, signatures and groups exactly, volumes to 1e-12.
//
//   node same_answers.mjs PACKAGE PROGRAM FOLDER [EVERY]
//
// PACKAGE: build/wasm/tripus. FOLDER: with triangulations-2.txt, -3, -4 and -cusped. Every EVERY-th of the
// lists of 4 tetrahedra (default: 1, all). Exit status 77: there is no module, which ctest calls skipped.
import {execFileSync} from 'node:child_process';
import {existsSync, readFileSync, rmSync, writeFileSync, mkdtempSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [place, program, folder, every = '1'] = process.argv.slice(2);
if (!existsSync(join(place, 'index.js'))) {
  console.log(`skipped: there is no module in ${place}; scripts/module builds it`);
  process.exit(77);
}
const {Manifold, TripusError, load} = await import(pathToFileURL(resolve(place, 'index.js')));
const tripus = await load();
const scratch = mkdtempSync(join(tmpdir(), 'tripus-'));
let problems = 0;
const complain = (text) => {
  if (++problems <= 20) console.error(text);
};
const expect = (holds, text) => holds || complain(text);

/** Fields that are equal, and numbers that are nearly so. */
const kSame = ['input', 'isosig', 'oriented_isosig', 'outcome', 'advice', 'H1', 'edge_valences', 'signature', 'oriented_signature',
               'decomposition', 'isometry_group', 'census', 'message', 'kind', 'cover', 'degree', 'regular',
               'deck_group_order', 'gluings', 'flat_tetrahedra'];
/** Of up to ten tetrahedra; beyond, for each ten. */
const kVolume = 1e-12;

/** As it reads with twelve digits of each long number: messages name volumes. */
const rounded = (value) => typeof value === 'string' ? value.replace(/\d+\.\d{11,}/g, (digits) => Number(digits).toPrecision(12)) : value;

function parse(text) {
  return text.split('\n').filter((line) => line !== '').map((line) => JSON.parse(line));
}

/** A verb that takes no list, asked about each line. */
function compareEach(verb, lines, flags) {
  for (const line of lines) {
    const args = [verb, line, '--json', ...flags];
    check(verb, parse(tripus.run(args).stdout), parse(execFileSync(program, args, {maxBuffer: 1e9}).toString()), line);
  }
  console.log(`${verb} ${flags.join(' ')}: of ${lines.length}`);
}

function compare(verb, lines, flags = []) {
  const text = `${lines.join('\n')}\n`;
  const list = join(scratch, 'list.txt');
  writeFileSync(list, text);
  const args = [verb, '--json', '--quiet', ...flags, '--batch'];
  const begin = performance.now();
  const run = tripus.run([...args, 'list.txt'], {files: {'list.txt': text}});
  const seconds = (performance.now() - begin) / 1000;
  const mine = parse(run.stdout);
  const theirs = parse(execFileSync(program, [...args, list], {maxBuffer: 1e9}).toString());
  expect(theirs.length === lines.length, `${verb}: ${lines.length} lines, ${theirs.length} answers of the program`);
  check(verb, mine, theirs, 'a list');
  console.log(`${verb}: ${theirs.length} answers, ${seconds.toFixed(1)} s`);
}

function check(verb, mine, theirs, what) {
  expect(mine.length === theirs.length, `${verb} ${what}: ${mine.length} answers of the module, ${theirs.length} of the program`);
  theirs.forEach((theirs, i) => {
    const found = mine[i] ?? {};
    for (const key of kSame)
      expect(JSON.stringify(rounded(found[key])) === JSON.stringify(rounded(theirs[key])),
             `${verb} ${theirs.input}: ${key}: ${JSON.stringify(found[key])}, the program ${JSON.stringify(theirs[key])}`);
    // One of several certificates may be found.
    expect(found.certificate?.kind === theirs.certificate?.kind, `${verb} ${theirs.input}: certificate ${found.certificate?.kind}`);
    const bothNumbers = typeof found.volume === 'number' && typeof theirs.volume === 'number';
    const isMetric = theirs.outcome === 'geometric' || theirs.outcome === 'degenerate';
    const accuracy = kVolume * Math.max(1, theirs.tetrahedron_count / 10 || 0);
    expect(bothNumbers ? !isMetric || Math.abs(found.volume - theirs.volume) <= accuracy : found.volume === theirs.volume,
           `${verb} ${theirs.input}: volume ${found.volume}, the program ${theirs.volume}`);
    expect(found.error?.message === theirs.error?.message,
           `${verb} ${theirs.input}: ${found.error?.message}, the program ${theirs.error?.message}`);
  });
}

const linesOf = (name) => readFileSync(join(folder, name), 'utf8').split('\n')
  .filter((line) => line !== '' && !line.startsWith('#'));
const thinned = (lines, step) => lines.filter((_, i) => i % step === 0);
const step = Number(every);
const four = thinned(linesOf('triangulations-4.txt'), step);
for (const list of [linesOf('triangulations-2.txt'), linesOf('triangulations-3.txt'), four, linesOf('triangulations-cusped.txt')]) {
  compare('solve', list);
  compare('canonize', list, ['--budget', '20']);
}
compare('info', four);
compare('identify', thinned(four, 5), ['--budget', '20']);
const cusped = linesOf('triangulations-cusped.txt'), five = thinned(linesOf('triangulations-5-sample.txt'), step);
compare('solve', five);
compare('identify', thinned(five, 5), ['--budget', '20']);
compare('identify', thinned(cusped, 3), ['--budget', '20']);
const few = [...thinned(linesOf('triangulations-3.txt'), 40), ...thinned(four, 40), ...thinned(cusped, 20)];
compareEach('cover', few, ['--degree', '2']);
compareEach('cover', few.slice(0, 5), ['--cyclic', '3']);
compareEach('simplify', few, ['--seed', '1']);

// Larger ones: metrics with and without cusps, flat minimisers, none.
const coverOf = (input, degree) => parse(execFileSync(program, ['cover', input, '--cyclic', String(degree), '--limit', '1', '--json'], {maxBuffer: 1e9}).toString())[0].isosig;
compare('solve', [coverOf('cPcbbbihq', 100), coverOf('cPcbbbiht', 60), coverOf('cPcbbbiht', 250), coverOf('eLAkbccdddprdk', 20)]);
// Where the exact decision is left out, that is said, and is no error.
const beyond = parse(tripus.run(['solve', coverOf('eLAkbccdddprdk', 80), '--json']).stdout)[0];
expect(['degenerate', 'unresolved'].includes(beyond.outcome) && beyond.message.includes('up to 300 tetrahedra only'), `320 tetrahedra: ${JSON.stringify(beyond).slice(0, 300)}`);

// The front door.
const M = await Manifold.from('cPcbbbihq');
expect(Math.abs(M.volume() - 6.451990270835033) < 1e-12, `volume ${M.volume()}`);
expect(M.isometrySignature() === 'cPcbbbihq' && M.homology() === '2 Z', 'signature or homology');
expect(M.identify()?.name === 't2g2.8', 'identify');
expect(M.covers(2).every((cover) => Math.abs(cover.volume() - 2 * M.volume()) < 1e-10), 'covers');
expect(M.isIsometricTo(await Manifold.from('cPcbbbdhq')) === false, 'compare');
expect(M.pageData({cells: 3}).face_pairings.length === 2, 'page data');
expect(M.embedding({cells: 3}).tetrahedra.length === 2, 'embedding');
expect(M.orthospectrum({length: 3}).arcs.length === 2, 'orthospectrum');
const sum = (await Manifold.from('dLQbcbcmebs')).verdict();
expect(sum === 'infeasible', `dLQbcbcmebs: ${sum}`);
try {
  await Manifold.from('hello');
  complain('"hello" is a manifold');
} catch (error) {
  expect(error instanceof TripusError && error.kind === 'invalid-input', `hello: ${error.kind} ${error.message}`);
}
// What is no input is refused, and never by an error of JavaScript itself.
const gzip = new Uint8Array([0x1f, 0x8b, 2, 255]);
for (const [input, kind] of [[undefined, 'usage'], [null, 'usage'], [5, 'usage'], [{name: 'a'}, 'usage'],
                             [{name: '../a', content: 'x'}, 'usage'], ['--help', 'invalid-input'],
                             [{name: '--help', content: '?'}, 'invalid-input'], [{name: 'a', content: gzip}, 'invalid-input'],
                             [{name: 'a', content: 'garbage\nmore'}, 'invalid-input']]) {
  const said = await Manifold.from(input).then(() => null, (error) => error);
  expect(said instanceof TripusError && said.kind === kind, `${JSON.stringify(input)}: ${said?.kind} ${said?.message}`);
}
for (const [what, ask, kind] of [['compare with a text', () => M.compare('cPcbbbihq'), 'usage'], ['no cells', () => M.pageData({cells: 0}), 'invalid-input'],
                                 ['no sheets', () => M.covers(0), 'invalid-input'], ['no seed', () => M.retriangulated({seed: NaN}), 'usage']]) {
  try {
    ask();
    complain(`${what} is answered`);
  } catch (error) {
    expect(error instanceof TripusError && error.kind === kind, `${what}: ${error.kind} ${error.message}`);
  }
}
expect(M.covers(2).every((cover) => cover.name() === cover.triangulationIsosig()), 'names of covers');
expect((await Manifold.from({name: '-', content: 'cPcbbbihq'})).volume() === M.volume(), 'a file with the name "-"');
// A stop, and after it the module goes on.
let asked = 0;
const stopped = tripus.run(['orthospectrum', 'cPcbbbihq', '--length', '12', '--json'], {stop: () => ++asked > 2});
expect(asked > 2 && stopped.status === 1, `stop: asked ${asked} times, status ${stopped.status}`);
expect(tripus.run(['solve', 'cPcbbbihq', '--json']).status === 0, 'after a stop');

rmSync(scratch, {recursive: true});
if (problems > 0) {
  console.error(`${problems} differences`);
  process.exit(1);
}
