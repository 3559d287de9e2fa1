// The panel: facts about the manifold, and the controls that change the state of the page.
const kCellCounts = [1, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 3000, 5000, 10000];

/// What of the state is on or off, and has a box to tick.
const kSwitches = ['mirror', 'lines', 'discs', 'faces', 'truncations', 'hollow', 'labels', 'rate'];

const kThemes = {
  light: {outside: {uHigh: '#d3dfea', uLow: '#f6f4ef', uInk: '#33506e'}, fog: '#dfe7ee'},
  dark: {outside: {uHigh: '#0a1120', uLow: '#1f2c3d', uInk: '#a9c8e8'}, fog: '#0b1420'},
};

const element = (id) => document.getElementById(id);

/// A number for people: twelve digits where it has them.
const shown = (x) => Number(x.toPrecision(12)).toString();

function listOf(numbers, limit = 12) {
  const text = numbers.slice(0, limit).map(shown).join(', ');
  return numbers.length > limit ? `${text}, \u2026 (${numbers.length} in all)` : text;
}

function showFacts(data) {
  const boundary = data.vertices.filter(({kind}) => kind === 'geodesic')
      .map((v) => `genus ${v.genus}, area ${shown(v.area)}`);
  const cusps = data.vertices.filter(({kind}) => kind === 'cusp').length;
  const parabolic = data.cone_angles.flatMap((angle, e) => (angle === 'order 0' ? [e] : []));
  const singular = data.cone_angles.flatMap(
      (angle, e) => (angle && angle !== 'order 0' ? [`${angle} at ${e}`] : []));
  const valences = data.edge_valences;
  const facts = [
    ['Verdict', data.outcome, data.message],
    ['Volume', shown(data.volume)],
    ...(boundary.length ? [['Geodesic boundary', boundary.join('; ')]] : []),
    ...(cusps ? [['Cusps', `${cusps}, cut off at horospheres of area ${
        shown(data.horosphere_area)}`]] : []),
    ...(parabolic.length ? [['Parabolic edges', `${parabolic.join(', ')}, cut off at horospheres`]]
                         : []),
    ...(singular.length ? [['Singular edges', singular.join(', ')]] : []),
    ['Tetrahedra', `${data.tetrahedron_count}, ${data.orientable ? '' : 'non-'}orientable`],
    [data.edge_lengths.length === 1 ? 'Edge length' : 'Edge lengths', listOf(data.edge_lengths)],
    [valences.length === 1 ? 'Edge valence' : 'Edge valences', listOf(valences)],
    ['Largest curvature left', data.max_curvature.toPrecision(2)],
    ...(data.discs ? [['Discs', `arcs orthogonal to the boundary up to length ${
        shown(data.discs.length)}`]] : []),
    ['Isomorphism signature', data.isosig || 'too long to compute'],
  ];
  for (const [noun, value, note] of facts) {
    const [dt, dd] = [document.createElement('dt'), document.createElement('dd')];
    dt.textContent = noun;
    dd.textContent = value;
    if (note) {
      dd.textContent = '';
      const badge = document.createElement('span');
      badge.className = 'badge';
      badge.textContent = value;
      dd.append(badge, ` ${note}`);
    }
    element('facts').append(dt, dd);
  }
}

/// The list of keys, in the help.
function showKeys({keys}) {
  for (const [key, , text] of keys) {
    if (!text) continue;
    const [dt, dd] = [document.createElement('dt'), document.createElement('dd')];
    [dt.textContent, dd.textContent] = [key, text];
    element('keys').append(dt, dd);
  }
}

/// Connects the controls; `changed(name)` is called after every change of the state.
function connectPanel(state, changed) {
  const connect = (id, event, read) => element(id).addEventListener(event, () => {
    read(element(id));
    changed(id);
  });
  connect('cells', 'input', (e) => { state.cells = kCellCounts[Number(e.value)]; });
  for (const id of ['explode', 'tube', 'sight'])
    connect(id, 'input', (e) => { state[id] = Number(e.value); });
  connect('cut', 'input', (e) => { state.cut = e.value === e.max ? null : Number(e.value); });
  connect('transparent', 'change', (e) => { state.transparent = e.value ? Number(e.value) : null; });
  for (const id of ['model', 'colour', 'wall', 'place'])
    connect(id, 'change', (e) => { state[id] = e.value; });
  for (const id of kSwitches) connect(id, 'change', (e) => {
    state[id] = e.checked;
    if (!state.faces && !state.truncations) state[id === 'faces' ? 'truncations' : 'faces'] = true;
  });
  for (const button of document.querySelectorAll('[data-view]'))
    button.addEventListener('click', () => { state.view = button.dataset.view; changed('view'); });
  element('fold').addEventListener('click', () => fold(!element('panel').classList.contains('folded')));
  fold(matchMedia('(max-width: 760px)').matches);
}

function fold(folded) {
  element('panel').classList.toggle('folded', folded);
  element('fold').setAttribute('aria-expanded', String(!folded));
  element('fold').textContent = folded ? 'More' : 'Less';
}

function setTheme(state, name) {
  state.themeName = name;
  state.theme = kThemes[name];
  document.documentElement.dataset.theme = name;
}

/// Makes the controls show the state, whoever changed it.
function showState({state, data}, cellCount) {
  const choices = element('transparent');
  if (choices.options.length === 1)
    for (let t = 0; t < Math.min(data.tetrahedron_count, 100); ++t) choices.add(new Option(t, t));
  choices.value = state.transparent ?? '';
  element('cut').value = state.cut ?? element('cut').max;
  const nearest = kCellCounts.findIndex((n) => n >= state.cells);
  element('cells').value = String(nearest < 0 ? kCellCounts.length - 1 : nearest);
  element('cells-shown').textContent = String(cellCount);
  element('cells-shown').dataset.drawn = '1';
  for (const id of ['explode', 'tube', 'sight', 'model', 'colour', 'wall', 'place'])
    element(id).value = String(state[id]);
  for (const id of kSwitches) element(id).checked = state[id];
  for (const view of ['outside', 'inside']) element(`controls-${view}`).hidden = state.view !== view;
  for (const button of document.querySelectorAll('[data-view]'))
    button.setAttribute('aria-pressed', String(button.dataset.view === state.view));
  element('pad').hidden = state.view !== 'inside' || !matchMedia('(pointer: coarse)').matches;
}

function showNotice(text) {
  element('notice').textContent = text;
  element('notice').hidden = !text;
}
