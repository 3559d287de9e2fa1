#include "embedding/developing_map.hpp"

#include "geometry/moebius.hpp"
#include "topology/dual_graph.hpp"

namespace tripus::embedding {

std::vector<Matrix4> fundamental_domain(const Embedding& embedding,
                                        const topology::Gluings& gluings) {
  const topology::SpanningForest forest = topology::spanning_forest(gluings);
  std::vector<Matrix4> places(embedding.tetrahedra.size(), Matrix4::Identity());
  for (const std::size_t t : forest.order) {
    const std::size_t parent = forest.parent[t];
    if (parent == topology::kNoTetrahedron) continue;
    places[t] = geometry::reorthogonalised(places[parent] *
                                           embedding.face_pairings[parent][forest.face[t]]);
  }
  return places;
}

}  // namespace tripus::embedding
