// The outside view: cells of the universal cover, in the ball or in the upper half-space.
const kCellTexels = 19;
const kCellsPerRow = 100;
/// Of the background, in each of which it changes evenly.
const kSkyStrips = 32;

/// What the upper half-space and the ball make of the hyperboloid model. In both a half-space
/// <n, x> <= 0, and what is outside a horoball, <v, x> <= -1, becomes A |p|^2 + 2 b.p + C <= 0; in
/// the Klein ball the latter is A |p|^2 + 2 b.p + C - 2 (d.p)^2 <= 0.
const kModels = {
  upper: {
    number: 0,
    // The hyperboloid's point, up to a factor, is this times (p, |p|^2, 1), column by column.
    points: [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0], [0, 0, 0.5, 0.5], [0, 0, -0.5, 0.5]],
    halfSpace: (n) => ({A: n[2] - n[3], b: [n[0], n[1], 0], C: -(n[2] + n[3])}),
    horosphere: (v) => ({A: v[2] - v[3], b: [v[0], v[1], 1], C: -(v[2] + v[3])}),
    sphere(centre, radius) {
      const height = 1 / (centre[3] - centre[2]);
      return {at: [centre[0] * height, centre[1] * height, Math.cosh(radius) * height],
              radius: Math.sinh(radius) * height};
    },
    ballOf(centre, radius) {
      const {at, radius: r} = this.sphere(centre, radius);
      return [...at, r];
    },
    place(x) {
      const height = 1 / (x[3] - x[2]);
      const size = Math.sqrt(Math.max(-Lorentz.dot(x, x), 1e-300));
      return [x[0] * height, x[1] * height, size * height];
    },
    /// Edge 01 of the root upwards in the middle, as in the paper; the truncation of vertex 1
    /// becomes the unit hemisphere, and everything lies under it. Of a parabolic edge the next one.
    frame(root) {
      const {faces} = root;
      const edge = kEdgeEnds.findIndex((_, e) => !root.edges[e]);
      if (edge < 0) return this.frameOfTruncation(root);
      const [v, w] = kEdgeEnds[edge], [k, l] = kEdgeFaces[edge];
      const [point, below] = [[w, v], [v, w]].map(
          ([i, j]) => root.corners.find((c) => c.vertex === i && c.other === j).point);
      const unit = (x) => Lorentz.scale(x, 1 / Math.sqrt(Lorentz.dot(x, x)));
      const inward = unit(Lorentz.combine(-1, faces[k], -1, faces[l]));
      const across = unit(Lorentz.combine(-1, faces[k], 1, faces[l]));
      // Along the edge; of a hyperideal vertex this is its pole.
      const upwards = root.diagonal[w] > 0
          ? root.vertices[w]
          : unit(Lorentz.combine(-1, below, -Lorentz.dot(below, point), point));
      const frame = Lorentz.fromColumns([inward, across, upwards, point]);
      return determinant(frame) > 0
          ? frame
          : Lorentz.fromColumns([inward, Lorentz.scale(across, -1), upwards, point]);
    },
    /// The same where all edges are parabolic: where the truncation is nearest to the centre.
    frameOfTruncation({vertices, faces}) {
      const pole = vertices[1];
      const point =
          Lorentz.toPoint(Lorentz.combine(1, Lorentz.origin, -Lorentz.dot(Lorentz.origin, pole), pole));
      const axes = [pole];
      for (const n of [faces[2], faces[3]]) {
        let x = Lorentz.combine(-1, n, -Lorentz.dot(n, point), point);
        for (const axis of axes) x = Lorentz.combine(1, x, -Lorentz.dot(x, axis), axis);
        axes.push(Lorentz.scale(x, 1 / Math.sqrt(Lorentz.dot(x, x))));
      }
      const [upwards, inward, across] = axes;
      const frame = Lorentz.fromColumns([inward, across, upwards, point]);
      return determinant(frame) > 0
          ? frame
          : Lorentz.fromColumns([inward, Lorentz.scale(across, -1), upwards, point]);
    },
    view: {target: [0, 0, 0.34], yaw: 0.45, pitch: 0.42, distance: 3.5},
  },
  ball: {
    number: 1,
    points: [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 0.5], [0, 0, 0, 0.5]],
    halfSpace: (n) => ({A: -n[3], b: n.slice(0, 3), C: -n[3]}),
    horosphere: (v) => ({A: -v[3] - 1, b: v.slice(0, 3), C: 1 - v[3]}),
    sphere(centre, radius) {
      const scale = 1 / (centre[3] + Math.cosh(radius));
      return {at: centre.slice(0, 3).map((x) => x * scale), radius: Math.sinh(radius) * scale};
    },
    ballOf(centre, radius) {
      const {at, radius: r} = this.sphere(centre, radius);
      return [...at, r];
    },
    place(x) {
      const scale = 1 / (x[3] + Math.sqrt(Math.max(-Lorentz.dot(x, x), 1e-300)));
      return [x[0] * scale, x[1] * scale, x[2] * scale];
    },
    /// The centre of the root in the middle, its vertex 3 upwards.
    frame: () => Lorentz.identity,
    view: {target: [0, 0, 0], yaw: 0.5, pitch: 0.35, distance: 3.5},
  },
  klein: {
    number: 2,
    points: [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 0], [0, 0, 0, 1]],
    halfSpace(n) {
      const length = Math.hypot(n[0], n[1], n[2]);
      return {A: 0, b: n.slice(0, 3).map((x) => x / length), C: -2 * n[3] / length};
    },
    horosphere(v) {
      const p = v.slice(0, 3), t = v[3];
      return {A: -1, b: scaled3(p, t), C: 1 - t * t, d: scaled3(p, Math.SQRT1_2)};
    },
    /// Cells are in the hulls of their corners.
    ballOf(centre, radius, corners) {
      const points = corners();
      const at = [0, 1, 2].map((k) => points.reduce((sum, p) => sum + p[k], 0) / points.length);
      return [...at, Math.max(...points.map((p) => Math.hypot(...p.map((x, k) => x - at[k]))))];
    },
    place: (x) => [x[0] / x[3], x[1] / x[3], x[2] / x[3]],
    frame: () => Lorentz.identity,
    view: {target: [0, 0, 0], yaw: 0.5, pitch: 0.35, distance: 3.5},
  },
};

