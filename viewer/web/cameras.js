// The two cameras: one orbits around the cells in the Euclidean space of the model, the other
// stands inside the manifold.

class OrbitCamera {
  constructor() { this.reset('ball'); }

  reset(model) {
    Object.assign(this, structuredClone(kModels[model].view));
    this.lowest = model === 'upper' ? 0.03 : -1.54;
  }

  turn(dx, dy) {
    this.yaw -= dx;
    this.pitch = Math.min(1.54, Math.max(this.lowest, this.pitch + dy));
  }
  zoom(factor) { this.distance = Math.min(40, Math.max(0.25, this.distance * factor)); }
  /// The same, while what is at a place of the picture, at the target's depth, stays there; x to the
  /// right and y upwards from -1 to 1.
  zoomAt(factor, x, y, aspect) {
    const before = this.distance;
    this.zoom(factor);
    const {tangent} = this.view(aspect), {right, up} = this.directions();
    for (let i = 0; i < 3; ++i)
      this.target[i] += (before - this.distance) * (x * tangent[0] * right[i] + y * tangent[1] * up[i]);
  }
  pan(dx, dy) {
    const {right, up} = this.directions();
    for (let i = 0; i < 3; ++i)
      this.target[i] += this.distance * (-dx * right[i] + dy * up[i]);
  }

  directions() {
    const [cy, sy, cp, sp] = [Math.cos(this.yaw), Math.sin(this.yaw), Math.cos(this.pitch),
                              Math.sin(this.pitch)];
    const outward = [cy * cp, sy * cp, sp];
    return {outward, right: [-sy, cy, 0], up: [-cy * sp, -sy * sp, cp]};
  }

  /// Uniforms of outside_camera.glsl. The field of view is that of the shorter side.
  view(aspect) {
    const {outward, right, up} = this.directions();
    const eye = this.target.map((x, i) => x + this.distance * outward[i]);
    eye[2] = Math.max(eye[2], this.lowest > 0 ? 0.01 : -1e9);
    const narrow = 0.36;
    const tangent = aspect >= 1 ? [narrow * aspect, narrow] : [narrow, narrow / aspect];
    const forward = scaled3(outward, -1);
    const depth = [0.01, this.distance + 12];
    // x and y of the picture from the space of the model; depth is the fragments' business.
    const row = (axis, t) => [...scaled3(axis, 1 / t), -dot3(axis, eye) / t];
    const rows = [row(right, tangent[0]), row(up, tangent[1]), [0, 0, 0, 0], row(forward, 1)];
    const projection = [0, 1, 2, 3].flatMap((j) => rows.map((r) => r[j]));
    return {eye, axes: [...right, ...up, ...forward], tangent, depth, projection};
  }
}

/// A frame that stands in a tetrahedron: columns right, up, forward, position, in its coordinates.
/// It is kept in doubles, made orthonormal again after every motion, and carried to the next
/// tetrahedron when it leaves through a face.
class WalkCamera {
  constructor(manifold) {
    this.manifold = manifold;
    this.place('centre');
  }

  /// One of three places in tetrahedron 0: its centre, near the wall of vertex 0, near edge 01.
  place(name) {
    const tetrahedron = this.manifold.tetrahedra[0], {vertices, corners} = tetrahedron;
    this.tetrahedron = 0;
    const corner = (i, j) => corners.find((c) => c.vertex === i && c.other === j).point;
    const middle = (...points) =>
        Lorentz.toPoint(points.reduce((sum, p) => Lorentz.combine(1, sum, 1, p)));
    if (name === 'wall') {
      const floor = middle(corner(0, 1), corner(0, 2), corner(0, 3));
      this.lookFrom(middle(floor, floor, floor, Lorentz.origin), middle(corner(2, 0), corner(3, 1)),
                    Lorentz.scale(vertices[0], -1));
    } else if (name === 'edge') {
      const edge = middle(corner(0, 1), corner(1, 0));
      this.lookFrom(middle(edge, edge, Lorentz.origin),
                    middle(corner(1, 0), corner(1, 2), corner(3, 2)), vertices[1]);
    } else {
      this.lookFrom(Lorentz.origin, middle(corner(2, 3), corner(3, 2), corner(1, 0)), vertices[1]);
    }
    if (!standsIn(tetrahedron, this.position())) this.frame = Lorentz.identity;
  }

  /// Stands at p and looks at q, with `up` upwards as far as possible.
  lookFrom(p, q, up) {
    const tangent = (x) => Lorentz.combine(1, x, Lorentz.dot(x, p), p);
    const unit = (x) => Lorentz.scale(x, 1 / Math.sqrt(Math.max(Lorentz.dot(x, x), 1e-300)));
    const forward = unit(tangent(q));
    let upward = tangent(up);
    upward = unit(Lorentz.combine(1, upward, -Lorentz.dot(upward, forward), forward));
    let right = Lorentz.identity.slice(0, 4);
    // Whatever is left: the axis that is farthest from the span of the others.
    let best = -1;
    for (const axis of [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]) {
      let a = tangent(axis);
      for (const b of [forward, upward]) a = Lorentz.combine(1, a, -Lorentz.dot(a, b), b);
      if (Lorentz.dot(a, a) > best) [best, right] = [Lorentz.dot(a, a), unit(a)];
    }
    const frame = Lorentz.fromColumns([right, upward, forward, p]);
    // right x up = -forward for a right-handed frame whose third axis points into the picture.
    this.frame = determinant(frame) < 0
        ? frame
        : Lorentz.fromColumns([Lorentz.scale(right, -1), upward, forward, p]);
  }

