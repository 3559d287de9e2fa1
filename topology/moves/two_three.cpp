#include <array>

#include "topology/moves/detail/kinds.hpp"
#include "topology/moves/detail/local.hpp"
#include "topology/moves/detail/surgery.hpp"

// 2-3: two tetrahedra that share a face become three around a new edge that joins the two vertices
// opposite it. 3-2 is the inverse.
//
// The two (three) tetrahedra make up a ball whose inside is embedded as soon as they are distinct;
// gluings among its outer faces do not matter, because the surface of the ball is left as it is.
// So the conditions are: 2-3, distinct tetrahedra on the two sides of the face; 3-2, an edge of
// valence 3 in three distinct tetrahedra.

namespace tripus::topology::detail {
namespace {

MoveRefusal refuse_two_three(const Gluings& gluings, const Move& move) {
  const int f = move.place;
  if (gluings.is_open(move.tetrahedron, f)) return MoveRefusal::kOpenFace;
  const TetrahedronIndex other = gluings.neighbour(move.tetrahedron, f);
  if (other == move.tetrahedron) return MoveRefusal::kNotDistinct;
  if (has_open_face(gluings, move.tetrahedron) || has_open_face(gluings, other))
    return MoveRefusal::kOpenFace;
  return MoveRefusal::kNone;
}

// Points 0..3 are the vertices of the first tetrahedron, 4 is the far one of the second.
MoveChange apply_two_three(Gluings& gluings, const Move& move) {
  const TetrahedronIndex t = move.tetrahedron;
  const int f = move.place;
  const Perm4 p = gluings.gluing(t, f);
  std::array<Piece, 2> old{{{t, {0, 1, 2, 3}}, {gluings.neighbour(t, f), {}}}};
  for (int v = 0; v < 4; ++v) old[1].points[static_cast<std::size_t>(p(v))] = v == f ? 4 : v;
  std::array<Points, 3> fresh{};
  std::size_t k = 0;
  for (int x = 0; x < 4; ++x) {
    if (x == f) continue;
    fresh[k] = {0, 1, 2, 3};
    fresh[k++][static_cast<std::size_t>(x)] = 4;
  }
  const unsigned face = 0xfu & ~(1u << f);
  MoveChange change = plan_ball(gluings, old, face, fresh).apply(gluings);
  change.inverse = Move{.kind = MoveKind::kThreeTwo,
                        .tetrahedron = change.added[0],
                        .place = static_cast<std::uint8_t>(edge_at(fresh[0], f, 4))};
  return change;
}

MoveRefusal refuse_three_two(const Gluings& gluings, const Move& move) {
  std::array<EdgeWalk, 3> corners{};
  return collect_corners(gluings, move.tetrahedron, move.place, corners);
}

// Points 0 and 1 are the ends of the edge, 2, 3, 4 the corners of the new face.
MoveChange apply_three_two(Gluings& gluings, const Move& move) {
  std::array<EdgeWalk, 3> corners{};
  collect_corners(gluings, move.tetrahedron, move.place, corners);
  std::array<Piece, 3> old{};
  for (std::size_t i = 0; i < 3; ++i) old[i] = piece_around(corners[i], i, 3);
  std::array<Points, 2> fresh{{{0, 2, 3, 4}, {1, 2, 3, 4}}};
  MoveChange change = plan_ball(gluings, old, 0b11, fresh).apply(gluings);
  change.inverse = Move{.kind = MoveKind::kTwoThree,
                        .tetrahedron = change.added[0],
                        .place = static_cast<std::uint8_t>(vertex_at(fresh[0], 0))};
  return change;
}

}  // namespace

MoveInfo two_three_info() {
  return {.kind = MoveKind::kTwoThree,
          .name = "2-3",
          .arrow = "2-3",
          .description = "two tetrahedra at a face become three around a new edge",
          .place = MovePlace::kFace,
          .choice_name = {},
          .has_steps = false,
          .tetrahedra = 1,
          .finite_vertices = 0,
          .inverse = MoveKind::kThreeTwo,
          .refusal = refuse_two_three,
          .apply = apply_two_three,
          .candidates = [](const Triangulation& triangulation, std::vector<Move>& moves) {
            face_candidates(triangulation, MoveKind::kTwoThree, moves);
          }};
}

MoveInfo three_two_info() {
  return {.kind = MoveKind::kThreeTwo,
          .name = "3-2",
          .arrow = "3-2",
          .description = "three tetrahedra around an edge become two at a new face",
          .place = MovePlace::kEdge,
          .choice_name = {},
          .has_steps = false,
          .tetrahedra = -1,
          .finite_vertices = 0,
          .inverse = MoveKind::kTwoThree,
          .refusal = refuse_three_two,
          .apply = apply_three_two,
          .candidates = [](const Triangulation& triangulation, std::vector<Move>& moves) {
            edge_candidates(triangulation, MoveKind::kThreeTwo, 1, moves);
          }};
}

}  // namespace tripus::topology::detail
