#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "topology/edge_walk.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::topology::detail {

inline bool has_open_face(const Gluings& gluings, std::size_t t) {
  for (int f = 0; f < 4; ++f)
    if (gluings.is_open(t, f)) return true;
  return false;
}

/// Whether two positions are the same corner in the same direction.
inline bool is_same_corner(const EdgeWalk& first, const EdgeWalk& second) {
  return first.t == second.t && first.a == second.a && first.b == second.b;
}

/// The corners around an edge in the order of the walk, if there are exactly N of them, in N
/// distinct tetrahedra without open faces.
template <std::size_t N>
MoveRefusal collect_corners(const Gluings& gluings, std::size_t t, int edge,
                            std::array<EdgeWalk, N>& corners) {
  auto walk = EdgeWalk::start(t, edge);
  for (std::size_t i = 0; i < N; ++i) {
    if (i > 0 && is_same_corner(walk, corners[0])) return MoveRefusal::kWrongValence;
    if (has_open_face(gluings, walk.t)) return MoveRefusal::kOpenFace;
    corners[i] = walk;
    walk.step(gluings);
  }
  if (!is_same_corner(walk, corners[0])) return MoveRefusal::kWrongValence;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = i + 1; j < N; ++j)
      if (corners[i].t == corners[j].t) return MoveRefusal::kNotDistinct;
  return MoveRefusal::kNone;
}

/// The valence of the edge along which the walk stands; 0 if it meets an open face. O(valence).
std::size_t valence(const Gluings& gluings, const EdgeWalk& start);

/// Whether two edges are one edge class. Open faces end the walk, which may then miss it.
/// O(valence).
bool is_same_edge(const Gluings& gluings, std::size_t t, int edge, std::size_t other,
                  int other_edge);

/// For moves at faces, edges, vertices or tetrahedra: each once, with choices 0 .. choices - 1.
void face_candidates(const Triangulation& triangulation, MoveKind kind, std::vector<Move>& moves);
void edge_candidates(const Triangulation& triangulation, MoveKind kind, int choices,
                     std::vector<Move>& moves);
void vertex_candidates(const Triangulation& triangulation, MoveKind kind, std::vector<Move>& moves);

}  // namespace tripus::topology::detail
