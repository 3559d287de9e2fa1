// The tables that come with Tripus, as cards with the pictures of their diagrams.
import type {Engine} from './engine';
import {byId, counted, make} from './dom';
import type {Json} from './messages';

export const kTables = [
  ['handlebody-knots', 'Handlebody-knots'],
  ['theta-curves', 'Theta curves'],
  ['knots', 'Knots'],
  ['links', 'Links'],
] as const;

export class Gallery {
  private rows = new Map<string, Json[]>();
  private drawn = new Map<string, string>();
  private seen: IntersectionObserver;
  private table = '';

  constructor(private readonly engine: Engine, private readonly open: (name: string) => void) {
    const tabs = byId('tables');
    for (const [name, title] of kTables)
      tabs.append(make('button', {type: 'button', 'data-table': name, 'aria-pressed': 'false',
                                  onclick: () => void this.show(name)}, title));
    byId('find').addEventListener('input', () => this.filter());
    byId('hyperbolic-only').addEventListener('change', () => this.filter());
    this.seen = new IntersectionObserver((entries) => {
      for (const {target, isIntersecting} of entries)
        if (isIntersecting) void this.draw(target as HTMLElement);
    }, {rootMargin: '200px'});
  }

  async show(table: string = kTables[0][0]) {
    this.table = table;
    for (const button of byId('tables').querySelectorAll<HTMLElement>('button'))
      button.setAttribute('aria-pressed', String(button.dataset.table === table));
    let rows = this.rows.get(table);
    if (!rows) {
      byId('cards').replaceChildren();
      byId('card-count').textContent = 'Reading the tables \u2026';
      try {
        const {answers} = await this.engine.ask('Reading the tables',
                                                {verb: 'table', sources: [{text: table}], flags: []});
        rows = answers[0].rows as Json[];
        this.rows.set(table, rows);
      } catch (problem: any) {
        byId('card-count').textContent = problem.message;
        return;
      }
      if (this.table !== table) return;
    }
    this.seen.disconnect();
    byId('cards').replaceChildren(...rows.map((row) => this.card(row)));
    this.filter();
  }

  private card(row: Json): HTMLElement {
    const volume = row.hyperbolic ? `volume ${Number(row.volume.toPrecision(10))}`
                                  : row.hyperbolic === false ? 'not hyperbolic' : 'not decided';
    const symmetries = row.isometry_group ? `${counted(row.isometry_group.order, 'isometry', 'isometries')}` : '';
    const picture = make('span', {class: 'diagram', 'data-name': row.name, 'aria-hidden': 'true'});
    const card = make('li', {'data-hyperbolic': String(row.hyperbolic === true)},
                      make('button', {type: 'button', onclick: () => this.open(row.name)},
                           picture, make('b', {}, row.name), make('span', {class: 'note'}, volume),
                           symmetries ? make('span', {class: 'note'}, symmetries) : null));
    this.seen.observe(picture);
    return card;
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

  private filter() {
    const wanted = byId<HTMLInputElement>('find').value.trim().toLowerCase();
    const hyperbolic = byId<HTMLInputElement>('hyperbolic-only').checked;
    let count = 0;
    for (const card of byId('cards').children as HTMLCollectionOf<HTMLElement>) {
      card.hidden = !card.textContent!.toLowerCase().includes(wanted) ||
          (hyperbolic && card.dataset.hyperbolic !== 'true');
      if (!card.hidden) ++count;
    }
    byId('card-count').textContent = `${count} of ${counted(byId('cards').children.length, 'diagram')}`;
  }
}

/** A drawing of the module as an element. */
export function drawing(svg: string): Node {
  const parsed = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
  parsed.setAttribute('class', 'drawing');
  return document.importNode(parsed, true);
}
