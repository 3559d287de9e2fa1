// The faces of cells, as the renderer of faces draws them: what viewer/faces/ is for the desktop. A
// face has a record of numbers for the shaders (faces.vert.glsl), an outline, whose convex hull holds
// it but for a margin, and, if another cell has it too, that cell's number.
const kOtherFaces = [0, 1, 2, 3].map((w) => [0, 1, 2, 3].filter((i) => i !== w));
/// Walls 0..3 are faces, 4..7 truncations, 8..13 those of parabolic edges; then comes the cut.
const kCutWall = 14, kPlainWalls = 8;
/// RecordKind of face_set.hpp.
const kTruncationKind = 0, kFaceKind = 1, kCutKind = 2, kEdgeWallKind = 3;
const kindOfWall = (wall) => (wall < 4 ? kFaceKind : wall < kPlainWalls ? kTruncationKind
    : wall < kCutWall ? kEdgeWallKind : kCutKind);
/// The walls that bound a wall, as bounds_of_wall of face_set.hpp has them.
function boundsOfWall(wall, withEdgeWalls) {
  const kind = kindOfWall(wall);
  if (kind === kCutKind)
    return Array.from({length: withEdgeWalls ? kCutWall : kPlainWalls}, (_, i) => i);
  if (kind === kEdgeWallKind) {
    const edge = wall - kPlainWalls;
    return [...kEdgeFaces[edge], ...kEdgeEnds[edge].map((v) => 4 + v)];
  }
  const others = kOtherFaces[wall % 4];
  const bounds = kind === kFaceKind ? [...others, ...others.map((i) => 4 + i)] : others;
  if (!withEdgeWalls) return bounds;
  return [...bounds, ...others.map((i) => {
    const edge = edgeBetween(wall % 4, i);
    return kPlainWalls + (kind === kFaceKind ? 5 - edge : edge);
  })];
}
/// Cells without some of their walls are not solid.
const isSolid = (state) => !state.hollow && state.faces && state.truncations;
const kClearAlpha = 0.22;
/// Cells of a smaller radius on the picture, in pixels, are small.
const kSmallCell = 2.5;
const kRecordTexelsPerRow = 2048;
const recordTexels = (bounds, bends) => 4 + bounds + Math.ceil(bounds / 4) + bends;
/// As flat_bounds of face_set.hpp: how many bounds are planes.
const kFlatBounds = [3, 3, 4, 4];
const hasOwnBend = (kind) => kind === kTruncationKind || kind === kEdgeWallKind;

// As in wall_outline.cpp.
const kOutlineTightness = 0.02, kOutlineHalvings = 8, kOutlineSafety = 1.7, kOutlineDetail = 5e-4;

/// The corners of a wall of a tetrahedron, in cyclic order; none if it is not there.
function cornersOfWall({corners, edges}, wall) {
  if (wall >= kPlainWalls) return edges[wall - kPlainWalls]?.corners ?? [];
  const around = kOtherFaces[wall % 4];
  // Of a parabolic edge there is one in each of its faces.
  const corner = (i, j, face) => {
    const edge = edgeBetween(i, j), there = face === kEdgeFaces[edge][0] ? [0, 1] : [3, 2];
    return edges[edge] ? edges[edge].corners[there[i < j ? 0 : 1]]
                       : corners.find((c) => c.vertex === i && c.other === j).point;
  };
  return around.flatMap((here, i) => {
    const [before, after] = [around[(i + 2) % 3], around[(i + 1) % 3]];
    if (wall < 4) return [corner(here, before, wall), corner(here, after, wall)];
    const v = wall - 4, one = [corner(v, here, after)];
    return edges[edgeBetween(v, here)] ? [...one, corner(v, here, before)] : one;
  });
}

const kNoOutline = {points: new Float64Array(0), margin: 0, middle: [0, 0, 0], radius: 0, sides: null,
                    edges: new Uint16Array(0)};

