// Names of tetrahedra and edge classes over the picture, as labels_of of scene_words.cpp finds them.
const kReadablePixels = 500;

/// [{x, y, text}], x and y from 0 to 1 from the upper left corner, of what is seen from outside.
function labelsOf(page) {
  const {state, manifold} = page;
  if (state.view === 'inside' || !page.graphics) return [];
  const {pixels, width, height} = page.identities();
  const cellAt = (x, y) => {
    if (x < 0 || y < 0 || x >= width || y >= height) return -1;
    const at = 4 * ((height - 1 - y) * width + x);
    return (pixels[at + 2] & 15) === 0 ? -1 : pixels[at] + 256 * pixels[at + 1];
  };
  const wallAt = (x, y) => (pixels[4 * ((height - 1 - y) * width + x) + 2] & 15) - 1;
  const isNear = (x, y, cell) => {
    for (let j = -2; j <= 2; ++j)
      for (let i = -2; i <= 2; ++i)
        if (cellAt(Math.floor(x) + i, Math.floor(y) + j) === cell) return true;
    return false;
  };
  const seen = new Map();
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const cell = cellAt(x, y);
      if (cell < 0) continue;
      if (!seen.has(cell)) seen.set(cell, {count: 0, x: 0, y: 0});
      const here = seen.get(cell);
      ++here.count;
      here.x += x;
      here.y += y;
    }
  const labels = [], view = page.orbit.view(width / height);
  const add = (x, y, text) => {
    if (!labels.some((other) => Math.abs(other.x * width - x) < 24 &&
                                Math.abs(other.y * height - y) < 14))
      labels.push({x: x / width, y: y / height, text});
  };
  const outside = page.views.outside, model = kModels[state.model];
  const toModel = outside.toModel(state.model);
  for (const [number, {count, x, y}] of seen) {
    if (count < kReadablePixels) continue;
    const cell = outside.cover.cells[number], t = cell.tetrahedron;
    if (isNear(x / count, y / count, number)) add(x / count, y / count, `${t}`);
    if (state.explode > 0) continue;  // edges are elsewhere then
    const isometry = Lorentz.multiply(toModel, cell.isometry);
    const {corners, faces, edges} = manifold.tetrahedra[t];
    kEdgeEnds.forEach(([v, w], e) => {
      const ends = [[v, w], [w, v]].map(
          ([i, j]) => corners.find((c) => c.vertex === i && c.other === j).point);
      // Of a parabolic edge its wall has the name.
      const middle = edges[e]
          ? onHorosphere(Lorentz.combine(0.5, ends[0], 0.5, ends[1]), edges[e].wall)
          : Lorentz.toPoint(Lorentz.combine(1, ends[0], 1, ends[1]));
      const p = model.place(Lorentz.apply(isometry, middle));
      const away = p.map((value, k) => value - view.eye[k]);
      const [right, up, ahead] = [0, 3, 6].map((k) => dot3(view.axes.slice(k, k + 3), away));
      const px = (right / ahead / view.tangent[0] + 1) / 2 * width;
      const py = (1 - up / ahead / view.tangent[1]) / 2 * height;
      if (!(ahead > 0 && px >= 0 && py >= 0 && px < width && py < height)) return;
      // One of its two faces must turn its outer side to the eye, or that wall must be seen.
      const turns = (f) => {
        const {A, b, C} = model.halfSpace(Lorentz.apply(isometry, faces[f]));
        return A * dot3(view.eye, view.eye) + 2 * dot3(b, view.eye) + C > 0;
      };
      const towards = edges[e] ? wallAt(Math.floor(px), Math.floor(py)) === kPlainWalls + e
                               : kEdgeFaces[e].some(turns);
      if (towards && isNear(px, py, number)) add(px, py, `e${manifold.edgeClass[t][e]}`);
    });
  }
  return labels;
}

function showLabels(labels) {
  element('names').replaceChildren(...labels.map(({x, y, text}) => {
    const span = document.createElement('span');
    span.textContent = text;
    span.style.left = `${100 * x}%`;
    span.style.top = `${100 * y}%`;
    return span;
  }));
}
