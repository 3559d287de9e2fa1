#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "topology/components.hpp"
#include "topology/triangulation.hpp"

namespace tripus::testing {

/// A triangulation of the kind M_{g,k} (Frigerio, Martelli, Petronio, arXiv math/0301114): g - k
/// tetrahedra with hyperideal vertices only, and for each of k cusps two with one ideal vertex, 0;
/// the sides of these two are glued as the two triangles of a square torus are. All other faces are
/// glued at random, consistently oriented, until the 6 g edges without an ideal vertex are one.
/// Then the hyperideal vertex has genus g. 0 <= k <= g.
inline topology::Triangulation random_frigerio(std::size_t g, std::size_t k,
                                               std::mt19937_64& random) {
  using topology::Perm4;
  using Face = std::pair<std::size_t, int>;
  for (;;) {
    topology::Gluings gluings(g + k);
    std::vector<Face> open;
    for (std::size_t t = 0; t < 2 * k; ++t) open.push_back({t, 0});
    for (std::size_t t = 2 * k; t < g + k; ++t)
      for (int f = 0; f < 4; ++f) open.push_back({t, f});
    for (std::size_t t = 0; t < 2 * k; t += 2)
      for (const auto& [side, p, q] : {std::array{1, 2, 3}, {2, 1, 3}, {3, 1, 2}})
        gluings.glue(t, side, static_cast<topology::TetrahedronIndex>(t + 1),
                     Perm4::transposition(p, q));
    std::shuffle(open.begin(), open.end(), random);
    for (std::size_t i = 0; i < open.size(); i += 2) {
      const auto [s, face] = open[i];
      const auto [t, other] = open[i + 1];
      std::vector<Perm4> ways;  // odd ones: the orientations agree
      for (int rank = 0; rank < 24; ++rank)
        if (const Perm4 p = Perm4::from_rank(rank); p.is_odd() && p(face) == other)
          ways.push_back(p);
      gluings.glue(s, face, static_cast<topology::TetrahedronIndex>(t),
                   ways[random() % ways.size()]);
    }
    if (topology::components(gluings).size() > 1) continue;
    topology::Triangulation triangulation(gluings);
    if (triangulation.edge_count() == k + 1) return triangulation;
  }
}

}  // namespace tripus::testing
