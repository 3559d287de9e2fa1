// The manifold of the page, from the JSON of `tripus embed`: faces are unit outward normals, vertices
// by their kind, their product with themselves,
//   1  hyperideal  the unit spacelike pole v of the truncating plane
//   0  ideal       a null vector v: of the horosphere of points x with product <x, v> = -1
//  -1  finite      the vertex itself
// A point x lies in the cell exactly if its products are <= 0 with faces and hyperideal vertices, and
// <= -1 with ideal ones and with the null vectors of parabolic edges, s (v_i + v_j) of edge ij.
const kEdgeEnds = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

const edgeBetween = (i, j) => kEdgeEnds.findIndex((ends) => ends.includes(i) && ends.includes(j));

/// Of the wall of each parabolic edge its null vector and its corners, in cyclic order: on the
/// truncations of the edge's vertices v < w and in its faces k < l, those of v k, w k, w l, v l. Of
/// the others null.
function edgeWalls(vertices, faces, parabolic, scale) {
  return kEdgeEnds.map(([v, w], e) => {
    if (!(parabolic >> e & 1)) return null;
    const wall = Lorentz.combine(scale, vertices[v], scale, vertices[w]), [k, l] = kEdgeEnds[5 - e];
    // In the plane that is orthogonal to the truncation and the face.
    const corner = (i, f) => {
      const [pole, normal] = [vertices[i], faces[f]], o = Lorentz.origin;
      const q = Lorentz.combine(1, Lorentz.combine(1, o, -Lorentz.dot(o, pole), pole),
                                -Lorentz.dot(o, normal), normal);
      const b = -1 / Lorentz.dot(wall, q);
      return Lorentz.toPoint(Lorentz.combine((1 + b * b * Lorentz.dot(q, q)) / 2, wall, b, q));
    };
    return {wall, corners: [corner(v, k), corner(w, k), corner(w, l), corner(v, l)]};
  });
}

/// The twelve corners: corner (i, j) is where the edge ij leaves through the truncation of i, or the
/// vertex i itself if it is finite; of a parabolic edge the middle of the side that its wall has there.
function tetrahedronCorners(vertices, diagonal, walls) {
  const corners = [];
  for (let i = 0; i < 4; ++i)
    for (let j = 0; j < 4; ++j) {
      if (i === j) continue;
      const parabolic = walls[edgeBetween(i, j)];
      if (parabolic) {
        const [a, b] = (i < j ? [0, 3] : [1, 2]).map((n) => parabolic.corners[n]);
        corners.push({vertex: i, other: j,
                      point: onHorosphere(Lorentz.combine(0.5, a, 0.5, b), parabolic.wall)});
        continue;
      }
      const product = Lorentz.dot(vertices[i], vertices[j]);
      let point = vertices[i];
      if (diagonal[i] > 0)
        point = Lorentz.toPoint(Lorentz.combine(1, vertices[j], -product, vertices[i]));
      if (diagonal[i] === 0)
        point = Lorentz.combine((1 + diagonal[j] / (product * product)) / 2, vertices[i],
                                -1 / product, vertices[j]);
      corners.push({vertex: i, other: j, point});
    }
  return corners;
}

/// The point of the horosphere of v half-way between points of it with this mean.
function onHorosphere(mean, v) {
  return Lorentz.combine(1, mean, (Lorentz.dot(mean, mean) + 1) / 2, v);
}

/// The half-spaces of the walls of a tetrahedron, moved by an isometry, in a model of kModels: faces,
/// truncations and, in manifolds with parabolic edges, those of the six edges.
function wallsOf({faces, vertices, diagonal, edges}, isometry, model) {
  return [
    ...faces.map((n) => model.halfSpace(Lorentz.apply(isometry, n))),
    ...vertices.map((v, i) => (diagonal[i] < 0 ? kNoWall
        : diagonal[i] > 0 ? model.halfSpace(Lorentz.apply(isometry, v))
                          : model.horosphere(Lorentz.apply(isometry, v)))),
    ...edges.map((edge) => (
        edge ? model.horosphere(Lorentz.apply(isometry, edge.wall)) : kNoWall))];
}

