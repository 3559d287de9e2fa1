#include <array>

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
MoveBall two_three_ball(const Gluings& gluings, const Move& move) {
  const TetrahedronIndex t = move.tetrahedron;
  const int f = move.place;
  const Perm4 p = gluings.gluing(t, f);
  MoveBall ball;
  ball.old.push_back({t, {0, 1, 2, 3}});
  ball.old.push_back({gluings.neighbour(t, f), {}});
  for (int v = 0; v < 4; ++v) ball.old[1].points[static_cast<std::size_t>(p(v))] = v == f ? 4 : v;
  for (int x = 0; x < 4; ++x) {
    if (x == f) continue;
    Points points{0, 1, 2, 3};
    points[static_cast<std::size_t>(x)] = 4;
    ball.fresh.push_back(points);
  }
  ball.core = 0xfu & ~(1u << f);
  return ball;
}

MoveChange apply_two_three(Gluings& gluings, const Move& move) {
  MoveBall ball = two_three_ball(gluings, move);
  MoveChange change = plan_ball(gluings, ball).apply(gluings);
  change.inverse = Move{.kind = MoveKind::kThreeTwo,
                        .tetrahedron = change.added[0],
                        .place = static_cast<std::uint8_t>(edge_at(ball.fresh[0], move.place, 4))};
  return change;
}

MoveRefusal refuse_three_two(const Gluings& gluings, const Move& move) {
  std::array<EdgeWalk, 3> corners{};
  return collect_corners(gluings, move.tetrahedron, move.place, corners);
}

// Points 0 and 1 are the ends of the edge, 2, 3, 4 the corners of the new face.
MoveBall three_two_ball(const Gluings& gluings, const Move& move) {
  MoveBall ball = ball_around<3>(gluings, move);
  ball.fresh.push_back({0, 2, 3, 4});
  ball.fresh.push_back({1, 2, 3, 4});
  return ball;
}

MoveChange apply_three_two(Gluings& gluings, const Move& move) {
  MoveBall ball = three_two_ball(gluings, move);
  MoveChange change = plan_ball(gluings, ball).apply(gluings);
  change.inverse = Move{.kind = MoveKind::kTwoThree,
                        .tetrahedron = change.added[0],
                        .place = static_cast<std::uint8_t>(vertex_at(ball.fresh[0], 0))};
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
          .ball = two_three_ball,
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
          .ball = three_two_ball,
          .candidates = [](const Triangulation& triangulation, std::vector<Move>& moves) {
            edge_candidates(triangulation, MoveKind::kThreeTwo, 1, moves);
          }};
}

}  // namespace tripus::topology::detail
