// What the page and its worker say to each other.

/** A manifold as it was typed, with the file that the text names, if it does. */
export interface Source {
  text: string;
  file?: {name: string; content: Uint8Array | string};
}

/** A verb of the program; the module has one more, page-data, for the picture. */
export interface Question {
  verb: string;
  sources: Source[];
  flags: string[];
}

export type Json = any;

export interface Failure {
  kind: string;
  message: string;
}

export type ToWorker = {bytes: ArrayBuffer} | {id: number; question: Question};

export type FromWorker =
    | {ready: true}
    | {failed: string}
    | {id: number; progress: {activity: string; tetrahedra: number}}
    | {id: number; answers: Json[]; text: string}
    | {id: number; failure: Failure};
