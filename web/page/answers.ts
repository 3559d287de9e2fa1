// The answers in words: what each verb's JSON becomes on the page.
import {shown} from 'viewer';
import {counted, make} from './dom';
import type {Json} from './messages';

/** Opens another manifold; given to whatever names one. */
export type Open = (text: string) => void;

type Row = [string, Node | string | null | undefined | false];

const kMostRows = 200;

/** Nouns and values. */
export function facts(rows: Row[]): HTMLElement {
  const list = make('dl', {class: 'facts'});
  for (const [noun, value] of rows)
    if (value) list.append(make('div', {}, make('dt', {}, noun), make('dd', {}, value)));
  return list;
}

/** A table; what is beyond a few hundred rows is in the JSON. */
function table(heads: string[], rows: (Node | string)[][], caption: string): HTMLElement {
  const body = make('tbody');
  for (const row of rows.slice(0, kMostRows))
    body.append(make('tr', {}, ...row.map((value) => make('td', {}, value))));
  return make('div', {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': caption},
              make('table', {}, make('caption', {class: 'unseen'}, caption),
                   make('thead', {}, make('tr', {}, ...heads.map((head) => make('th', {scope: 'col'}, head)))),
                   body),
              rows.length > kMostRows ? make('p', {class: 'note'}, `The first ${kMostRows} of ${rows.length}; all are in the JSON.`)
                                      : null);
}

function more(title: string, ...content: Node[]): HTMLElement {
  return make('details', {}, make('summary', {}, title), ...content);
}

/** A signature or name that opens what it names. */
export function link(text: string, open: Open, title = text): HTMLElement {
  return make('button', {type: 'button', class: 'open', title: 'Open this manifold', onclick: () => open(text)}, title);
}

const number = (x: number | null | undefined) => (x === null || x === undefined ? '' : shown(x));
const list = (numbers: number[], limit = 8) =>
    numbers.slice(0, limit).map(shown).join(', ') + (numbers.length > limit ? `, \u2026 (${numbers.length})` : '');

/** "genus 2", "genus 3 and 2 cusps". */
export function boundary(vertices: Json[]): string {
  const count = new Map<string, number>();
  for (const {kind, genus} of vertices) {
    const word = kind === 'geodesic' ? `genus ${genus}` : kind === 'finite' ? 'finite vertex' : 'cusp';
    count.set(word, (count.get(word) ?? 0) + 1);
  }
  const words = [...count].map(([word, n]) => {
    if (n === 1) return word;
    return word.startsWith('genus') ? `${n} of ${word}` : `${n} ${word === 'cusp' ? 'cusps' : 'finite vertices'}`;
  });
  return words.join(', ') || 'none';
}

/** Each value once, with how often it comes: "12", "3, 4 \u00d7 2". */
function repeated(numbers: number[], limit = 12): string {
  const count = new Map<number, number>();
  for (const x of numbers) count.set(x, (count.get(x) ?? 0) + 1);
  const parts = [...count].sort(([a], [b]) => a - b).map(([x, n]) => (n === 1 ? `${x}` : `${x} \u00d7 ${n}`));
  return parts.length > limit ? `${parts.slice(0, limit).join(', ')}, \u2026` : parts.join(', ');
}

export function badge(outcome: string): HTMLElement {
  return make('span', {class: 'badge', 'data-outcome': outcome}, outcome);
}

/** What a triangulation is: `tripus info`; with the metric, once there is one: `tripus solve`. */
export function subjectFacts(info: Json, solution: Json | null, open: Open): HTMLElement {
  const signature = info.oriented_isosig ?? info.isosig;
  const geometric = solution?.outcome === 'geometric';
  const area = geometric ? areaOf(solution) : 0;
  return facts([
    ['Volume', geometric && make('strong', {}, number(solution.volume))],
    ['Boundary', boundary(info.vertices) + (area > 0 ? `, area ${number(area)}` : '')],
    ['First homology', info.H1],
    ['Tetrahedra', `${info.tetrahedron_count}, ${info.orientable ? 'orientable' : 'not orientable'}`],
    [info.edge_count === 1 ? 'Edge, valence' : `${info.edge_count} edges, valence`, repeated(info.edge_valences)],
    ['Signature', signature && link(signature, open)],
    ['Components', info.component_count > 1 && String(info.component_count)],
    ['Flat tetrahedra', list(solution?.flat_tetrahedra ?? [])],
    ['Certificate', solution?.certificate && 'exact, in the JSON: integer arithmetic checks it'],
  ]);
}

const areaOf = (solution: Json): number =>
    solution.vertices.reduce((sum: number, v: Json) => sum + (v.kind === 'geodesic' ? v.area : 0), 0);

/** Lengths and angles, once there are any. */
export function measures(answer: Json): Node[] {
  if (!answer.edge_lengths || !answer.dihedral_angles) return [];
  const lengths = answer.edge_lengths.map((length: number, e: number) =>
      [String(e), String(answer.edge_valences[e]), number(length)]);
  const angles = answer.dihedral_angles.map((row: number[], t: number) =>
      [String(t), ...row.map((angle) => (angle / Math.PI).toFixed(8))]);
  return [more(`Lengths of ${counted(lengths.length, 'edge')}`,
               table(['edge', 'valence', 'length'], lengths, 'Edge lengths')),
          more('Dihedral angles', make('p', {class: 'note'}, 'In units of \u03c0, at the edges 01 02 03 12 13 23 of each tetrahedron.'),
               table(['', '01', '02', '03', '12', '13', '23'], angles, 'Dihedral angles')),
          more('How it was found', facts([
            ['Method', `${answer.method}, ${counted(answer.iterations, 'iteration')}`],
            ['Largest curvature left', answer.max_curvature.toPrecision(2)],
            ['Theorem', answer.valence_theorem?.message],
          ]))];
}

function solved(answer: Json, open: Open): Node[] {
  const geometric = answer.outcome === 'geometric', found = answer.retriangulation;
  return [
    make('p', {}, badge(answer.outcome), ` ${answer.message}`),
    facts([
      ['Volume', geometric && make('strong', {}, number(answer.volume))],
      ['Found on', found && geometric && answer.isosig && link(answer.isosig, open)],
      ['Tried', found && counted(found.tried, 'triangulation')],
      ['Moves', found?.path?.join('; ')],
    ]),
    ...(geometric ? measures(answer) : []),
  ];
}

function simplified(answer: Json, open: Open): Node[] {
  const {given, simplified: left} = answer.stages;
  return [facts([
    ['Tetrahedra', given === left ? `${left}, as before` : `${left}, before ${given}`],
    ['Signature', answer.isosig ? link(answer.oriented_isosig ?? answer.isosig, open) : ''],
    ['Finite vertices left', answer.finite_vertices_left ? String(answer.finite_vertices_left) : ''],
  ])];
}

function group({order, name, orientation_preserving: keeping, amphicheiral}: Json): string {
  const parts = [`${name ?? 'order ' + order}${name && !name.includes(String(order)) ? `, of order ${order}` : ''}`];
  if (keeping !== undefined) parts.push(keeping === order ? 'all keep the orientation' : `${keeping} keep the orientation`);
  if (amphicheiral) parts.push('amphicheiral');
  return parts.join('; ');
}

function canonized(answer: Json, open: Open): Node[] {
  if (answer.outcome !== 'geometric')
    return [make('p', {}, badge(answer.outcome), ` ${answer.message}`)];
  return [
    make('p', {}, answer.message),
    facts([
      ['Canonical cells', answer.decomposition],
      ['Isometries', answer.isometry_group ? group(answer.isometry_group) : ''],
      ['Isometry signature', answer.oriented_signature ?? answer.signature],
      ['Volume', number(answer.volume)],
      ['Triangulation', answer.triangulation ? link(answer.triangulation, open) : ''],
    ]),
  ];
}

function identified(answer: Json, open: Open): Node[] {
  const row = answer.census;
  return [
    make('p', {}, answer.message),
    row ? facts([
      ['Name', link(row.name, open)],
      ['Volume', number(row.volume)],
      ['Boundary', row.boundary],
      ['First homology', row.H1],
      ['Canonical cells', row.decomposition],
      ['Isometries', `${row.orientation_preserving} keep the orientation, ${row.orientation_reversing} reverse it`],
    ]) : '',
    row?.triangulations?.length
        ? more(counted(row.triangulations.length, 'triangulation'),
               make('p', {class: 'signatures'}, ...row.triangulations.slice(0, kMostRows).map((one: string) => link(one, open))))
        : '',
  ].filter((one): one is HTMLElement => one !== '');
}

function compared(answer: Json): Node[] {
  const {first, second} = answer;
  const side = (noun: string, value: (m: Json) => string) => [noun, value(first), value(second)];
  const rows = first && second ? [
    side('volume', (m) => number(m.volume)),
    side('canonical cells', (m) => m.decomposition ?? ''),
    side('isometry signature', (m) => m.oriented_signature ?? m.signature ?? ''),
    side('isometries', (m) => (m.isometry_group ? String(m.isometry_group.order) : '')),
  ].filter(([, a, b]) => a || b) : [];
  return [
    make('p', {}, badge(answer.verdict), ` ${answer.message}`),
    rows.length ? table(['', String(first.input), String(second.input)], rows as string[][], 'Comparison') : '',
  ].filter((one): one is HTMLElement => one !== '');
}

function covers(answers: Json[], open: Open): Node[] {
  const rows = answers.map((one) => [
    String(one.cover), one.regular ? 'regular' : '', String(one.tetrahedron_count), boundary(one.vertices), one.H1,
    one.isosig ? link(one.oriented_isosig ?? one.isosig, open)
               : link(JSON.stringify({gluings: one.gluings}), open, 'open'),
  ]);
  return [make('p', {}, `${counted(answers.length, 'connected cover')}.`),
          table(['', '', 'tetrahedra', 'boundary', 'homology', 'triangulation'], rows, 'Covers')];
}

function arcs(answer: Json): Node[] {
  const rows = answer.arcs.map((arc: Json) => [
    number(arc.length), String(arc.multiplicity), arc.ends.join(' \u2013 '), arc.edge === null ? '' : String(arc.edge)]);
  const share = (part: Json) => (part?.exact ? `${number(part.counted)} of ${number(part.exact)}` : '');
  return [
    facts([
      ['Up to length', number(answer.length)],
      ['Arcs', String(answer.arc_count)],
      ['Area that they explain', share(answer.area)],
      ['Volume that they explain', share(answer.volume)],
    ]),
    table(['length', 'arcs', 'between components', 'edge'], rows, 'Arcs by length'),
  ];
}

/** The answer of a verb. */
export function shownAnswer(verb: string, answers: Json[], open: Open): Node[] {
  const answer = answers[0];
  switch (verb) {
    case 'solve': return solved(answer, open);
    case 'simplify': return simplified(answer, open);
    case 'canonize': return canonized(answer, open);
    case 'identify': return identified(answer, open);
    case 'compare': return compared(answer);
    case 'cover': return covers(answers, open);
    case 'orthospectrum': return arcs(answer);
    default: return [make('pre', {}, JSON.stringify(answer, null, 1))];
  }
}
