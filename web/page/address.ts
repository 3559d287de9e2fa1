// The fragment of the address: which manifold, and how it is looked at. Nothing of it leaves the browser.
import type {Source} from './messages';

/** Of the fragment's names these are ours; all others are the viewer's (viewer/web/main.js). */
const kOwn = ['input', 'name', 'file', 'packed', 'gallery'];
/** Longer texts are packed; links of more characters than that break in mails and chats. */
const kPlain = 200, kLongest = 8000;

async function through(bytes: Uint8Array, stream: GenericTransformStream): Promise<Uint8Array> {
  const read = new Blob([bytes as BlobPart]).stream().pipeThrough(stream as ReadableWritablePair);
  return new Uint8Array(await new Response(read).arrayBuffer());
}

const toBase64 = (bytes: Uint8Array) => {
  let letters = '';
  for (const byte of bytes) letters += String.fromCharCode(byte);
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
};

export function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  const letters = atob(text.trim().replaceAll('-', '+').replaceAll('_', '/'));
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

/** The names of a source in a fragment, or null if it is too long for a link. */
export async function sourceToFragment({text, file}: Source): Promise<string | null> {
  const content = file ? file.content : text;
  const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content;
  const parts = new URLSearchParams();
  if (file) {
    parts.set('file', file.name);
    if (text !== file.name) parts.set('input', text);
  }
  if (!file && text.length <= kPlain) {
    parts.set('input', text);
  } else {
    if (bytes.length > 1e6) return null;
    parts.set('packed', toBase64(await through(bytes, new CompressionStream('deflate-raw'))));
  }
  const fragment = parts.toString();
  return fragment.length <= kLongest ? fragment : null;
}

/** What a fragment asks for: a manifold, the view of it, or one of the tables. */
export async function readFragment(fragment: string): Promise<{source: Source | null; view: string; table: string}> {
  const parts = new URLSearchParams(fragment);
  const input = parts.get('input'), packed = parts.get('packed'), name = parts.get('file');
  const view = new URLSearchParams([...parts].filter(([key]) => !kOwn.includes(key))).toString();
  const table = parts.get('gallery') ?? '';
  if (packed === null) return {source: input?.trim() ? {text: input} : null, view, table};
  const bytes = await through(fromBase64(packed), new DecompressionStream('deflate-raw'));
  const source = name ? {text: input ?? name, file: {name, content: bytes}}
                      : {text: new TextDecoder().decode(bytes)};
  return {source, view, table};
}

export const joinFragments = (...parts: string[]) => parts.filter((part) => part).join('&');
