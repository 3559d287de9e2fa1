#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "topology/diagrams/diagram.hpp"
#include "topology/diagrams/read_diagram.hpp"

// One function a form in which diagrams are written; the table is in read_diagram.cpp.

namespace tripus::topology::detail {

NamedDiagram read_pd_text(std::string_view text);
NamedDiagram read_diagram_json(std::string_view text);
NamedDiagram read_dt_code(std::string_view text);
NamedDiagram read_gauss_code(std::string_view text);
NamedDiagram read_braid(std::string_view text);
NamedDiagram read_embedding(std::string_view text);
NamedDiagram read_knot_picture(std::string_view text);
NamedDiagram read_knotpy(std::string_view text);

/// Of a node without a word: four arcs are a crossing.
inline NodeKind kind_of(std::size_t arcs) {
  return arcs == 4 ? NodeKind::kCrossing : NodeKind::kVertex;
}

/// Arcs listed clockwise, put in counterclockwise order; the first stays the first.
void turn_round(std::vector<DiagramNode>& nodes);

/// A diagram of a knot or link as one walks along it: a position is a passage of a crossing. Codes
/// of Dowker and Thistlethwaite and of Gauss say this.
struct Positions {
  std::vector<std::size_t> following;                          ///< [2n] the next on the component
  std::vector<bool> above;                                     ///< [2n]
  std::vector<std::pair<std::size_t, std::size_t>> crossings;  ///< [n] the two positions of each
};

/// For each crossing: whether its second position enters counterclockwise right behind the first.
/// The positions say which meet but not this: a planar embedding chooses, up to mirror images of
/// the diagram's prime parts. Throws InvalidInput if there is none.
std::vector<bool> planar_choice(const Positions& positions);

/// The nodes; the arc into a position is named by it, from 1 on.
std::vector<DiagramNode> nodes_of(const Positions& positions, const std::vector<bool>& behind);

}  // namespace tripus::topology::detail
