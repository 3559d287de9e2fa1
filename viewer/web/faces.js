// The faces of cells, as the renderer of faces draws them: what viewer/faces/ is for the desktop. A
// face has a record of numbers for the shaders (faces.vert.glsl), an outline, whose convex hull holds
// it but for a margin, and, if another cell has it too, that cell's number.
const kFaceBounds = [0, 1, 2, 3].map((w) => {
  const others = [0, 1, 2, 3].filter((i) => i !== w);
  return [...others, ...others.map((i) => 4 + i)];
});
const kTruncationBounds = [0, 1, 2, 3].map((v) => [0, 1, 2, 3].filter((i) => i !== v));
const boundsOfWall = (wall) => (wall < 4 ? kFaceBounds[wall] : kTruncationBounds[wall - 4]);
const kRecordTexelsPerRow = 2048;
const recordTexels = (bounds) => 4 + bounds + Math.ceil(bounds / 4);

// As in wall_outline.cpp.
const kOutlineTightness = 0.03, kOutlineHalvings = 8, kOutlineSafety = 1.7, kOutlineDetail = 5e-4;

/// The corners of a wall of a tetrahedron, in cyclic order.
function cornersOfWall({corners}, wall) {
  const around = [0, 1, 2, 3].filter((v) => v !== wall % 4);
  const corner = (i, j) => corners.find((c) => c.vertex === i && c.other === j).point;
  return around.flatMap((here, i) => {
    if (wall >= 4) return [corner(wall - 4, here)];
    const [before, after] = [around[(i + 2) % 3], around[(i + 1) % 3]];
    return [corner(here, before), corner(here, after)];
  });
}

/// The walls of cells in a model; grows with the universal cover.
class FaceSet {
  constructor(manifold, model, toModel) {
    this.manifold = manifold;
    this.model = kModels[model];
    this.toModel = toModel;
    this.balls = [];       // of cells: x, y, z, radius
    this.halfSpaces = [];  // [8 cells] of {a, b, c}
    this.isometries = [];
    this.outlines = [];    // [8 cells] of {points, margin, middle, radius}
    this.partner = [];     // [8 cells] cell on the other side, Infinity if there is none
    this.corners = manifold.tetrahedra.map(
        (tetrahedron) => [0, 1, 2, 3, 4, 5, 6, 7].map((wall) => cornersOfWall(tetrahedron, wall)));
  }

  /// Takes cells in until there are as many as in `cells`.
  grow(cells) {
    if (this.balls.length >= cells.length) return;
    for (let i = this.balls.length; i < cells.length; ++i) this.add(cells[i]);
    this.findPartners();
  }

  add(cell) {
    const tetrahedron = this.manifold.tetrahedra[cell.tetrahedron];
    const isometry = Lorentz.multiply(this.toModel, cell.isometry);
    const place = (x) => this.model.place(Lorentz.apply(isometry, x));
    this.isometries.push(isometry);
    this.balls.push(this.model.ballOf(
        Lorentz.apply(isometry, tetrahedron.ball.centre), tetrahedron.ball.radius,
        () => tetrahedron.corners.map((c) => place(c.point))));
    [...tetrahedron.faces, ...tetrahedron.vertices].forEach((normal, wall) => {
      const {A, b, C} = this.model.halfSpace(Lorentz.apply(isometry, normal));
      this.halfSpaces.push({a: A / 2, b, c: C / 2});
      this.outlines.push(this.outline(this.corners[cell.tetrahedron][wall], place));
      this.partner.push(Infinity);
    });
  }

  /// Cuts the triangles of a wall until their sides are nearly straight in the model.
  outline(around, place) {
    const corner = (sum) => {
      const x = Lorentz.toPoint(sum);
      return {x, p: place(x)};
    };
    const away = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    const corners = around.map(corner), points = corners.map(({p}) => p);
    const middle = corner(around.reduce((sum, x) => Lorentz.combine(1, sum, 1, x)));
    const size = Math.max(...points.map((p) => away(p, points[0])));
    const error = Math.max(kOutlineDetail, kOutlineTightness * size) / kOutlineSafety;
    let margin = 0;
    const cut = (triangle, halvings) => {
      let [most, worst, between] = [-1, 0, null];
      for (let k = 0; k < 3; ++k) {
        const [a, b] = [triangle[k], triangle[(k + 1) % 3]];
        const half = corner(Lorentz.combine(1, a.x, 1, b.x));
        const leaves = away(half.p, a.p.map((x, i) => (x + b.p[i]) / 2));
        if (leaves > most) [most, worst, between] = [leaves, k, half];
      }
      if (most <= error || halvings === kOutlineHalvings) {
        margin = Math.max(margin, kOutlineSafety * most);
        return;
      }
      points.push(between.p);
      const [a, b, c] = [0, 1, 2].map((k) => triangle[(worst + k) % 3]);
      cut([a, between, c], halvings + 1);
      cut([between, b, c], halvings + 1);
    };
    if (corners.length === 3) {
      cut(corners, 0);
    } else {
      points.push(middle.p);
      corners.forEach((a, k) => cut([middle, a, corners[(k + 1) % 6]], 0));
    }
    const radius = Math.max(...points.map((p) => away(p, middle.p))) + margin;
    return {points: Float64Array.from(points.flat()), margin, middle: middle.p, radius};
  }

