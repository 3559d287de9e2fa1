#include "meshing/tube/detail/convex_hull.hpp"

#include <algorithm>

#include "meshing/predicates.hpp"

namespace tripus::meshing::tube {
namespace {

/// Four of the names whose points do not lie in a plane, in front; says no if there are none.
bool put_simplex_first(const std::vector<Point>& points, std::vector<std::uint32_t>& names) {
  const auto bring = [&](std::size_t place, const auto& fits) {
    for (std::size_t i = place; i < names.size(); ++i)
      if (fits(points[names[i]])) {
        std::swap(names[place], names[i]);
        return true;
      }
    return false;
  };
  const auto at = [&](std::size_t i) -> const Point& { return points[names[i]]; };
  return names.size() >= 4 && bring(1, [&](const Point& p) { return p != at(0); }) &&
         bring(2, [&](const Point& p) { return projection_axis(at(0), at(1), p) >= 0; }) &&
         bring(3, [&](const Point& p) { return orientation(at(0), at(1), at(2), p) != 0; });
}

Triangle from_least(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

}  // namespace

ConvexHull::ConvexHull(const std::vector<Point>& points, const std::vector<std::uint32_t>& names) {
  std::vector<std::uint32_t> order = names;
  if (!put_simplex_first(points, order)) return;
  std::uint32_t a = order[0], b = order[1];
  const std::uint32_t c = order[2], d = order[3];
  if (orientation(points[a], points[b], points[c], points[d]) > 0) std::swap(a, b);
  facets_ = {{a, b, c}, {b, a, d}, {c, b, d}, {a, c, d}};
  for (std::size_t i = 4; i < order.size(); ++i) add(points, order[i]);
}

bool ConvexHull::add(const std::vector<Point>& points, std::uint32_t name) {
  kept_.clear();
  sides_.clear();
  backward_.clear();
  for (const Triangle& f : facets_) {
    if (orientation(points[f[0]], points[f[1]], points[f[2]], points[name]) <= 0) {
      kept_.push_back(f);
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      sides_.push_back({f[k], f[(k + 1) % 3]});
      backward_.push_back({f[(k + 1) % 3], f[k]});
    }
  }
  if (sides_.empty()) return false;
  // What is seen of the hull is a disc; its rim are the sides without a mate.
  std::sort(backward_.begin(), backward_.end());
  for (const auto& side : sides_)
    if (!std::binary_search(backward_.begin(), backward_.end(), side))
      kept_.push_back({side[0], side[1], name});
  facets_.swap(kept_);
  return true;
}

bool take_out(std::vector<Triangle>& facets, const std::vector<Triangle>& triangles) {
  std::vector<Triangle> sorted;
  for (const Triangle& t : triangles) sorted.push_back(from_least(t));
  std::sort(sorted.begin(), sorted.end());
  return sorted.size() == std::erase_if(facets, [&](const Triangle& facet) {
           return std::binary_search(sorted.begin(), sorted.end(), from_least(facet));
         });
}

}  // namespace tripus::meshing::tube
