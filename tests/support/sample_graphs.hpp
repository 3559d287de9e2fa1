#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "meshing/tube/spatial_graph.hpp"
#include "tests/support/data_folder.hpp"

/// Graphs in space for the tests of meshing/tube.
namespace tripus::testing {

using meshing::OuterBox;
using meshing::OuterSphere;
using meshing::Point;
using meshing::SpatialGraph;

/// examples/graphs/<name>.json
inline SpatialGraph example_graph(const std::string& name) {
  std::ifstream file(data_folder() + "/../examples/graphs/" + name + ".json");
  std::stringstream text;
  text << file.rdbuf();
  return meshing::read_spatial_graph(text.str());
}

/// A regular polygon of n sides in the plane z = 0, as a knot.
inline SpatialGraph ring_graph(int n, double radius, Point centre = {0, 0, 0}) {
  SpatialGraph graph;
  graph.edges.emplace_back();
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    graph.edges[0].push_back(
        {centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle), centre[2]});
  }
  graph.edges[0].push_back(graph.edges[0].front());
  return graph;
}

/// A subgraph of the cubic lattice, and what its tube must be by counting alone.
struct LatticeGraph {
  SpatialGraph graph;
  std::vector<long> euler_characteristics;  ///< sorted, with the outer surface's
};

/// Every edge of the n x n x n lattice is taken with probability `density`; where `openings`, some
/// points of the lowest and highest layer are joined to the outer box as well.
inline LatticeGraph random_lattice_graph(int n, double density, bool openings,
                                         std::mt19937_64& random) {
  const auto chance = [&] { return double(random() >> 11) * 0x1p-53; };
  std::vector<int> parent(std::size_t(n * n * n));
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = int(i);
  const auto root = [&](int i) {
    while (parent[std::size_t(i)] != i) i = parent[std::size_t(i)];
    return i;
  };
  const auto number = [&](std::array<int, 3> at) { return (at[0] * n + at[1]) * n + at[2]; };
  const auto point = [](std::array<int, 3> at) {
    return Point{double(at[0]), double(at[1]), double(at[2])};
  };
  LatticeGraph result;
  std::vector<int> degree(parent.size()), edges(parent.size()), open(parent.size());
  std::array<int, 3> at;
  for (at[0] = 0; at[0] < n; ++at[0])
    for (at[1] = 0; at[1] < n; ++at[1])
      for (at[2] = 0; at[2] < n; ++at[2]) {
        const auto here = std::size_t(number(at));
        for (std::size_t axis = 0; axis < 3; ++axis) {
          std::array<int, 3> next = at;
          if (++next[axis] == n || chance() >= density) continue;
          result.graph.edges.push_back({point(at), point(next)});
          ++degree[here];
          ++degree[std::size_t(number(next))];
          ++edges[here];
          parent[std::size_t(root(number(at)))] = root(number(next));
        }
        if (openings && (at[2] == 0 || at[2] == n - 1) && chance() < density / 2) {
          Point end = point(at);
          end[2] += at[2] == 0 ? -2 : 2;
          result.graph.edges.push_back({point(at), end});
          ++degree[here];
          ++open[here];
        }
      }
  struct Count {
    long chi = 0, open = 0;
  };
  std::map<int, Count> components;
  for (at[0] = 0; at[0] < n; ++at[0])
    for (at[1] = 0; at[1] < n; ++at[1])
      for (at[2] = 0; at[2] < n; ++at[2]) {
        const auto here = std::size_t(number(at));
        if (degree[here] == 0) continue;
        result.graph.vertices.push_back(point(at));
        Count& count = components[root(int(here))];
        count.chi += 1 - edges[here];
        count.open += open[here];
      }
  long outer = 2;
  for (const auto& [component, count] : components) {
    if (count.open > 0)
      outer += 2 * count.chi - 2 * count.open;
    else
      result.euler_characteristics.push_back(2 * count.chi);
  }
  result.euler_characteristics.push_back(outer);
  std::sort(result.euler_characteristics.begin(), result.euler_characteristics.end());
  result.graph.outer = OuterBox{{-1, -1, -1}, {double(n), double(n), double(n)}};
  return result;
}

/// Volume that a closed surface bounds, by the divergence theorem.
inline double enclosed_volume(const meshing::SurfaceMesh& mesh) {
  double six_volumes = 0;
  for (const auto& t : mesh.triangles) {
    const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    six_volumes += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return six_volumes / 6;
}

/// Euler characteristics of the components, sorted, by counting the edges as a set: a route of its
/// own. Returns nothing if an edge does not have two triangles, one in each direction.
inline std::vector<long> counted_characteristics(const meshing::SurfaceMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
  std::vector<std::uint32_t> label(mesh.points.size());
  for (std::uint32_t v = 0; v < label.size(); ++v) label[v] = v;
  const auto root = [&](std::uint32_t v) {
    while (label[v] != v) v = label[v] = label[label[v]];
    return v;
  };
  for (const auto& [side, count] : sides) {
    const auto back = sides.find({side.second, side.first});
    if (count != 1 || back == sides.end() || back->second != 1) return {};
    label[root(side.first)] = root(side.second);
  }
  std::map<std::uint32_t, long> chi;
  for (std::uint32_t v = 0; v < label.size(); ++v) ++chi[root(v)];
  for (const auto& [side, count] : sides)
    if (side.first < side.second) --chi[root(side.first)];
  for (const auto& t : mesh.triangles) ++chi[root(t[0])];
  std::vector<long> result;
  for (const auto& [component, value] : chi) result.push_back(value);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace tripus::testing
