// The worker: it holds the module, answers one question after the other, and knows nothing of the page.
import {load, type Tripus} from 'tripus';
import type {Failure, FromWorker, Question, Source, ToWorker} from './messages';

const scope = self as unknown as {
  onmessage: (event: MessageEvent<ToWorker>) => void;
  postMessage(message: FromWorker): void;
};

let tripus: Tripus | null = null;

/** The argument that names a source, and the file that it needs. */
function argumentOf({text, file}: Source, files: Record<string, Uint8Array | string>, number: number) {
  if (file) {
    files[file.name] = file.content;
    return text.startsWith(file.name) ? text : file.name;
  }
  // Only a planar diagram may have several lines in an argument; what else has them is a file's content.
  if (!/^\s*[{[%<]|[\n\r]/.test(text)) return text;
  const name = number === 0 ? 'pasted' : `pasted-${number + 1}`;
  files[name] = text;
  return name;
}

/** What a run printed: its JSON objects, or the problem that it tells of. */
function parse(stdout: string): any[] {
  try {
    return [JSON.parse(stdout)];
  } catch {
    return stdout.split('\n').filter((line) => line.trim()).map((line) => JSON.parse(line));
  }
}

function answer(id: number, {verb, sources, flags}: Question): FromWorker {
  const files: Record<string, Uint8Array | string> = {};
  const names = sources.map((source, i) => argumentOf(source, files, i));
  const progress = (activity: string, tetrahedra: number) =>
      scope.postMessage({id, progress: {activity, tetrahedra}});
  const isDrawing = verb === 'draw';
  const result = tripus!.run([verb, ...names, ...flags, ...(isDrawing ? [] : ['--json'])], {files, progress});
  if (isDrawing && result.status === 0) return {id, answers: [result.stdout], text: result.stdout};
  const answers = isDrawing ? [] : parse(result.stdout);
  const failed = answers.find((one) => one.error);
  if (failed) return {id, failure: failed.error};
  if (result.status > 1 || answers.length === 0)
    return {id, failure: {kind: result.status === 2 ? 'usage' : 'internal',
                          message: result.stderr.replace(/^tripus: /, '').trim() || 'there was no answer'}};
  return {id, answers, text: result.stdout};
}

/** In words; the module may have been ended by the browser. */
function failureOf(error: any): Failure {
  const message = String(error?.message ?? error);
  if (error instanceof RangeError || /memory/i.test(message))
    return {kind: 'out_of_memory', message: 'There is not enough memory for this in a browser; the program has more.'};
  return {kind: error?.kind ?? 'internal', message};
}

scope.onmessage = async ({data}) => {
  try {
    if ('bytes' in data) {
      tripus = await load(data.bytes);
      scope.postMessage({ready: tripus.version});
    } else {
      scope.postMessage(answer(data.id, data.question));
    }
  } catch (error: any) {
    if ('bytes' in data) scope.postMessage({failed: String(error?.message ?? error)});
    else scope.postMessage({id: data.id, failure: failureOf(error)});
  }
};
