#include "meshing/tube/detail/guarded_surface.hpp"

#include "base/error.hpp"
#include "base/tolerances.hpp"

namespace tripus::meshing::tube {
namespace {

constexpr double kEps = tolerance::kSweepClearance;

struct Range {
  double low, high;
};

template <std::size_t N>
Range along(const Point& axis, const std::array<Point, N>& points) {
  Range r{HUGE_VAL, -HUGE_VAL};
  for (const Point& p : points) {
    const double x = dot(axis, p);
    r.low = std::min(r.low, x);
    r.high = std::max(r.high, x);
  }
  return r;
}

/// Two convex bodies with no common corner: is there a plane between them? Points are relative to
/// one of them; `size` bounds them all.
bool separate(const std::array<Point, 4>& t, const std::array<Point, 3>& f, double size) {
  const auto parts = [&](const Point& axis) {
    const double length = norm(axis);
    if (length <= kEps * size * size) return false;
    const Range a = along(axis, t), b = along(axis, f);
    const double gap = kEps * size * length;
    return a.low > b.high + gap || b.low > a.high + gap;
  };
  const std::array<Point, 6> te{t[1] - t[0], t[2] - t[0], t[3] - t[0],
                                t[2] - t[1], t[3] - t[1], t[3] - t[2]};
  const std::array<Point, 3> fe{f[1] - f[0], f[2] - f[0], f[2] - f[1]};
  if (parts(cross(fe[0], fe[1]))) return true;
  if (parts(cross(te[0], te[1])) || parts(cross(te[0], te[2])) || parts(cross(te[1], te[2])) ||
      parts(cross(te[3], te[4])))
    return true;
  for (const Point& x : te)
    for (const Point& y : fe)
      if (parts(cross(x, y))) return true;
  // Flat bodies in one plane are told apart within it.
  const Point n = cross(fe[0], fe[1]);
  for (const Point& y : fe)
    if (parts(cross(n, y))) return true;
  for (const Point& x : te)
    if (parts(cross(n, x))) return true;
  return false;
}

/// Two cones from a common corner, given by unit vectors along their edges: is there a plane
/// through the corner with one on each side, touching nothing but the corner?
///
/// Normals n with n . t >= 0 and n . f <= 0 for all edges form a cone, whose own edges are cross
/// products of two of these vectors (or, if all lie in one plane, of one with that plane's normal).
/// Their sum is inside it, and so separates strictly if any normal does.
bool cones_apart(const std::array<Point, 3>& t, const std::array<Point, 2>& f) {
  const std::array<Point, 5> rays{t[0], t[1], t[2], -1.0 * f[0], -1.0 * f[1]};
  Point sum{0, 0, 0};
  const auto add = [&](const Point& x, const Point& y) {
    const Point n = cross(x, y);
    const double length = norm(n);
    if (length <= kEps) return;
    double low = 0, high = 0;
    for (const Point& ray : rays) {
      const double d = dot(n, ray) / length;
      low = std::min(low, d);
      high = std::max(high, d);
    }
    if (low > -kEps) sum = sum + (1 / length) * n;
    if (high < kEps) sum = sum - (1 / length) * n;
  };
  for (std::size_t i = 0; i < rays.size(); ++i)
    for (std::size_t j = i + 1; j < rays.size(); ++j) add(rays[i], rays[j]);
  const Point plane = cross(f[0], f[1]);
  for (const Point& ray : rays) add(plane, ray);
  const double length = norm(sum);
  if (length <= kEps) return false;
  for (const Point& ray : rays)
    if (!(dot(sum, ray) > kEps * length)) return false;
  return true;
}

/// A wedge a b u p and a half-plane a b q at a common edge a b.
bool wedge_apart(const Point& edge, const Point& u, const Point& p, const Point& q) {
  const Point e = unit(edge);
  const auto across = [&](const Point& x) { return x - dot(x, e) * e; };
  const Point x = across(u), y = across(p), z = across(q);
  const double nx = norm(x), ny = norm(y), nz = norm(z);
  if (!(nx > 0 && ny > 0 && nz > 0)) return false;
  const double wedge = angle_between(x, y), to_x = angle_between(x, z), to_y = angle_between(y, z);
  // z is in the wedge exactly if the two angles add up to the wedge's.
  return to_x + to_y > wedge + kEps && to_x > kEps && to_y > kEps;
}

/// Moves the corners common to both to the front of each, in the same order.
int gather_common(Simplex<4>& t, Simplex<3>& f) {
  int common = 0;
  for (int i = 0; i < 4 && common < 3; ++i)
    for (int j = common; j < 3; ++j)
      if (t.names[i] == f.names[j]) {
        std::swap(t.names[i], t.names[common]);
        std::swap(t.points[i], t.points[common]);
        std::swap(f.names[j], f.names[common]);
        std::swap(f.points[j], f.points[common]);
        ++common;
        break;
      }
  return common;
}

}  // namespace

bool meet_in_common_face_only(const Simplex<4>& tetrahedron, const Simplex<3>& triangle) {
  Simplex<4> t = tetrahedron;
  Simplex<3> f = triangle;
  const int common = gather_common(t, f);
  if (common == 3) return false;
  const Point o = t.points[0];
  double size = 0;
  for (Point& p : t.points) {
    p = p - o;
    size = std::max(size, norm(p));
  }
  for (Point& p : f.points) {
    p = p - o;
    size = std::max(size, norm(p));
  }
  if (common == 0) return separate(t.points, f.points, size);
  for (int k = 1; k < 4; ++k)
    if (norm(t.points[k]) <= kEps * size) return false;
  if (common == 1)
    return cones_apart({unit(t.points[1]), unit(t.points[2]), unit(t.points[3])},
                       {unit(f.points[1]), unit(f.points[2])});
  return wedge_apart(t.points[1], t.points[2], t.points[3], f.points[2]);
}

namespace {

/// Grid cells for each triangle, at most; and the side of a cell in mean triangle sides.
constexpr double kCellsPerTriangle = 8;
constexpr double kCellSize = 2;

/// Name of the place that a vertex moves to, where that is no vertex.
constexpr std::uint32_t kNewPlace = 0xffffffff;

}  // namespace

GuardedSurface::GuardedSurface(SurfaceMesh mesh)
    : points_(std::move(mesh.points)),
      triangles_(std::move(mesh.triangles)),
      dead_(triangles_.size()),
      stars_(points_.size()),
      alive_(triangles_.size()),
      seen_(triangles_.size()) {
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    for (const std::uint32_t v : triangles_[t]) {
      if (stars_[v].count == kMostInStar)
        throw InternalError("a vertex of the sampled surface has more triangles than it can");
      stars_[v].triangles[stars_[v].count++] = t;
    }
  make_grid();
}

void GuardedSurface::make_grid() {
  double sides = 0;
  for (const Triangle& t : triangles_) sides += distance(points_[t[0]], points_[t[1]]);
  for (const Point& p : points_) bounds_.add(p);
  if (triangles_.empty()) return;
  const Point size = bounds_.high - bounds_.low;
  const double volume = size[0] * size[1] * size[2];
  cell_ = std::max(kCellSize * sides / double(triangles_.size()),
                   std::cbrt(volume / (kCellsPerTriangle * double(triangles_.size()))));
  for (int k = 0; k < 3; ++k) cells_[k] = std::size_t(size[k] / cell_) + 1;
  grid_.resize(cells_[0] * cells_[1] * cells_[2]);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) insert(t);
}

