#include "embedding/detail/orientations.hpp"

#include "topology/dual_graph.hpp"

namespace tripus::embedding::detail {

std::vector<int> orientations(const topology::Gluings& gluings) {
  const topology::SpanningForest forest = topology::spanning_forest(gluings);
  std::vector<int> sign(gluings.tetrahedron_count(), 1);
  for (const std::size_t t : forest.order) {
    if (forest.parent[t] == topology::kNoTetrahedron) continue;
    const bool same = gluings.gluing(forest.parent[t], forest.face[t]).is_odd();
    sign[t] = same ? sign[forest.parent[t]] : -sign[forest.parent[t]];
  }
  return sign;
}

bool pairing_reverses(const std::vector<int>& orientation, const topology::Gluings& gluings,
                      std::size_t t, int f) {
  const bool same = orientation[t] == orientation[gluings.neighbour(t, f)];
  return same != gluings.gluing(t, f).is_odd();
}

std::vector<std::array<geometry::MoebiusMap, 4>> moebius_pairings(
    const Embedding& embedding, const topology::Gluings& gluings) {
  const std::vector<int> orientation = orientations(gluings);
  std::vector<std::array<geometry::MoebiusMap, 4>> pairings(embedding.face_pairings.size());
  for (std::size_t t = 0; t < pairings.size(); ++t) {
    for (int f = 0; f < 4; ++f) {
      const auto face = static_cast<std::size_t>(f);
      pairings[t][face] = geometry::to_moebius(embedding.face_pairings[t][face],
                                               pairing_reverses(orientation, gluings, t, f));
    }
  }
  return pairings;
}

}  // namespace tripus::embedding::detail