  /// Faces whose middles are at one place are one face.
  findPartners() {
    const order = [];
    this.outlines.forEach(({middle: [x, y, z]}, i) => {
      if (i % 8 < 4) order.push([x + 0.6180339887 * y + 0.3247179572 * z, i]);
    });
    order.sort((one, other) => one[0] - other[0]);
    for (let i = 0; i < order.length; ++i) {
      const {middle: p, radius} = this.outlines[order[i][1]];
      for (let j = i + 1; j < order.length && order[j][0] - order[i][0] <= 2e-6 * radius; ++j) {
        const q = this.outlines[order[j][1]].middle;
        if (Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) > 1e-6 * radius) continue;
        this.partner[order[i][1]] = order[j][1] >> 3;
        this.partner[order[j][1]] = order[i][1] >> 3;
        break;
      }
    }
  }

  /// Writes the record of a face; returns where the next one begins.
  ///   look  {number, shared, disc, colour}
  write(numbers, at, face, look) {
    const cell = face >> 3, wall = face & 7;
    const [x, y, z, radius] = this.balls[cell];
    const local = ({a, b, c}) => ({
      b: [b[0] + 2 * a * x, b[1] + 2 * a * y, b[2] + 2 * a * z], a: a * radius,
      c: (a * (x * x + y * y + z * z) + b[0] * x + b[1] * y + b[2] * z + c) / radius,
    });
    const own = local(this.halfSpaces[face]);
    numbers.set([...own.b, own.a, own.c, wall, look.shared ? 1 : 0, look.disc, x, y, z, radius,
                 ...look.colour, look.number], at);
    const bounds = boundsOfWall(wall).map((other) => local(this.halfSpaces[8 * cell + other]));
    bounds.forEach((h, i) => numbers.set([...h.b, h.a], at + 16 + 4 * i));
    bounds.forEach((h, i) => { numbers[at + 16 + 4 * bounds.length + i] = h.c; });
    return at + 4 * recordTexels(bounds.length);
  }
}

/// Finds where faces lie on a picture, and makes polygons around them; as in proxies.cpp.
class ProxyMesh {
  constructor() {
    this.corners = new Float32Array(3 * 4096);
    this.triangles = new Uint32Array(3 * 4096);
    this.reach = new Float64Array(8);
    this.clear();
  }

  clear() { this.cornerCount = this.triangleCount = 0; }

  look(view, width, height) {
    Object.assign(this, {view, width, height});
    this.focal = [width / 2 / view.tangent[0], height / 2 / view.tangent[1]];
  }

  /// Adds the polygon around the points, moved towards `centre` by the factor `shrink`.
  add(points, margin, centre, shrink, record) {
    const {eye, axes} = this.view, [fx, fy] = this.focal, {reach} = this;
    let nearest = Infinity;
    let [x0, x1, s0, s1, y0, y1, t0, t1] =
        [Infinity, -Infinity, Infinity, -Infinity, Infinity, -Infinity, Infinity, -Infinity];
    const [cx, cy, cz] = [0, 1, 2].map((k) => centre[k] * (1 - shrink) - eye[k]);
    for (let i = 0; i < points.length; i += 3) {
      const px = points[i] * shrink + cx, py = points[i + 1] * shrink + cy,
            pz = points[i + 2] * shrink + cz;
      const depth = axes[6] * px + axes[7] * py + axes[8] * pz;
      if (depth < nearest) nearest = depth;
      const x = fx * (axes[0] * px + axes[1] * py + axes[2] * pz) / depth;
      const y = fy * (axes[3] * px + axes[4] * py + axes[5] * pz) / depth;
      const s = x + y, t = y - x;
      if (x < x0) x0 = x;
      if (x > x1) x1 = x;
      if (s < s0) s0 = s;
      if (s > s1) s1 = s;
      if (y < y0) y0 = y;
      if (y > y1) y1 = y;
      if (t < t0) t0 = t;
      if (t > t1) t1 = t;
    }
    margin *= shrink;
    if (nearest <= margin + 1e-6) {  // it may surround the eye
      reach.fill(this.width + this.height);
    } else {
      const focal = Math.max(fx, fy), tilt = Math.hypot(1, ...this.view.tangent);
      const more = margin / (nearest - margin) * focal * tilt * tilt + 0.06;
      const [h, diagonal] = [more, Math.SQRT1_2];
      reach.set([x1 + h, diagonal * s1 + h, y1 + h, diagonal * t1 + h, h - x0, h - diagonal * s0,
                 h - y0, h - diagonal * t0]);
    }
    this.addPolygon(record);
  }

