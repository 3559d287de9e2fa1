// The picture of a manifold and its controls: their state, what draws them, and when.

/// While things move, frames are drawn so coarsely that they take about so long, in milliseconds, but
/// not with fewer than this share of the pixels across.
const kMovingFrame = 40, kCoarsest = 0.15;
/// What does not change for so many milliseconds rests.
const kRestAfter = 180;
const kLost = 'The graphics card has given up on this page. It will be drawn again when the browser gives the ' +
    'graphics back; otherwise reload the page.';
/// Samples a pixel of the resting picture inside.
const kRefinements = 16;

/// The digits of n in a base, behind the point: places that fill [0, 1] evenly.
function radicalInverse(n, base) {
  let sum = 0;
  for (let share = 1 / base; n > 0; share /= base) {
    sum += share * (n % base);
    n = Math.floor(n / base);
  }
  return sum;
}

/// How coarse the next frame should be, when one of `quality` took so long: pixels cost time in
/// proportion to their number.
function nextQuality(quality, milliseconds) {
  const wanted = quality * Math.sqrt(kMovingFrame / Math.max(milliseconds, 1));
  const slowly = Math.min(1.06 * quality, Math.max(0.4 * quality, wanted));
  return Math.min(1, Math.max(kCoarsest, slowly));
}

const kColourings = ['tetrahedron', 'face', 'depth', 'component', 'edge'];
const afterOf = (choices, one) => choices[(choices.indexOf(one) + 1) % choices.length];

/// What keys and buttons ask for, by the names of the one list of keys (viewer/keys.cpp).
const kActs = {
  'fewer cells': ({state}) => { state.cells = Math.max(1, state.cells - Math.ceil(state.cells / 5)); },
  'more cells': ({state}) => {
    state.cells = Math.min(kCellCounts.at(-1), state.cells + Math.max(1, state.cells >> 2));
  },
  'change view': ({state}) => { state.view = state.view === 'inside' ? 'outside' : 'inside'; },
  'change model': (page) => {
    page.state.model = afterOf(['ball', 'upper', 'klein'], page.state.model);
    page.changed('model');
  },
  'change colour': ({state}) => { state.colour = afterOf(kColourings, state.colour); },
  faces: ({state}) => { state.faces = !state.faces || !state.truncations; },
  truncations: ({state}) => { state.truncations = !state.truncations || !state.faces; },
  discs: ({state}) => { state.discs = !state.discs; },
  lines: ({state}) => { state.lines = !state.lines; },
  hollow: ({state}) => { state.hollow = !state.hollow; },
  cut: ({state}) => { state.cut = state.cut === null ? 0 : null; },
  'cut back': ({state}) => { if (state.cut !== null) state.cut -= 0.04; },
  'cut forth': ({state}) => { if (state.cut !== null) state.cut += 0.04; },
  transparent: (page) => page.makeTransparent(),
  labels: ({state}) => { state.labels = !state.labels; },
  save: (page) => page.savePicture(),
  link: (page) => page.link(),
  reset: (page) => page.resetView(),
  theme: ({state}) => setTheme(state, state.themeName === 'dark' ? 'light' : 'dark'),
  rate: ({state}) => { state.rate = !state.rate; },
  help: () => element('help-text').showModal(),
};

