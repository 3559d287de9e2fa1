#include <array>

#include "topology/moves/detail/surgery.hpp"

// 1-4: a new vertex inside a tetrahedron cuts it into four; always possible. 4-1 is the inverse:
// it needs a vertex at which four distinct tetrahedra meet as they do after a 1-4, one for each
// triangle of a link that is the surface of a tetrahedron. Four distinct tetrahedra with another
// spherical link (or another way to glue the same four) do not do.

namespace tripus::topology::detail {
namespace {

constexpr int kCentre = 4;

MoveRefusal refuse_one_four(const Gluings& gluings, const Move& move) {
  return has_open_face(gluings, move.tetrahedron) ? MoveRefusal::kOpenFace : MoveRefusal::kNone;
}

// Points 0..3 are the vertices of the tetrahedron.
MoveBall one_four_ball(const Gluings&, const Move& move) {
  MoveBall ball;
  ball.core = 1u << kCentre;
  ball.old.push_back({move.tetrahedron, {0, 1, 2, 3}});
  for (std::size_t i = 0; i < 4; ++i) {
    Points points{0, 1, 2, 3};
    points[i] = kCentre;
    ball.fresh.push_back(points);
  }
  return ball;
}

MoveChange apply_one_four(Gluings& gluings, const Move& move) {
  MoveBall ball = one_four_ball(gluings, move);
  MoveChange change = plan_ball(gluings, ball).apply(gluings);
  change.inverse = Move{.kind = MoveKind::kFourOne,
                        .tetrahedron = change.added[0],
                        .place = static_cast<std::uint8_t>(vertex_at(ball.fresh[0], kCentre))};
  return change;
}

/// The four tetrahedra around a vertex v with their points: those of the first are its own vertex
/// numbers, but for the centre at v; the point that it lacks has the number v.
MoveRefusal collect_star(const Gluings& gluings, std::size_t t, int v, std::array<Piece, 4>& star) {
  std::size_t size = 0;
  star[size++] = {static_cast<TetrahedronIndex>(t), {0, 1, 2, 3}};
  star[0].points[static_cast<std::size_t>(v)] = kCentre;
  if (has_open_face(gluings, t)) return MoveRefusal::kOpenFace;
  for (int f = 0; f < 4; ++f) {
    if (f == v) continue;
    const Perm4 p = gluings.gluing(t, f);
    Piece& piece = star[size++];
    piece.t = gluings.neighbour(t, f);
    for (int u = 0; u < 4; ++u)
      piece.points[static_cast<std::size_t>(p(u))] =
          u == f ? v : star[0].points[static_cast<std::size_t>(u)];
    if (has_open_face(gluings, piece.t)) return MoveRefusal::kOpenFace;
  }
  // Every inner face must lead to the piece that has its points, point by point.
  for (const Piece& from : star)
    for (const Piece& to : star) {
      if (&from == &to) continue;
      if (from.t == to.t) return MoveRefusal::kNotDistinct;
      const unsigned lacked = point_mask(from.points) & ~point_mask(to.points);
      int f = 0;
      while (1u << from.points[static_cast<std::size_t>(f)] != lacked) ++f;
      if (gluings.neighbour(from.t, f) != to.t) return MoveRefusal::kWrongValence;
      const Perm4 p = gluings.gluing(from.t, f);
      for (int u = 0; u < 4; ++u)
        if (u != f &&
            to.points[static_cast<std::size_t>(p(u))] != from.points[static_cast<std::size_t>(u)])
          return MoveRefusal::kWrongValence;
    }
  return MoveRefusal::kNone;
}

MoveRefusal refuse_four_one(const Gluings& gluings, const Move& move) {
  std::array<Piece, 4> star{};
  return collect_star(gluings, move.tetrahedron, move.place, star);
}

MoveBall four_one_ball(const Gluings& gluings, const Move& move) {
  std::array<Piece, 4> star{};
  collect_star(gluings, move.tetrahedron, move.place, star);
  MoveBall ball;
  ball.core = 1u << kCentre;
  for (const Piece& piece : star) ball.old.push_back(piece);
  ball.fresh.push_back({0, 1, 2, 3});
  return ball;
}

MoveChange apply_four_one(Gluings& gluings, const Move& move) {
  MoveBall ball = four_one_ball(gluings, move);
  MoveChange change = plan_ball(gluings, ball).apply(gluings);
  change.inverse = Move{.kind = MoveKind::kOneFour, .tetrahedron = change.added[0]};
  return change;
}

}  // namespace

MoveInfo one_four_info() {
  return {.kind = MoveKind::kOneFour,
          .name = "1-4",
          .arrow = "1-4",
          .description = "a new finite vertex cuts a tetrahedron into four",
          .place = MovePlace::kTetrahedron,
          .choice_name = {},
          .has_steps = false,
          .tetrahedra = 3,
          .finite_vertices = 1,
          .inverse = MoveKind::kFourOne,
          .refusal = refuse_one_four,
          .apply = apply_one_four,
          .ball = one_four_ball,
          .candidates = [](const Triangulation& triangulation, std::vector<Move>& moves) {
            for (TetrahedronIndex t = 0; t < triangulation.tetrahedron_count(); ++t)
              moves.push_back({.kind = MoveKind::kOneFour, .tetrahedron = t});
          }};
}

MoveInfo four_one_info() {
  return {.kind = MoveKind::kFourOne,
          .name = "4-1",
          .arrow = "4-1",
          .description = "four tetrahedra around a finite vertex become one",
          .place = MovePlace::kVertex,
          .choice_name = {},
          .has_steps = false,
          .tetrahedra = -3,
          .finite_vertices = -1,
          .inverse = MoveKind::kOneFour,
          .refusal = refuse_four_one,
          .apply = apply_four_one,
          .ball = four_one_ball,
          .candidates = [](const Triangulation& triangulation, std::vector<Move>& moves) {
            vertex_candidates(triangulation, MoveKind::kFourOne, moves);
          }};
}

}  // namespace tripus::topology::detail
