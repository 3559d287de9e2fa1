// Tripus for JavaScript: the program in WebAssembly, and the front door on its JSON. Types: index.d.ts.
import createModule from './module.js';

export class TripusError extends Error {
  constructor(kind, message) {
    super(message);
    this.name = 'TripusError';
    this.kind = kind;
  }
}

const usage = (message) => new TripusError('usage', message);

/** Whatever is given as options: an object, or nothing; what all methods take is checked. */
function optionsOf(options) {
  if (options === undefined || options === null) return {};
  if (typeof options !== 'object') throw usage(`options are an object, such as {timeLimit: 5}, not ${shown(options)}`);
  const {files, stdin, stop, progress} = options;
  for (const [name, callback] of Object.entries({stop, progress}))
    if (isGiven(callback) && typeof callback !== 'function') throw usage(`the option ${name} is a function, not ${shown(callback)}`);
  if (isGiven(stdin) && !isContent(stdin)) throw usage(`the option stdin is a text or a Uint8Array, not ${shown(stdin)}`);
  if (!isGiven(files)) return options;
  if (typeof files !== 'object') throw usage(`the option files is an object of names and contents, not ${shown(files)}`);
  for (const [name, content] of Object.entries(files)) {
    requireName(name);
    if (!isContent(content)) throw usage(`the content of the file ${shown(name)} is a text or a Uint8Array, not ${shown(content)}`);
  }
  return options;
}

function requireName(name) {
  if (name.includes('\0') || name.split('/').some((part) => part === '' || part === '..' || part === '.'))
    throw usage(`${shown(name)} is no name of a file here: give one without a path`);
}

function requireArguments(args) {
  if (!Array.isArray(args) || args.some((word) => typeof word !== 'string' || word.includes('\0')))
    throw usage(`arguments are a list of texts, such as ["solve", "cPcbbbihq"], without the character NUL, not ${shown(args)}`);
}

/** What was given, for a message of one line. */
function shown(value) {
  let text;
  try {
    text = typeof value === 'bigint' || typeof value === 'symbol' ? String(value) : JSON.stringify(value) ?? String(value);
  } catch {
    text = String(value);
  }
  return text.length > 60 ? `${text.slice(0, 60)}...` : text;
}

const isGiven = (value) => value !== undefined && value !== null;
const isContent = (content) => typeof content === 'string' || content instanceof Uint8Array;

const kWork = '/work';
const encoder = new TextEncoder();
const decoder = new TextDecoder();

const bytesOf = (content) => (typeof content === 'string' ? encoder.encode(content) : content);
const isGzip = (bytes) => bytes.length > 2 && bytes[0] === 0x1f && bytes[1] === 0x8b;

