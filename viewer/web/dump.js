// For tests: #dump=1&size=200x150&... draws one picture of that size and writes what it saw as JSON
// into the page, where a browser without a screen can print it.
const kDumpWays = {forward: [0, 0, 1], back: [0, 0, -1], right: [1, 0, 0], left: [-1, 0, 0],
                   up: [0, 1, 0], down: [0, -1, 0]};

function hexOf(pixels) {
  let text = '';
  for (const byte of pixels) text += byte.toString(16).padStart(2, '0');
  return text;
}

function dump(page) {
  const out = {problem: page.problem, view: page.state.view, model: page.state.model};
  if (page.graphics) {
    const [width, height] = (page.wishes.get('size') ?? '200x150').split('x').map(Number);
    page.fixedSize = [width, height];
    // walk=forward:2,right:0.5 and turn=dx:dy:roll, one after the other
    for (const part of (page.wishes.get('walk') ?? '').split(',').filter(Boolean)) {
      const [way, distance] = part.split(':');
      out.touched = page.walker.walk(kDumpWays[way], Number(distance));
    }
    Object.assign(out, {width, height, frame: page.walker.frame,
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
    const frames = Number(page.wishes.get('frames') ?? 0);
    const begin = performance.now();
    for (let i = 0; i < frames; ++i) {
      page.draw(1);
      page.graphics.finish();
    }
    out.milliseconds = frames ? (performance.now() - begin) / frames : null;
    out.cells = page.views.outside.cover.cells.slice(0, page.state.cells)
        .map((cell) => ({...cell, centre: Lorentz.column(cell.isometry, 3)}));
    out.error = page.graphics?.gl.getError() ?? 0;
    out.problem = page.problem;
  }
  const pre = document.createElement('pre');
  pre.id = 'dump';
  pre.hidden = true;
  pre.textContent = JSON.stringify(out);
  document.body.append(pre);
}
