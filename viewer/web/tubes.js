// Tubes around edges, as viewer/faces/tubes.cpp makes them for the desktop: each edge once, in pieces
// that are nearly straight in the model (where cells stand apart, each edge of each cell), with a record of numbers for the shaders (tubes.vert.glsl).
const kTubeRadius = 0.025, kSingularTubeRadius = 0.05;
// As wide as the lines of faces, in pixels: thinner tubes are left to them.
const kThinnestTube = 1.2;
const kTubeStraight = 1 / 16, kTubeHalvings = 5, kTubeTexels = 9;
/// Of the numbers of a record, where its centre begins.
const kTubePlace = 28;
/// The faces at each edge.
const kEdgeFaces = [[2, 3], [1, 3], [1, 2], [0, 3], [0, 2], [0, 1]];

/// <n, X> times the factor of a model as a polynomial {a, b, c} of its points, and the factor itself
/// (in the Klein ball its square).
function tubeLevel(model, n) {
  if (model.number === 2) return {a: 0, b: n.slice(0, 3), c: -n[3]};
  const {A, b, C} = model.halfSpace(n);
  return {a: A / 2, b, c: C / 2};
}
const kTubeFactors = [{a: 0, b: [0, 0, 1], c: 0}, {a: -0.5, b: [0, 0, 0], c: 0.5},
                      {a: -1, b: [0, 0, 0], c: 1}];

/// The unit tangent at a point of the hyperboloid away from another one.
function awayFrom(other, at) {
  const tangent = Lorentz.combine(-1, other, -Lorentz.dot(other, at), at);
  return Lorentz.scale(tangent, 1 / Math.sqrt(Math.max(Lorentz.dot(tangent, tangent), 1e-300)));
}

class TubeSet {
  ///   set    the faces, grown to as many cells
  ///   apart  whether the cells stand apart, so that they share no edges
  constructor(set, cells, apart) {
    this.model = set.model;
    this.pieces = [];
    this.numbers = [];
    for (const edge of this.findEdges(set, cells, apart)) this.addEdge(edge);
  }

  /// Moves pieces to where they are when cells shrink towards their middles.
  shrink(balls, factor) {
    this.pieces.forEach((piece, i) => {
      const [x, y, z] = balls[piece.cell], {centre, size} = piece.first;
      const moved = (p) => [x + factor * (p[0] - x), y + factor * (p[1] - y), z + factor * (p[2] - z)];
      piece.centre = moved(centre);
      piece.size = factor * size;
      piece.margin = factor * piece.first.margin;
      piece.radius = factor * piece.first.radius;
      const {points} = piece.first;
      piece.points = Float64Array.from([...moved(points.slice(0, 3)), ...moved(points.slice(3))]);
      [...piece.centre, piece.size].forEach((number, k) => {
        this.numbers[4 * kTubeTexels * i + kTubePlace + k] = number;
      });
    });
  }

  findEdges(set, cells, apart) {
    const edges = cells.flatMap((cell, number) => {
      const {corners, diagonal, faces, singular, edges: walls} =
          set.manifold.tetrahedra[cell.tetrahedron];
      const isometry = set.isometries[number];
      return kEdgeEnds.flatMap(([v, w], e) => {
        if (walls[e]) return [];
        const [begin, end] = [[v, w], [w, v]].map(([i, j]) => Lorentz.apply(
            isometry, corners.find((c) => c.vertex === i && c.other === j).point));
        const middle = this.model.place(Lorentz.toPoint(Lorentz.combine(1, begin, 1, end)));
        return [{
          begin, end, middle, cell: number, isSingular: (singular >> e & 1) === 1,
          isFinite: [diagonal[v] < 0, diagonal[w] < 0],
          normals: () => kEdgeFaces[e].map((f) => Lorentz.apply(isometry, faces[f])),
          edgeClass: set.manifold.edgeClass[cell.tetrahedron][e],
          isInner: !apart && kEdgeFaces[e].every((f) => set.partner[set.walls * number + f] < cells.length),
          along: middle[0] + 0.6180339887 * middle[1] + 0.3247179572 * middle[2]}];
      });
    });
    if (apart) return edges;
    const order = [...edges].sort((one, other) => one.along - other.along);
    const known = new Set(), result = [];
    order.forEach((edge, i) => {
      if (known.has(edge)) return;
      const [p, q] = [edge.begin, edge.end].map((x) => this.model.place(x));
      const near = 1e-6 * Math.hypot(...p.map((x, k) => x - q[k]));
      for (let j = i + 1; j < order.length && order[j].along - edge.along <= 2 * near; ++j) {
        const other = order[j];
        if (Math.hypot(...other.middle.map((x, k) => x - edge.middle[k])) > near) continue;
        known.add(other);
        edge.isInner &&= other.isInner;
      }
      result.push(edge);
    });
    return result;
  }

