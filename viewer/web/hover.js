// What the pointer rests on, in words: tetrahedron, face, edges, and the word of the cell in the
// generators of the fundamental group: what one crosses on the way there from tetrahedron 0.
class Hover {
  constructor(page) {
    this.page = page;
    this.timer = 0;
    this.text = '';
    const {canvas} = page;
    canvas.addEventListener('pointermove', (e) => {
      this.clear();
      if (e.buttons !== 0 || e.pointerType === 'touch') return;
      const box = canvas.getBoundingClientRect();
      const [x, y] = [(e.clientX - box.left) / box.width, (e.clientY - box.top) / box.height];
      this.timer = setTimeout(() => this.show(this.at(x, y)), 120);
    });
    for (const type of ['pointerleave', 'pointerdown', 'wheel', 'keydown'])
      canvas.addEventListener(type, () => this.clear(), {passive: true});
  }

  clear() {
    clearTimeout(this.timer);
    this.show('');
  }

  show(text) {
    if (text === this.text) return;
    this.text = text;
    this.page.showStatus();
  }

  /// What is seen at a place of the picture, x and y from 0 to 1, from the upper left corner.
  at(x, y) {
    const {page} = this;
    if (!page.graphics) return '';
    const pixel = page.identityAt(x, y);
    return page.state.view === 'inside' ? this.inside(pixel, x, y) : this.outside(pixel);
  }

  outside([low, high, rest]) {
    const [surface, disc] = [rest & 15, rest >> 4];
    if (surface === 0) return '';
    const {cells} = this.page.views.outside.cover;
    const number = low + 256 * high;
    if (number >= cells.length) return '';
    const letters = [];
    for (let cell = cells[number]; cell.parent !== null; cell = cells[cell.parent])
      letters.unshift(this.letter(cells[cell.parent].tetrahedron, cell.face));
    const t = cells[number].tetrahedron;
    if (surface === kCutWall + 1) return `tetrahedron ${t}, cut; word ${this.word(letters)}`;
    return `${surface > 4 ? this.truncation(t, surface - 5, disc) : this.face(t, surface - 1)}; ` +
        `word ${this.word(letters)}`;
  }

  inside([kind, tetrahedron, what, rest], x, y) {
    const [number, disc] = [what & 15, what >> 4];
    if (kind === 0) return '';
    const {page} = this;
    const {path, letters} = page.views.inside.follow(page.walker, x, y, page.canvas, 255 - rest);
    const t = path.at(-1);
    if ((t & 255) !== tetrahedron) return '';
    const seen = kind === 1 ? this.truncation(t, number, disc) : this.edge(t, number);
    return `${seen}; ${255 - rest} faces away; word ${this.word(letters.map(
        ([from, f]) => this.letter(from, f)))}`;
  }

  letter(t, f) { return this.page.data.face_letters[t][f]; }

  face(t, f) {
    const {manifold} = this.page;
    const edges = kEdgeEnds.flatMap((ends, e) => (
        ends.includes(f) ? [] : [`${manifold.edgeClass[t][e]} (${this.measures(t, e)})`]));
    return `tetrahedron ${t}, face ${f}, glued to face ${manifold.gluedFace[t][f]} of tetrahedron ` +
        `${manifold.neighbour[t][f]}; edges ${edges.join(', ')}`;
  }

  /// Of vertex v, or of the wall of the parabolic edge v - 4.
  truncation(t, v, disc) {
    if (v >= 4)
      return `tetrahedron ${t}, horosphere of the parabolic edge ${kEdgeEnds[v - 4].join('')} of ` +
          `class ${this.page.manifold.edgeClass[t][v - 4]}`;
    if (this.page.manifold.tetrahedra[t].diagonal[v] === 0)
      return `tetrahedron ${t}, horosphere ${v} of cusp ${this.page.manifold.vertexClass[t][v]}`;
    const length = this.page.manifold.discs.lengthOf(t, v, disc);
    return `tetrahedron ${t}, truncation ${v} of boundary component ` +
        `${this.page.manifold.vertexClass[t][v]}` +
        (length === null ? '' : `, disc of an arc of length ${shown(length)}`);
  }

  edge(t, e) {
    return `tetrahedron ${t}, edge ${kEdgeEnds[e].join('')} of class ` +
        `${this.page.manifold.edgeClass[t][e]}, ${this.measures(t, e)}`;
  }

  /// The length of an edge and its dihedral angle in the tetrahedron.
  measures(t, e) {
    const {edgeClass, tetrahedra} = this.page.manifold;
    if (tetrahedra[t].edges[e]) return 'parabolic';
    const [k, l] = [0, 1, 2, 3].filter((v) => !kEdgeEnds[e].includes(v));
    const cosine = -Lorentz.dot(tetrahedra[t].faces[k], tetrahedra[t].faces[l]);
    const degrees = Math.acos(Math.min(1, Math.max(-1, cosine))) * 180 / Math.PI;
    return `length ${Number(this.page.data.edge_lengths[edgeClass[t][e]].toPrecision(8))}, ` +
        `angle ${Number(degrees.toPrecision(8))}\u00b0`;
  }

  /// a, b, ... and A, B, ... for inverses; x1, X1, ... where there are more than 26 generators.
  word(letters) {
    const reduced = [];
    for (const letter of letters) {
      if (letter === 0) continue;
      if (reduced.at(-1) === -letter) reduced.pop();
      else reduced.push(letter);
    }
    const many = this.page.data.face_letters.flat().some((letter) => Math.abs(letter) > 26);
    const name = (letter) => {
      const text = many ? `x${Math.abs(letter)}` : String.fromCharCode(96 + Math.abs(letter));
      return letter > 0 ? text : text.toUpperCase();
    };
    return reduced.map(name).join(many ? '*' : '') || '1';
  }
}
