#include "meshing/tube/detail/guarded_surface.hpp"

#include "base/error.hpp"
#include "base/tolerances.hpp"

namespace tripus::meshing::tube {
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
