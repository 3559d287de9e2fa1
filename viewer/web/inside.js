// The inside view: what one sees along geodesics when standing in the manifold.
const kTetrahedronTexels = 32;
const kTetrahedraPerRow = 32;

class InsideView {
  constructor(graphics, manifold) {
    this.graphics = graphics;
    this.manifold = manifold;
    this.connect();
  }

  connect() {
    this.program = this.graphics.program('fullscreen.vert.glsl', 'inside.frag.glsl');
    const numbers = new Float32Array(4 * kTetrahedronTexels * this.manifold.count);
    for (let t = 0; t < this.manifold.count; ++t)
      numbers.set(this.record(t), 4 * kTetrahedronTexels * t);
    this.texture = this.graphics.dataTexture(numbers, kTetrahedronTexels, kTetrahedraPerRow);
  }

  /// 32 x 4 numbers of a tetrahedron; their order is in inside.frag.glsl.
  record(t) {
    const m = this.manifold;
    const {faces, vertices} = m.tetrahedra[t];
    const numbers = new Float32Array(4 * kTetrahedronTexels);
    [...faces, ...vertices].forEach((n, i) => numbers.set([n[0], n[1], n[2], -n[3]], 4 * i));
    m.crossing[t].forEach((matrix, f) => numbers.set(matrix, 32 + 16 * f));
    numbers.set(m.neighbour[t], 96);
    numbers.set(m.gluedFace[t], 100);
    kEdgeEnds.forEach(([i, j], e) => {
      const [k, l] = [0, 1, 2, 3].filter((v) => v !== i && v !== j);
      numbers[104 + e] = Lorentz.dot(faces[k], faces[l]);
      numbers[112 + e] = m.edgeClass[t][e] % 4096;
    });
    numbers.set(m.vertexClass[t].map((v) => v % 4096), 120);
    return numbers;
  }

  draw(state, camera, width, height) {
    const gl = this.graphics.gl;
    const {at, program} = this.program;
    const aspect = width / height;
    const narrow = 0.72;
    const tangent = aspect >= 1 ? [narrow * aspect, narrow] : [narrow, narrow / aspect];
    // A wide picture would stretch its sides: beyond a right angle across, no wider.
    const shrink = Math.min(1, 1.25 / Math.max(...tangent));
    gl.useProgram(program);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.uniform1i(at('uTetrahedra'), 0);
    gl.uniform1i(at('uPerRow'), kTetrahedraPerRow);
    gl.uniform1i(at('uStart'), camera.tetrahedron);
    gl.uniformMatrix4fv(at('uFrame'), true, camera.frame);
    gl.uniform2f(at('uTangent'), tangent[0] * shrink, tangent[1] * shrink);
    gl.uniform2f(at('uSize'), width, height);
    gl.uniform1f(at('uPixel'), 2 * tangent[1] * shrink / height);
    gl.uniform1i(at('uMaxCrossings'), state.crossings);
    gl.uniform1f(at('uTube'), Math.sinh(state.tube) ** 2);
    gl.uniform1f(at('uFog'), 1 / state.sight);
    gl.uniform1f(at('uMirror'), state.mirror ? 0.45 : 0);
    gl.uniform1i(at('uGrid'), state.lines ? 1 : 0);
    gl.uniform1i(at('uColourBy'), state.wall === 'triangle' ? 0 : 1);
    gl.uniform3fv(at('uPalette'), kLinearPalette.flat());
    gl.uniform3fv(at('uFogColour'), linearColour(state.theme.fog));
    gl.uniform1i(at('uOutput'), state.identities ? 1 : 0);
    gl.depthFunc(gl.ALWAYS);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