/** What a file holds that may be compressed by gzip. */
export async function unpacked(content) {
  if (!isContent(content)) throw usage(`a content is a text or a Uint8Array, not ${shown(content)}`);
  const bytes = bytesOf(content);
  if (!isGzip(bytes)) return bytes;
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  try {
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch (error) {
    throw new TripusError('invalid-input', `the content begins as what gzip compressed, and is damaged: ${error.message}`);
  }
}

/** The program: one run after the other, in a folder of files in memory that is empty before each. */
class Program {
  #compiled;
  #module = null;

  constructor(compiled) {
    this.#compiled = compiled;
  }

  /** Makes an instance without waiting: the first, and another where one has failed. */
  #start() {
    const module = {
      instantiateWasm: (imports, receive) => {
        const instance = new WebAssembly.Instance(this.#compiled, imports);
        receive(instance);
        return instance.exports;
      },
      print() {},
      printErr() {},
      stdin: () => (module.tripusInput ? module.tripusInput() : null),
    };
    createModule(module)?.catch?.(() => {});  // what fails is seen in the next line
    if (!module._tripus_run) throw new TripusError('internal', 'the module does not start');
    module.FS.mkdir(kWork);
    module.FS.chdir(kWork);
    return module;
  }

  get #running() {
    this.#module ??= this.#start();
    return this.#module;
  }

  #text(address, size) {
    return decoder.decode(this.#module.HEAPU8.slice(address, address + size));
  }

  get version() {
    const module = this.#running;
    const start = module._tripus_version();
    return this.#text(start, module.HEAPU8.indexOf(0, start) - start);
  }

  #clear(folder) {
    const {FS} = this.#module;
    for (const name of FS.readdir(folder)) {
      if (name === '.' || name === '..') continue;
      const path = `${folder}/${name}`;
      if (FS.isDir(FS.stat(path).mode)) {
        this.#clear(path);
        FS.rmdir(path);
      } else {
        FS.unlink(path);
      }
    }
  }

  /** The files below a folder that were not given, by their names. */
  #written(given, folder = kWork, found = {}) {
    const {FS} = this.#module;
    for (const name of FS.readdir(folder)) {
      if (name === '.' || name === '..') continue;
      const path = `${folder}/${name}`;
      const short = path.slice(kWork.length + 1);
      if (FS.isDir(FS.stat(path).mode)) this.#written(given, path, found);
      else if (!(short in given)) found[short] = FS.readFile(path);
    }
    return found;
  }

  #give(files) {
    const {FS} = this.#module;
    for (const [name, content] of Object.entries(files)) {
      const parts = name.split('/');
      for (let i = 1; i < parts.length; ++i) {
        const folder = `${kWork}/${parts.slice(0, i).join('/')}`;
        if (!FS.analyzePath(folder).exists) FS.mkdir(folder);
      }
      FS.writeFile(`${kWork}/${name}`, bytesOf(content));
    }
  }

  run(args, asked) {
    const options = optionsOf(asked);
    requireArguments(args);
    const given = options.files ?? {};
    const module = this.#running;
    this.#clear(kWork);
    this.#give(given);
    const words = options.timeLimit === undefined ? args : [...args, '--time-limit', String(options.timeLimit)];
    const input = bytesOf(options.stdin ?? '');
    let at = 0;
    module.tripusInput = () => (at < input.length ? input[at++] : null);
    // What these throw ends the work, and is thrown when it has ended: nothing of C++ lies between.
    const thrown = [];
    const guarded = (callback) => (...values) => {
      try {
        return thrown.length > 0 || callback(...values);
      } catch (error) {
        thrown.push(error);
        return true;
      }
    };
    module.tripusStop = guarded(options.stop ?? (() => false));
    module.tripusProgress = options.progress
      ? guarded((address, size, tetrahedra) => options.progress(this.#text(address, size), tetrahedra))
      : null;
    const bytes = encoder.encode(words.map((word) => `${word}\0`).join(''));
    try {
      const address = module._malloc(bytes.length || 1);
      if (address === 0) throw new RangeError('out of memory');
      module.HEAPU8.set(bytes, address);
      const status = module._tripus_run(address, bytes.length);
      const result = {
        status,
        stdout: this.#text(module._tripus_output(), module._tripus_output_size()),
        stderr: this.#text(module._tripus_messages(), module._tripus_messages_size()),
        files: this.#written(given),
      };
      module._free(address);
      if (thrown.length === 0) return result;
    } catch (error) {
      this.#module = null;  // the next run begins with an empty memory
      if (!(error instanceof RangeError || error instanceof WebAssembly.RuntimeError ||
            error instanceof WebAssembly.Exception)) throw error;
      return failure(words, error);
    }
    throw thrown[0];
  }
}

/** What the program answers where it could not end by itself. */
function failure(words, error) {
  const isMemory = error instanceof RangeError || /memory|stack/i.test(error.message ?? '');
  const kind = isMemory ? 'out-of-memory' : 'internal';
  const message = isMemory ? 'not enough memory for this here; the program itself has more'
                           : `the module failed: ${error.message ?? error}`;
  const answer = {tripus: '', input: '', error: {kind, message}};
  return {status: 3, stdout: words.includes('--json') ? `${JSON.stringify(answer)}\n` : '',
          stderr: `tripus: ${message}\n`, files: {}};
}

/** The name of the file that a text becomes. */
const kText = 'input';

function checked(input) {
  if (typeof input !== 'string' && !(typeof input?.name === 'string' && isContent(input.content)))
    throw usage('an input is a text, or {name, content} of a file, the content as text or as a Uint8Array');
  if (typeof input !== 'string') requireName(input.name);
  return input;
}

/** The argument that an Input is, and the file that it needs. */
function argument(input, number) {
  if (typeof input !== 'string') {
    // What begins with a hyphen would be an option.
    const word = `${input.name.startsWith('-') ? './' : ''}${input.name}`;
    return [input.label === undefined ? word : `${word}#${input.label}`, {[input.name]: input.content}];
  }
  // Only a diagram may have several lines in an argument; what else has them is a file's content, and
  // so is what no command line can hold.
  if (!/^\s*[{[%<]|[\n\r\0]|^\s*-./.test(input)) return [input, {}];
  const name = number === 0 ? kText : `${kText}-${number + 1}`;
  return [name, {[name]: input}];
}

class Module {
  #program;

  constructor(compiled) {
    this.#program = new Program(compiled);
    this.version = this.#program.version;
  }

  run(args, options) {
    return this.#program.run(args, options);
  }

  words(inputs) {
    const named = [inputs].flat().map((input, number) => argument(checked(input), number));
    return {words: named.map(([word]) => word), files: Object.assign({}, ...named.map(([, files]) => files))};
  }

  ask(verb, inputs, flags, asked) {
    const options = optionsOf(asked);
    if (!Array.isArray(flags ?? [])) throw usage(`flags are a list of texts, such as ["--degree", "2"], not ${shown(flags)}`);
    const {words, files} = this.words(inputs);
    const {status, stdout, stderr} =
      this.run([verb, ...words, ...(flags ?? []), '--json'], {...options, files: {...options.files, ...files}});
    const answers = stdout.split('\n').filter((line) => line !== '').map((line) => {
      try {
        return JSON.parse(line);
      } catch {
        throw usage(`the verb ${shown(verb)} does not answer in JSON: ask run() for it`);
      }
    });
    const failed = answers.find((answer) => answer.error);
    if (failed) throw new TripusError(failed.error.kind, failed.error.message);
    if (status > 1 || answers.length === 0) throw new TripusError(status === 3 ? 'internal' : 'usage', stderr.replace(/^tripus: /, '').trim());
    return answers;
  }

  manifold(input, options) {
    const manifold = new Manifold(this, input);
    manifold.info(options);
    return manifold;
  }
}

let source = null;
let ready = null;

/** Where the bytes of the module come from if nobody gives them. */
export function setSource(bytes) {
  source = bytes;
}

async function compile(bytes) {
  if (bytes instanceof WebAssembly.Module) return bytes;
  try {
    return await WebAssembly.compile(await unpacked(bytes instanceof ArrayBuffer ? new Uint8Array(bytes) : bytes));
  } catch (error) {
    throw usage(`load(bytes): these are not the bytes of the module: ${error.message}`);
  }
}

let own = null;
export function compiled() {
  if (!source) throw usage('load(bytes): the bytes of the module are not at hand');
  own ??= source().then(compile);
  return own;
}

export async function load(bytes) {
  if (bytes !== undefined) return new Module(await compile(bytes));
  ready ??= compiled().then((module) => new Module(module));
  return ready;
}

/** A compact 3-manifold with a triangulation. A value: nothing is computed before it is first asked for,
 *  and then once. */
export class Manifold {
  #tripus;
  #input;
  #known = new Map();

  constructor(tripus, input) {
    if (!(tripus instanceof Module)) throw usage('a manifold is made by Manifold.from(input)');
    this.#tripus = tripus;
    this.#input = input;
  }

  static async from(input, options) {
    const given = typeof checked(input) === 'string' ? input : {...input, content: await unpacked(input.content)};
    return (await load()).manifold(given, options);
  }

  /** The first answer of a verb; kept unless a stop or a time limit may have cut it short. */
  #ask(verb, flags = [], asked = undefined) {
    const options = optionsOf(asked);
    const key = [verb, ...flags].join('\0');
    if (this.#known.has(key)) return this.#known.get(key);
    const [answer] = this.#tripus.ask(verb, this.#input, flags, options);
    if (!options.stop && options.timeLimit === undefined) this.#known.set(key, answer);
    return answer;
  }

  #metric() {
    const answer = this.solve();
    if (answer.outcome !== 'geometric') throw new TripusError('no-metric', answer.message);
    return answer;
  }

  /** The manifold of the gluing table or the signature in an answer. */
  #other(answer) {
    return this.#tripus.manifold(
      answer.gluings ? JSON.stringify({name: answer.name ?? '', gluings: answer.gluings}) : answer.isosig);
  }

  get input() { return this.#input; }
  toString() { return this.name(); }
  name() {
    const {name, input, isosig} = this.info();
    return name || (input === kText && isosig) || input;
  }
  info(options) { return this.#ask('info', [], options); }
  numTetrahedra() { return this.info().tetrahedron_count; }
  numEdges() { return this.info().edge_count; }
  numVertices() { return this.info().vertex_count; }
  numCusps() { return this.links().filter((link) => link.kind === 'cusp').length; }
  numBoundaryComponents() { return this.links().filter((link) => link.kind === 'geodesic').length; }
  isOrientable() { return this.info().orientable; }
  isConnected() { return this.info().component_count <= 1; }
  links() {
    return this.info().vertices.map((vertex) => ({
      kind: vertex.kind,
      eulerCharacteristic: vertex.link_euler_characteristic,
      orientable: vertex.link_orientable,
      triangles: vertex.triangle_count,
    }));
  }
  get valences() { return this.info().edge_valences; }
  get edgeClasses() { return this.info().edge_classes; }
  triangulationIsosig(options) {
    const {oriented = false} = optionsOf(options);
    const found = this.info()[oriented ? 'oriented_isosig' : 'isosig'];
    if (found === null) throw new TripusError('undecided', 'this triangulation has no such signature');
    return found;
  }
  homology() { return this.info().H1; }

  solve(options) { return this.#ask('solve', [], options); }
  verdict() { return this.solve().outcome; }
  volume() { return this.#metric().volume; }
  get lengths() { return this.#metric().edge_lengths; }
  get dihedralAngles() { return this.#metric().dihedral_angles; }
  toJSON() { return this.solve(); }

  simplified(asked) {
    const {seed, effort, ...options} = optionsOf(asked);
    const flags = [...(seed === undefined ? [] : ['--seed', String(seed)]),
                   ...(effort === undefined ? [] : ['--effort', String(effort)])];
    return this.#other(this.#ask('simplify', flags, options));
  }
  retriangulated(asked) {
    const {seed, budget, ...options} = optionsOf(asked);
    const flags = ['--retriangulate', ...(seed === undefined ? [] : ['--seed', String(seed)]),
                   ...(budget === undefined ? [] : ['--budget', String(budget)])];
    const answer = this.#ask('solve', flags, options);
    if (answer.outcome !== 'geometric') throw new TripusError('no-metric', answer.message);
    return this.#other(answer);
  }
  covers(degree, asked) {
    const {cyclic = false, distinct = false, limit, ...options} = optionsOf(asked);
    const flags = [cyclic ? '--cyclic' : '--degree', String(degree), ...(distinct ? ['--distinct'] : []),
                   ...(limit === undefined ? [] : ['--limit', String(limit)])];
    return this.#tripus.ask('cover', this.#input, flags, options)
      .filter((answer) => answer.gluings).map((answer) => this.#other(answer));
  }

  canonical(options) { return this.#ask('canonize', [], options); }
  isometrySignature() { return this.#canonicalPart('signature'); }
  symmetryGroup() { return this.#canonicalPart('isometry_group'); }
  #canonicalPart(name) {
    const answer = this.canonical();
    if (answer[name] === undefined || answer[name] === null) throw new TripusError('undecided', answer.message);
    return answer[name];
  }
  compare(other, options) {
    if (!(other instanceof Manifold)) throw usage('compare(other): other is a Manifold');
    return this.#tripus.ask('compare', [this.#input, other.#input], [], options)[0];
  }
  isIsometricTo(other) {
    const {verdict} = this.compare(other);
    return verdict === 'same' ? true : verdict === 'different' ? false : undefined;
  }
  identify(options) { return this.#ask('identify', [], options).census ?? null; }
  orthospectrum(asked) {
    const {length, words = false, ...options} = optionsOf(asked);
    return this.#withMetric(this.#ask('orthospectrum', [...(length === undefined ? [] : ['--length', String(length)]),
                                                        ...(words ? ['--words'] : [])], options), 'arcs');
  }
  /** An answer that has a part only where there is a metric. */
  #withMetric(answer, part) {
    if (!answer[part]) throw new TripusError('no-metric', answer.message);
    return answer;
  }

  embedding(asked) {
    const {cells, ...options} = optionsOf(asked);
    return this.#withMetric(this.#ask('embed', cells === undefined ? [] : ['--cells', String(cells)], options), 'tetrahedra');
  }
  pageData(asked) {
    const {cells, model, discs, ...options} = optionsOf(asked);
    const flags = [...(cells === undefined ? [] : ['--cells', String(cells)]),
                   ...(model === undefined ? [] : ['--model', String(model)]),
                   ...(discs === true ? ['--discs'] : []),
                   ...(typeof discs === 'number' ? ['--disc-length', String(discs)] : [])];
    return this.#withMetric(this.#ask('page-data', flags, options), 'face_pairings');
  }
}