class Page {
  ///   data      of page_data.hpp
  ///   fragment  what the address of the page wishes for, such as view=inside&place=wall
  ///   address   for the key L: from the fragment of this view to that of the address
  constructor(data, fragment, address = (view) => view) {
    this.data = data;
    this.address = address;
    setPalette(this.data.colours);
    this.canvas = element('picture');
    this.wishes = new URLSearchParams(fragment);
    const number = (name, otherwise, low, high) => {
      const x = Number(this.wishes.get(name) ?? NaN);
      return Number.isFinite(x) ? Math.min(high, Math.max(low, x)) : otherwise;
    };
    const choice = (name, choices) =>
        (choices.includes(this.wishes.get(name)) ? this.wishes.get(name) : choices[0]);
    this.number = number;
    this.state = {
      view: choice('view', this.data.view_shown === 'inside' ? ['inside', 'outside'] : ['outside', 'inside']),
      model: choice('model', [this.data.model_shown, 'ball', 'upper', 'klein']),
      renderer: choice('renderer', ['faces', 'cells']),
      cells: Math.round(number('cells', this.data.cells_shown ?? 20, 1, kCellCounts.at(-1))),
      explode: number('explode', 0, 0, 1.5),
      colour: choice('colour', kColourings),
      wall: choice('wall', ['triangle', 'component']),
      place: choice('place', ['centre', 'wall', 'edge']),
      tube: number('tube', 0.03, 0.005, 0.12),
      sight: number('sight', 3.4, 1, 8),
      mirror: this.wishes.get('mirror') === '1',
      ...Object.fromEntries(['lines', 'discs', 'faces', 'truncations'].map(
          (name) => [name, this.wishes.get(name) !== '0'])),
      ...Object.fromEntries(['hollow', 'labels', 'rate'].map(
          (name) => [name, this.wishes.get(name) === '1'])),
      cut: this.wishes.has('cut') ? number('cut', null, -100, 100) : null,
      transparent: this.wishes.has('transparent')
          ? Math.round(number('transparent', 0, 0, this.data.tetrahedron_count - 1)) : null,
      crossings: 60,
      identities: false,
    };
    const dark = matchMedia('(prefers-color-scheme: dark)').matches;
    setTheme(this.state, choice('theme', dark ? ['dark', 'light'] : ['light', 'dark']));
    if (!this.state.faces && !this.state.truncations) this.state.faces = true;
    // Keys of one character, and what they ask for.
    this.acts = new Map(this.data.keys.filter(([, name]) => name)
        .map(([key, name]) => [key.toLowerCase(), name]));
    for (const name of this.acts.values())
      if (!kActs[name]) throw new Error(`the action ${name} is missing`);
    this.problem = '';
    this.quality = 1;
    this.times = [];  // of frames in the last second
    this.stale = this.ticking = this.drew = this.stopped = false;
    this.last = null;  // when the last tick was, while they come
    this.fineTimer = 0;
  }

  start() {
    showKeys(this.data);
    showDiscScale(this.data.discs);
    this.manifold = new Manifold(this.data);
    this.orbit = new OrbitCamera();
    this.resetView();
    for (const name of ['yaw', 'pitch', 'distance'])
      this.orbit[name] = this.number(name, this.orbit[name], -100, 100);
    connectPanel(this.state, (name) => this.changed(name));
    for (const id of ['reset', 'save', 'link', 'theme', 'help'])
      element(id).addEventListener('click', () => this.act(id));
    this.controls = new Controls(this.canvas, this);
    this.hover = new Hover(this);
    this.canvas.addEventListener('webglcontextlost', (e) => {
      if (this.stopped) return;
      e.preventDefault();
      this.graphics = null;
      this.fail(kLost);
    });
    this.canvas.addEventListener('webglcontextrestored', () => this.connect());
    this.resized = new ResizeObserver(() => this.redraw());
    this.resized.observe(element('stage'));
    this.connect();
  }

  /// Gives the graphics card back, and draws no more; the elements can go then.
  stop() {
    this.stopped = true;
    clearTimeout(this.fineTimer);
    this.resized.disconnect();
    this.controls.stop();
    this.hover.clear();
    const gl = this.graphics?.gl;
    this.graphics = null;
    gl?.getExtension('WEBGL_lose_context')?.loseContext();
  }

  /// Makes everything that lives on the graphics card.
  connect() {
    try {
      this.graphics = new Graphics(this.canvas);
      const motion = this.views?.outside.motion;
      this.views = {outside: new OutsideView(this.graphics, this.manifold),
                    inside: new InsideView(this.graphics, this.manifold)};
      if (motion) this.views.outside.setMotion(motion);
      else this.restore();
      this.problem = '';
      showNotice('');
    } catch (error) {
      this.giveUp(error);
      return;
    }
    this.redraw();
  }

  /// Draws no more because of an error. One of a lost context says nothing: all that is asked of it
  /// is answered by null, before the page hears of the loss.
  giveUp(error) {
    const isLost = this.graphics?.gl.isContextLost();
    this.graphics = null;
    this.fail(isLost ? kLost : `This page cannot draw the manifold: ${error.message}\n\n` +
                               'The numbers beside it do not need graphics.');
  }

  fail(text) {
    this.problem = text;
    showNotice(text);
  }

  changed(name) {
    if (name === 'model') {
      this.orbit.reset(this.state.model);
      this.state.cut = null;
    }
    if (name === 'place') this.walker.place(this.state.place);
    this.redraw();
  }

  resetView() {
    this.orbit.reset(this.state.model);
    this.walker = new WalkCamera(this.manifold);
    this.walker.place(this.state.place);
    if (this.views && this.views.outside.moves > 0) this.views.outside.setMotion(Lorentz.identity);
  }

