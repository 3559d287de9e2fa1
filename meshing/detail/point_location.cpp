#include "meshing/detail/point_location.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.hpp"
#include "base/tolerances.hpp"
#include "meshing/predicates.hpp"

namespace tripus::meshing::detail {
namespace {

/// Rays are drawn at random; a fixed seed makes every run the same.
constexpr std::uint32_t kRaySeed = 20261122;
constexpr int kMostRays = 1000;

/// Whether the segment p + t d, 0 <= t <= 1, may meet the box. All d are of one size, so that what
/// rounding adds to t is far below the margin.
bool may_meet(const Box& box, const Point& p, const Point& d) {
  double enter = 0, leave = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double s = (box.low[k] - p[k]) / d[k], t = (box.high[k] - p[k]) / d[k];
    enter = std::fmax(enter, std::fmin(s, t));
    leave = std::fmin(leave, std::fmax(s, t));
  }
  return enter <= leave + tolerance::kRayMargin;
}

}  // namespace

PointLocation::PointLocation(const SurfaceMesh& mesh,
                             const std::vector<std::uint32_t>& component_of)
    : mesh_(mesh), component_of_(component_of), tree_(mesh) {}

PointLocation::Ray PointLocation::cast(const Point& p, const Point& q, std::uint32_t without,
                                       std::vector<std::uint32_t>& crossed) const {
  const Point d{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  Ray result = Ray::kDone;
  tree_.for_each([&](const Box& box) { return may_meet(box, p, d); },
                 [&](std::uint32_t t) {
                   if (component_of_[t] == without) return true;
                   const Triangle& corners = mesh_.triangles[t];
                   const Point &a = mesh_.points[corners[0]], &b = mesh_.points[corners[1]],
                               &c = mesh_.points[corners[2]];
                   const int from = orientation(a, b, c, p), to = orientation(a, b, c, q);
                   if (from * to > 0) return true;
                   if (from == 0 && to == 0) {
                     if (segment_meets_triangle(p, q, a, b, c)) result = Ray::kUnlucky;
                     return result == Ray::kDone;
                   }
                   const int ab = orientation(p, q, a, b), bc = orientation(p, q, b, c),
                             ca = orientation(p, q, c, a);
                   if (std::min({ab, bc, ca}) < 0 && std::max({ab, bc, ca}) > 0) return true;
                   if (from == 0) {
                     result = Ray::kOnSurface;
                   } else if (ab == 0 || bc == 0 || ca == 0) {
                     result = Ray::kUnlucky;
                   } else {
                     crossed.push_back(component_of_[t]);
                   }
                   return result == Ray::kDone;
                 });
  return result;
}

std::optional<std::vector<std::uint32_t>> PointLocation::around(const Point& p,
                                                                std::uint32_t without) const {
  std::mt19937 random(kRaySeed);
  std::uniform_real_distribution<double> beyond(1, 2);
  const Box& box = tree_.box();
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) size = std::fmax(size, box.high[k] - box.low[k]);
  for (int ray = 0; ray < kMostRays; ++ray) {
    Point q;
    for (std::size_t k = 0; k < 3; ++k) q[k] = box.high[k] + size * beyond(random);
    std::vector<std::uint32_t> crossed;
    const Ray result = cast(p, q, without, crossed);
    if (result == Ray::kOnSurface) return std::nullopt;
    if (result == Ray::kUnlucky) continue;
    std::sort(crossed.begin(), crossed.end());
    std::vector<std::uint32_t> odd;
    for (std::size_t i = 0, end = 0; i < crossed.size(); i = end) {
      while (end < crossed.size() && crossed[end] == crossed[i]) ++end;
      if ((end - i) % 2 == 1) odd.push_back(crossed[i]);
    }
    return odd;
  }
  throw InternalError("no ray from a point met the surface in the inside of its triangles");
}

}  // namespace tripus::meshing::detail
