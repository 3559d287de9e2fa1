#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "topology/gluings.hpp"

namespace tripus::topology {

/// A breadth-first spanning forest of the dual graph: one node a tetrahedron, one arc a glued pair
/// of faces.
struct SpanningForest {
  std::vector<TetrahedronIndex> parent;  ///< [T] kNoTetrahedron at roots
  std::vector<std::uint8_t> face;        ///< [T] the face of `parent` behind which t lies
  std::vector<TetrahedronIndex> order;   ///< [T] parents before children, component by component
  std::size_t component_count = 0;
};

/// Roots are the first tetrahedra of the components. O(T). Open faces are no arcs.
/// The table must be consistent.
SpanningForest spanning_forest(const Gluings& gluings);

/// True for one component; the empty table has none.
bool is_connected(const Gluings& gluings);

}  // namespace tripus::topology
