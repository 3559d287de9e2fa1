// Polygons of a picture that hold faces: what the card is given to draw, so that it asks few pixels in
// vain.

/// The polygon of a picture around sides that are arcs of conics: one that bends inwards has its
/// middle for a corner, if that saves enough, one that bends outwards is in its tangents.
class RimPolygon {
  constructor() {
    // 6 corners, and 2 on each side; sharp ones count twice.
    [this.x, this.y, this.inX, this.inY] = [36, 36, 36, 36].map((size) => new Float64Array(size));
    this.ring = new Int32Array(36);
    this.triangles = new Int32Array(102);
    this.places = new Float64Array(6);  // of a side: begin, middle, end
    this.ways = new Float64Array(6);    // its directions there
    this.count = 0;
  }

  /// Returns false where there is no simple polygon.
  build(sides, offset, shrink, axes, focal) {
    const {places, ways} = this;
    Object.assign(this, {sides, offset, shrink, axes, focal});
    this.count = 0;
    const count = sides.length / 15;
    let turn = 0;  // twice the area of the corners and middles
    for (let side = 0; side < count; ++side) {
      this.look(15 * side, 0);
      this.look(15 * side + 3, 2);
      this.look(15 * ((side + 1) % count), 4);
      turn += places[0] * places[3] - places[1] * places[2] + places[2] * places[5] - places[3] * places[4];
    }
    const saves = turn > 300 || turn < -300;
    for (let side = 0; side < count; ++side) {
      this.look(15 * side, 0);
      this.look(15 * side + 3, 2);
      this.look(15 * ((side + 1) % count), 4);
      this.add(places[0], places[1]);
      const dx = places[4] - places[0], dy = places[5] - places[1];
      // How far the middle is within the chord, times the chord's length.
      const within = (dx * (places[3] - places[1]) - dy * (places[2] - places[0])) * Math.sign(turn);
      if (within > 0) {
        if (saves && within > 8) this.add(places[2], places[3]);
        continue;
      }
      if (within > -1e-2 * Math.hypot(dx, dy)) continue;
      for (let k = 0; k < 3; ++k) this.lookAlong(15 * side + 6 + 3 * k, 2 * k);
      if (!this.addMeeting(0) || !this.addMeeting(2)) return false;
    }
    if (turn < 0) this.reverse();
    return this.widen() && this.cut();
  }

  /// Finds a place of the picture.
  look(at, to) {
    const {sides, offset, shrink, axes, focal, places} = this;
    const px = sides[at] * shrink + offset[0], py = sides[at + 1] * shrink + offset[1],
          pz = sides[at + 2] * shrink + offset[2];
    const depth = axes[6] * px + axes[7] * py + axes[8] * pz;
    places[to] = focal[0] * (axes[0] * px + axes[1] * py + axes[2] * pz) / depth;
    places[to + 1] = focal[1] * (axes[3] * px + axes[4] * py + axes[5] * pz) / depth;
  }

  /// Finds a direction there, up to a positive factor.
  lookAlong(at, to) {
    const {sides, axes, focal, places, ways} = this;
    const tx = sides[at], ty = sides[at + 1], tz = sides[at + 2];
    const deeper = axes[6] * tx + axes[7] * ty + axes[8] * tz;
    ways[to] = focal[0] * (axes[0] * tx + axes[1] * ty + axes[2] * tz) - places[to] * deeper;
    ways[to + 1] = focal[1] * (axes[3] * tx + axes[4] * ty + axes[5] * tz) - places[to + 1] * deeper;
  }

  add(x, y) {
    this.x[this.count] = x;
    this.y[this.count++] = y;
  }

  /// Adds the place where two tangents meet, ahead of the first and behind the second.
  addMeeting(at) {
    const {places, ways} = this;
    const sine = ways[at] * ways[at + 3] - ways[at + 1] * ways[at + 2];
    const dx = places[at + 2] - places[at], dy = places[at + 3] - places[at + 1];
    const ahead = (dx * ways[at + 3] - dy * ways[at + 2]) / sine;
    const behind = (dx * ways[at + 1] - dy * ways[at]) / sine;
    if (!(ahead > 0 && behind < 0)) return false;
    this.add(places[at] + ahead * ways[at], places[at + 1] + ahead * ways[at + 1]);
    return true;
  }

  reverse() {
    const {x, y, count} = this;
    for (let i = 0, j = count - 1; i < j; ++i, --j) {
      const px = x[i], py = y[i];
      x[i] = x[j];
      y[i] = y[j];
      x[j] = px;
      y[j] = py;
    }
  }

