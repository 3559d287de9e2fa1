#include "meshing/tube/detail/components.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "base/error.hpp"

namespace tripus::meshing::tube {
namespace {

/// Side k of a triangle: the directed edge from its corner k to the next.
struct Side {
  std::uint32_t from, to, triangle;
  friend auto operator<=>(const Side&, const Side&) = default;
};

std::vector<Side> sorted_sides(const SurfaceMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      sides.push_back({mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3], t});
  std::sort(sides.begin(), sides.end());
  return sides;
}

class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) { parent_[root(i)] = root(j); }

 private:
  std::vector<std::uint32_t> parent_;
};

[[noreturn]] void fail(const std::string& what) {
  throw InternalError("the tube's surface is not a closed manifold: " + what +
                      "; please report this graph");
}

}  // namespace

std::vector<long> euler_characteristics(const SurfaceMesh& mesh) {
  const std::vector<Side> sides = sorted_sides(mesh);
  const auto same_edge = [](const Side& a, const Side& b) {
    return a.from == b.from && a.to == b.to;
  };
  if (const auto twice = std::adjacent_find(sides.begin(), sides.end(), same_edge);
      twice != sides.end())
    fail("edge " + std::to_string(twice->from) + "-" + std::to_string(twice->to) + " twice");
  // Triangles at one vertex are joined around it; a manifold has one class of them at each vertex.
  UnionFind corners(3 * mesh.triangles.size()), components(mesh.points.size());
  const auto corner_of = [&](std::uint32_t t, std::uint32_t v) {
    const Triangle& c = mesh.triangles[t];
    return 3 * t + (c[0] == v ? 0u : c[1] == v ? 1u : 2u);
  };
  for (const Side& side : sides) {
    const auto back = std::lower_bound(sides.begin(), sides.end(), Side{side.to, side.from, 0});
    if (back == sides.end() || back->from != side.to || back->to != side.from)
      fail("edge " + std::to_string(side.from) + "-" + std::to_string(side.to) + " is open");
    for (const std::uint32_t v : {side.from, side.to})
      corners.join(corner_of(side.triangle, v), corner_of(back->triangle, v));
    components.join(side.from, side.to);
  }
  std::vector<std::uint32_t> umbrella(mesh.points.size(), 0xffffffff);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      std::uint32_t& first = umbrella[mesh.triangles[t][k]];
      const std::uint32_t root = corners.root(3 * t + k);
      if (first == 0xffffffff) first = root;
      if (first != root) fail("vertex " + std::to_string(mesh.triangles[t][k]) + " is pinched");
    }
  std::map<std::uint32_t, long> twice_chi;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (umbrella[v] == 0xffffffff) fail("vertex " + std::to_string(v) + " is unused");
    twice_chi[components.root(v)] += 2;
  }
  for (const Triangle& t : mesh.triangles) --twice_chi[components.root(t[0])];  // 3/2 - 1 = 1/2
  std::vector<long> result;
  for (const auto& [component, twice] : twice_chi) result.push_back(twice / 2);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace tripus::meshing::tube
