#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "topology/dual_graph.hpp"
#include "topology/edge_walk.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology::detail {

/// Generators of H1: the glued face pairs outside a spanning forest of the dual graph. Crossing a
/// pair from the face with the lower number 4 t + f counts +1, back -1.
class FaceGenerators {
 public:
  explicit FaceGenerators(const Gluings& gluings) : code_(4 * gluings.tetrahedron_count(), 0) {
    const SpanningForest forest = spanning_forest(gluings);
    std::vector<bool> in_tree(code_.size(), false);
    for (std::size_t t = 0; t < forest.parent.size(); ++t) {
      if (forest.parent[t] == kNoTetrahedron) continue;
      const std::size_t parent = forest.parent[t];
      const int face = forest.face[t];
      in_tree[4 * parent + static_cast<std::size_t>(face)] = true;
      in_tree[partner(gluings, parent, face)] = true;
    }
    for (std::size_t slot = 0; slot < code_.size(); ++slot) {
      const int face = static_cast<int>(slot % 4);
      if (in_tree[slot] || gluings.is_open(slot / 4, face)) continue;
      const std::size_t other = partner(gluings, slot / 4, face);
      if (other < slot) continue;
      code_[slot] = static_cast<std::int32_t>(++count_);
      code_[other] = -code_[slot];
    }
  }

  std::size_t count() const { return count_; }
  /// 0 in the forest, else +-(1 + the number of the generator), for face slot 4 t + f.
  std::int32_t code(std::size_t slot) const { return code_[slot]; }

 private:
  static std::size_t partner(const Gluings& gluings, std::size_t t, int f) {
    return 4 * std::size_t{gluings.neighbour(t, f)} +
           static_cast<std::size_t>(gluings.gluing(t, f)(f));
  }
  std::vector<std::int32_t> code_;
  std::size_t count_ = 0;
};

/// Calls visit(face slot 4 t + f) for each face crossed on the way around edge class e.
template <class Visit>
void walk_around_edge(const Triangulation& triangulation, std::size_t e, Visit visit) {
  const EdgeCorner first = triangulation.corners(e)[0];
  auto walk = EdgeWalk::start(first.tetrahedron(), first.edge());
  for (std::size_t i = 0; i < triangulation.valence(e); ++i) {
    visit(4 * walk.t + static_cast<std::size_t>(walk.c));
    walk.step(triangulation.gluings());
  }
}

}  // namespace tripus::topology::detail
