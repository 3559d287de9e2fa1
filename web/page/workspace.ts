// One manifold: what it is, its metric, its picture, and whatever more is asked about it.
import {joinFragments, sourceToFragment} from './address';
import {badge, measures, shownAnswer, subjectFacts, type Open} from './answers';
import {byId, copyText, make} from './dom';
import type {Engine, Reply} from './engine';
import {drawing} from './gallery';
import {history} from './history';
import type {Json, Source} from './messages';
import {View} from './view';

/** Of more tetrahedra a picture is made only when it is asked for: it would keep the page busy. */
const kPictureAtOnce = 1500, kMostPicture = 10000;

/** How each question is put: the verb of the program, its options, and its title. */
const kAsks: Record<string, {verb: string; title: string; doing: string; flags?: () => string[]}> = {
  identify: {verb: 'identify', title: 'Census', doing: 'Identifying'},
  canonize: {verb: 'canonize', title: 'Canonical cells', doing: 'Finding the canonical cells'},
  simplify: {verb: 'simplify', title: 'Simplified', doing: 'Simplifying'},
  retriangulate: {verb: 'solve', title: 'Retriangulated', doing: 'Retriangulating', flags: () => ['--retriangulate']},
  cover: {verb: 'cover', title: 'Covers', doing: 'Finding covers', flags: () => [
    byId<HTMLSelectElement>('cover-kind').value, byId<HTMLSelectElement>('cover-degree').value]},
  orthospectrum: {verb: 'orthospectrum', title: 'Arcs orthogonal to the boundary', doing: 'Finding arcs',
                  flags: () => ['--count', byId<HTMLInputElement>('arc-count').value || '20']},
  compare: {verb: 'compare', title: 'Compared', doing: 'Comparing'},
};

/** What a source is called where there is no name. */
export function titleOf({text, file}: Source): string {
  if (file) return text;
  const line = text.trim().replaceAll(/\s+/g, ' ');
  return line.length > 60 ? `${line.slice(0, 57)}\u2026` : line;
}

export class Workspace {
  source: Source | null = null;
  readonly view: View;
  private info: Json = null;
  private solution: Reply | null = null;
  /** Of the opened source; an answer that comes after another was opened is dropped. */
  private turn = 0;
  private own = '';

  constructor(private readonly engine: Engine, private readonly open: Open,
              private readonly refuse: (message: string) => void) {
    this.view = new View((view) => joinFragments(this.own, view));
    byId('copy-json').addEventListener('click', (event) => {
      const reply = this.solution;
      if (reply) void this.copy(event.currentTarget as HTMLElement, reply.text);
    });
    byId('copy-link').addEventListener('click', (event) => void this.copyLink(event.currentTarget as HTMLElement));
    for (const button of byId('more').querySelectorAll<HTMLElement>('[data-ask]'))
      if (button.getAttribute('type') === 'button')
        button.addEventListener('click', () => void this.ask(button.dataset.ask!));
    byId('more').addEventListener('submit', (event) => {
      event.preventDefault();
      const other = byId<HTMLInputElement>('other');
      if (other.value.trim()) void this.ask('compare', {text: other.value.trim()});
      else other.focus();
    });
  }

  /** The fragment of the address for this manifold; empty if it is too long for a link. */
  get fragment() { return this.own; }

  /** Shows a manifold; `opened` is called as soon as it is known to be one. Until then, and for bad
   *  input, what was shown stays. Returns whether it was opened. */
  async show(source: Source, view: string, opened: () => void): Promise<boolean> {
    const turn = ++this.turn;
    const current = () => turn === this.turn;
    let info: Json;
    try {
      info = (await this.run('Reading', 'info', source)).answers[0];
    } catch (problem: any) {
      if (current()) this.refuse(problem.message);
      return false;
    }
    if (!current()) return true;
    await this.begin(source, info);
    opened();
    void this.drawDiagram(source, current);
    try {
      const reply = await this.run('Solving', 'solve', source);
      if (!current()) return true;
      this.solve(reply);
      await this.picture(reply.answers[0], view, current);
    } catch (problem: any) {
      if (current()) this.failed(problem);
    }
    if (current()) await history.add(source, byId('subject-name').textContent!, this.note());
    return true;
  }

  private async begin(source: Source, info: Json) {
    [this.source, this.info, this.solution] = [source, info, null];
    this.own = (await sourceToFragment(source)) ?? '';
    byId('subject-name').textContent = info.name || titleOf(source);
    byId('subject-badge').replaceChildren();
    byId('subject-message').textContent = '';
    byId('subject-facts').replaceChildren(subjectFacts(info, null, this.open));
    for (const id of ['subject-diagram', 'cards-of-answers']) byId(id).replaceChildren();
    byId('subject-tools').hidden = true;
    this.view.clear();
  }

  /** Nothing is shown any more. */
  close() {
    ++this.turn;
    this.source = null;
    this.view.clear();
  }

  private note() {
    const solution = this.solution?.answers[0];
    if (!solution) return '';
    return solution.outcome === 'geometric' ? `volume ${Number(solution.volume.toPrecision(8))}` : solution.outcome;
  }

