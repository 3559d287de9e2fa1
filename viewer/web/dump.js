// For tests: #dump=1&size=200x150&... draws a picture of that size and writes what it saw as JSON into
// the page, where a browser without a screen can print it; several of them with | between.
const kDumpWays = {forward: [0, 0, 1], back: [0, 0, -1], right: [1, 0, 0], left: [-1, 0, 0],
                   up: [0, 1, 0], down: [0, -1, 0]};

function hexOf(pixels) {
  let text = '';
  for (const byte of pixels) text += byte.toString(16).padStart(2, '0');
  return text;
}

/// keys=w:2,q:1 holds keys for so many seconds; drag=30:-20 drags by so many pixels.
function act(page) {
  const send = (type, event) => page.canvas.dispatchEvent(event(type));
  for (const part of (page.wishes.get('keys') ?? '').split(',').filter(Boolean)) {
    const [name, seconds] = part.split(':');
    const key = decodeURIComponent(name);
    const event = (type) => new KeyboardEvent(type, {key, cancelable: true});
    send('keydown', event);
    for (let passed = 0; passed < Number(seconds); passed += 0.02) page.controls.advance(0.02);
    send('keyup', event);
  }
  // wheel=100:20:30 turns the wheel over a place.
  if (page.wishes.has('wheel')) {
    const [deltaY, clientX, clientY] = page.wishes.get('wheel').split(':').map(Number);
    send('wheel', (type) => new WheelEvent(type, {deltaY, clientX, clientY, cancelable: true}));
  }
  // pinch=1.5: two fingers move apart, or together.
  if (page.wishes.has('pinch')) {
    const finger = (pointerId, x, y) => (type) => new PointerEvent(
        type, {pointerId, pointerType: 'touch', clientX: x, clientY: y, buttons: 1});
    const spread = Number(page.wishes.get('pinch'));
    send('pointerdown', finger(11, 100, 100));
    send('pointerdown', finger(12, 200, 100));
    send('pointermove', finger(12, 100 + 100 * spread, 100));
    send('pointerup', finger(12, 100 + 100 * spread, 100));
    send('pointerup', finger(11, 100, 100));
  }
  if (!page.wishes.has('drag')) return;
  const [dx, dy] = page.wishes.get('drag').split(':').map(Number);
  const event = (x, y) => (type) =>
      new PointerEvent(type, {pointerId: 7, clientX: 50 + x, clientY: 50 + y, buttons: 1});
  send('pointerdown', event(0, 0));
  send('pointermove', event(dx, dy));
  send('pointerup', event(dx, dy));
}

function dump(page) {
  const out = {problem: page.problem};
  if (page.graphics) {
    const [width, height] = (page.wishes.get('size') ?? '200x150').split('x').map(Number);
    page.fixedSize = [width, height];
    // polygons=whole: each face that may be seen has all pixels for its polygon.
    if (page.wishes.get('polygons') === 'whole')
      for (const {mesh} of page.views.outside.faces.kinds) mesh.isWhole = true;
    act(page);
    // walk=forward:2,right:0.5: one after the other
    for (const part of (page.wishes.get('walk') ?? '').split(',').filter(Boolean)) {
      const [way, distance] = part.split(':');
      out.touched = page.walker.walk(kDumpWays[way], Number(distance));
    }
    Object.assign(out, {view: page.state.view, model: page.state.model, width, height, yaw: page.orbit.yaw, pitch: page.orbit.pitch,
                        distance: page.orbit.distance, frame: page.walker.frame,
                        tetrahedron: page.walker.tetrahedron,
                        camera: page.orbit.view(width / height),
                        toModel: page.views.outside.toModel(page.state.model)});
    const picture = (identities) => {
      page.state.identities = identities;
      page.draw(1);
      return page.graphics ? hexOf(page.graphics.read()) : '';
    };
    out.identities = picture(true);
    out.colours = picture(false);
    // refine=16: what inside becomes after so many samples.
    const samples = Number(page.wishes.get('refine') ?? 0);
    for (let count = 1; count <= samples; ++count) page.draw(1, count);
    if (samples > 0) out.colours = hexOf(page.graphics.readCanvas());
    // hover=0.5:0.5,0.2:0.7: what is said of these places, x and y from the upper left corner.
    out.hover = (page.wishes.get('hover') ?? '').split(',').filter(Boolean)
        .map((place) => page.hover.at(...place.split(':').map(Number)));
    const frames = Number(page.wishes.get('frames') ?? 0);
    const begin = performance.now();
    for (let i = 0; i < frames; ++i) {
      page.draw(1);
      page.graphics.finish();
    }
    out.milliseconds = frames ? (performance.now() - begin) / frames : null;
    // motion=10: what the share of pixels across becomes in so many frames while the camera turns;
    // paces=200:10,5:10: what it would become in frames that take so many milliseconds, so many times.
    out.motion = [];
    for (let i = 0; i < Number(page.wishes.get('motion') ?? 0); ++i) {
      const start = performance.now();
      page.orbit.turn(0.02, 0);
      page.draw(page.quality);
      page.graphics.finish();
      const milliseconds = performance.now() - start;
      out.motion.push({quality: page.quality, milliseconds});
      page.quality = nextQuality(page.quality, milliseconds);
    }
    out.paces = (page.wishes.get('paces') ?? '').split(',').filter(Boolean).map((pace) => {
      const [milliseconds, times] = pace.split(':').map(Number);
      for (let i = 0; i < times; ++i) page.quality = nextQuality(page.quality, milliseconds);
      return page.quality;
    });
    out.fragment = page.fragment();
    out.labels = page.state.labels ? labelsOf(page) : [];
    out.state = {...page.state};
    out.target = page.orbit.target;
    out.cells = page.views.outside.cover.cells.slice(0, page.state.cells)
        .map((cell) => ({...cell, centre: Lorentz.column(cell.isometry, 3)}));
    out.error = page.graphics?.gl.getError() ?? 0;
    out.problem = page.problem;
  }
  return out;
}

function writeDump(pictures) {
  const pre = document.createElement('pre');
  pre.id = 'dump';
  pre.hidden = true;
  pre.textContent = JSON.stringify(pictures);
  document.body.append(pre);
}