const dot3 = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const scaled3 = (a, s) => a.map((x) => x * s);
const cross3 = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                          a[0] * b[1] - a[1] * b[0]];

function determinant(m) {
  const minor = (rows, columns) => (rows.length === 0 ? 1 : columns.reduce((sum, c, k) =>
      sum + (k % 2 ? -1 : 1) * m[4 * rows[0] + c] *
          minor(rows.slice(1), columns.filter((other) => other !== c)), 0));
  return minor([0, 1, 2, 3], [0, 1, 2, 3]);
}

/// From points at + radius u of the model to the hyperboloid in the tetrahedron's coordinates:
/// five columns that (u, |u|^2, 1) is multiplied with. The result is the point over s, where u
/// moves s of hyperbolic length for one of its own.
function toTetrahedron(isometry, model, at, radius) {
  const inverse = Lorentz.inverse(isometry);
  const [x, y, z, square, one] = model.points;
  const sum = (terms) => Lorentz.apply(inverse, [0, 1, 2, 3].map(
      (i) => terms.reduce((total, [factor, column]) => total + factor * column[i], 0)));
  const axes = [x, y, z];
  return [...axes.map((axis, k) => sum([[1, axis], [2 * at[k], square]])),
          sum([[radius, square]]),
          sum([...axes.map((axis, k) => [at[k] / radius, axis]),
               [dot3(at, at) / radius, square], [1 / radius, one]])].flat();
}

class OutsideView {
  constructor(graphics, manifold) {
    this.graphics = graphics;
    this.manifold = manifold;
    this.cover = new UniversalCover(manifold);
    this.records = {upper: [], ball: []};
    this.sets = {};
    this.moves = 0;  // so often have cells been moved
    this.motion = Lorentz.identity;
    this.texture = null;
    this.shown = '';
    this.connect();
  }

