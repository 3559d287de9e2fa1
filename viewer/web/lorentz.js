// The hyperboloid model: vectors [x1, x2, x3, x4] with x1 y1 + x2 y2 + x3 y3 - x4 y4, time last.
// Matrices are arrays of 16, row by row, and act on columns. Everything here is in doubles: the
// shaders get single precision only after the numbers have been brought near the origin.
const Lorentz = {
  origin: [0, 0, 0, 1],
  identity: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],

  dot: (x, y) => x[0] * y[0] + x[1] * y[1] + x[2] * y[2] - x[3] * y[3],
  scale: (x, s) => x.map((value) => value * s),
  /// a x + b y
  combine: (a, x, b, y) => x.map((value, i) => a * value + b * y[i]),

  apply: (m, x) => [0, 4, 8, 12].map(
      (row) => m[row] * x[0] + m[row + 1] * x[1] + m[row + 2] * x[2] + m[row + 3] * x[3]),

  multiply(a, b) {
    const out = new Array(16);
    for (let i = 0; i < 4; ++i)
      for (let j = 0; j < 4; ++j) {
        let sum = 0;
        for (let k = 0; k < 4; ++k) sum += a[4 * i + k] * b[4 * k + j];
        out[4 * i + j] = sum;
      }
    return out;
  },

  /// The inverse of an isometry: J m^T J with J = diag(1, 1, 1, -1).
  inverse(m) {
    const out = new Array(16);
    for (let i = 0; i < 4; ++i)
      for (let j = 0; j < 4; ++j)
        out[4 * i + j] = (i === 3) !== (j === 3) ? -m[4 * j + i] : m[4 * j + i];
    return out;
  },

  column: (m, j) => [m[j], m[4 + j], m[8 + j], m[12 + j]],
  fromColumns: (c) => [0, 1, 2, 3].flatMap((i) => c.map((column) => column[i])),

  /// The point of the hyperboloid on the ray of a timelike vector.
  toPoint(x) {
    const length = Math.sqrt(Math.max(-Lorentz.dot(x, x), 1e-300));
    return Lorentz.scale(x, Math.sign(x[3]) / length);
  },

  /// The isometry without rotation that takes the origin to point p.
  boostTo(p) {
    const [x, y, z, w] = p;
    const k = 1 / (1 + w);
    return [1 + x * x * k, x * y * k, x * z * k, x,
            y * x * k, 1 + y * y * k, y * z * k, y,
            z * x * k, z * y * k, 1 + z * z * k, z,
            x, y, z, w];
  },

  /// The isometry that moves by `distance` along an axis (0, 1, 2) of its frame.
  boostAlong(axis, distance) {
    const out = Lorentz.identity.slice();
    out[5 * axis] = out[15] = Math.cosh(distance);
    out[4 * axis + 3] = out[12 + axis] = Math.sinh(distance);
    return out;
  },

  /// The rotation by `angle` that turns axis a towards axis b.
  rotation(a, b, angle) {
    const out = Lorentz.identity.slice();
    out[5 * a] = out[5 * b] = Math.cos(angle);
    out[4 * b + a] = Math.sin(angle);
    out[4 * a + b] = -Math.sin(angle);
    return out;
  },

  /// The isometry nearest to a matrix that has drifted: Gram-Schmidt, the point first.
  orthonormalise(m) {
    const p = Lorentz.toPoint(Lorentz.column(m, 3));
    const axes = [];
    for (let j = 0; j < 3; ++j) {
      let a = Lorentz.column(m, j);
      a = Lorentz.combine(1, a, Lorentz.dot(a, p), p);
      for (const b of axes) a = Lorentz.combine(1, a, -Lorentz.dot(a, b), b);
      axes.push(Lorentz.scale(a, 1 / Math.sqrt(Math.max(Lorentz.dot(a, a), 1e-300))));
    }
    return Lorentz.fromColumns([...axes, p]);
  },

  distance: (p, q) => Math.acosh(Math.max(1, -Lorentz.dot(p, q))),
};