  position() { return Lorentz.column(this.frame, 3); }

  /// Turns: dx to the right, dy upwards, roll clockwise, in radians.
  turn(dx, dy, roll = 0) {
    const steps = [Lorentz.rotation(2, 0, dx), Lorentz.rotation(2, 1, dy),
                   Lorentz.rotation(1, 0, roll)];
    this.frame = Lorentz.orthonormalise(steps.reduce(Lorentz.multiply, this.frame));
  }

  /// Walks `distance` in the direction (right, up, forward), through faces, but not through the
  /// wall: what is left of a step that meets the wall goes along it. Returns true at a wall.
  walk(direction, distance) {
    let touched = false;
    let left = distance;
    let way = direction;
    for (let part = 0; part < 4 && left > 1e-9; ++part) {
      const wall = this.step(way, left);
      if (!wall) break;
      touched = true;
      left = wall.left;
      // The direction without its component towards the wall.
      const normal = [0, 1, 2].map((i) => Lorentz.dot(Lorentz.column(this.frame, i), wall.normal));
      const size = dot3(normal, normal);
      const into = dot3(way, normal) / size;
      const along = way.map((x, i) => x - into * normal[i]);
      const length = Math.hypot(...along);
      left *= length / Math.max(Math.hypot(...way), 1e-12);
      if (length < 1e-6) break;
      way = scaled3(along, 1 / length);
    }
    return touched;
  }

  /// Goes straight until the distance is done (null) or a wall is near (what is left, its normal).
  step(direction, distance) {
    const unit = scaled3(direction, 1 / Math.max(Math.hypot(...direction), 1e-12));
    let left = distance;
    for (let crossing = 0; crossing < 64 && left > 0; ++crossing) {
      const tetrahedron = this.manifold.tetrahedra[this.tetrahedron], {faces} = tetrahedron;
      const p = this.position();
      const u = unit.reduce((sum, x, i) => Lorentz.combine(1, sum, x, Lorentz.column(this.frame, i)),
                            [0, 0, 0, 0]);
      let [reach, face, wall] = [left, -1, null];
      faces.forEach((n, f) => {
        const towards = Lorentz.dot(n, u);
        if (towards <= 0) return;
        const ratio = -Lorentz.dot(n, p) / towards;
        const s = ratio >= 1 ? Infinity : Math.atanh(Math.max(ratio, 0));
        if (s < reach) [reach, face, wall] = [s, f, null];
      });
      cutOff(tetrahedron).forEach(({wall: v, isHorosphere}) => {
        if (Lorentz.dot(v, u) <= 0) return;
        const level = isHorosphere ? -Math.exp(WalkCamera.kClearance)
                                   : -Math.sinh(WalkCamera.kClearance);
        const s = distanceToLevel(Lorentz.dot(v, p), Lorentz.dot(v, u), level);
        if (s < reach) [reach, face, wall] = [s, -1, v];
      });
      this.advance(unit, reach);
      left -= reach;
      if (wall) return {left, normal: wall};
      if (face < 0) return null;
      this.cross(face);
    }
    return null;
  }

  advance(unit, distance) {
    // In the camera's own coordinates: a boost along `unit`.
    const motion = Lorentz.boostTo([...scaled3(unit, Math.sinh(distance)), Math.cosh(distance)]);
    this.frame = Lorentz.orthonormalise(Lorentz.multiply(this.frame, motion));
  }

  cross(face) {
    const matrix = this.manifold.crossing[this.tetrahedron][face];
    this.frame = Lorentz.orthonormalise(Lorentz.multiply(matrix, this.frame));
    this.tetrahedron = this.manifold.neighbour[this.tetrahedron][face];
  }
}
/// How near a wall one can come; nearer, it would fill the view.
WalkCamera.kClearance = 0.06;

/// The first s >= 0 with a cosh s + b sinh s = level, where b > 0; 0 if it is behind already.
function distanceToLevel(a, b, level) {
  if (a >= level) return 0;
  // (a + b) e^s / 2 + (a - b) e^-s / 2 = level
  const [p, q] = [(a + b) / 2, (a - b) / 2];
  const root = Math.sqrt(Math.max(level * level - 4 * p * q, 0));
  const candidates = Math.abs(p) < 1e-15 ? [q / level] : [(level + root) / (2 * p),
                                                           (level - root) / (2 * p)];
  const good = candidates.filter((y) => y >= 1).map(Math.log);
  return good.length ? Math.min(...good) : Infinity;
}
