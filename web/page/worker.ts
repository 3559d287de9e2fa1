// The worker: it holds the module, answers one question after the other, and knows nothing of the page.
import {load, type Input, type Tripus} from 'tripus';
import type {Failure, FromWorker, Question, Source, ToWorker} from './messages';

const scope = self as unknown as {
  onmessage: (event: MessageEvent<ToWorker>) => void;
  postMessage(message: FromWorker): void;
};

let tripus: Tripus | null = null;

/** The text may go on behind the name of its file with #LABEL. */
function inputOf({text, file}: Source): Input {
  if (!file) return text;
  return text.startsWith(`${file.name}#`) ? {...file, label: text.slice(file.name.length + 1)} : file;
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
  const {words, files} = tripus!.words(sources.map(inputOf));
  const progress = (activity: string, tetrahedra: number) =>
      scope.postMessage({id, progress: {activity, tetrahedra}});
  const isDrawing = verb === 'draw';
  const result = tripus!.run([verb, ...words, ...flags, ...(isDrawing ? [] : ['--json'])], {files, progress});
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
    return {kind: 'out-of-memory', message: 'There is not enough memory for this in a browser; the program has more.'};
  return {kind: error?.kind ?? 'internal', message};
}

scope.onmessage = async ({data}) => {
  try {
    if ('bytes' in data) {
      tripus = await load(data.bytes);
      scope.postMessage({ready: true});
    } else {
      scope.postMessage(answer(data.id, data.question));
    }
  } catch (error: any) {
    if ('bytes' in data) scope.postMessage({failed: String(error?.message ?? error)});
    else scope.postMessage({id: data.id, failure: failureOf(error)});
  }
};