  /// Makes what lives on the graphics card, at the start and after it was lost.
  connect() {
    this.cells = null;
    this.discs = this.manifold.discs.texture(this.graphics);
    this.faces = new FaceDrawing(this.graphics, this.manifold, this.discs);
    this.tubes = new TubeDrawing(this.graphics);
    this.grounds = {};
    this.shown = '';
  }

  /// The isometry from the coordinates of the root to those of the model.
  toModel(model) {
    return Lorentz.multiply(this.motion,
                            Lorentz.inverse(kModels[model].frame(this.manifold.tetrahedra[0])));
  }

  /// Moves all cells from where they stood at first.
  setMotion(motion) {
    this.motion = motion;
    ++this.moves;
    this.sets = {};
    this.records = {upper: [], ball: []};
    this.shown = '';
  }

  /// 19 x 4 numbers of a cell for the shader; see outside.frag.glsl.
  record(cell, model, toModel) {
    const {sphere} = kModels[model];
    const tetrahedron = this.manifold.tetrahedra[cell.tetrahedron];
    const isometry = Lorentz.multiply(toModel, cell.isometry);
    const {at, radius} =
        sphere(Lorentz.apply(isometry, tetrahedron.ball.centre), tetrahedron.ball.radius);
    const numbers = new Float32Array(4 * kCellTexels);
    wallsOf(tetrahedron, isometry, kModels[model]).forEach(({A, b, C}, i) => {
      numbers.set([...b.map((x, k) => x + A * at[k]), A * radius], 4 * i);
      numbers[32 + i] = (A * dot3(at, at) + 2 * dot3(b, at) + C) / radius;
    });
    numbers.set([...at, radius], 40);
    numbers.set([...paletteColour(cell.tetrahedron), cell.depth], 44);
    numbers.set(this.manifold.faceClass[cell.tetrahedron], 48);
    numbers.set(toTetrahedron(isometry, kModels[model], at, radius), 52);
    const tile = 4 * cell.tetrahedron;
    numbers.set(this.manifold.discs.first.slice(tile, tile + 4), 72);
    return numbers;
  }

  /// Sends the first `count` cells to the graphics card; returns how many there are.
  upload(count, model) {
    const cells = this.cover.grow(count);
    const key = `${model} ${cells.length} ${this.moves}`;
    if (key === this.shown) return cells.length;
    const records = this.records[model];
    const toModel = this.toModel(model);
    while (records.length < cells.length)
      records.push(this.record(cells[records.length], model, toModel));
    const numbers = new Float32Array(4 * kCellTexels * cells.length);
    cells.forEach((_, i) => numbers.set(records[i], 4 * kCellTexels * i));
    if (this.texture) this.graphics.gl.deleteTexture(this.texture);
    this.texture = this.graphics.dataTexture(numbers, kCellTexels, kCellsPerRow);
    this.shown = key;
    return cells.length;
  }

  /// Draws into the current target. `scale`: pixels of the picture for one of the screen.
  draw(state, camera, width, height, scale) {
    const gl = this.graphics.gl;
    const view = camera.view(width / height);
    // Over the camera's shoulder, so that no view is dark, and from above.
    const sum = [0, 1, 2].map((i) => -0.5 * view.axes[i] + 0.6 * view.axes[3 + i] -
        0.75 * view.axes[6 + i] + (i === 2 ? 0.35 : 0));
    const key = scaled3(sum, 1 / Math.hypot(...sum));
    const setCamera = (program) => {
      gl.useProgram(program.program);
      gl.uniform3fv(program.at('uEye'), view.eye);
      gl.uniformMatrix3fv(program.at('uAxes'), false, view.axes);
      gl.uniform2fv(program.at('uTangent'), view.tangent);
      gl.uniform2f(program.at('uSize'), width, height);
      gl.uniform2fv(program.at('uDepth'), view.depth);
      gl.uniform1f(program.at('uPixel'), 2 * view.tangent[1] / height);
      gl.uniform3fv(program.at('uKey'), key);
      gl.uniform1i(program.at('uOutput'), state.identities ? 1 : 0);
      gl.uniform3fv(program.at('uInk'), linearColour(state.theme.outside.uInk));
      gl.uniform1f(program.at('uSoft'), state.model === 'upper'
          ? 0 : 1 / (3 * Math.sqrt(2 * view.tangent[1] / height)));
    };
    gl.depthFunc(gl.LEQUAL);
    let faces = null;
    if (state.renderer === 'cells' && state.model !== 'klein' && !this.manifold.hasEdgeWalls)
      this.drawCells(state, view, scale, setCamera);
    else
      faces = this.drawFaces(state, view, width, height, scale, setCamera);

    this.drawGround(state, view, setCamera);
    if (!faces) return;
    this.tubes.draw(...faces);
    this.faces.drawClear(...faces);
  }

