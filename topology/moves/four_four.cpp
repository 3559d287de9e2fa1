#include <array>

#include "topology/moves/detail/surgery.hpp"

// 4-4: the four tetrahedra around an edge of valence 4 make up an octahedron with that edge as its
// axis; they are replaced by the four around another of its three axes. The four must be distinct,
// then the inside of the octahedron is embedded; nothing else is needed (see two_three.cpp).

namespace tripus::topology::detail {
namespace {

MoveRefusal refuse(const Gluings& gluings, const Move& move) {
  std::array<EdgeWalk, 4> corners{};
  return collect_corners(gluings, move.tetrahedron, move.place, corners);
}

// Points 0 and 1 are the ends of the old axis, 2, 3, 4, 5 lie around it. The walk starts in the
// tetrahedron with points 2 and 3: choice 0 is the axis 2 4, choice 1 the axis 3 5.
MoveBall ball_here(const Gluings& gluings, const Move& move) {
  MoveBall ball = ball_around<4>(gluings, move);
  const int bottom = 2 + move.choice;
  const int top = 4 + move.choice;
  const std::array<int, 4> ring{0, 3 + move.choice, 1, move.choice == 0 ? 5 : 2};
  for (std::size_t i = 0; i < 4; ++i)
    ball.fresh.push_back({bottom, top, ring[i], ring[(i + 1) % 4]});
  return ball;
}

MoveChange apply_here(Gluings& gluings, const Move& move) {
  MoveBall ball = ball_here(gluings, move);
  const Points& first = ball.fresh[0];
  const int bottom = first[0];
  const int top = first[1];
  const int ring = first[3];
  MoveChange change = plan_ball(gluings, ball).apply(gluings);
  // The first new tetrahedron has old end 0; that axis is choice 0 if its vertex comes first.
  const bool second = vertex_at(first, 0) > vertex_at(first, ring);
  change.inverse = Move{.kind = MoveKind::kFourFour,
                        .tetrahedron = change.added[0],
                        .place = static_cast<std::uint8_t>(edge_at(first, bottom, top)),
                        .choice = static_cast<std::uint8_t>(second)};
  return change;
}

}  // namespace

MoveInfo four_four_info() {
  return {.kind = MoveKind::kFourFour,
          .name = "4-4",
          .arrow = "4-4",
          .description = "the octahedron around an edge gets another axis",
          .place = MovePlace::kEdge,
          .choice_name = "axis",
          .has_steps = false,
          .tetrahedra = 0,
          .finite_vertices = 0,
          .inverse = MoveKind::kFourFour,
          .refusal = refuse,
          .apply = apply_here,
          .ball = ball_here,
          .candidates = [](const Triangulation& triangulation, std::vector<Move>& moves) {
            edge_candidates(triangulation, MoveKind::kFourFour, 2, moves);
          }};
}

}  // namespace tripus::topology::detail
