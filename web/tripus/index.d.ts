/**
 * Tripus as a WebAssembly module: the front door of the library, for node (18 and newer) and browsers.
 *
 * Names are Python's (docs/python.md) in camelCase. Whatever is an object here is the object that the
 * program prints with --json: docs of the fields are the program's (docs/index.md).
 */

/** What a verb of the program answers with --json: the fields of its JSON object. */
export type Answer = Record<string, any>;

/** Whoever may end a computation, and is told how it goes. All are called or read while the module
 *  works, in the thread that it works in; what they throw ends the work and is thrown by the method. */
export interface RunOptions {
  /** Polled where the work looks at its clock, at most twenty times a second; true ends it with what is
   *  known by then. A thread that works receives no messages: let it look at a SharedArrayBuffer, or end
   *  the worker. */
  stop?: () => boolean;
  /** Seconds after which the work ends with what is known. */
  timeLimit?: number;
  /** What is going on, at most ten times a second; tetrahedra is 0 where that is not known. */
  progress?: (activity: string, tetrahedra: number) => void;
  /** Files that the arguments name. What is compressed by gzip has to be unpacked before: `unpacked`. */
  files?: Record<string, Uint8Array | string>;
  /** Standard input: what INPUT "-" reads. */
  stdin?: string;
}

export interface RunResult {
  /** Exit status of the program: 0 an answer, 1 a mathematical "no", unresolved or stopped,
   *  2 bad usage or bad input, 3 a failure of the program itself (out of memory). */
  status: number;
  /** Standard output: with --json one JSON object a line. */
  stdout: string;
  /** Standard error: messages for people. */
  stderr: string;
  /** Files that the run wrote (-o FILE). */
  files: Record<string, Uint8Array>;
}

/** The module, compiled and ready. `load()` makes one; it works synchronously. */
export interface Tripus {
  readonly version: string;
  /** Runs the program: run(["solve", "cPcbbbihq", "--json"]). Never throws for what the program
   *  answers, errors included. */
  run(args: readonly string[], options?: RunOptions): RunResult;
  /** What names inputs in the arguments of run(), and the files that it needs. */
  words(inputs: Input | readonly Input[]): { words: string[]; files: Record<string, Uint8Array | string> };
  /** The JSON objects that VERB answers about an input, or about the two of "compare", one a line of its output;
   *  the verbs are those of the program. Throws TripusError for an object that holds an "error". */
  ask(verb: string, inputs: Input | readonly Input[], flags?: readonly string[], options?: RunOptions): Answer[];
  /** A manifold from whatever INPUT the program takes. Throws TripusError. */
  manifold(input: Input, options?: RunOptions): Manifold;
}

// Where the lists of types of the reader's tsconfig.json have no WebAssembly.
declare global {
  namespace WebAssembly { interface Module {} }
}

/** The module, loaded once. `bytes` is a compiled module or its bytes if they are at hand (a worker is
 *  given them by the page); nothing is fetched. */
export function load(bytes?: WebAssembly.Module | ArrayBuffer | Uint8Array): Promise<Tripus>;
/** The compiled module, to hand it to workers. */
export function compiled(): Promise<WebAssembly.Module>;

/** The content of a file, decompressed if it is compressed by gzip. `Manifold.from` does so by itself. */
export function unpacked(content: Uint8Array | string): Promise<Uint8Array>;

/** A signature, name, planar diagram or gluing JSON as text, or the content of a file; the label names one of
 *  several in it. */
export type Input = string | { name: string; content: Uint8Array | string; label?: string };

export type ErrorKind =
  // the program's
  | "usage" | "invalid-input" | "unsupported" | "time-limit" | "interrupted" | "system" | "internal"
  // of the module, and of what a Manifold is asked that it has not
  | "out-of-memory" | "no-metric" | "undecided" | (string & {});

/** Bad input, or what is not there; the message is the program's and names place and remedy. */
export class TripusError extends Error {
  constructor(kind: ErrorKind, message: string);
  readonly kind: ErrorKind;
}

export interface Link {
  kind: "geodesic" | "cusp" | "finite";
  eulerCharacteristic: number;
  orientable: boolean;
  triangles: number;
}

export interface SimplifyOptions extends RunOptions { seed?: number; effort?: number }
export interface RetriangulateOptions extends RunOptions { seed?: number; budget?: number }
export interface CoverOptions extends RunOptions { cyclic?: boolean; distinct?: boolean; limit?: number }
export interface OrthospectrumOptions extends RunOptions { length?: number; words?: boolean }

/** A compact 3-manifold with a triangulation. A value: nothing is computed before it is first asked
 *  for, and then once. Every method may throw TripusError. */
export class Manifold {
  private constructor();
  /** Loads the module if need be. */
  static from(input: Input, options?: RunOptions): Promise<Manifold>;

  // What it is
  readonly input: Input;
  /** Its own, or that of its input; of a text without one the signature. */
  name(): string;
  numTetrahedra(): number;
  numEdges(): number;
  numVertices(): number;
  numCusps(): number;
  numBoundaryComponents(): number;
  isOrientable(): boolean;
  isConnected(): boolean;
  links(): Link[];
  readonly valences: number[];
  readonly edgeClasses: number[][];
  triangulationIsosig(options?: { oriented?: boolean }): string;
  /** First homology, such as "2 Z". */
  homology(): string;
  /** `tripus info --json` */
  info(options?: RunOptions): Answer;

  // The metric on this triangulation
  /** `tripus solve --json`: outcome, volume, edge_lengths, dihedral_angles, certificate, message ... */
  solve(options?: RunOptions): Answer;
  verdict(): "geometric" | "degenerate" | "infeasible" | "unresolved";
  /** Throws TripusError of kind "no-metric" where the triangulation carries none. */
  volume(): number;
  /** [E] */
  readonly lengths: number[];
  /** [T][6], radians */
  readonly dihedralAngles: number[][];
  /** The answer of `tripus solve --json`: what JSON.stringify(M) writes. */
  toJSON(): Answer;

  // Other triangulations and manifolds
  simplified(options?: SimplifyOptions): Manifold;
  /** A triangulation of the same manifold that carries the metric. Kind "no-metric" if none was found. */
  retriangulated(options?: RetriangulateOptions): Manifold;
  covers(degree: number, options?: CoverOptions): Manifold[];

  // The manifold, whatever its triangulation
  /** `tripus canonize --json` */
  canonical(options?: RunOptions): Answer;
  isometrySignature(): string;
  /** isometry_group of canonical(): order, orientation_preserving, amphicheiral, name ... */
  symmetryGroup(): Answer;
  /** `tripus compare --json`: verdict "same" | "different" | "unresolved", decided_by, message ... */
  compare(other: Manifold, options?: RunOptions): Answer;
  isIsometricTo(other: Manifold): boolean | undefined;
  /** The entry of the census, or null. */
  identify(options?: RunOptions): Answer | null;
  /** `tripus orthospectrum --json`. Kind "no-metric" where the triangulation carries none; so below. */
  orthospectrum(options?: OrthospectrumOptions): Answer;

  // Pictures
  /** `tripus embed --json`: tetrahedra [T] with vertices and faces in the hyperboloid, face_pairings,
   *  the universal cover. */
  embedding(options?: RunOptions & { cells?: number }): Answer;
  /** What the script of a page of `tripus view` reads as TRIPUS (viewer/web/page_data.hpp). Kind "no-metric" where
   *  the triangulation carries none. */
  pageData(options?: RunOptions & { cells?: number; model?: "ball" | "upper" | "klein"; discs?: boolean | number }): Answer;
}