/// What cuts a tetrahedron off at its vertices and edges: [{wall, isHorosphere}].
function cutOff({vertices, diagonal, edges}) {
  return [
    ...vertices.flatMap((wall, i) => (
        diagonal[i] < 0 ? [] : [{wall, isHorosphere: diagonal[i] === 0}])),
    ...edges.flatMap((edge) => (edge ? [{wall: edge.wall, isHorosphere: true}] : []))];
}

/// Whether a point lies in a tetrahedron, or beyond it by rounding.
function standsIn(tetrahedron, point) {
  return tetrahedron.faces.every((n) => Lorentz.dot(n, point) <= 1e-6) &&
      cutOff(tetrahedron).every(({wall, isHorosphere}) => (
          Lorentz.dot(wall, point) <= (isHorosphere ? -1 : 0) + 1e-6));
}
/// What every point of a model near the cells lies in.
const kNoWall = {A: 0, b: [1e-6, 0, 0], C: -1};

/// Centre and radius of a hyperbolic ball around points, close to the smallest: it walks towards
/// the farthest point in shrinking steps (Badoiu and Clarkson).
function enclosingBall(points) {
  let centre = Lorentz.toPoint(points.reduce((sum, p) => Lorentz.combine(1, sum, 1, p)));
  const farthest = () => points.reduce(
      (far, p) => (Lorentz.dot(p, centre) < Lorentz.dot(far, centre) ? p : far));
  for (let step = 2; step < 60; ++step) {
    const far = farthest();
    const d = Lorentz.distance(centre, far);
    if (d < 1e-9) break;
    const t = d / step;
    centre = Lorentz.toPoint(
        Lorentz.combine(Math.sinh(d - t) / Math.sinh(d), centre, Math.sinh(t) / Math.sinh(d), far));
  }
  return {centre, radius: Lorentz.distance(centre, farthest())};
}

/// Every tetrahedron has a frame of its own with its centre at the origin, where its numbers are
/// smallest. pairing[t][f] carries the neighbour across face f next to t; crossing[t][f] takes
/// coordinates of t to those of the neighbour.
class Manifold {
  constructor(data) {
    this.data = data;
    this.count = data.tetrahedra.length;
    /// Whether there are parabolic edges.
    this.hasEdgeWalls = data.tetrahedra.some(({parabolic = 0}) => parabolic !== 0);
    /// `edges`: none, or of each edge the wall that cuts it off or null.
    this.tetrahedra = data.tetrahedra.map(
        ({vertices, faces, diagonal = [1, 1, 1, 1], singular = 0, parabolic = 0, scale = 1}) => {
      const edges =
          this.hasEdgeWalls ? edgeWalls(vertices, faces, parabolic, scale) : [];
      const corners = tetrahedronCorners(vertices, diagonal, edges);
      const points = [...corners.map((c) => c.point),
                      ...edges.flatMap((edge) => edge?.corners ?? [])];
      return {vertices, faces, diagonal, singular, edges, scale, corners, points,
              ball: enclosingBall(points)};
    });
    /// What the shader of the view from inside has to know of (kKinds), as InsideManifold::kinds().
    this.kinds = this.hasEdgeWalls ? 2
        : this.tetrahedra.some(({diagonal}) => diagonal.some((d) => d <= 0)) ? 1 : 0;
    this.neighbour = data.gluings.map((row) => row.map(([t]) => t));
    this.pairing = data.face_pairings;
    this.crossing = this.pairing.map((row) => row.map(Lorentz.inverse));
    this.gluedFace = data.gluings.map((row) => row.map(([, word], f) => Number(word[f])));
    this.edgeClass = data.edge_classes;
    this.vertexClass = data.vertex_classes;
    this.faceClass = this.numberFaces();
    this.discs = new Discs(data.discs, 4 * this.count);
  }

