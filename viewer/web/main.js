// The page: its state, what draws it, and when.

/// While things move, frames are drawn so coarsely that they take about so long, in milliseconds, but
/// not with fewer than this share of the pixels across.
const kMovingFrame = 40, kCoarsest = 0.15;

/// How coarse the next frame should be, when one of `quality` took so long: pixels cost time in
/// proportion to their number.
function nextQuality(quality, milliseconds) {
  const wanted = quality * Math.sqrt(kMovingFrame / Math.max(milliseconds, 1));
  const slowly = Math.min(1.06 * quality, Math.max(0.4 * quality, wanted));
  return Math.min(1, Math.max(kCoarsest, slowly));
}

class Page {
  /// `fragment`: what the address of the page wishes for, such as view=inside&place=wall.
  constructor(fragment) {
    this.data = JSON.parse(element('manifold-data').textContent);
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
      colour: choice('colour', ['tetrahedron', 'depth', 'face']),
      wall: choice('wall', ['triangle', 'component']),
      place: choice('place', ['centre', 'wall', 'edge']),
      tube: number('tube', 0.03, 0.005, 0.12),
      sight: number('sight', 3.4, 1, 8),
      mirror: this.wishes.get('mirror') === '1',
      lines: this.wishes.get('lines') !== '0',
      discs: this.wishes.get('discs') !== '0',
      crossings: 60,
      identities: false,
    };
    const dark = matchMedia('(prefers-color-scheme: dark)').matches;
    setTheme(this.state, choice('theme', dark ? ['dark', 'light'] : ['light', 'dark']));
    this.problem = '';
    this.quality = 1;
    this.waiting = false;
    this.last = this.done = 0;
    this.rested = true;
    this.fineTimer = 0;
  }

  start() {
    showFacts(this.data);
    showDiscScale(this.data.discs);
    this.manifold = new Manifold(this.data);
    this.orbit = new OrbitCamera();
    this.resetView();
    for (const name of ['yaw', 'pitch', 'distance'])
      this.orbit[name] = this.number(name, this.orbit[name], -100, 100);
    this.restore();
    connectPanel(this.state, (name) => this.changed(name));
    for (const id of ['reset', 'save', 'link']) element(id).addEventListener('click', () => this.act(id));
    this.controls = new Controls(this.canvas, this);
    this.hover = new Hover(this);
    this.canvas.addEventListener('webglcontextlost', (e) => {
      e.preventDefault();
      this.graphics = null;
      this.fail('The graphics card has given up on this page. It will be drawn again when the ' +
                'browser gives the graphics back; otherwise reload the page.');
    });
    this.canvas.addEventListener('webglcontextrestored', () => this.connect());
    new ResizeObserver(() => this.redraw()).observe(element('stage'));
    this.connect();
  }

  /// Makes everything that lives on the graphics card.
  connect() {
    try {
      this.graphics = new Graphics(this.canvas);
      this.views = {outside: new OutsideView(this.graphics, this.manifold),
                    inside: new InsideView(this.graphics, this.manifold)};
      this.problem = '';
      showNotice('');
    } catch (error) {
      this.graphics = null;
      this.fail(`This page cannot draw the manifold: ${error.message}\n\n` +
                'The numbers beside it do not need graphics.');
      return;
    }
    this.redraw();
  }

  fail(text) {
    this.problem = text;
    showNotice(text);
  }

  changed(name) {
    if (name === 'model') this.orbit.reset(this.state.model);
    if (name === 'place') this.walker.place(this.state.place);
    this.redraw();
  }

  resetView() {
    this.orbit.reset(this.state.model);
    this.walker = new WalkCamera(this.manifold);
    this.walker.place(this.state.place);
  }

  act(name) {
    if (name === 'change view') this.state.view = this.state.view === 'inside' ? 'outside' : 'inside';
    const after = (choices, one) => choices[(choices.indexOf(one) + 1) % choices.length];
    if (name === 'change model') {
      this.state.model = after(['ball', 'upper', 'klein'], this.state.model);
      this.orbit.reset(this.state.model);
    }
    if (name === 'change colour')
      this.state.colour = after(['tetrahedron', 'depth', 'face'], this.state.colour);
    if (name === 'link') this.link();
    if (name === 'reset') this.resetView();
    if (name === 'save') this.savePicture();
    if (name === 'help') element('help-text').showModal();
    this.redraw();
  }

  /// What link() wrote of the cameras, beside what the constructor has read.
  restore() {
    const numbers = (name, count) => {
      const list = (this.wishes.get(name) ?? '').split(',').map(Number);
      return list.length === count && list.every((x) => Math.abs(x) < 1e6) ? list : null;
    };
    this.orbit.target = numbers('target', 3) ?? this.orbit.target;
    const frame = numbers('frame', 16), t = Number(this.wishes.get('tetrahedron') ?? -1);
    if (!frame || !this.manifold.tetrahedra[t]) return;
    const stands = Lorentz.orthonormalise(frame), place = Lorentz.column(stands, 3);
    const {faces, vertices} = this.manifold.tetrahedra[t];
    if (![...faces, ...vertices].every((n) => Lorentz.dot(n, place) <= 1e-6)) return;
    [this.walker.tetrahedron, this.walker.frame] = [t, stands];
  }

  /// The fragment of the address that shows this very view.
  fragment() {
    const {state, orbit, walker} = this;
    const wishes = new URLSearchParams({theme: state.themeName});
    for (const name of ['view', 'model', 'cells', 'explode', 'colour', 'wall', 'tube', 'sight'])
      wishes.set(name, state[name]);
    for (const name of ['mirror', 'lines', 'discs']) wishes.set(name, state[name] ? '1' : '0');
    const short = (x) => Number(x.toPrecision(10));
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
    history.replaceState(null, '', '#' + this.fragment());
    navigator.clipboard?.writeText(location.href).catch(() => {});
    this.hover.show('the address of this page is now that of this view');
  }

  savePicture() {
    if (!this.graphics) return;
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
    if (this.waiting || !this.graphics || this.wishes.has('dump')) return;
    this.waiting = true;
    this.rested = performance.now() - this.done > 60;
    requestAnimationFrame((now) => this.frame(now));
  }

  /// A frame: quick and, on slow machines, coarse while things move; fine when they rest.
  frame(now) {
    this.waiting = false;
    if (!this.graphics) return;
    const passed = now - this.last;
    this.last = now;
    const moving = this.controls.advance(Math.min(passed, 100) / 1000);
    if (!this.rested) this.quality = nextQuality(this.quality, passed);
    this.draw(this.quality);
    clearTimeout(this.fineTimer);
    if (moving) this.redraw();
    else this.fineTimer = setTimeout(() => this.graphics && this.fine(), 160);
    this.done = performance.now();
  }

  /// The resting picture: four samples a pixel, unless that would take this machine too long.
  fine() {
    const begin = performance.now();
    this.draw(1);
    this.graphics.finish();
    if (performance.now() - begin < 300 || this.wishes.get('fine') === '1') this.draw(2);
  }

  /// Draws at `scale` pixels for one of the canvas.
  draw(scale) {
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
      graphics.begin(w, h);
      const camera = state.view === 'inside' ? this.walker : this.orbit;
      this.views[state.view].draw(state, camera, w, h, scale);
      graphics.present();
    } catch (error) {
      this.fail(`This page cannot draw the manifold: ${error.message}`);
      this.graphics = null;
      return;
    }
    showState(state, Math.min(state.cells, this.views.outside.cover.cells.length));
    this.showStatus();
  }

  /// Where one is, and what the pointer rests on.
  showStatus() {
    const here = this.state.view === 'inside' ? [`in tetrahedron ${this.walker.tetrahedron}`] : [];
    if (this.hover.text) here.push(this.hover.text);
    element('status').textContent = here.join('; seen: ');
  }

  /// The four bytes of common.glsl's kIdentities at a place of the picture, x and y from 0 to 1.
  identityAt(x, y) {
    const {canvas, graphics, state} = this;
    const {width, height} = canvas;
    const before = state.identities;
    state.identities = true;
    graphics.begin(width, height);
    this.views[state.view].draw(state, state.view === 'inside' ? this.walker : this.orbit, width,
                                height, 1);
    state.identities = before;
    return graphics.readAt(Math.min(width - 1, Math.floor(x * width)),
                           Math.max(0, height - 1 - Math.floor(y * height)));
  }
}

function main() {
  try {
    const pages = location.hash.slice(1).split('|').map((fragment) => {
      const page = new Page(fragment);
      page.start();
      return page.wishes.has('dump') ? dump(page) : null;
    });
    if (pages.some((page) => page)) writeDump(pages);
  } catch (error) {
    showNotice(`This page has failed: ${error.message}`);
    throw error;
  }
}
main();