/// The walls of cells in a model; grows with the universal cover.
class FaceSet {
  ///   toModel  from the coordinates of the first cell to those of the model
  ///   number   another one for another set
  constructor(manifold, model, toModel, number) {
    this.number = number;
    this.manifold = manifold;
    this.model = kModels[model];
    // Horospheres of the Klein ball are no spheres.
    this.isBent = model === 'klein' && manifold.kinds > 0;
    this.walls = manifold.hasEdgeWalls ? kCutWall : kPlainWalls;
    this.bounds = Array.from({length: kCutWall + 1},
                             (_, wall) => boundsOfWall(wall, manifold.hasEdgeWalls));
    this.toModel = toModel;
    this.balls = [];       // of cells: x, y, z, radius
    this.halfSpaces = [];  // [walls x cells] of {a, b, c}
    this.isometries = [];
    this.outlines = [];    // [walls x cells] of {points, margin, middle, radius}
    this.partner = [];     // [walls x cells] cell on the other side, Infinity if there is none
    this.corners = manifold.tetrahedra.map((tetrahedron) => Array.from(
        {length: this.walls}, (_, wall) => cornersOfWall(tetrahedron, wall)));
  }

  /// How many half-spaces bound what is of a kind, and of how many its record has d.
  boundCount(kind) { return this.bounds[[4, 0, kCutWall, kPlainWalls][kind]].length; }
  bends(kind) {
    if (!this.isBent) return 0;
    return this.boundCount(kind) - kFlatBounds[kind] + (hasOwnBend(kind) ? 1 : 0);
  }
  texels(kind) { return recordTexels(this.boundCount(kind), this.bends(kind)); }

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
        () => tetrahedron.points.map(place)));
    wallsOf(tetrahedron, isometry, this.model).forEach(({A, b, C, d = [0, 0, 0]}, wall) => {
      this.halfSpaces.push({a: A / 2, b, c: C / 2, d});
      const edge = tetrahedron.edges[wall - kPlainWalls];
      const kind = wall < 4 ? 1 : wall < kPlainWalls ? tetrahedron.diagonal[wall - 4] : edge ? 0 : -1;
      this.outlines.push(kind < 0 ? kNoOutline : this.outline(
          this.corners[cell.tetrahedron][wall], place,
          kind === 0 ? edge?.wall ?? tetrahedron.vertices[wall - 4] : null));
      this.partner.push(Infinity);
    });
  }

  /// Cuts the triangles of a wall until their sides are nearly straight in the model.
  ///   horosphere  its null vector, of a truncation that is one
  outline(around, place, horosphere) {
    const corner = (sum, count) => {
      const x = horosphere && count > 1 ? onHorosphere(Lorentz.scale(sum, 1 / count), horosphere)
                                        : Lorentz.toPoint(sum);
      return {x, p: place(x)};
    };
    const away = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    const corners = around.map((x) => corner(x, 1)), points = corners.map(({p}) => p);
    corners.forEach((each, i) => { each.number = i; });
    const edges = new Set();
    const middle = corner(around.reduce((sum, x) => Lorentz.combine(1, sum, 1, x)), around.length);
    const size = Math.max(...points.map((p) => away(p, points[0])));
    const error = Math.max(kOutlineDetail, kOutlineTightness * size) / kOutlineSafety;
    let margin = 0;
    const halves = new Map();  // of sides, by the numbers of their ends
    const key = (i, j) => 4096 * Math.min(i, j) + Math.max(i, j);
    const number = (each) => {
      each.number = points.length;
      points.push(each.p);
    };
    const cut = (triangle, halvings) => {
      let [most, worst, between] = [-1, 0, null];
      for (let k = 0; k < 3; ++k) {
        const [a, b] = [triangle[k], triangle[(k + 1) % 3]], side = key(a.number, b.number);
        if (!halves.has(side)) {
          const half = corner(Lorentz.combine(1, a.x, 1, b.x), 2);
          halves.set(side, {half, leaves: away(half.p, a.p.map((x, i) => (x + b.p[i]) / 2))});
        }
        const {half, leaves} = halves.get(side);
        if (leaves > most) [most, worst, between] = [leaves, k, half];
      }
      if (most <= error || halvings === kOutlineHalvings) {
        margin = Math.max(margin, kOutlineSafety * most);
        triangle.forEach(({number: i}, k) => edges.add(key(i, triangle[(k + 1) % 3].number)));
        return;
      }
      if (between.number === undefined) number(between);
      const [a, b, c] = [0, 1, 2].map((k) => triangle[(worst + k) % 3]);
      cut([a, between, c], halvings + 1);
      cut([between, b, c], halvings + 1);
    };
    if (corners.length === 3) {
      cut(corners, 0);
    } else {
      number(middle);
      corners.forEach((a, k) => cut([middle, a, corners[(k + 1) % corners.length]], 0));
    }
    const radius = Math.max(...points.map((p) => away(p, middle.p))) + margin;
    return {points: Float64Array.from(points.flat()), margin, middle: middle.p, radius,
            sides: this.sides(corners, corner),
            edges: Uint16Array.from([...edges].flatMap((pair) => [pair >> 12, pair & 4095]))};
  }

  /// Of each side of a wall where it begins, its middle, and its directions there and at its end: 15
  /// numbers.
  sides(corners, corner) {
    const step = 1e-4;
    return Float64Array.from(corners.flatMap(({x: a, p}, i) => {
      const b = corners[(i + 1) % corners.length].x;
      const at = (share) => corner(Lorentz.combine(2 - 2 * share, a, 2 * share, b), 2).p;
      const along = (share) => {
        const [before, after] = [at(share - step), at(share + step)];
        return after.map((x, k) => x - before[k]);
      };
      return [...p, ...at(0.5), ...along(0), ...along(0.5), ...along(1)];
    }));
  }

  /// Faces whose middles are at one place are one face.
  findPartners() {
    const order = [];
    this.outlines.forEach(({middle: [x, y, z]}, i) => {
      if (i % this.walls < 4) order.push([x + 0.6180339887 * y + 0.3247179572 * z, i]);
    });
    order.sort((one, other) => one[0] - other[0]);
    for (let i = 0; i < order.length; ++i) {
      const {middle: p, radius} = this.outlines[order[i][1]];
      for (let j = i + 1; j < order.length && order[j][0] - order[i][0] <= 2e-6 * radius; ++j) {
        const q = this.outlines[order[j][1]].middle;
        if (Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) > 1e-6 * radius) continue;
        this.partner[order[i][1]] = Math.floor(order[j][1] / this.walls);
        this.partner[order[j][1]] = Math.floor(order[i][1] / this.walls);
        break;
      }
    }
  }

  /// Writes the record of a wall of a cell; returns where the next one begins.
  ///   own   its half-space
  ///   look  {shared, disc, colour, edges}; edges: numbers of the colours of a face's edges
  write(numbers, at, cell, wall, own, look) {
    const [x, y, z, radius] = this.balls[cell];
    const local = ({a, b, c, d}) => {
      const bent = d[0] * x + d[1] * y + d[2] * z;
      return {
        b: [x, y, z].map((at, k) => b[k] + 2 * (a * at - bent * d[k])), a: a * radius,
        c: (a * (x * x + y * y + z * z) + b[0] * x + b[1] * y + b[2] * z + c - bent * bent) / radius,
        d: d.map((part) => part * Math.sqrt(radius)),
      };
    };
    const {a, b, c, d} = local(own);
    numbers.set([...b, a, c, wall, look.shared ? 1 : 0, look.disc, x, y, z, radius,
                 ...look.colour, cell], at);
    const kind = kindOfWall(wall);
    const bounds =
        this.bounds[wall].map((other) => local(this.halfSpaces[this.walls * cell + other]));
    bounds.forEach((h, i) => numbers.set([...h.b, h.a], at + 16 + 4 * i));
    bounds.forEach((h, i) => { numbers[at + 16 + 4 * bounds.length + i] = h.c; });
    if (bounds.length % 4 !== 0) numbers[at + 16 + 5 * bounds.length] = look.edges;
    const end = at + 4 * recordTexels(bounds.length, 0);
    if (!this.isBent) return end;
    const bends = [...(hasOwnBend(kind) ? [d] : []),
                   ...bounds.slice(kFlatBounds[kind]).map((h) => h.d)];
    bends.forEach((bend, i) => numbers.set(bend, end + 4 * i));
    return end + 4 * bends.length;
  }
}

