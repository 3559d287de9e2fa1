#include "meshing/detail/connectivity.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "meshing/detail/places.hpp"

namespace tripus::meshing::detail {
namespace {

constexpr std::uint32_t kNoneYet = UINT32_MAX;

struct Side {
  std::uint32_t low, high;  ///< the ends
  std::uint32_t side;       ///< 3 * triangle + k

  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(3 * t + k)});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    if (x.low != y.low) return x.low < y.low;
    return x.high != y.high ? x.high < y.high : x.side < y.side;
  });
  return sides;
}

using Name = std::function<std::string(std::size_t)>;

/// The wrong edges of one kind: how many, and the one in the first triangle.
struct Wrong {
  std::size_t count = 0;
  std::vector<Side> first;

  void add(const Side* begin, const Side* end) {
    if (count++ == 0 || begin->side < first.front().side) first.assign(begin, end);
  }
};

std::vector<std::uint32_t> mates(const std::vector<Triangle>& triangles, const Name& name,
                                 const Places& places) {
  const std::vector<Side> sides = sorted_sides(triangles);
  std::vector<std::uint32_t> mate(sides.size(), kNoneYet);
  Wrong open, crowded;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].same_edge(sides[i])) ++end;
    if (end - i == 2) {
      mate[sides[i].side] = sides[i + 1].side;
      mate[sides[i + 1].side] = sides[i].side;
    } else {
      (end - i == 1 ? open : crowded).add(&sides[i], &sides[0] + end);
    }
  }
  if (crowded.count > 0) {
    const auto& s = crowded.first;
    throw InvalidInput(places.edge(s[0].low, s[0].high) + " is not manifold: it is in " +
                       std::to_string(s.size()) + " triangles, the first of them " +
                       name(s[0].side / 3) + ", " + name(s[1].side / 3) + ", " +
                       name(s[2].side / 3) + in_all(crowded.count) +
                       "; an edge must be in two: separate the sheets that touch there");
  }
  if (open.count > 0) {
    const Side& s = open.first.front();
    throw InvalidInput(places.edge(s.low, s.high) + " is open: only " + name(s.side / 3) +
                       " has it" + in_all(open.count) +
                       "; close the surface (merge points that lie in one place, fill holes)");
  }
  return mate;
}

/// The triangles around each point, walked across the mates, must be all that have it.
void require_fans(const std::vector<Triangle>& triangles, std::size_t point_count,
                  const std::vector<std::uint32_t>& mate, const Name& name, const Places& places) {
  std::vector<bool> seen(3 * triangles.size(), false);  // corners
  std::vector<std::uint32_t> first(point_count, kNoneYet);
  for (std::uint32_t start = 0; start < 3 * triangles.size(); ++start) {
    if (seen[start]) continue;
    const std::uint32_t point = triangles[start / 3][start % 3];
    if (first[point] != kNoneYet)
      throw InvalidInput(places.point(point) + " is not manifold: " + name(first[point] / 3) +
                         " and " + name(start / 3) +
                         " meet there without a chain of triangles around it; separate the parts "
                         "of the surface that touch at this point");
    first[point] = start;
    std::uint32_t corner = start;
    std::uint32_t leave = start;  // the side across which the walk goes on
    do {
      seen[corner] = true;
      const std::uint32_t across = mate[leave];
      const std::uint32_t t = across / 3, k = across % 3;
      // The point is one end of side `across`; the walk leaves over the other side at it.
      const bool at_start = triangles[t][k] == point;
      corner = 3 * t + (at_start ? k : (k + 1) % 3);
      leave = 3 * t + (at_start ? (k + 2) % 3 : (k + 1) % 3);
    } while (corner != start);
  }
}

/// Components, and which triangles to turn round.
void walk_components(const std::vector<Triangle>& triangles, const Name& name, Connectivity& c) {
  c.component_of.assign(triangles.size(), kNoneYet);
  c.turned.assign(triangles.size(), false);
  std::vector<std::uint32_t> todo;
  for (std::uint32_t start = 0; start < triangles.size(); ++start) {
    if (c.component_of[start] != kNoneYet) continue;
    c.component_of[start] = c.component_count;
    todo.push_back(start);
    while (!todo.empty()) {
      const std::uint32_t t = todo.back();
      todo.pop_back();
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t across = c.mate[3 * t + k], other = across / 3;
        // Neighbours that agree run along the edge in opposite directions.
        const bool agree = triangles[t][k] != triangles[other][across % 3];
        const bool turn = c.turned[t] == agree;
        if (c.component_of[other] == kNoneYet) {
          c.component_of[other] = c.component_count;
          c.turned[other] = turn;
          todo.push_back(other);
        } else if (c.turned[other] != turn) {
          throw InvalidInput("the surface is one-sided (" + name(t) + " and " + name(other) +
                             " cannot both be turned to face outwards), so it bounds nothing in "
                             "space");
        }
      }
    }
    ++c.component_count;
  }
}

}  // namespace

Connectivity require_closed_manifold(const std::vector<Triangle>& triangles,
                                     std::size_t point_count, const Name& name,
                                     const Places& places) {
  Connectivity c;
  c.mate = mates(triangles, name, places);
  require_fans(triangles, point_count, c.mate, name, places);
  walk_components(triangles, name, c);
  return c;
}

}  // namespace tripus::meshing::detail