template <class Visit>
void GuardedSurface::for_cells(const Bounds& bounds, Visit&& visit) const {
  std::array<std::size_t, 3> from, to;
  for (int k = 0; k < 3; ++k) {
    const auto index = [&](double x) {
      const double i = (x - bounds_.low[k]) / cell_;
      return i <= 0 ? 0 : std::min(std::size_t(i), cells_[k] - 1);
    };
    from[k] = index(bounds.low[k]);
    to[k] = index(bounds.high[k]);
  }
  for (std::size_t i = from[0]; i <= to[0]; ++i)
    for (std::size_t j = from[1]; j <= to[1]; ++j)
      for (std::size_t k = from[2]; k <= to[2]; ++k) visit((i * cells_[1] + j) * cells_[2] + k);
}

Bounds GuardedSurface::bounds_of(std::uint32_t t) const {
  Bounds result;
  for (const std::uint32_t v : triangles_[t]) result.add(points_[v]);
  return result;
}

void GuardedSurface::insert(std::uint32_t t) {
  for_cells(bounds_of(t), [&](std::size_t c) { grid_[c].push_back(t); });
}

void GuardedSurface::remove(std::uint32_t t) {
  for_cells(bounds_of(t), [&](std::size_t c) {
    auto& cell = grid_[c];
    const auto found = std::find(cell.begin(), cell.end(), t);
    *found = cell.back();
    cell.pop_back();
  });
}