  addPolygon(record) {
    const {reach, width, height} = this;
    if (reach[0] < -width / 2 || reach[4] < -width / 2 || reach[2] < -height / 2 ||
        reach[6] < -height / 2)
      return;
    const straight = (reach[0] + reach[4]) * (reach[2] + reach[6]);
    const slanting = (reach[1] + reach[5]) * (reach[3] + reach[7]);
    const step = Math.min(straight, slanting) < 120 ? 2 : 1;
    const start = step === 2 && slanting < straight ? 1 : 0;
    const count = 8 / step;
    this.reserve(count);
    const first = this.cornerCount;
    for (let n = 0; n < count; ++n) {
      const k = (start + n * step) % 8, l = (k + step) % 8;
      const d = ProxyMesh.kDirections[k], e = ProxyMesh.kDirections[l];
      const turn = d[0] * e[1] - d[1] * e[0];
      const at = 3 * this.cornerCount++;
      this.corners[at] = 2 * (reach[k] * e[1] - reach[l] * d[1]) / turn / width;
      this.corners[at + 1] = 2 * (reach[l] * d[0] - reach[k] * e[0]) / turn / height;
      this.corners[at + 2] = record;
    }
    for (let i = 1; i + 1 < count; ++i) {
      const at = 3 * this.triangleCount++;
      this.triangles[at] = first;
      this.triangles[at + 1] = first + i;
      this.triangles[at + 2] = first + i + 1;
    }
  }

  reserve(more) {
    const grown = (array, needed) => {
      if (needed <= array.length) return array;
      const larger = new array.constructor(2 * needed);
      larger.set(array);
      return larger;
    };
    this.corners = grown(this.corners, 3 * (this.cornerCount + more));
    this.triangles = grown(this.triangles, 3 * (this.triangleCount + more));
  }
}
ProxyMesh.kDirections = Array.from({length: 8}, (_, k) => [Math.cos(k * Math.PI / 4),
                                                           Math.sin(k * Math.PI / 4)]);

/// Whether some point of a face may turn its outer side to the eye; as in proxies.cpp.
function mayFace({a, b, c}, points, margin, eye) {
  const s = [0, 1, 2].map((k) => -b[k] - 2 * a * eye[k]);
  let least = Infinity;
  for (let i = 0; i < points.length; i += 3)
    least = Math.min(least, s[0] * points[i] + s[1] * points[i + 1] + s[2] * points[i + 2]);
  return least - 2 * c - dot3(b, eye) <= (margin + 1e-6) * Math.hypot(...s);
}

/// Draws the faces of cells in a model.
class FaceDrawing {
  constructor(graphics, manifold, discs) {
    this.graphics = graphics;
    this.manifold = manifold;
    this.discs = discs;
    const gl = graphics.gl;
    this.kinds = [3, 6].map((bounds) => ({
      bounds, programs: new Map(), mesh: new ProxyMesh(), corners: gl.createBuffer(),
      triangles: gl.createBuffer(),
    }));
    this.array = gl.createVertexArray();
    this.records = this.places = null;
    this.shown = '';
  }

  /// The program for faces of a kind; see faces.glsl for what is defined.
  program({bounds, programs}, model, discs) {
    const defined = `#define kBounds ${bounds}\n#define kSides 1\n#define kCut 0\n` +
        `#define kModel ${model}\n#define kDiscs ${discs}\n`;
    if (!programs.has(defined))
      programs.set(defined, this.graphics.program(
          'faces.vert.glsl', 'outside_faces.frag.glsl', [defined, 'outside_camera.glsl'],
          ['discs.glsl', 'faces.glsl']));
    return programs.get(defined);
  }