  /// Moves all sides outwards by what rounding in the shaders may move a pixel.
  widen() {
    const {count} = this, x = this.inX, y = this.inY, more = 0.08;
    [this.inX, this.inY, this.x, this.y] = [this.x, this.y, x, y];
    const {inX, inY} = this;
    this.count = 0;
    for (let n = 0; n < count; ++n) {
      const before = n > 0 ? n - 1 : count - 1, after = n + 1 < count ? n + 1 : 0;
      let dx = inX[n] - inX[before], dy = inY[n] - inY[before];
      let ex = inX[after] - inX[n], ey = inY[after] - inY[n];
      const d = Math.sqrt(dx * dx + dy * dy), e = Math.sqrt(ex * ex + ey * ey);
      if (!(d > 1e-3 && e > 1e-3)) return false;
      dx *= more / d;
      dy *= more / d;
      ex *= more / e;
      ey *= more / e;
      const sine = dx * ey - dy * ex, cosine = dx * ex + dy * ey, square = more * more;
      if (cosine > -0.7 * square) {
        // Where the two lines, moved outwards, meet.
        const along = sine / (square + cosine);
        this.add(inX[n] + dy + along * dx, inY[n] - dx + along * dy);
      } else {
        this.add(inX[n] + dy + dx, inY[n] - dx + dy);
        this.add(inX[n] + ey - ex, inY[n] - ex - ey);
      }
    }
    return true;
  }

  /// Cuts it into triangles, corner by corner; false if it crosses itself.
  cut() {
    const {x, y, ring, triangles} = this;
    let left = this.count, done = 0;
    const area = (a, b, c) => (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    for (let n = 0; n < left; ++n) ring[n] = n;
    while (left > 3) {
      let best = -1, shortest = Infinity;
      for (let n = 0; n < left; ++n) {
        const a = ring[(n + left - 1) % left], b = ring[n], c = ring[(n + 1) % left];
        const long = (x[c] - x[a]) ** 2 + (y[c] - y[a]) ** 2;
        if (long >= shortest || !(area(a, b, c) > 0)) continue;
        let free = true;
        for (let k = 0; k < left && free; ++k) {
          const p = ring[k];
          if (p === a || p === b || p === c) continue;
          free = area(a, b, p) < 0 || area(b, c, p) < 0 || area(c, a, p) < 0;
        }
        if (!free) continue;
        best = n;
        shortest = long;
      }
      if (best < 0) return false;
      triangles[done++] = ring[(best + left - 1) % left];
      triangles[done++] = ring[best];
      triangles[done++] = ring[(best + 1) % left];
      for (let k = best; k + 1 < left; ++k) ring[k] = ring[k + 1];
      --left;
    }
    if (!(area(ring[0], ring[1], ring[2]) > 0)) return false;
    for (let k = 0; k < 3; ++k) triangles[done++] = ring[k];
    return true;
  }
}

/// Finds where faces lie on a picture, and makes polygons around them; as in proxies.cpp.
class ProxyMesh {
  constructor() {
    this.corners = new Float32Array(3 * 4096);
    this.triangles = new Uint32Array(3 * 4096);
    this.reach = new Float64Array(16);
    this.offset = new Float64Array(3);
    this.rim = new RimPolygon();
    this.isWhole = false;  // for tests: all polygons are the whole picture
    this.clear();
  }

  clear() { this.cornerCount = this.triangleCount = 0; }

