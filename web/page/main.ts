// The page: its field, what is dropped on it, its address, and what it shows.
import {unpacked} from 'tripus';
import {fromBase64, joinFragments, readFragment, sourceToFragment} from './address';
import {byId, make} from './dom';
import {Engine, type Work} from './engine';
import {Gallery, kTables} from './gallery';
import {history} from './history';
import type {Source} from './messages';
import {surfaceAdvice, surfaceFormat} from './surfaces';
import {Workspace} from './workspace';

const kLargestFile = 50e6;
const kExamples: [string, string][] = [
  ['cPcbbbihq', 'a signature'],
  ['hk5_3', 'a handlebody-knot'],
  ['5_1 theta', 'a theta curve'],
  ['t3g2.13', 'the census'],
  ['PD: X[4,2,5,1] X[8,6,1,5] X[6,3,7,4] X[2,7,3,8]', 'a planar diagram'],
];

const question = byId<HTMLTextAreaElement>('question');

/** The file that the field speaks of, until another text is typed. */
let file: Source['file'];

// The worker, and the bar that tells of it.

let bar = 0;

function showWork(work: Work | null) {
  window.clearInterval(bar);
  const box = byId('work');
  if (!work) {
    box.hidden = true;
    byId('work-text').textContent = '';
    return;
  }
  const tell = () => {
    const seconds = (performance.now() - work.since) / 1000;
    if (seconds < 0.25 && box.hidden) return;  // nothing flickers for what is quick
    box.hidden = false;
    const parts = [work.activity && work.activity !== work.title ? `${work.title}: ${work.activity}` : work.title];
    if (work.tetrahedra > 0) parts.push(`${work.tetrahedra} tetrahedra`);
    if (seconds >= 1) parts.push(`${Math.floor(seconds)} s`);
    if (work.waiting > 0) parts.push(`${work.waiting} waiting`);
    const text = parts.join(', ');
    if (byId('work-text').textContent !== text) byId('work-text').textContent = text;
  };
  tell();
  bar = window.setInterval(tell, 100);
}

async function moduleBytes(): Promise<ArrayBuffer> {
  if (document.readyState === 'loading')
    await new Promise((done) => document.addEventListener('DOMContentLoaded', done, {once: true}));
  if (typeof WebAssembly === 'undefined') throw new Error('this browser has no WebAssembly, or it is switched off');
  return fromBase64(byId('module-bytes').textContent!).buffer;
}

const engine = new Engine(byId('worker-script').textContent!, moduleBytes, showWork);

// What is shown.

const workspace = new Workspace(engine, (text) => void ask({text}), refuse);
const gallery = new Gallery(engine, (name) => void ask({text: name}));

function showScreen(name: 'home' | 'workspace') {
  document.body.dataset.screen = name;
  byId('home').hidden = name !== 'home';
  byId('workspace').hidden = name !== 'workspace';
}

function refuse(message: string) {
  const place = byId('input-problem');
  place.textContent = message;
  place.hidden = !message;
  question.setAttribute('aria-invalid', String(Boolean(message)));
  if (message) question.focus();
}

function fillField({text, file: named}: Source) {
  file = named;
  question.value = text;
  grow();
}

function grow() {
  question.style.height = 'auto';
  question.style.height = `${Math.min(question.scrollHeight + 2, 180)}px`;
}

/** Opens a manifold, and makes it the address of the page. */
async function ask(source: Source) {
  const fragment = await sourceToFragment(source);
  await show(source, '', () => window.history.pushState(null, '', fragment === null ? '#' : `#${fragment}`));
}

/** Returns whether it could be opened. */
function show(source: Source, view: string, opened = () => {}): Promise<boolean> {
  refuse('');
  fillField(source);
  return workspace.show(source, view, () => {
    opened();
    document.title = `${byId('subject-name').textContent} \u2013 Tripus`;
    showScreen('workspace');
    scrollTo(0, 0);
    byId('answers').scrollTop = 0;
  });
}

function home(table = '') {
  document.title = 'Tripus';
  refuse('');
  workspace.close();
  showScreen('home');
  const shown = gallery.show(table || kTables[0][0]);
  if (!table) return;
  const title = byId('gallery-title');
  title.focus({preventScroll: true});
  title.scrollIntoView();
  // Again when there is something below it to scroll to, unless the reader went elsewhere.
  void shown.then(() => document.activeElement === title && title.scrollIntoView());
}

/** What the address asks for. */
async function restore() {
  try {
    const {source, view, table} = await readFragment(location.hash.slice(1));
    const theme = new URLSearchParams(view).get('theme');
    if (theme === 'dark' || theme === 'light') setTheme(theme);
    if (!source) {
      home(table);
      return;
    }
    showScreen('workspace');  // nothing else flashes by
    // While the worker compiles the module.
    void engine.start().then(() => setTimeout(() => workspace.source ?? workspace.view.prepare(), 0));
    if (!(await show(source, view)) && !workspace.source) {
      const problem = byId('input-problem').textContent!;
      home();
      refuse(problem);
    }
  } catch {
    home();
    refuse('The link is damaged: what it holds cannot be read.');
  }
}

// Files.

