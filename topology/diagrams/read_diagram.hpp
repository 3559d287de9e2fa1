#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "topology/cone_angle.hpp"
#include "topology/diagrams/diagram.hpp"

namespace tripus::topology {

/// A cone angle on a strand, named by one of its arcs. The strand is not drilled.
struct DiagramLabel {
  std::int64_t arc = 0;
  ConeAngle angle;
};

/// A diagram as a text gives it.
struct NamedDiagram {
  std::string name = {};  ///< empty if there is none
  Diagram diagram;
  std::vector<DiagramLabel> labels = {};
  std::vector<std::string> notes = {};  ///< what was not as people expect, in words for people
  /// False where the text leaves open which of two mirror images it means (a DT code).
  bool orientation_known = true;
};

/// Whether a text begins as a diagram does in one of the forms below.
bool looks_like_diagram(std::string_view text);

/// The names of the forms, for messages.
std::string diagram_format_names();

/// Reads a diagram:
///   PD: V[1,6,11] X[1,9,2,10] ...   also PD[X[..], ..], X_{1,4,2,5}, X1425, with or without "PD:"
///   PD: [[4,2,5,1], [8,6,1,5], ..]  nested lists or tuples of any brackets; four arcs are a
///   crossing
///   {"diagram": [["V",[1,3,4]], ["X",[5,9,6,10]], ..], "name": .., "cone_orders": {"1": 3}}
///   DT: 4 6 8 2, DT:[(6,8),(2,4)], DT[dadbcda]      Dowker and Thistlethwaite; mirror image open
///   Gauss: 1 -2 3 -1 2 -3, O1-U2-O3-U1-O2-U3-       with the signs the mirror image is known
///   Braid: 1 -2 1 -2, BR[3,{1,-2}]  the closure; a positive letter is a positive crossing
///   embedding:4 {0: (4,5,6), ..}, knot { ^ ^ ; ( x ); U U ; }      appcontour
///   a=V(b0 c0 d3) b=X(..) ..        KnotPy
/// Arcs are numbered in any way. They are counterclockwise around their nodes, X[incoming
/// under-strand, ..], unless "PD clockwise:" or "clockwise": true says otherwise (SageMath).
/// Loop[1] is a circle. Cone[1,3] gives the strand of arc 1 the cone order 3 (0: parabolic).
/// Throws InvalidInput with the place and the remedy.
NamedDiagram read_diagram(std::string_view text);

/// "PD: V[1,2,3] X[4,2,5,1] Cone[1,3]": the diagram with its labels, as `read_diagram` reads it.
std::string pd_text(const NamedDiagram& diagram);

}  // namespace tripus::topology
