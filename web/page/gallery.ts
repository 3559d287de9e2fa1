// The tables that come with Tripus, and the census, as cards: of diagrams with their pictures.
import type {Engine} from './engine';
import {byId, counted, make} from './dom';
import type {Json} from './messages';

export const kTables = [
  ['handlebody-knots', 'Handlebody-knots'],
  ['theta-curves', 'Theta curves'],
  ['knots', 'Knots'],
  ['links', 'Links'],
  ['census', 'Census'],
] as const;

/** So many cards are made at once; all of any table of diagrams. */
const kCardsOfPage = 240;

/** What a card shows, and what is found by it. */
interface Row {
  name: string;
  notes: string[];
  hyperbolic: boolean;
  volume: number;
  text: string;
}

function rowOf(name: string, hyperbolic: boolean, volume: number, notes: string[]): Row {
  const shown = notes.filter((note) => note !== '');
  return {name, notes: shown, hyperbolic, volume, text: [name, ...shown].join('\n').toLowerCase()};
}

const volumeText = (volume: number) => `volume ${Number(volume.toPrecision(10))}`;
const isometriesText = (order: number) => counted(order, 'isometry', 'isometries');

function rowOfDiagram(row: Json): Row {
  const is = row.hyperbolic ? volumeText(row.volume) : row.hyperbolic === false ? 'not hyperbolic' : 'not decided';
  return rowOf(row.name, row.hyperbolic === true, row.hyperbolic ? row.volume : Infinity,
               [is, row.isometry_group ? isometriesText(row.isometry_group.order) : '']);
}

function rowOfCensus(row: Json): Row {
  return rowOf(row.name, true, row.volume,
               [volumeText(row.volume), row.H1, row.decomposition,
                isometriesText(row.orientation_preserving + row.orientation_reversing)]);
}

export class Gallery {
  private rows = new Map<string, Row[]>();
  private drawn = new Map<string, string>();
  private seen: IntersectionObserver;
  private table = '';
  private page = 0;

  constructor(private readonly engine: Engine, private readonly open: (name: string) => void) {
    const tabs = byId('tables');
    for (const [name, title] of kTables)
      tabs.append(make('button', {type: 'button', 'data-table': name, 'aria-pressed': 'false',
                                  onclick: () => void this.show(name)}, title));
    for (const [id, event] of [['find', 'input'], ['order', 'change'], ['hyperbolic-only', 'change']] as const)
      byId(id).addEventListener(event, () => this.turn(0));
    byId('page-before').addEventListener('click', () => this.leaf(-1));
    byId('page-after').addEventListener('click', () => this.leaf(1));
    this.seen = new IntersectionObserver((entries) => {
      for (const {target, isIntersecting} of entries)
        if (isIntersecting) void this.draw(target as HTMLElement);
    }, {rootMargin: '200px'});
  }

  /** Shows a table; of a name that is none the first. */
  async show(table: string) {
    this.table = kTables.some(([name]) => name === table) ? table : kTables[0][0];
    for (const button of byId('tables').querySelectorAll<HTMLElement>('button'))
      button.setAttribute('aria-pressed', String(button.dataset.table === this.table));
    byId('hyperbolic-only').closest<HTMLElement>('label')!.hidden = this.table === 'census';
    if (!this.rows.has(this.table)) {
      const asked = this.table;
      byId('cards').replaceChildren();
      byId('pages').hidden = true;
      byId('card-count').textContent = 'Reading the tables \u2026';
      try {
        this.rows.set(asked, await this.read(asked));
      } catch (problem: any) {
        if (this.table === asked) byId('card-count').textContent = problem.message;
        return;
      }
      if (this.table !== asked) return;
    }
    this.turn(0);
  }

  private async read(table: string): Promise<Row[]> {
    const isCensus = table === 'census';
    const question = isCensus ? {verb: 'census-rows', sources: [], flags: []}
                              : {verb: 'table', sources: [{text: table}], flags: []};
    const {answers} = await this.engine.ask('Reading the tables', question);
    return (answers[0].rows as Json[]).map(isCensus ? rowOfCensus : rowOfDiagram);
  }

  /** What the fields choose, in the order that they ask for. */
  private get chosen(): Row[] {
    const wanted = byId<HTMLInputElement>('find').value.trim().toLowerCase();
    const hyperbolic = this.table !== 'census' && byId<HTMLInputElement>('hyperbolic-only').checked;
    const rows = this.rows.get(this.table)!.filter((row) => row.text.includes(wanted) && (row.hyperbolic || !hyperbolic));
    return byId<HTMLSelectElement>('order').value === 'volume' ? rows.sort((a, b) => (a.volume < b.volume ? -1 : a.volume > b.volume ? 1 : 0))
                                                               : rows;
  }

  private leaf(step: number) {
    this.turn(this.page + step);
    byId('gallery-title').scrollIntoView();
  }

  private turn(page: number) {
    if (!this.rows.has(this.table)) return;
    const rows = this.chosen, all = this.rows.get(this.table)!.length;
    const last = Math.max(0, Math.ceil(rows.length / kCardsOfPage) - 1);
    this.page = Math.min(Math.max(page, 0), last);
    const first = this.page * kCardsOfPage, end = Math.min(first + kCardsOfPage, rows.length);
    this.seen.disconnect();
    byId('cards').replaceChildren(...rows.slice(first, end).map((row) => this.card(row)));
    byId('card-count').textContent =
        `${rows.length} of ${this.table === 'census' ? counted(all, 'manifold') : counted(all, 'diagram')}`;
    byId('pages').hidden = last === 0;
    byId('page-number').textContent = `${first + 1} to ${end} of ${rows.length}`;
    byId<HTMLButtonElement>('page-before').disabled = this.page === 0;
    byId<HTMLButtonElement>('page-after').disabled = this.page === last;
  }

  private card({name, notes}: Row): HTMLElement {
    const picture = this.table === 'census' ? null : make('span', {class: 'diagram', 'data-name': name, 'aria-hidden': 'true'});
    if (picture) this.seen.observe(picture);
    return make('li', {}, make('button', {type: 'button', onclick: () => this.open(name)}, picture, make('b', {}, name),
                               ...notes.map((note) => make('span', {class: 'note'}, note))));
  }

  private async draw(place: HTMLElement) {
    this.seen.unobserve(place);
    const name = place.dataset.name!;
    let svg = this.drawn.get(name);
    if (svg === undefined) {
      try {
        svg = (await this.engine.ask('Drawing diagrams', {verb: 'draw', sources: [{text: name}], flags: ['--size', '150']}, true))
                  .answers[0] as string;
      } catch {
        return;
      }
      this.drawn.set(name, svg);
    }
    place.replaceChildren(drawing(svg));
  }
}

/** A drawing of the module as an element. */
export function drawing(svg: string): Node {
  const parsed = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
  parsed.setAttribute('class', 'drawing');
  return document.importNode(parsed, true);
}