  addEdge(edge) {
    const radius = edge.isSingular ? kSingularTubeRadius : kTubeRadius, more = Math.tanh(radius);
    const place = (x) => this.model.place(x);
    // Tubes that meet in a finite vertex go on beyond it.
    const [begin, end] = [[edge.begin, edge.end], [edge.end, edge.begin]].map(([at, other], i) => (
        edge.isFinite[i] ? Lorentz.toPoint(Lorentz.combine(1, at, more, awayFrom(other, at))) : at));
    const [n, m] = edge.normals(), cosine = Lorentz.dot(n, m);
    const size = 1 / Math.sqrt((1 - cosine) * (1 + cosine));
    const across = [n, Lorentz.combine(size, m, -cosine * size, n)];
    const cut = (from, to, halvings) => {
      const between = Lorentz.toPoint(Lorentz.combine(1, from, 1, to));
      const [p, q, r] = [from, to, between].map(place);
      const leaves = Math.hypot(...r.map((x, k) => x - (p[k] + q[k]) / 2));
      if (halvings === kTubeHalvings ||
          leaves <= kTubeStraight * Math.hypot(...p.map((x, k) => x - q[k]))) {
        this.addPiece(edge, across, Math.sinh(radius), from, to, [p, q, r], leaves);
        return;
      }
      cut(from, between, halvings + 1);
      cut(between, to, halvings + 1);
    };
    cut(begin, end, 0);
  }

  /// How far Euclidean length in the model goes at most for hyperbolic length.
  scaleAt(p) {
    if (this.model.number === 0) return p[2];
    const rest = Math.max(1 - dot3(p, p), 0);
    return this.model.number === 1 ? rest / 2 : Math.sqrt(rest);
  }

  addPiece(edge, across, radius, begin, end, [p, q, m], leaves) {
    const wide = 1.1 * radius * Math.max(...[p, q, m].map((x) => this.scaleAt(x)));
    const margin = 1.1 * leaves + wide;
    const centre = p.map((x, k) => (x + q[k]) / 2);
    const size = Math.hypot(...p.map((x, k) => x - q[k])) / 2 + margin;
    const local = ({a, b, c}, share = 1) => ({
      b: [0, 1, 2].map((k) => share * (b[k] + 2 * a * centre[k])), a: share * a * size,
      c: share * (a * dot3(centre, centre) + dot3(b, centre) + c) / size});
    const bound = (x, y) => {
      const {A, b, C} = this.model.halfSpace(awayFrom(x, y));
      return local({a: A / 2, b, c: C / 2});
    };
    const polynomials = [
      ...across.map((n) => local(tubeLevel(this.model, n))),
      // The square of the factor has one more factor 1 / size than the factor.
      local(kTubeFactors[this.model.number], this.model.number === 2 ? 1 / size : 1),
      bound(end, begin), bound(begin, end)];
    const first = {points: [...p, ...q], margin, centre, size, radius: radius * this.scaleAt(m)};
    this.pieces.push({...first, points: Float64Array.from(first.points), first, cell: edge.cell, isInner: edge.isInner,
                      isSingular: edge.isSingular, edgeClass: edge.edgeClass});
    for (const {a, b} of polynomials) this.numbers.push(...b, a);
    this.numbers.push(...polynomials.map(({c}) => c), radius * radius, edge.isSingular ? 1 : 0,
                      0, ...centre, size,
                      0, 0, 0, 0);
  }
}