bool GuardedSurface::adjacent(std::uint32_t u, std::uint32_t v) const {
  for (const std::uint32_t t : star(u))
    if (std::ranges::find(triangles_[t], v) != triangles_[t].end()) return true;
  return false;
}

std::span<const GuardedSurface::RingEdge> GuardedSurface::ring_of(std::uint32_t u) {
  std::size_t count = 0;
  for (const std::uint32_t t : star(u)) {
    const Triangle& corners = triangles_[t];
    const int at = corners[0] == u ? 0 : corners[1] == u ? 1 : 2;
    ring_[count++] = {corners[(at + 1) % 3], corners[(at + 2) % 3]};
  }
  return {ring_.data(), count};
}

bool GuardedSurface::star_stays_embedded(std::uint32_t u, const Point& to, std::uint32_t merged,
                                         double least_quality) {
  const auto ring = ring_of(u);
  const Point& from = points_[u];
  Point n{0, 0, 0};
  double worst = 1;
  for (const auto& [a, b] : ring) {
    n = n + area_vector(from, points_[a], points_[b]);
    worst = std::min(worst, triangle_quality(from, points_[a], points_[b]));
  }
  const double size = norm(n);
  if (!(size > 0)) return false;
  n = (1 / size) * n;
  const double bound = std::min(worst, least_quality);
  // Every triangle keeps its side, by a margin, at the start and at the end, and so on the way.
  for (const auto& [a, b] : ring) {
    const double least = tolerance::kSweepClearance * size;
    if (!(dot(n, area_vector(from, points_[a], points_[b])) > least)) return false;
    if (a == merged || b == merged) continue;
    if (!(dot(n, area_vector(to, points_[a], points_[b])) > least)) return false;
    if (triangle_quality(to, points_[a], points_[b]) < bound) return false;
  }
  // Once around: seen along n, the ring crosses the line through its first corner upwards once.
  const Point side = cross(n, points_[ring[0].a] - from);
  int turns = 0;
  for (const auto& [a, b] : ring) {
    const Point pa = points_[a] - from, pb = points_[b] - from;
    const bool above_a = a == ring[0].a || dot(pa, side) >= 0;
    const bool above_b = b == ring[0].a || dot(pb, side) >= 0;
    if (!above_a && above_b) ++turns;
  }
  return turns == 1;
}

void GuardedSurface::collect_near(const Bounds& bounds, std::uint32_t u) {
  near_.clear();
  if (++now_ == 0) {  // the stamps came round
    std::ranges::fill(seen_, 0u);
    now_ = 1;
  }
  for (const std::uint32_t t : star(u)) seen_[t] = now_;
  for_cells(bounds, [&](std::size_t c) {
    for (const std::uint32_t t : grid_[c]) {
      if (seen_[t] == now_) continue;
      seen_[t] = now_;
      if (bounds_of(t).meets(bounds)) near_.push_back(t);
    }
  });
}

