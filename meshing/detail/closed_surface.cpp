#include "meshing/detail/closed_surface.hpp"

#include <algorithm>

namespace tripus::meshing::detail {
namespace {

/// A side of a triangle, from one corner to the next.
struct DirectedSide {
  std::uint32_t from, to, triangle;
};

bool runs_before(const DirectedSide& a, const DirectedSide& b) {
  return a.from != b.from ? a.from < b.from : a.to < b.to;
}

std::vector<DirectedSide> directed_sides(const std::vector<Triangle>& triangles) {
  std::vector<DirectedSide> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      sides.push_back({triangles[t][k], triangles[t][(k + 1) % 3], t});
  std::sort(sides.begin(), sides.end(), runs_before);
  return sides;
}

std::string name_of(const DirectedSide& side) {
  return "edge " + std::to_string(side.from) + "-" + std::to_string(side.to);
}

}  // namespace

std::string manifold_fault(const std::vector<Triangle>& triangles, std::size_t point_count) {
  const std::vector<DirectedSide> sides = directed_sides(triangles);
  topology::DisjointSets corners(3 * triangles.size());
  const auto corner = [&](std::uint32_t t, std::uint32_t v) {
    return 3 * t + (triangles[t][0] == v ? 0u : triangles[t][1] == v ? 1u : 2u);
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i > 0 && !runs_before(sides[i - 1], sides[i])) return name_of(sides[i]) + " twice";
    const DirectedSide wanted{sides[i].to, sides[i].from, 0};
    const auto back = std::lower_bound(sides.begin(), sides.end(), wanted, runs_before);
    if (back == sides.end() || runs_before(wanted, *back)) return name_of(sides[i]) + " is open";
    for (const std::uint32_t v : {wanted.from, wanted.to})
      corners.join(corner(sides[i].triangle, v), corner(back->triangle, v));
  }
  constexpr std::uint32_t kNone = 0xffffffff;
  std::vector<std::uint32_t> fan(point_count, kNone);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      std::uint32_t& first = fan[triangles[t][k]];
      const std::uint32_t root = corners.root(3 * t + k);
      if (first == kNone) first = root;
      if (first != root) return "vertex " + std::to_string(triangles[t][k]) + " is pinched";
    }
  return {};
}

std::map<std::uint32_t, long> doubled_characteristics(const std::vector<Triangle>& triangles,
                                                      topology::DisjointSets& sets) {
  std::vector<bool> used(sets.size());
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) used[v] = true;
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  std::map<std::uint32_t, long> result;
  for (std::uint32_t v = 0; v < sets.size(); ++v)
    if (used[v]) result[sets.root(v)] += 2;
  for (const Triangle& t : triangles) --result[sets.root(t[0])];  // 3/2 - 1 = 1/2
  return result;
}

}  // namespace tripus::meshing::detail
