#pragma once

#include <string_view>

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

}  // namespace tripus::topology::detail