bool GuardedSurface::sweep_is_clear(std::uint32_t u, const Point& to, std::uint32_t merged) {
  const auto ring = ring_of(u);
  Bounds bounds;
  bounds.add(points_[u]);
  bounds.add(to);
  for (const auto& [a, b] : ring) bounds.add(points_[a]);
  collect_near(bounds, u);
  const std::uint32_t place = merged == kNewPlace ? kNewPlace : merged;
  for (const auto& [a, b] : ring) {
    if (a == merged || b == merged) continue;  // sweeps nothing but itself
    const Simplex<4> swept{{u, place, a, b}, {points_[u], to, points_[a], points_[b]}};
    const Bounds swept_bounds = swept.bounds();
    for (const std::uint32_t t : near_) {
      const Triangle& c = triangles_[t];
      const Simplex<3> other{c, {points_[c[0]], points_[c[1]], points_[c[2]]}};
      if (swept_bounds.meets(other.bounds()) && !meet_in_common_face_only(swept, other))
        return false;
    }
  }
  return true;
}

bool GuardedSurface::move(std::uint32_t u, const Point& to, double least_quality) {
  if (to == points_[u]) return false;
  if (!star_stays_embedded(u, to, kNewPlace, least_quality)) return false;
  if (!sweep_is_clear(u, to, kNewPlace)) return false;
  for (const std::uint32_t t : star(u)) remove(t);
  points_[u] = to;
  for (const std::uint32_t t : star(u)) insert(t);
  return true;
}

bool GuardedSurface::link_allows(std::uint32_t u, std::uint32_t v) {
  // The only common neighbours of u and v are the far corners of the two triangles between them.
  int common = 0, between = 0;
  for (const auto& [a, b] : ring_of(u)) {
    if (a == v || b == v) ++between;
    if (a != v && adjacent(a, v)) ++common;
  }
  return between == 2 && common == 2 && stars_[v].count > 3 &&
         stars_[u].count + stars_[v].count - 4 <= kMostInStar;
}

void GuardedSurface::drop_from_star(std::uint32_t v, std::uint32_t t) {
  Star& s = stars_[v];
  *std::find(s.triangles.begin(), s.triangles.begin() + s.count, t) = s.triangles[s.count - 1];
  --s.count;
}

bool GuardedSurface::collapse(std::uint32_t u, std::uint32_t v, double least_quality) {
  if (!link_allows(u, v)) return false;
  if (!star_stays_embedded(u, points_[v], v, least_quality)) return false;
  if (!sweep_is_clear(u, points_[v], v)) return false;
  for (const std::uint32_t t : star(u)) remove(t);
  for (const std::uint32_t t : star(u)) {
    const Triangle& corners = triangles_[t];
    if (std::ranges::find(corners, v) == corners.end()) continue;
    dead_[t] = true;
    --alive_;
    for (const std::uint32_t w : corners)
      if (w != u) drop_from_star(w, t);
  }
  for (const std::uint32_t t : star(u)) {
    if (dead_[t]) continue;
    *std::ranges::find(triangles_[t], u) = v;
    stars_[v].triangles[stars_[v].count++] = t;
    insert(t);
  }
  stars_[u].count = 0;
  return true;
}

SurfaceMesh GuardedSurface::mesh() const {
  SurfaceMesh result;
  std::vector<std::uint32_t> number(points_.size());
  for (std::size_t v = 0; v < points_.size(); ++v)
    if (stars_[v].count > 0) {
      number[v] = std::uint32_t(result.points.size());
      result.points.push_back(points_[v]);
    }
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    if (!dead_[t])
      result.triangles.push_back(
          {number[triangles_[t][0]], number[triangles_[t][1]], number[triangles_[t][2]]});
  return result;
}

}  // namespace tripus::meshing::tube
