#include "embedding/developing_map.hpp"

#include "embedding/detail/orientations.hpp"
#include "topology/dual_graph.hpp"

namespace tripus::embedding {
namespace {

std::vector<geometry::MoebiusMap> develop(const Embedding& embedding,
                                          const topology::Gluings& gluings,
                                          const topology::SpanningForest& forest) {
  const auto pairings = detail::moebius_pairings(embedding, gluings);
  std::vector<geometry::MoebiusMap> places(embedding.tetrahedra.size());
  for (const std::uint32_t t : forest.order) {
    const std::uint32_t parent = forest.parent[t];
    if (parent != topology::kNoTetrahedron)
      places[t] = places[parent] * pairings[parent][forest.face[t]];
  }
  return places;
}

}  // namespace

std::vector<geometry::MoebiusMap> developing_map(const Embedding& embedding,
                                                 const topology::Gluings& gluings) {
  return develop(embedding, gluings, topology::spanning_forest(gluings));
}

std::vector<Cell> fundamental_domain(const Embedding& embedding, const topology::Gluings& gluings) {
  const topology::SpanningForest forest = topology::spanning_forest(gluings);
  const std::vector<geometry::MoebiusMap> places = develop(embedding, gluings, forest);
  std::vector<std::uint32_t> cell_of(forest.order.size(), kNoCell);
  std::vector<Cell> cells;
  cells.reserve(forest.order.size());
  for (const std::uint32_t t : forest.order) {
    cell_of[t] = static_cast<std::uint32_t>(cells.size());
    const std::uint32_t parent = forest.parent[t];
    const bool root = parent == topology::kNoTetrahedron;
    cells.push_back({t, geometry::to_matrix(places[t]), root ? 0 : cells[cell_of[parent]].depth + 1,
                     root ? kNoCell : cell_of[parent]});
  }
  return cells;
}

}  // namespace tripus::embedding