const kNoPoints = new Float64Array(0);

/// Of the points of a face, which are joined by edges, those that may turn their outer sides to the eye,
/// and where edges leave them; all, the very array, if all do. As in proxies.cpp.
function facingPart({a, b, c, d}, {points, margin, edges, middle, radius}, eye) {
  const bent = 2 * (d[0] * eye[0] + d[1] * eye[1] + d[2] * eye[2]);
  const x = bent * d[0] - b[0] - 2 * a * eye[0], y = bent * d[1] - b[1] - 2 * a * eye[1],
        z = bent * d[2] - b[2] - 2 * a * eye[2];
  const steep = Math.sqrt(x * x + y * y + z * z), doubt = (margin + 1e-6) * steep;
  const most = 2 * c + b[0] * eye[0] + b[1] * eye[1] + b[2] * eye[2];
  // Most faces are on one side with the whole ball around them.
  const around = x * middle[0] + y * middle[1] + z * middle[2] - most, reach = radius * steep + doubt;
  if (around < -reach) return points;
  if (around > reach) return kNoPoints;
  const count = points.length / 3;
  if (facingPart.beyond.length < count) facingPart.beyond = new Float64Array(2 * count);
  if (facingPart.part.length < points.length + 3 * edges.length)
    facingPart.part = new Float64Array(2 * (points.length + 3 * edges.length));
  const {beyond, part} = facingPart;
  let greatest = -Infinity;
  for (let i = 0; i < count; ++i) {
    const f = x * points[3 * i] + y * points[3 * i + 1] + z * points[3 * i + 2] - most;
    beyond[i] = f - doubt;
    if (f > greatest) greatest = f;
  }
  if (greatest < -doubt) return points;
  let size = 0;
  for (let i = 0; i < count; ++i) {
    if (beyond[i] > 0) continue;
    for (let k = 0; k < 3; ++k) part[size++] = points[3 * i + k];
  }
  if (size === 0) return kNoPoints;
  for (let e = 0; e < edges.length; e += 2) {
    const i = edges[e], j = edges[e + 1];
    if (!(beyond[i] * beyond[j] < 0)) continue;
    const share = beyond[i] / (beyond[i] - beyond[j]);
    for (let k = 0; k < 3; ++k)
      part[size++] = points[3 * i + k] + share * (points[3 * j + k] - points[3 * i + k]);
  }
  return part.subarray(0, size);
}
facingPart.beyond = new Float64Array(0);
facingPart.part = new Float64Array(0);

