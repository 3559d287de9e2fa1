#include <array>

#include "topology/moves/detail/surgery.hpp"

// 2-0 at an edge of valence 2: its two tetrahedra make up a pillow between two discs, each of two
// triangles hinged on an edge opposite to the first; the pillow is flattened. Conditions:
//  - the two tetrahedra are distinct, so that the inside of the pillow is embedded;
//  - the two opposite edges are distinct classes: flattening merges them, and a disc whose two
//    sides meet in one edge already would close to a sphere and be pinched;
//  - no chain of merged faces closes up (Surgery::is_sealed). The outer faces f1, f2 of one
//    tetrahedron are laid upon g1, g2 of the other. Glued as f1 = g1, or f1 = f2 and g1 = g2, or
//    f1 = g2 and g1 = f2, there is no triangle left outside that could carry the merged face.
//    One gluing among the four alone is harmless: the two others get what lies behind them.
//
// 2-0 at a vertex of valence 2: two distinct tetrahedra that share the three faces at a finite
// vertex, hence by one and the same permutation, make up a triangular pillow; its two outer
// triangles have their sides in common and must only not be glued to each other.

namespace tripus::topology::detail {
namespace {

MoveBall edge_ball(const Gluings& gluings, const Move& move) {
  return ball_around<2>(gluings, move);
}

MoveRefusal refuse_edge(const Gluings& gluings, const Move& move) {
  const MoveRefusal met = refuse_pillow(gluings, move);
  if (met != MoveRefusal::kNone) return met;
  const auto corner = EdgeWalk::start(move.tetrahedron, move.place);
  EdgeWalk next = corner;
  next.step(gluings);
  if (is_same_edge(gluings, corner.t, 5 - corner.edge(), next.t, 5 - next.edge()))
    return MoveRefusal::kSameOppositeEdges;
  return MoveRefusal::kNone;
}

MoveChange apply_edge(Gluings& gluings, const Move& move) {
  MoveBall ball = edge_ball(gluings, move);
  return plan_ball(gluings, ball).apply(gluings);
}

MoveBall vertex_ball(const Gluings& gluings, const Move& move) {
  const TetrahedronIndex t = move.tetrahedron;
  const int f = (move.place + 1) % 4;
  const Perm4 p = gluings.gluing(t, f);
  MoveBall ball;
  ball.core = 1u << move.place;
  ball.old.push_back({t, {0, 1, 2, 3}});
  ball.old.push_back({gluings.neighbour(t, f), {}});
  for (int u = 0; u < 4; ++u) ball.old[1].points[static_cast<std::size_t>(p(u))] = u;
  return ball;
}

MoveRefusal refuse_vertex(const Gluings& gluings, const Move& move) {
  const TetrahedronIndex t = move.tetrahedron;
  const int v = move.place;
  if (has_open_face(gluings, t)) return MoveRefusal::kOpenFace;
  const TetrahedronIndex other = gluings.neighbour(t, (v + 1) % 4);
  if (other == t) return MoveRefusal::kNotDistinct;
  for (int f = 0; f < 4; ++f)
    if (f != v && (gluings.neighbour(t, f) != other ||
                   gluings.gluing(t, f) != gluings.gluing(t, (v + 1) % 4)))
      return MoveRefusal::kWrongValence;
  if (has_open_face(gluings, other)) return MoveRefusal::kOpenFace;
  MoveBall ball = vertex_ball(gluings, move);
  return plan_ball(gluings, ball).is_sealed() ? MoveRefusal::kSealedFace : MoveRefusal::kNone;
}

MoveChange apply_vertex(Gluings& gluings, const Move& move) {
  MoveBall ball = vertex_ball(gluings, move);
  return plan_ball(gluings, ball).apply(gluings);
}

}  // namespace

MoveRefusal refuse_pillow(const Gluings& gluings, const Move& move) {
  std::array<EdgeWalk, 2> corners{};
  const MoveRefusal met = collect_corners(gluings, move.tetrahedron, move.place, corners);
  if (met != MoveRefusal::kNone) return met;
  MoveBall ball = edge_ball(gluings, move);
  return plan_ball(gluings, ball).is_sealed() ? MoveRefusal::kSealedFace : MoveRefusal::kNone;
}

MoveInfo two_zero_edge_info() {
  return {.kind = MoveKind::kTwoZeroEdge,
          .name = "2-0 edge",
          .arrow = "2-0",
          .description = "the two tetrahedra around an edge are flattened",
          .place = MovePlace::kEdge,
          .choice_name = {},
          .has_steps = false,
          .tetrahedra = -2,
          .finite_vertices = 0,
          .inverse = MoveKind::kZeroTwoEdge,
          .refusal = refuse_edge,
          .apply = apply_edge,
          .ball = edge_ball,
          .candidates = [](const Triangulation& triangulation, std::vector<Move>& moves) {
            edge_candidates(triangulation, MoveKind::kTwoZeroEdge, 1, moves);
          }};
}

MoveInfo two_zero_vertex_info() {
  return {.kind = MoveKind::kTwoZeroVertex,
          .name = "2-0 vertex",
          .arrow = "2-0",
          .description = "the two tetrahedra around a finite vertex are flattened",
          .place = MovePlace::kVertex,
          .choice_name = {},
          .has_steps = false,
          .tetrahedra = -2,
          .finite_vertices = -1,
          .inverse = MoveKind::kZeroTwoFace,
          .refusal = refuse_vertex,
          .apply = apply_vertex,
          .ball = vertex_ball,
          .candidates = [](const Triangulation& triangulation, std::vector<Move>& moves) {
            vertex_candidates(triangulation, MoveKind::kTwoZeroVertex, moves);
          }};
}

}  // namespace tripus::topology::detail