  private failed(problem: {kind: string; message: string}) {
    byId('subject-message').textContent = problem.message;
    if (!this.view.shown) this.view.clear(problem.kind === 'stopped' ? 'Stopped before the picture.' : 'No picture.');
  }

  private solve(reply: Reply) {
    const answer = reply.answers[0];
    this.solution = reply;
    byId('subject-badge').replaceChildren(badge(answer.outcome));
    byId('subject-message').textContent = answer.message;
    byId('subject-facts').replaceChildren(subjectFacts(this.info, answer, this.open),
                                          ...(answer.outcome === 'geometric' ? measures(answer) : []));
    byId('subject-tools').hidden = false;
    if (answer.advice === 'retriangulate' || (answer.outcome === 'infeasible' && answer.manifold?.hyperbolic !== false))
      byId('subject-facts').append(make('p', {class: 'hint'}, 'Another triangulation of the same manifold may carry the metric. ',
                                        make('button', {type: 'button', onclick: () => void this.ask('retriangulate')}, 'Retriangulate')));
  }

  private async picture(solution: Json, view: string, current: () => boolean) {
    if (solution.outcome !== 'geometric') {
      this.view.clear('No metric on this triangulation, so there is no picture.');
      return;
    }
    const source = this.source!;
    const draw = async () => {
      try {
        const {answers} = await this.run('Preparing the picture of', 'page-data', source, ['--cells', '20']);
        if (current()) this.view.show(answers[0], view);
      } catch (problem: any) {
        if (current()) this.view.clear(problem.message);
      }
    };
    const count = solution.tetrahedron_count;
    if (count <= kPictureAtOnce) {
      await draw();
    } else if (count > kMostPicture) {
      this.view.clear(`The page draws manifolds of up to ${kMostPicture} tetrahedra, not ${count}.`);
    } else {
      this.view.clear(`The picture of ${count} tetrahedra takes a while, and memory.`);
      byId('no-picture').append(' ', make('button', {type: 'button', onclick: () => void draw()}, 'Draw it'));
    }
  }

  /** The drawing of a diagram, where the source is one: a signature has none. */
  private async drawDiagram(source: Source, current: () => boolean) {
    const text = source.file ? '' : source.text.trim();
    if (source.file ? source.file.content.length > 20000 : /^[a-zA-Z0-9+-]+$/.test(text) && !/^(hk\d|L\d)/.test(text)) return;
    try {
      const {answers} = await this.engine.ask('Drawing', {verb: 'draw', sources: [source], flags: ['--size', '220']}, true);
      if (current()) byId('subject-diagram').replaceChildren(
          make('figure', {}, drawing(answers[0]), make('figcaption', {class: 'note'}, 'The diagram')));
    } catch {
      // It is none.
    }
  }

  private run(doing: string, verb: string, source: Source, flags: string[] = [], ...others: Source[]): Promise<Reply> {
    return this.engine.ask(`${doing} ${titleOf(source)}`, {verb, sources: [source, ...others], flags});
  }

  async ask(name: string, ...others: Source[]) {
    const turn = this.turn, {verb, title, doing, flags} = kAsks[name]!;
    const options = flags?.() ?? [];
    const suffix = name === 'cover' ? ` of degree ${options[1]}` : name === 'compare' ? ` with ${titleOf(others[0]!)}` : '';
    const body = make('div', {}, make('p', {class: 'note'}, `${doing} \u2026`));
    const head = make('header', {}, make('h3', {tabindex: '-1'}, title + suffix));
    const card = make('article', {class: 'card', 'aria-busy': 'true'}, head, body);
    byId('cards-of-answers').prepend(card);
    card.scrollIntoView({block: 'nearest', behavior: 'smooth'});
    try {
      const {answers, text, seconds} = await this.run(doing, verb, this.source!, options, ...others);
      if (turn !== this.turn) return;
      body.replaceChildren(...shownAnswer(verb, answers, this.open));
      head.append(make('span', {class: 'note'}, `${seconds < 0.1 ? '< 0.1' : seconds.toFixed(1)} s`));
      head.append(make('button', {type: 'button', onclick: (event) => void this.copy(event.currentTarget as HTMLElement, text)},
                       'Copy JSON'));
    } catch (problem: any) {
      if (turn !== this.turn) return;
      body.replaceChildren(make('p', {class: 'problem'}, problem.message));
    }
    head.append(make('button', {type: 'button', 'aria-label': `Close ${title + suffix}`, onclick: () => card.remove()}, '\u00d7'));
    card.removeAttribute('aria-busy');
  }

  async copyLink(button: HTMLElement) {
    const fragment = joinFragments(this.own, this.view.fragment);
    if (!this.own) {
      this.say(button, 'Too long for a link');
      return;
    }
    window.history.replaceState(null, '', `#${fragment}`);
    await this.copy(button, location.href);
  }

  private async copy(button: HTMLElement, text: string) {
    this.say(button, (await copyText(text)) ? 'Copied' : 'The browser does not allow it');
  }

  private say(button: HTMLElement, text: string) {
    const before = button.dataset.text ??= button.textContent!;
    button.textContent = text;
    setTimeout(() => { button.textContent = before; }, 1500);
  }
}