/// Draws the faces of cells in a model.
class FaceDrawing {
  constructor(graphics, manifold, discs) {
    this.graphics = graphics;
    this.manifold = manifold;
    this.discs = discs;
    const gl = graphics.gl;
    this.kinds = [kTruncationKind, kFaceKind, kCutKind, kEdgeWallKind].map((kind) => ({
      kind, programs: new Map(), mesh: new ProxyMesh(), corners: gl.createBuffer(),
      triangles: gl.createBuffer(),
    }));
    this.array = gl.createVertexArray();
    this.records = this.places = this.cuts = null;
    this.shown = this.cutShown = '';
  }

  /// The program for faces of a kind; see faces.glsl for what is defined.
  program({kind, programs}, set, discs, state) {
    const cut = state.cut !== null && kind !== kCutKind, edges = state.colour === 'edge' && state.lines;
    const defined = `#define kKind ${kind}\n#define kBounds ${set.boundCount(kind)}\n` +
        `#define kBends ${set.bends(kind)}\n#define kSides ${isSolid(state) ? 1 : 2}\n` +
        `#define kModel ${set.model.number}\n` +
        `#define kDiscs ${discs}\n#define kCut ${cut ? 1 : 0}\n` +
        `#define kEdges ${edges ? 1 : 0}\n` +
        // Of few bounds, or there would be more numbers than graphics cards must take.
        (set.boundCount(kind) === 3 && !set.isBent ? '#define kHandOn\n' : '');
    if (!programs.has(defined))
      programs.set(defined, this.graphics.program(
          'faces.vert.glsl', 'outside_faces.frag.glsl', [defined, 'outside_camera.glsl'],
          ['discs.glsl', 'faces.glsl', 'outside_light.glsl']));
    return programs.get(defined);
  }

  /// Sends the records of the first `count` cells to the graphics card.
  upload(set, cells, state, modelName) {
    const key = `${modelName} ${set.number} ${cells.length} ${state.colour}`;
    if (key !== this.shown) this.uploadFaces(set, cells, state);
    this.shown = key;
    const cutKey = `${key} ${state.cut}`;
    if (state.cut !== null && cutKey !== this.cutShown) this.uploadCuts(set, cells, state);
    this.cutShown = cutKey;
  }