  /// One number for each pair of glued faces.
  numberFaces() {
    const number = this.neighbour.map(() => [-1, -1, -1, -1]);
    let next = 0;
    for (let t = 0; t < this.count; ++t)
      for (let f = 0; f < 4; ++f)
        if (number[t][f] < 0) {
          number[t][f] = next;
          number[this.neighbour[t][f]][this.gluedFace[t][f]] = next++;
        }
    return number;
  }
}

/// Cells of the universal cover, each once, grown on demand in the order of `tripus embed`: next
/// comes the cell whose centre is nearest to that of the root among those that touch one which is
/// there. A cell is known by its tetrahedron and the image of its centre: two points of the
/// hyperboloid at hyperbolic distance d are at least d apart in its coordinates, so that a grid much
/// finer than a cell tells them apart.
class UniversalCover {
  constructor(manifold, root = 0) {
    this.manifold = manifold;
    this.cells = [];
    this.found = [];  // everything discovered; cells are those that have had their turn
    this.known = new Set();
    this.queue = new Heap((p, q) => this.found[p].isometry[15] - this.found[q].isometry[15] || p - q);
    this.discover(root, Lorentz.identity, 0, null, null);
  }

  /// The first `count` cells; fewer only if that many cannot be told apart in doubles.
  grow(count) {
    while (this.cells.length < count && this.queue.size > 0) {
      const cell = this.found[this.queue.pop()];
      const number = this.cells.length;
      this.cells.push(cell);
      for (let f = 0; f < 4; ++f) {
        const image =
            Lorentz.multiply(cell.isometry, this.manifold.pairing[cell.tetrahedron][f]);
        this.discover(this.manifold.neighbour[cell.tetrahedron][f], Lorentz.orthonormalise(image),
                      cell.depth + 1, number, f);
      }
    }
    return this.cells.slice(0, count);
  }

  /// `face` of the parent was crossed.
  discover(tetrahedron, isometry, depth, parent, face) {
    const centre = Lorentz.column(isometry, 3);
    if (!(centre[3] < UniversalCover.kLargestTime)) return;
    if (this.keys(tetrahedron, centre).some((key) => this.known.has(key))) return;
    this.known.add(this.keys(tetrahedron, centre, 0)[0]);
    this.found.push({tetrahedron, isometry, depth, parent, face});
    this.queue.push(this.found.length - 1);
  }

  /// The grid cell of a centre and, near a border of the grid, those next to it.
  keys(tetrahedron, centre, slack = 0.05) {
    let keys = [`${tetrahedron}`];
    for (const x of centre) {
      const scaled = x * UniversalCover.kGrid + 0.137;
      const near = Math.round(scaled);
      const other = near + (scaled > near ? 1 : -1);
      const doubtful = Math.abs(Math.abs(scaled - near) - 0.5) < slack;
      keys = keys.flatMap((key) => (doubtful ? [`${key},${near}`, `${key},${other}`]
                                             : [`${key},${near}`]));
    }
    return keys;
  }
}
UniversalCover.kGrid = 64;
// Beyond, rounding in the isometries (about 1e-16 times the square of the time) nears the grid.
UniversalCover.kLargestTime = 1e5;

/// A priority queue: the least first.
class Heap {
  constructor(compare) {
    this.compare = compare;
    this.items = [];
  }
  get size() { return this.items.length; }

  push(item) {
    const {items} = this;
    let at = items.push(item) - 1;
    while (at > 0) {
      const above = (at - 1) >> 1;
      if (this.compare(items[at], items[above]) >= 0) break;
      [items[at], items[above]] = [items[above], items[at]];
      at = above;
    }
  }

  pop() {
    const {items} = this;
    const least = items[0];
    const last = items.pop();
    if (items.length === 0) return least;
    items[0] = last;
    for (let at = 0;;) {
      let next = 2 * at + 1;
      if (next >= items.length) return least;
      if (next + 1 < items.length && this.compare(items[next + 1], items[next]) < 0) ++next;
      if (this.compare(items[at], items[next]) <= 0) return least;
      [items[at], items[next]] = [items[next], items[at]];
      at = next;
    }
  }
}
