#pragma once

#include "topology/moves/moves.hpp"

namespace tripus::topology::detail {

// One function a kind, each at the end of the file that holds the move. The table in moves.cpp
// lists them; refusal and apply may assume that tetrahedron, place and choice are in range.
MoveInfo two_three_info();
MoveInfo three_two_info();
MoveInfo four_four_info();
MoveInfo two_zero_edge_info();
MoveInfo zero_two_edge_info();
MoveInfo two_zero_vertex_info();
MoveInfo zero_two_face_info();
MoveInfo two_one_info();
MoveInfo one_two_info();
MoveInfo one_four_info();
MoveInfo four_one_info();

/// The conditions of a 2-0 at an edge, but for the opposite edges being distinct.
MoveRefusal refuse_pillow(const Gluings& gluings, const Move& move);
/// The conditions of a 2-1, but for the edges to be merged being distinct.
MoveRefusal refuse_fold(const Gluings& gluings, const Move& move);

}  // namespace tripus::topology::detail
