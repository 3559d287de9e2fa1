#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "topology/disjoint_sets.hpp"
#include "topology/edge_walk.hpp"
#include "topology/simplify/mutable_triangulation.hpp"

namespace tripus::topology {

/// Why an edge cannot be collapsed.
enum class CollapseRefusal : std::uint8_t {
  kNone,         ///< it can
  kNoSuchPlace,  ///< the tetrahedron or edge does not exist
  kSameEnds,     ///< the edge is a loop
  kNoFiniteEnd,  ///< neither end has a sphere as its link
  kMeetsItself,  ///< a tetrahedron around the edge has it twice
  kEdgeCycle,    ///< the edges to be merged form a cycle
  kFaceCycle,    ///< the faces to be merged form a cycle
};
std::string_view to_string(CollapseRefusal refusal);

/// Edge collapse on a MutableTriangulation: the edge shrinks to a point, the triangles around it
/// to edges and the tetrahedra around it to triangles. T falls by the valence, the number of finite
/// vertices by one, and the manifold stays. The conditions, with proof, are at the top of
/// collapse.cpp; they are those of Regina 7.3 for triangulations without boundary.
/// Cost: O(valence), and the relabelling of the smaller of two classes that become one.
class EdgeCollapse {
 public:
  explicit EdgeCollapse(MutableTriangulation& triangulation) : m_(&triangulation) {}

  /// Never throws.
  CollapseRefusal refusal(TetrahedronIndex t, int edge);
  /// Throws InvalidInput with the place and the reason if it is refused; nothing is changed then.
  void apply(TetrahedronIndex t, int edge);
  /// Collapses the edge if that is legal; says why not otherwise.
  CollapseRefusal try_apply(TetrahedronIndex t, int edge) {
    const CollapseRefusal reason = refusal(t, edge);
    if (reason == CollapseRefusal::kNone) collapse();
    return reason;
  }

 private:
  using Label = MutableTriangulation::Label;

  /// An edge class that is to be merged with others, by one of its corners.
  struct Node {
    TetrahedronIndex t;
    int e;
    Label label;
  };

  bool has_edge_cycle();
  bool merges_kept();
  bool has_face_cycle();
  std::uint32_t node(TetrahedronIndex t, int e);
  void collapse();
  void merge_labels();
  void close_gap();

  MutableTriangulation* m_;
  std::vector<EdgeWalk> corners_;  // around the edge; set by refusal, as what follows
  std::vector<Node> nodes_;
  DisjointSets edge_sets_;                   // of nodes_
  DisjointSets tetrahedron_sets_;            // of corners_
  std::vector<std::uint32_t> node_of_edge_;  // by label: 0 none, else node + 1; cleared after use
  std::vector<std::uint32_t> corner_of_;     // by tetrahedron, likewise
  std::vector<std::uint32_t> largest_;       // node, by root
};

/// The same for a plain table, as a move by itself: the collapsed table, tetrahedra in their order.
/// Rebuilds the skeleton, O(T).
/// Throws InvalidInput if the table is not closed up, or with the place and the reason for which
/// the collapse is refused.
Gluings collapse_edge(const Gluings& gluings, TetrahedronIndex t, int edge);

}  // namespace tripus::topology