/// Draws tubes, over all else, as they are blended at their rims.
class TubeDrawing {
  constructor(graphics) {
    this.graphics = graphics;
    const {gl} = graphics;
    this.programs = new Map();
    this.mesh = new ProxyMesh();
    this.corners = gl.createBuffer();
    this.triangles = gl.createBuffer();
    this.array = gl.createVertexArray();
    this.texture = null;
    this.shown = '';
  }

  program(model, state) {
    const defined = `#define kModel ${model}\n#define kCut ${state.cut === null ? 0 : 1}\n`;
    if (!this.programs.has(defined))
      this.programs.set(defined, this.graphics.program(
          'tubes.vert.glsl', 'outside_tubes.frag.glsl', [defined, 'outside_camera.glsl'],
          ['tubes.glsl', 'outside_light.glsl']));
    return this.programs.get(defined);
  }

  upload(set, cells, state) {
    const key = `${state.model} ${set.number} ${cells.length} ${state.colour} ${state.explode}`;
    if (key === this.shown) return;
    this.shown = key;
    const apart = state.explode > 0;
    if (set.tubes?.count !== cells.length || set.tubes.apart !== apart)
      set.tubes = {count: cells.length, apart, tubes: new TubeSet(set, cells, apart)};
    this.tubes = set.tubes.tubes;
    if (apart) this.tubes.shrink(set.balls, 1 / (1 + state.explode));
    const {numbers, pieces} = this.tubes;
    pieces.forEach(({edgeClass, isSingular}, i) => {
      const colour = isSingular ? kSingularColour
          : state.colour === 'edge' ? paletteColour(edgeClass) : [0.045, 0.055, 0.07];
      colour.forEach((x, k) => { numbers[4 * kTubeTexels * (i + 1) - 4 + k] = x; });
    });
    if (this.texture) this.graphics.gl.deleteTexture(this.texture);
    this.texture = this.graphics.dataTexture(numbers, kRecordTexelsPerRow, 1);
  }

  draw(set, cells, state, view, width, height, scale, setCamera) {
    // Cut cells that stand apart have lines.
    if (!state.lines || state.identities || (state.explode > 0 && state.cut !== null)) return;
    this.upload(set, cells, state);
    const {mesh} = this, {gl} = this.graphics;
    mesh.clear();
    mesh.look(view, width, height);
    const focal = height / 2 / view.tangent[1], solid = isSolid(state);
    const away = ({centre}) => Math.hypot(...centre.map((x, k) => x - view.eye[k]));
    const seen = [];
    this.tubes.pieces.forEach((piece, i) => {
      if (piece.isInner && solid && state.transparent === null && state.cut === null) return;
      if (state.cut !== null && piece.centre[0] - piece.size > state.cut) return;
      const distance = away(piece);
      const wide = distance > piece.size ? piece.radius * focal / (scale * distance) : Infinity;
      if (wide < kThinnestTube && !piece.isSingular) return;
      if (piece.size * focal < scale * distance) return;
      const margin = piece.margin + Math.max(0, kThinnestTube / wide - 1) * piece.radius;
      seen.push({distance, piece, margin, record: kTubeTexels * i});
    });
    // The farthest first.
    seen.sort((one, other) => other.distance - one.distance);
    for (const {piece, margin, record} of seen)
      mesh.add(piece.points, margin, piece.centre, 1, record);
    if (mesh.triangleCount === 0) return;
    const program = this.program(set.model.number, state);
    setCamera(program);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.uniform1i(program.at('uTubes'), 0);
    gl.uniform1f(program.at('uThin'), kThinnestTube * scale);
    gl.uniform1f(program.at('uCut'), state.cut ?? 0);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ZERO, gl.ONE);
    gl.bindVertexArray(this.array);
    gl.enableVertexAttribArray(0);
    mesh.draw(gl, this.corners, this.triangles);
    gl.bindVertexArray(this.graphics.nothing);
    gl.disable(gl.BLEND);
  }
}