async function take(list: FileList | undefined | null) {
  const one = list?.[0];
  if (!one) return;
  if (one.size > kLargestFile) {
    refuse(`${one.name} has ${Math.round(one.size / 1e6)} MB; a browser takes files of up to ${kLargestFile / 1e6} MB, the program any.`);
    return;
  }
  let content: Uint8Array;
  try {
    content = new Uint8Array(await one.arrayBuffer());
  } catch {
    refuse(`${one.name} cannot be read: is it a folder, or has it gone?`);
    return;
  }
  try {
    content = await unpacked(content);
  } catch (error: any) {
    refuse(`${one.name}: ${error.message}`);
    return;
  }
  const format = surfaceFormat(one.name, content);
  if (format) {
    refuse(surfaceAdvice(one.name, format));
    return;
  }
  await ask({text: one.name, file: {name: one.name, content}});
}

function connectFiles() {
  const chooser = byId<HTMLInputElement>('file'), hint = byId('drop-hint');
  byId('choose-file').addEventListener('click', () => chooser.click());
  chooser.addEventListener('change', () => {
    void take(chooser.files);
    chooser.value = '';
  });
  let inside = 0;
  const show = (change: number) => {
    inside = Math.max(0, inside + change);
    hint.hidden = inside === 0;
  };
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  document.addEventListener('dragenter', (event) => hasFiles(event) && show(1));
  document.addEventListener('dragleave', (event) => hasFiles(event) && show(-1));
  document.addEventListener('dragover', (event) => hasFiles(event) && event.preventDefault());
  document.addEventListener('drop', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    show(-1000);
    void take(event.dataTransfer?.files);
  });
}

// Light and dark.

function setTheme(name: 'light' | 'dark') {
  document.documentElement.dataset.theme = name;
}

function connectTheme() {
  setTheme(matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
  const button = byId('day-night');
  const tell = () => { button.textContent = document.documentElement.dataset.theme === 'dark' ? 'Light' : 'Dark'; };
  // The viewer's own key changes it, too.
  new MutationObserver(() => {
    tell();
    workspace.view.setTheme(document.documentElement.dataset.theme!);
  }).observe(document.documentElement, {attributeFilter: ['data-theme']});
  tell();
  button.addEventListener('click', () => setTheme(document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark'));
}

// History and help.

function showHistory() {
  const list = byId('history-list');
  list.replaceChildren(...history.all().map((entry) => make('li', {},
      make('a', {href: `#${entry.fragment}`, onclick: () => byId<HTMLDialogElement>('history-box').close()}, entry.name),
      make('span', {class: 'note'}, entry.note))));
  if (list.children.length === 0) list.append(make('li', {class: 'note'}, 'Nothing yet.'));
  byId<HTMLDialogElement>('history-box').showModal();
}

function showAbout() {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('webgl2');
  byId('webgl-state').textContent = context ? 'it is there' : 'it is missing here';
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  byId<HTMLDialogElement>('about-box').showModal();
}

function connect() {
  connectTheme();
  connectFiles();
  byId('ask').addEventListener('submit', (event) => {
    event.preventDefault();
    const text = question.value.trim();
    if (!text) {
      refuse('Type or paste a manifold, or drop a file.');
      return;
    }
    // Of several in a file one is named FILE#LABEL.
    const named = file && (text === file.name || text.startsWith(`${file.name}#`)) ? file : undefined;
    void ask(named ? {text, file: named} : {text});
  });
  question.addEventListener('input', grow);
  question.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter' || event.shiftKey || event.isComposing) return;
    event.preventDefault();
    byId<HTMLFormElement>('ask').requestSubmit();
  });
  byId('skip').addEventListener('click', (event) => {
    event.preventDefault();
    question.focus();
  });
  byId('stop').addEventListener('click', () => engine.stop());
  document.addEventListener('keydown', (event) => {
    const typing = event.target instanceof HTMLElement && event.target.matches('input, textarea, select');
    if (event.key === 'Escape' && !byId('work').hidden && !document.querySelector('dialog[open]')) engine.stop();
    if (event.key === '/' && !typing && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      question.focus();
      question.select();
    }
  });
  byId('brand').addEventListener('click', () => {
    window.history.pushState(null, '', '#');
    home();
  });
  byId('to-gallery').addEventListener('click', () => {
    window.history.pushState(null, '', `#${joinFragments('gallery=' + kTables[0][0])}`);
    home(kTables[0][0]);
  });
  byId('show-history').addEventListener('click', showHistory);
  byId('clear-history').addEventListener('click', () => {
    history.clear();
    showHistoryAgain();
  });
  byId('about').addEventListener('click', showAbout);
  for (const [text, what] of kExamples)
    byId('examples').append(make('button', {type: 'button', class: 'chip', title: what, onclick: () => void ask({text})},
                                 text.length > 20 ? what : text));
  for (const button of document.querySelectorAll<HTMLElement>('[data-example]'))
    button.addEventListener('click', () => void ask({text: button.dataset.example!}));
  window.addEventListener('popstate', () => void restore());
}

function showHistoryAgain() {
  byId<HTMLDialogElement>('history-box').close();
  showHistory();
}

connect();
void restore();
void engine.start();
document.documentElement.dataset.ready = String(Math.round(performance.now()));