  /// What surrounds the cells, where there is nothing yet.
  drawGround(state, view, setCamera) {
    const gl = this.graphics.gl, isUpper = state.model === 'upper';
    // Most pixels show neither cells nor the ball.
    const isOutside = !isUpper && Math.hypot(...view.eye) > 1.01;
    const draw = (vertex, fragment, kind, count, defined) => {
      const program = this.grounds[vertex + defined] ??=
          this.graphics.program(vertex, fragment, [defined, 'outside_camera.glsl']);
      setCamera(program);
      for (const name of ['uHigh', 'uLow'])
        gl.uniform3fv(program.at(name), linearColour(state.theme.outside[name]));
      gl.drawArrays(kind, 0, count);
    };
    if (isOutside)
      draw('outside_sky.vert.glsl', 'outside_sky.frag.glsl', gl.TRIANGLE_STRIP, 2 * kSkyStrips + 2,
           `#define kStrips ${kSkyStrips}`);
    draw(isOutside ? 'outside_ball.vert.glsl' : 'fullscreen.vert.glsl', 'outside_ground.frag.glsl',
         isOutside ? gl.TRIANGLE_FAN : gl.TRIANGLES, isOutside ? 8 : 3,
         `#define kHandOn\n#define kUpper ${isUpper ? 1 : 0}`);
  }

  drawFaces(state, view, width, height, scale, setCamera) {
    const cells = this.cover.grow(state.cells);
    const set = this.sets[state.model] ??=
        new FaceSet(this.manifold, state.model, this.toModel(state.model), this.moves);
    set.grow(cells);
    if (this.moves > 0)  // they may be anywhere
      view.depth[1] = Math.max(view.depth[1], ...set.balls.map(
          ([x, y, z, r]) => Math.hypot(x - view.eye[0], y - view.eye[1], z - view.eye[2]) + r));
    const drawing = [set, cells, state, view, width, height, scale, setCamera];
    this.faces.draw(...drawing);
    return drawing;
  }

  /// Each cell by its eight half-spaces: the reference that faces are compared with.
  drawCells(state, view, scale, setCamera) {
    const gl = this.graphics.gl;
    const count = this.upload(state.cells, state.model);
    this.cells ??= this.graphics.program('outside.vert.glsl', 'outside.frag.glsl',
                                         ['outside_camera.glsl', 'discs.glsl'],
                                         ['outside_light.glsl']);
    setCamera(this.cells);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.uniform1i(this.cells.at('uCells'), 0);
    gl.uniform1i(this.cells.at('uCellsPerRow'), kCellsPerRow);
    this.manifold.discs.use(gl, this.cells, this.discs, state.discs);
    gl.uniform1f(this.cells.at('uExplode'), state.explode);
    gl.uniformMatrix4fv(this.cells.at('uProjection'), false, view.projection);
    // It knows no other colours.
    gl.uniform1i(this.cells.at('uColourBy'),
                 Math.max(0, ['tetrahedron', 'depth', 'face'].indexOf(state.colour)));
    gl.uniform3fv(this.cells.at('uPalette'), linearPalette.flat());
    gl.uniform3fv(this.cells.at('uDepths'), kDepthPalette.flat());
    gl.uniform1f(this.cells.at('uLine'), (state.lines ? 1.9 : 0) * scale);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
  }
}
