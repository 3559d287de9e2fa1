// Mouse, touch and keys. One pointer turns, two zoom and shift; keys walk as long as they are held.
// Letters move the cells by Moebius maps outside, arrows turn them.
const kKeyWays = {
  w: [0, 0, 1], arrowup: [0, 0, 1], s: [0, 0, -1], arrowdown: [0, 0, -1], a: [-1, 0, 0],
  d: [1, 0, 0], r: [0, 1, 0], f: [0, -1, 0], forward: [0, 0, 1], back: [0, 0, -1],
};
const kKeyTurns = {arrowleft: [-1, 0], arrowright: [1, 0], q: [0, -1], e: [0, 1]};

/// Keeps a pointer's events coming when it leaves the element; it may be gone already.
function capture(target, pointerId) {
  try {
    target.setPointerCapture(pointerId);
  } catch (error) {
    if (error.name !== 'NotFoundError') throw error;
  }
}

class Controls {
  /// `page` has state, orbit, walker, act(name) and redraw().
  constructor(canvas, page) {
    this.canvas = canvas;
    this.page = page;
    this.pointers = new Map();
    this.held = new Set();
    this.place = null;  // of the pointer on the picture, x and y from 0 to 1
    const listen = (type, handler, options) => canvas.addEventListener(type, handler, options);
    listen('pointerdown', (e) => this.down(e));
    listen('pointermove', (e) => this.move(e));
    for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'])
      listen(type, (e) => this.pointers.delete(e.pointerId));
    listen('wheel', (e) => this.wheel(e), {passive: false});
    listen('contextmenu', (e) => e.preventDefault());
    listen('keydown', (e) => this.key(e));
    listen('keyup', (e) => this.held.delete(e.key.toLowerCase()));
    listen('blur', () => this.held.clear());
    this.release = () => this.held.clear();
    window.addEventListener('blur', this.release);
    for (const button of document.querySelectorAll('[data-hold]')) this.hold(button);
  }

  stop() { window.removeEventListener('blur', this.release); }

  get inside() { return this.page.state.view === 'inside'; }

  hold(button) {
    const name = button.dataset.hold;
    button.addEventListener('pointerdown', (e) => {
      e.preventDefault();
      capture(button, e.pointerId);
      this.held.add(name);
      this.page.redraw();
    });
    for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'])
      button.addEventListener(type, () => this.held.delete(name));
    button.addEventListener('contextmenu', (e) => e.preventDefault());
  }

  down(e) {
    this.canvas.focus({preventScroll: true});
    capture(this.canvas, e.pointerId);
    this.pointers.set(e.pointerId, [e.clientX, e.clientY]);
  }

  move(e) {
    const box = this.canvas.getBoundingClientRect();
    this.place = [(e.clientX - box.left) / box.width, (e.clientY - box.top) / box.height];
    const before = this.pointers.get(e.pointerId);
    if (!before) return;
    const now = [e.clientX, e.clientY];
    const size = Math.min(this.canvas.clientWidth, this.canvas.clientHeight) || 1;
    const [dx, dy] = [(now[0] - before[0]) / size, (now[1] - before[1]) / size];
    if (this.pointers.size >= 2) {
      this.pinch(e.pointerId, before, now, dx, dy);
    } else if (this.inside) {
      this.page.walker.turn(-dx * 1.6, dy * 1.6);
    } else if (e.shiftKey || (e.buttons & 2)) {
      this.page.orbit.pan(0.7 * dx, 0.7 * dy);
    } else {
      this.page.orbit.turn(dx * 3.2, dy * 3.2);
    }
    this.pointers.set(e.pointerId, now);
    this.page.redraw();
  }

  pinch(id, before, now, dx, dy) {
    const other = [...this.pointers].find(([key]) => key !== id)[1];
    const spread = (p) => Math.max(8, Math.hypot(p[0] - other[0], p[1] - other[1]));
    const ratio = spread(now) / spread(before);
    if (this.inside) {
      this.page.walker.walk([0, 0, Math.sign(Math.log(ratio)) || 1], Math.abs(Math.log(ratio)));
    } else {
      this.page.orbit.zoom(1 / ratio);
      this.page.orbit.pan(0.35 * dx, 0.35 * dy);
    }
  }

  wheel(e) {
    e.preventDefault();
    const amount = Math.max(-1, Math.min(1, e.deltaY * (e.deltaMode === 1 ? 0.05 : 0.002)));
    if (this.inside) {
      this.page.walker.walk([0, 0, -Math.sign(amount)], Math.abs(amount) * 0.4);
    } else {
      const box = this.canvas.getBoundingClientRect();
      this.page.orbit.zoomAt(Math.exp(amount), 2 * (e.clientX - box.left) / box.width - 1,
                             1 - 2 * (e.clientY - box.top) / box.height, box.width / box.height);
    }
    this.page.redraw();
  }

  key(e) {
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    const key = e.key.toLowerCase();
    if (this.page.acts.has(key)) {
      this.page.act(this.page.acts.get(key));
    } else if (kKeyWays[key] || kKeyTurns[key] || key === '+' || key === '-' || key === '=') {
      this.held.add(key);
    } else {
      return;
    }
    e.preventDefault();
    this.page.redraw();
  }

  /// Moves by what is held for `seconds`; returns whether anything was.
  advance(seconds) {
    if (this.held.size === 0) return false;
    let [way, flight, turn, roll, zoom] = [[0, 0, 0], [0, 0, 0], [0, 0], 0, 0];
    for (const key of this.held) {
      if (kKeyWays[key]) way = way.map((x, i) => x + kKeyWays[key][i]);
      if (kKeyWays[key] && key.length === 1) flight = flight.map((x, i) => x + kKeyWays[key][i]);
      if (kKeyTurns[key]) [turn[0], roll] = [turn[0] + kKeyTurns[key][0], roll + kKeyTurns[key][1]];
      if (key === '+' || key === '=') --zoom;
      if (key === '-') ++zoom;
    }
    if (this.inside) {
      this.page.walker.turn(turn[0] * seconds, 0, roll * seconds);
      if (way.some((x) => x !== 0)) this.page.walker.walk(way, 0.6 * seconds);
    } else {
      this.page.orbit.turn(turn[0] * seconds * 1.5, (flight[2] - way[2]) * seconds * 1.2);
      if (flight.some((x) => x !== 0)) this.page.fly(flight, 0.6 * seconds);
      this.page.orbit.zoom(Math.exp(zoom * seconds));
    }
    return true;
  }
}
