#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "topology/diagrams/diagram.hpp"
#include "topology/gluings.hpp"

namespace tripus::topology {

/// An edge of a triangulation that is a strand of the graph.
struct KeptStrand {
  std::int64_t arc = 0;  ///< the name by which it was asked for
  TetrahedronIndex tetrahedron = 0;
  int edge = 0;
};

/// The exterior of a graph, triangulated.
struct DiagramExterior {
  Gluings
      gluings;  ///< oriented as space is; vertices: the components of the graph, and two spheres
  std::vector<KeptStrand> kept;
  std::size_t kinks = 0;   ///< put in: regions without crossing, cycles all above or below
  std::size_t pieces = 1;  ///< of the diagram; if several, the exterior is a connected sum
};

/// The exterior of the graph: ideal vertices with the boundary of its neighbourhood as link, a
/// torus for a knot, and two finite vertices, which `simplify` removes. O(arcs); four tetrahedra a
/// crossing.
///
/// `kept` names strands, each by one of its arcs, which are not drilled: they become an edge of the
/// triangulation (two tetrahedra more for each), so that they can carry a cone angle, and the
/// vertices at their ends get the links that are left without them.
/// Throws InvalidInput for a kept arc that does not exist, or two on one strand.
///
/// The octahedron between the two strands of a crossing falls into four tetrahedra, one a corner,
/// with the vertices over-strand, under-strand, P above and M below the plane. Where a region has
/// several corners, these meet in the line from P to M through the region. Source: D. Thurston's
/// octahedra, as in K. Yokota, *On the volume conjecture for hyperbolic knots* (2000); for graphs,
/// ../docs/diagrams.md.
DiagramExterior exterior(const Diagram& diagram, std::span<const std::int64_t> kept = {});

}  // namespace tripus::topology
