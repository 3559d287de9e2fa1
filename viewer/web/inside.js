// The inside view: what one sees along geodesics when standing in the manifold.
const kTetrahedronTexels = 37;
const kTetrahedraPerRow = 32;

class InsideView {
  constructor(graphics, manifold) {
    this.graphics = graphics;
    this.manifold = manifold;
    this.connect();
  }

  connect() {
    this.program =
        this.graphics.program('fullscreen.vert.glsl', 'inside.frag.glsl',
                              [`#define kKinds ${this.manifold.kinds}`, 'discs.glsl']);
    this.discs = this.manifold.discs.texture(this.graphics);
    const numbers = new Float32Array(4 * kTetrahedronTexels * this.manifold.count);
    for (let t = 0; t < this.manifold.count; ++t)
      numbers.set(this.record(t), 4 * kTetrahedronTexels * t);
    this.texture = this.graphics.dataTexture(numbers, kTetrahedronTexels, kTetrahedraPerRow);
  }

  /// 37 x 4 numbers of a tetrahedron; their order is in inside.frag.glsl.
  record(t) {
    const m = this.manifold;
    const {faces, vertices, diagonal, singular, edges, scale} = m.tetrahedra[t];
    const numbers = new Float32Array(4 * kTetrahedronTexels);
    [...faces, ...vertices].forEach((n, i) => numbers.set([n[0], n[1], n[2], -n[3]], 4 * i));
    m.crossing[t].forEach((matrix, f) => numbers.set(matrix, 32 + 16 * f));
    numbers.set(m.neighbour[t], 96);
    numbers.set(m.gluedFace[t], 100);
    kEdgeEnds.forEach(([i, j], e) => {
      const [k, l] = [0, 1, 2, 3].filter((v) => v !== i && v !== j);
      const cosine = Lorentz.dot(faces[k], faces[l]);
      numbers[104 + e] = cosine;
      numbers[128 + e] = edges[e] ? -scale : 1 / (1 - cosine * cosine);
      numbers[112 + e] = m.edgeClass[t][e] % 4096;
    });
    numbers.set(m.vertexClass[t].map((v) => v % 4096), 120);
    numbers.set(m.discs.first.slice(4 * t, 4 * t + 4), 124);
    numbers.set(diagonal, 136);
    kEdgeEnds.forEach((_, e) => { numbers[140 + e] = singular >> e & 1; });
    return numbers;
  }

  /// Tangents of half the angles of view, across and upwards.
  tangent(aspect) {
    const narrow = 0.72;
    const tangent = aspect >= 1 ? [narrow * aspect, narrow] : [narrow, narrow / aspect];
    // A wide picture would stretch its sides: beyond a right angle across, no wider.
    const shrink = Math.min(1, 1.25 / Math.max(...tangent));
    return tangent.map((x) => x * shrink);
  }

  /// Follows the line of sight at a place of the picture (x, y from 0 to 1, from the upper left)
  /// through so many faces: the tetrahedra on the way, and the [tetrahedron, face] crossed.
  follow(camera, x, y, {width, height}, crossings) {
    const tangent = this.tangent(width / height);
    const ray = [(2 * x - 1) * tangent[0], (1 - 2 * y) * tangent[1], 1, 0];
    const unit = Lorentz.scale(ray, 1 / Math.hypot(...ray));
    let [point, direction, from] =
        [Lorentz.column(camera.frame, 3), Lorentz.apply(camera.frame, unit), -1];
    const path = [camera.tetrahedron], letters = [];
    for (let i = 0; i < crossings; ++i) {
      const t = path.at(-1);
      let [face, least] = [-1, Infinity];
      this.manifold.tetrahedra[t].faces.forEach((normal, f) => {
        const [a, b] = [Lorentz.dot(normal, point), Lorentz.dot(normal, direction)];
        if (f !== from && b > 0 && -a / b < least) [face, least] = [f, -a / b];
      });
      if (face < 0 || least >= 1) break;
      const along = Math.atanh(Math.max(0, least));
      const [c, s] = [Math.cosh(along), Math.sinh(along)];
      [point, direction] = [Lorentz.combine(c, point, s, direction),
                            Lorentz.combine(s, point, c, direction)]
          .map((v) => Lorentz.apply(this.manifold.crossing[t][face], v));
      letters.push([t, face]);
      from = this.manifold.gluedFace[t][face];
      path.push(this.manifold.neighbour[t][face]);
    }
    return {path, letters};
  }

  draw(state, camera, width, height) {
    const gl = this.graphics.gl;
    const {at, program} = this.program;
    const tangent = this.tangent(width / height);
    gl.useProgram(program);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.uniform1i(at('uTetrahedra'), 0);
    gl.uniform1i(at('uPerRow'), kTetrahedraPerRow);
    gl.uniform1i(at('uStart'), camera.tetrahedron);
    gl.uniformMatrix4fv(at('uFrame'), true, camera.frame);
    gl.uniform2fv(at('uTangent'), tangent);
    gl.uniform2f(at('uSize'), width, height);
    gl.uniform2fv(at('uJitter'), state.jitter ?? [0, 0]);
    gl.uniform1f(at('uPixel'), 2 * tangent[1] / height);
    gl.uniform1i(at('uMaxCrossings'), state.crossings);
    gl.uniform1f(at('uTube'), Math.sinh(state.tube) ** 2);
    gl.uniform1f(at('uFog'), 1 / state.sight);
    gl.uniform1f(at('uMirror'), state.mirror ? 0.45 : 0);
    gl.uniform1i(at('uGrid'), state.lines ? 1 : 0);
    gl.uniform1i(at('uColourBy'), state.wall === 'triangle' ? 0 : 1);
    this.manifold.discs.use(gl, this.program, this.discs, state.discs);
    gl.uniform3fv(at('uPalette'), linearPalette.flat());
    gl.uniform3fv(at('uFogColour'), linearColour(state.theme.fog));
    gl.uniform3fv(at('uSingular'), kSingularColour);
    gl.uniform1i(at('uOutput'), state.identities ? 1 : 0);
    gl.depthFunc(gl.ALWAYS);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