  uploadFaces(set, cells, state) {
    const texels = cells.length * (4 * (set.texels(kTruncationKind) + set.texels(kFaceKind)) +
        (set.walls - kPlainWalls) * set.texels(kEdgeWallKind));
    const rows = Math.max(1, Math.ceil(texels / kRecordTexelsPerRow));
    const numbers = new Float32Array(4 * kRecordTexelsPerRow * rows);
    this.first = new Float32Array(set.walls * cells.length);
    let at = 0;
    cells.forEach((cell, number) => {
      for (let wall = 0; wall < set.walls; ++wall) {
        const face = set.walls * number + wall;
        this.first[face] = at / 4;
        if (set.outlines[face] === kNoOutline) continue;
        at = set.write(numbers, at, number, wall, set.halfSpaces[face], {
          shared: set.partner[face] < cells.length,
          disc: kindOfWall(wall) !== kTruncationKind ? -1 : this.manifold.discs.first[4 * cell.tetrahedron + wall - 4],
          colour: this.colour(state, cell, wall),
          edges: wall < 4 ? this.edgeColours(cell.tetrahedron, wall) : 0});
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
  }

  /// The records of the cells' cuts, and the balls that hold them.
  uploadCuts(set, cells, state) {
    const texels = set.texels(kCutKind);
    const own = {a: 0, b: [1, 0, 0], c: -state.cut, d: [0, 0, 0]};
    this.cutBalls = [];
    set.balls.slice(0, cells.length).forEach(([x, y, z, radius], cell) => {
      const beyond = x - state.cut;
      if (Math.abs(beyond) < radius)
        this.cutBalls.push({cell, points: [state.cut, y, z],
                            margin: Math.sqrt(radius * radius - beyond * beyond)});
    });
    const rows = Math.max(1, Math.ceil(this.cutBalls.length * texels / kRecordTexelsPerRow));
    const numbers = new Float32Array(4 * kRecordTexelsPerRow * rows);
    this.cutBalls.forEach(({cell}, i) => set.write(numbers, 4 * texels * i, cell, kCutWall, own, {
      shared: false, disc: -1, colour: this.colour(state, cells[cell], 4), edges: 0}));
    if (this.cuts) this.graphics.gl.deleteTexture(this.cuts);
    this.cuts = this.graphics.dataTexture(numbers, kRecordTexelsPerRow, 1);
  }

  /// As FaceLook::edge_colours of face_set.hpp.
  edgeColours(t, face) {
    return kOtherFaces[face].reduce((sum, other, i) => {
      const edge = kEdgeEnds.findIndex((ends) => !ends.includes(face) && !ends.includes(other));
      return sum + (this.manifold.edgeClass[t][edge] % linearPalette.length) * 64 ** i;
    }, 0);
  }

  colour(state, cell, wall) {
    const grey = [0.46, 0.47, 0.49], paper = [0.88, 0.86, 0.80];
    if (state.colour === 'edge') return wall < 4 ? grey : paper;
    if (state.colour === 'component') {
      const {vertexClass, edgeClass} = this.manifold, t = cell.tetrahedron;
      return wall < 4 ? grey : wall < kPlainWalls ? paletteColour(vertexClass[t][wall - 4])
          : lastPaletteColour(edgeClass[t][wall - kPlainWalls]);
    }
    let base = paletteColour(cell.tetrahedron);
    if (state.colour === 'depth') base = kDepthPalette[Math.min(cell.depth, 11)];
    if (state.colour === 'face' && wall < 4)
      base = paletteColour(this.manifold.faceClass[cell.tetrahedron][wall]);
    if (wall < 4) return base;
    // Truncations, the geodesic boundary, are pale, whatever the colours say; horospheres are bluish.
    const isCusp = wall >= kPlainWalls ||
        this.manifold.tetrahedra[cell.tetrahedron].diagonal[wall - 4] === 0;
    return base.map((x, k) => x + 0.4 * ((isCusp ? [0.62, 0.77, 0.95] : [0.95, 0.93, 0.88])[k] - x));
  }

  /// Finds the polygons of the faces that may be seen, of cells that one cannot look through, or,
  /// where `clear`, of the others, the farthest first.
  project(set, cells, state, view, width, height, clear) {
    const shrink = 1 / (1 + state.explode), count = cells.length, solid = isSolid(state);
    const isClear = (cell) => cells[cell].tetrahedron === state.transparent;
    let order = cells.map((_, i) => i);
    if (state.transparent !== null) order = order.filter((cell) => isClear(cell) === clear);
    if (clear) {
      const away = ([x, y, z]) => Math.hypot(x - view.eye[0], y - view.eye[1], z - view.eye[2]);
      const distance = new Map(order.map((cell) => [cell, away(set.balls[cell])]));
      order.sort((one, other) => distance.get(other) - distance.get(one));
    }
    for (const {mesh} of this.kinds) {
      mesh.clear();
      mesh.look(view, width, height);
    }
    const focal = height / 2 / view.tangent[1], eye = new Float64Array(3);
    const {axes} = view;
    const nearestOf = ({middle, radius}, ball) => {
      let depth = -radius * shrink;
      for (let k = 0; k < 3; ++k)
        depth += axes[6 + k] * (ball[k] + (middle[k] - ball[k]) * shrink - view.eye[k]);
      return depth;
    };
    for (const cell of order) {
      const ball = set.balls[cell], radius = ball[3] * shrink;
      let square = 0;
      for (let k = 0; k < 3; ++k) {
        const away = view.eye[k] - ball[k];
        square += away * away;
        eye[k] = ball[k] + away / shrink;
      }
      if (square > radius * radius && radius * focal < 0.4 * Math.sqrt(square)) continue;
      if (state.cut !== null && ball[0] - state.cut > ball[3]) continue;
      // Squares around the balls of their faces serve small cells.
      const small = radius * focal < kSmallCell * Math.sqrt(square);
      for (let wall = 0; wall < set.walls; ++wall) {
        const face = set.walls * cell + wall;
        if (wall < 4 ? !state.faces : !state.truncations) continue;
        if (set.outlines[face] === kNoOutline) continue;
        const partner = set.partner[face];
        // Through a transparent partner it is seen.
        if (solid && shrink === 1 && partner < count && (clear || !isClear(partner))) continue;
        const outline = set.outlines[face];
        let {points} = outline;
        if (solid) {
          points = facingPart(set.halfSpaces[face], outline, eye);
          if (points.length === 0) continue;
        }
        const {mesh} = this.kinds[kindOfWall(wall)];
        const first = this.first[face];
        if (small) {
          mesh.add(outline.middle, outline.radius, ball, shrink, first);
        } else if (!solid || !outline.sides || points !== outline.points ||
                   !mesh.addSides(outline.sides, nearestOf(outline, ball), ball, shrink, first)) {
          mesh.add(points, outline.margin, ball, shrink, first);
        }
      }
    }
    if (state.cut !== null && solid && !clear) {
      this.cutBalls.forEach(({cell, points, margin}, i) => {
        if (!isClear(cell))
          this.kinds[kCutKind].mesh.add(points, margin, set.balls[cell], shrink,
                                 set.texels(kCutKind) * i);
      });
    }
    return shrink;
  }

  /// `setCamera(program)` uses it and sets the camera's uniforms.
  draw(set, cells, state, view, width, height, scale, setCamera) {
    this.upload(set, cells, state, state.model);
    const shrink = this.project(set, cells, state, view, width, height, false);
    this.drawMeshes(set, state, scale, setCamera, shrink, 1);
  }

  /// What one looks through: after all else, and it hides nothing.
  drawClear(set, cells, state, view, width, height, scale, setCamera) {
    if (state.transparent === null || !isSolid(state) || state.identities) return;
    const gl = this.graphics.gl;
    const shrink = this.project(set, cells, state, view, width, height, true);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ZERO, gl.ONE);
    gl.depthMask(false);
    this.drawMeshes(set, state, scale, setCamera, shrink, kClearAlpha);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  drawMeshes(set, state, scale, setCamera, shrink, alpha) {
    const gl = this.graphics.gl;
    gl.bindVertexArray(this.array);
    gl.enableVertexAttribArray(0);
    for (const kind of this.kinds) {
      const {mesh, corners, triangles} = kind;
      if (mesh.triangleCount === 0) continue;
      const withDiscs = kind.kind === kTruncationKind && this.manifold.discs.exist && state.discs;
      const program = this.program(kind, set, withDiscs ? 1 : 0, state);
      setCamera(program);
      this.manifold.discs.use(gl, program, this.discs, state.discs);
      const bind = (unit, name, texture) => {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.uniform1i(program.at(name), unit);
      };
      bind(0, 'uFaces', kind.kind === kCutKind ? this.cuts : this.records);
      bind(2, 'uPlaces', this.places ?? this.records);
      gl.uniform1f(program.at('uShrink'), shrink);
      gl.uniform1f(program.at('uCut'), state.cut ?? 0);
      gl.uniform1f(program.at('uAlpha'), alpha);
      if (state.colour === 'edge') gl.uniform3fv(program.at('uPalette'), linearPalette.flat());
      const line = state.lines ? 1.2 * scale : -1e3;
      gl.uniform2f(program.at('uLine'), line, state.lines ? 0.6 * line : line);
      mesh.draw(gl, corners, triangles);
    }
    gl.bindVertexArray(this.graphics.nothing);
  }
}
