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

}  // namespace tripus::embedding::detail