  /// Moves the cells against a direction (right, up, forward) of the camera.
  fly(way, distance) {
    const {axes} = this.orbit.view(1), size = Math.hypot(...way);
    const along = [0, 1, 2].map((k) => way[0] * axes[k] + way[1] * axes[3 + k] + way[2] * axes[6 + k]);
    const there = scaled3(along, -Math.sinh(distance) / size);
    const motion = Lorentz.orthonormalise(Lorentz.multiply(
        Lorentz.boostTo([...there, Math.cosh(distance)]), this.views.outside.motion));
    // Farther away they would be lost at the boundary of the model.
    if (motion[15] < 1000) this.views.outside.setMotion(motion);
  }

  act(name) {
    kActs[name](this);
    this.redraw();
  }

  /// What link() wrote of the cameras, beside what the constructor has read.
  restore() {
    const numbers = (name, count) => {
      const list = (this.wishes.get(name) ?? '').split(',').map(Number);
      return list.length === count && list.every((x) => Math.abs(x) < 1e6) ? list : null;
    };
    this.orbit.target = numbers('target', 3) ?? this.orbit.target;
    const motion = numbers('motion', 16);
    if (motion) this.views.outside.setMotion(Lorentz.orthonormalise(motion));
    const frame = numbers('frame', 16), t = Number(this.wishes.get('tetrahedron') ?? -1);
    if (!frame || !this.manifold.tetrahedra[t]) return;
    const stands = Lorentz.orthonormalise(frame), place = Lorentz.column(stands, 3);
    if (!standsIn(this.manifold.tetrahedra[t], place)) return;
    [this.walker.tetrahedron, this.walker.frame] = [t, stands];
  }

  /// The fragment of the address that shows this very view.
  fragment() {
    const {state, orbit, walker} = this;
    const wishes = new URLSearchParams({theme: state.themeName});
    for (const name of ['view', 'model', 'cells', 'explode', 'colour', 'wall', 'tube', 'sight'])
      wishes.set(name, state[name]);
    for (const name of kSwitches) wishes.set(name, state[name] ? '1' : '0');
    const short = (x) => Number(x.toPrecision(10));
    for (const name of ['cut', 'transparent'])
      if (state[name] !== null) wishes.set(name, short(state[name]));
    if (this.views.outside.moves > 0)
      wishes.set('motion', this.views.outside.motion.map(short).join(','));
    if (state.view === 'outside') {
      for (const name of ['yaw', 'pitch', 'distance']) wishes.set(name, short(orbit[name]));
      wishes.set('target', orbit.target.map(short).join(','));
    } else {
      wishes.set('tetrahedron', walker.tetrahedron);
      wishes.set('frame', walker.frame.map(short).join(','));
    }
    return wishes.toString().replaceAll('%2C', ',');
  }

  /// Makes the address of the page that of this view, and copies it where the browser lets us.
  link() {
    history.replaceState(null, '', '#' + this.address(this.fragment()));
    navigator.clipboard?.writeText(location.href).catch(() => {});
    this.hover.show('the address of this page is now that of this view');
  }

  /// The tetrahedron under the pointer, or none again.
  makeTransparent() {
    const {state, controls} = this;
    const before = state.transparent;
    state.transparent = null;
    if (before !== null || !controls.place || state.view === 'inside' || !this.graphics) return;
    const [low, high, wall] = this.identityAt(...controls.place);
    const cell = this.views.outside.cover.cells[low + 256 * high];
    if ((wall & 15) !== 0 && cell) state.transparent = cell.tetrahedron;
  }

  savePicture() {
    if (!this.graphics) return;
    if (this.state.view === 'inside' && this.graphics.canSum)
      for (let count = 1; count <= kRefinements; ++count) this.draw(1, count);
    else
      this.draw(2);
    this.canvas.toBlob((blob) => {
      const link = document.createElement('a');
      link.href = URL.createObjectURL(blob);
      link.download = `${this.state.view}.png`;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    });
  }

  redraw() {
    if (!this.graphics || this.wishes.has('dump')) return;
    this.stale = true;
    if (this.ticking) return;
    this.ticking = true;
    this.drew = false;
    this.times = [];
    clearTimeout(this.fineTimer);
    requestAnimationFrame((now) => this.tick(now));
  }