  /// Draws the polygons by way of two buffers; attribute 0 is on.
  draw(gl, corners, triangles) {
    gl.bindBuffer(gl.ARRAY_BUFFER, corners);
    gl.bufferData(gl.ARRAY_BUFFER, this.corners.subarray(0, 3 * this.cornerCount), gl.STREAM_DRAW);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, triangles);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, this.triangles.subarray(0, 3 * this.triangleCount),
                  gl.STREAM_DRAW);
    gl.drawElements(gl.TRIANGLES, 3 * this.triangleCount, gl.UNSIGNED_INT, 0);
  }

  look(view, width, height) {
    Object.assign(this, {view, width, height});
    this.focal = [width / 2 / view.tangent[0], height / 2 / view.tangent[1]];
    // Away from the middle of the picture lengths look longer.
    this.widening = Math.max(...this.focal) * (1 + view.tangent[0] ** 2 + view.tangent[1] ** 2);
  }

  /// Adds the polygon around the points, moved towards `centre` by the factor `shrink`.
  add(points, margin, centre, shrink, record) {
    const {reach} = this, {eye} = this.view;
    if (this.isWhole) {
      reach.fill(this.width + this.height);
      this.addPolygon(4, 0, record);
      return;
    }
    const {offset} = this;
    for (let k = 0; k < 3; ++k) offset[k] = centre[k] * (1 - shrink) - eye[k];
    reach.fill(-Infinity);
    const nearest = this.extend(points, offset, shrink, 0);
    margin *= shrink;
    if (nearest <= margin + 1e-6) {  // it may surround the eye
      reach.fill(this.width + this.height);
      this.addPolygon(2, 0, record);
      return;
    }
    const more = margin / (nearest - margin) * this.widening + 0.06;
    const straight = (reach[0] + reach[8] + 2 * more) * (reach[4] + reach[12] + 2 * more);
    const slanting = (reach[2] + reach[10] + 2 * more) * (reach[6] + reach[14] + 2 * more);
    const area = Math.min(straight, slanting), large = area > 2500;
    if (large) this.extend(points, offset, shrink, 1);
    for (let k = 0; k < 16; ++k) reach[k] += more;
    if (area < 120) this.addPolygon(4, slanting < straight ? 2 : 0, record);
    else this.addPolygon(large ? 1 : 2, 0, record);
  }

  /// Adds the polygon around the sides of a wall that turns its outer side to the eye with all
  /// its points; returns whether there is one.
  ///   nearest  its least depth
  addSides(sides, nearest, centre, shrink, record) {
    if (this.isWhole || !(nearest > 1e-3)) return false;
    const {rim, offset} = this, {eye} = this.view;
    for (let k = 0; k < 3; ++k) offset[k] = centre[k] * (1 - shrink) - eye[k];
    if (!rim.build(sides, offset, shrink, this.view.axes, this.focal)) return false;
    const {count, x, y, triangles} = rim, {width, height} = this;
    const first = this.begin(count);
    for (let n = 0; n < count; ++n) this.addCorner(2 * x[n] / width, 2 * y[n] / height, record);
    if (!this.end(first)) return true;
    for (let i = 0; i < 3 * (count - 2); ++i)
      this.triangles[3 * this.triangleCount + i] = first + triangles[i];
    this.triangleCount += count - 2;
    return true;
  }

  /// Finds how far points reach in the even or odd ones of 16 directions; returns the least depth.
  extend(points, offset, shrink, odd) {
    const reach = this.reach, axes = this.view.axes, d = ProxyMesh.kDirections;
    const fx = this.focal[0], fy = this.focal[1], ox = offset[0], oy = offset[1], oz = offset[2];
    let nearest = Infinity;
    for (let i = 0; i < points.length; i += 3) {
      const px = points[i] * shrink + ox, py = points[i + 1] * shrink + oy,
            pz = points[i + 2] * shrink + oz;
      const depth = axes[6] * px + axes[7] * py + axes[8] * pz;
      if (depth < nearest) nearest = depth;
      const x = fx * (axes[0] * px + axes[1] * py + axes[2] * pz) / depth;
      const y = fy * (axes[3] * px + axes[4] * py + axes[5] * pz) / depth;
      for (let k = odd; k < 8; k += 2) {
        const along = d[2 * k] * x + d[2 * k + 1] * y;
        if (along > reach[k]) reach[k] = along;
        if (-along > reach[k + 8]) reach[k + 8] = -along;
      }
    }
    return nearest;
  }

  /// The polygon that reaches so far in every `step`-th direction, the first being `start`.
  addPolygon(step, start, record) {
    const reach = this.reach, width = this.width, height = this.height;
    const directions = ProxyMesh.kDirections;
    const count = 16 / step;
    const first = this.begin(count);
    for (let n = 0; n < count; ++n) {
      const k = (start + n * step) % 16, l = (k + step) % 16;
      const dx = directions[2 * k], dy = directions[2 * k + 1], ex = directions[2 * l],
            ey = directions[2 * l + 1];
      const sine = dx * ey - dy * ex;
      this.addCorner(2 * (reach[k] * ey - reach[l] * dy) / sine / width,
                     2 * (reach[l] * dx - reach[k] * ex) / sine / height, record);
    }
    if (!this.end(first)) return;
    for (let i = 1; i + 1 < count; ++i) {
      const at = 3 * this.triangleCount++;
      this.triangles[at] = first;
      this.triangles[at + 1] = first + i;
      this.triangles[at + 2] = first + i + 1;
    }
  }

  /// Makes room for a polygon; returns the number of its first corner.
  begin(count) {
    this.reserve(count);
    this.left = this.low = Infinity;
    this.right = this.high = -Infinity;
    return this.cornerCount;
  }

  addCorner(x, y, record) {
    const at = 3 * this.cornerCount++;
    this.corners[at] = x;
    this.corners[at + 1] = y;
    this.corners[at + 2] = record;
    if (x < this.left) this.left = x;
    if (x > this.right) this.right = x;
    if (y < this.low) this.low = y;
    if (y > this.high) this.high = y;
  }

  /// Takes the corners since `first` back if all of them lie beside the picture; whether they stay.
  end(first) {
    if (this.left <= 1 && this.right >= -1 && this.low <= 1 && this.high >= -1) return true;
    this.cornerCount = first;
    return false;
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
// Sixteen directions of the picture, counter-clockwise.
ProxyMesh.kDirections = Float64Array.from({length: 32}, (_, i) => {
  const angle = (i >> 1) * Math.PI / 8;
  return i % 2 === 0 ? Math.cos(angle) : Math.sin(angle);
});