  /// Sends the records of the first `count` cells to the graphics card.
  upload(set, cells, state, modelName) {
    const key = `${modelName} ${cells.length} ${state.colour}`;
    if (key === this.shown) return;
    const texels = cells.length * 4 * (recordTexels(3) + recordTexels(6));
    const rows = Math.max(1, Math.ceil(texels / kRecordTexelsPerRow));
    const numbers = new Float32Array(4 * kRecordTexelsPerRow * rows);
    this.first = new Float32Array(8 * cells.length);
    let at = 0;
    cells.forEach((cell, number) => {
      for (let wall = 0; wall < 8; ++wall) {
        const face = 8 * number + wall;
        this.first[face] = at / 4;
        at = set.write(numbers, at, face, {
          number, shared: set.partner[face] < cells.length,
          disc: wall < 4 ? -1 : this.manifold.discs.first[4 * cell.tetrahedron + wall - 4],
          colour: this.colour(state, cell, wall)});
      }
    });
    const gl = this.graphics.gl;
    if (this.records) gl.deleteTexture(this.records);
    this.records = this.graphics.dataTexture(numbers, kRecordTexelsPerRow, 1);
    if (this.places) gl.deleteTexture(this.places);
    this.places = this.manifold.discs.exist
        ? this.graphics.dataTexture(Float32Array.from(cells.flatMap((_, i) => toTetrahedron(
              set.isometries[i], set.model, set.balls[i].slice(0, 3), set.balls[i][3]))),
              kRecordTexelsPerRow, 1)
        : null;
    this.shown = key;
  }

  colour(state, cell, wall) {
    let base = paletteColour(cell.tetrahedron);
    if (state.colour === 'depth') base = kDepthPalette[Math.min(cell.depth, 11)];
    if (state.colour === 'face' && wall < 4)
      base = kLinearPalette[this.manifold.faceClass[cell.tetrahedron][wall] % 12];
    if (wall < 4) return base;
    // Truncations, the geodesic boundary, are pale, whatever the colours say.
    return base.map((x, k) => x + 0.4 * ([0.95, 0.93, 0.88][k] - x));
  }

  /// Finds the polygons of the faces that may be seen.
  project(set, count, state, view, width, height) {
    const shrink = 1 / (1 + state.explode);
    for (const {mesh} of this.kinds) {
      mesh.clear();
      mesh.look(view, width, height);
    }
    const focal = height / 2 / view.tangent[1];
    for (let cell = 0; cell < count; ++cell) {
      const [x, y, z, radius] = set.balls[cell];
      const away = [view.eye[0] - x, view.eye[1] - y, view.eye[2] - z];
      const distance = Math.hypot(...away);
      const pixels = distance > radius * shrink ? radius * shrink / distance * focal : Infinity;
      if (pixels < 0.4) continue;
      const centre = [x, y, z], eye = centre.map((p, k) => p + away[k] / shrink);
      for (let face = 8 * cell; face < 8 * cell + 8; ++face) {
        if (shrink === 1 && set.partner[face] < count) continue;
        const {points, margin} = set.outlines[face];
        if (!mayFace(set.halfSpaces[face], points, margin, eye)) continue;
        this.kinds[face % 8 < 4 ? 1 : 0].mesh.add(points, margin, centre, shrink, this.first[face]);
      }
    }
    return shrink;
  }

  /// `setCamera(program)` uses it and sets the camera's uniforms.
  draw(set, cells, state, view, width, height, scale, setCamera) {
    const gl = this.graphics.gl;
    this.upload(set, cells, state, state.model);
    const shrink = this.project(set, cells.length, state, view, width, height);
    gl.bindVertexArray(this.array);
    gl.enableVertexAttribArray(0);
    for (const kind of this.kinds) {
      const {mesh, corners, triangles} = kind;
      if (mesh.triangleCount === 0) continue;
      const withDiscs = kind.bounds === 3 && this.manifold.discs.exist && state.discs;
      const program = this.program(kind, set.model.number, withDiscs ? 1 : 0);
      setCamera(program);
      this.manifold.discs.use(gl, program, this.discs, state.discs);
      const bind = (unit, name, texture) => {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.uniform1i(program.at(name), unit);
      };
      bind(0, 'uFaces', this.records);
      bind(2, 'uPlaces', this.places ?? this.records);
      gl.uniform1f(program.at('uShrink'), shrink);
      const line = state.lines ? 1.2 * scale : -1e3;
      gl.uniform2f(program.at('uLine'), line, state.lines ? 0.6 * line : line);
      gl.bindBuffer(gl.ARRAY_BUFFER, corners);
      gl.bufferData(gl.ARRAY_BUFFER, mesh.corners.subarray(0, 3 * mesh.cornerCount),
                    gl.STREAM_DRAW);
      gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, triangles);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.triangles.subarray(0, 3 * mesh.triangleCount),
                    gl.STREAM_DRAW);
      gl.drawElements(gl.TRIANGLES, 3 * mesh.triangleCount, gl.UNSIGNED_INT, 0);
    }
    gl.bindVertexArray(this.graphics.nothing);
  }
}