  /// Draws what has changed: quick and, on slow machines, coarse while things move; fine when they
  /// rest. It goes on for a while after the last change: the next tick tells how long a frame took,
  /// whenever the next change comes.
  tick(now) {
    const passed = now - (this.last ?? now);
    this.last = now;
    if (!this.graphics) {
      this.ticking = false;
      return;
    }
    if (this.drew) this.quality = nextQuality(this.quality, passed);
    this.drew = false;
    if (this.controls.advance(Math.min(passed, 100) / 1000)) this.stale = true;
    if (this.stale) {
      this.stale = false;
      this.drew = true;
      this.times = this.times.filter((time) => now - time < 1000);
      this.times.push(now);
      showLabels([]);
      this.draw(this.quality);
    }
    if (now - this.times.at(-1) < kRestAfter || this.drew) {
      requestAnimationFrame((next) => this.tick(next));
      return;
    }
    this.ticking = false;
    this.last = null;
    this.fineTimer = setTimeout(() => this.graphics && this.fine(), 0);
  }

  /// The resting picture. Inside, one sample after the other, each as quick as a frame; outside four
  /// samples a pixel, unless that would take this machine too long.
  fine() {
    if (this.state.view === 'inside' && this.graphics.canSum) {
      this.refine(1);
      return;
    }
    const begin = performance.now();
    this.draw(1);
    this.graphics.finish();
    if (performance.now() - begin < 300 || this.wishes.get('fine') === '1') this.draw(2);
    if (this.state.labels) showLabels(labelsOf(this));
  }

  /// Adds the `count`-th sample of each pixel, and goes on while nothing changes.
  refine(count) {
    if (this.ticking || !this.graphics) return;
    this.draw(1, count);
    if (count < kRefinements) requestAnimationFrame(() => this.refine(count + 1));
  }

  /// While things move; 0 before there are two of them.
  framesASecond() {
    const {times} = this, span = times.length ? times.at(-1) - times[0] : 0;
    return span > 0 ? 1000 * (times.length - 1) / span : 0;
  }

  /// Draws at `scale` pixels for one of the canvas; with a `count`, into the mean of so many pictures
  /// whose rays go through the pixels at other places.
  draw(scale, count = 0) {
    const {canvas, graphics, state} = this;
    if (!graphics) return;
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = this.fixedSize ??
        [canvas.clientWidth * ratio, canvas.clientHeight * ratio];
    const size = [width, height].map((x) => Math.min(4096, Math.max(1, Math.round(x))));
    if (canvas.width !== size[0] || canvas.height !== size[1])
      [canvas.width, canvas.height] = size;
    const [w, h] = size.map((x) => Math.min(4096, Math.max(1, Math.round(x * scale))));
    try {
      if (count > 0) graphics.beginMean(w, h, count);
      else graphics.begin(w, h, !state.identities);
      state.jitter = count > 0 ? [2, 3].map((base) => radicalInverse(count, base) - 0.5) : [0, 0];
      const camera = state.view === 'inside' ? this.walker : this.orbit;
      this.views[state.view].draw(state, camera, w, h, scale);
      graphics.present();
    } catch (error) {
      this.giveUp(error);
      return;
    }
    showState(this, Math.min(state.cells, this.views.outside.cover.cells.length));
    this.showStatus();
  }

  /// Where one is, and what the pointer rests on.
  showStatus() {
    const here = this.state.view === 'inside' ? [`in tetrahedron ${this.walker.tetrahedron}`] : [];
    if (this.state.rate)
      here.unshift(`${this.framesASecond().toFixed(0)} frames a second, ${
          Math.round(100 * this.quality)} % of the pixels across`);
    if (this.hover.text) here.push(this.hover.text);
    element('status').textContent = here.join('; seen: ');
  }

  /// The picture in common.glsl's kIdentities, the bottom row first.
  identities() {
    const {width, height} = this.canvas;
    this.drawIdentities();
    return {pixels: this.graphics.read(), width, height};
  }

  drawIdentities() {
    const {canvas: {width, height}, graphics, state} = this;
    const before = state.identities;
    state.identities = true;
    graphics.begin(width, height);
    this.views[state.view].draw(state, state.view === 'inside' ? this.walker : this.orbit, width,
                                height, 1);
    state.identities = before;
  }

  /// The four bytes of common.glsl's kIdentities at a place of the picture, x and y from 0 to 1.
  identityAt(x, y) {
    const {canvas: {width, height}, graphics} = this;
    this.drawIdentities();
    return graphics.readAt(Math.min(width - 1, Math.floor(x * width)),
                           Math.max(0, height - 1 - Math.floor(y * height)));
  }
}
