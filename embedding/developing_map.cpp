#include "embedding/developing_map.hpp"

#include "geometry/moebius.hpp"
#include "topology/dual_graph.hpp"

namespace tripus::embedding {

std::vector<Matrix4> developing_map(const Embedding& embedding, const topology::Gluings& gluings) {
  std::vector<Matrix4> places(embedding.tetrahedra.size());
  for (const Cell& cell : fundamental_domain(embedding, gluings))
    places[cell.tetrahedron] = cell.isometry;
  return places;
}

std::vector<Cell> fundamental_domain(const Embedding& embedding, const topology::Gluings& gluings) {
  const topology::SpanningForest forest = topology::spanning_forest(gluings);
  std::vector<std::uint32_t> cell_of(forest.order.size(), kNoCell);
  std::vector<Cell> cells;
  cells.reserve(forest.order.size());
  for (const std::uint32_t t : forest.order) {
    cell_of[t] = static_cast<std::uint32_t>(cells.size());
    const std::uint32_t parent = forest.parent[t];
    if (parent == topology::kNoTetrahedron) {
      cells.push_back({t, Matrix4::Identity(), 0, kNoCell});
      continue;
    }
    const Cell& beside = cells[cell_of[parent]];
    cells.push_back({t,
                     geometry::reorthogonalised(beside.isometry *
                                                embedding.face_pairings[parent][forest.face[t]]),
                     beside.depth + 1, cell_of[parent]});
  }
  return cells;
}

}  // namespace tripus::embedding
