#include <array>
#include <utility>

#include "topology/moves/detail/surgery.hpp"

// 0-2 at an edge, the inverse of 2-0: the disc of two faces hinged on an edge is cut open and a
// pillow of two tetrahedra X, Y around a new edge of valence 2 is put in. The walk around the edge
// begins in the given tetrahedron, leaves through the face that the side names (0: opposite the
// first vertex off the edge, 1: the second), and `steps` corners later leaves through the other
// face. X closes off the corners between the two, Y the others, so that an edge of valence n
// becomes two of valences steps + 1 and n - steps + 1.
//
// It is always possible. The two faces may be the same triangle, met at two of its edges or even
// at one (steps = 0): the disc then runs along it twice, as two parallel copies, and the second is
// cut open on that side from which the walk comes. The other order is the same move begun at the
// other face, or walked the other way.
//
// 0-2 at a face, the inverse of 2-0 at a vertex: the face is cut open and two tetrahedra that
// share a new finite vertex are put in.

namespace tripus::topology::detail {
namespace {

EdgeWalk first_seam(const Move& move) {
  auto walk = EdgeWalk::start(move.tetrahedron, move.place);
  if (move.choice != 0) std::swap(walk.c, walk.d);
  return walk;
}

MoveRefusal refuse_opening_edge(const Gluings& gluings, const Move& move) {
  const std::size_t count = valence(gluings, first_seam(move));
  if (count == 0) return MoveRefusal::kOpenFace;
  return move.steps < count ? MoveRefusal::kNone : MoveRefusal::kNoSuchPlace;
}

/// The permutation that sends a, b, c, d to the four values.
Perm4 sending(const EdgeWalk& from, int a, int b, int c, int d) {
  std::array<int, 4> images{};
  images[static_cast<std::size_t>(from.a)] = a;
  images[static_cast<std::size_t>(from.b)] = b;
  images[static_cast<std::size_t>(from.c)] = c;
  images[static_cast<std::size_t>(from.d)] = d;
  return Perm4::from_images(images[0], images[1], images[2], images[3]);
}

/// Cuts a face open: its near side goes to one tetrahedron, its far side to another, with the
/// labels of the near side.
void cut_open(Gluings& gluings, std::size_t t, int f, TetrahedronIndex near, Perm4 near_map,
              TetrahedronIndex far, Perm4 far_map) {
  const TetrahedronIndex behind = gluings.neighbour(t, f);
  const Perm4 p = gluings.gluing(t, f);
  gluings.glue(t, f, near, near_map);
  gluings.glue(behind, p(f), far, far_map * p.inverse());
}

// In both new tetrahedra vertices 2 and 3 are the ends of the old edge; the ends p, q of the new
// one are 0 and 1, the other way round in Y than in X. The first disc face has corner p, the
// second q.
MoveChange open_edge(Gluings& gluings, const Move& move) {
  const EdgeWalk first = first_seam(move);
  EdgeWalk second = first;
  for (std::uint32_t i = 0; i < move.steps; ++i) second.step(gluings);

  const auto x = static_cast<TetrahedronIndex>(gluings.tetrahedron_count());
  const TetrahedronIndex y = x + 1;
  // The near side of the first face sees Y; that gluing must be odd in an oriented table.
  const int xp = sending(first, 2, 3, 0, 1).is_odd() ? 0 : 1;
  const int xq = 1 - xp;
  gluings.resize(x + 2);
  const Perm4 swap = Perm4::from_images(1, 0, 2, 3);
  gluings.glue(x, 2, y, swap);
  gluings.glue(x, 3, y, swap);
  cut_open(gluings, first.t, first.c, y, sending(first, 2, 3, xp, xq), x,
           sending(first, 2, 3, xq, xp));
  cut_open(gluings, second.t, second.c, x, sending(second, 2, 3, xp, xq), y,
           sending(second, 2, 3, xq, xp));

  MoveChange change;
  change.added.push_back(x);
  change.added.push_back(y);
  change.inverse = Move{.kind = MoveKind::kTwoZeroEdge, .tetrahedron = x, .place = 0};
  return change;
}

/// The two faces of every disc, each pair once. Where they are one triangle met at two edges, the
/// two orders of its copies are two places: begun at the other face if the walk crosses it in the
/// same direction both times, else walked the other way.
void edge_candidates_with_steps(const Triangulation& triangulation, std::vector<Move>& moves) {
  const Gluings& gluings = triangulation.gluings();
  std::vector<EdgeWalk> corners;
  const auto add = [&](const EdgeWalk& at, std::size_t steps) {
    moves.push_back({.kind = MoveKind::kZeroTwoEdge,
                     .tetrahedron = static_cast<TetrahedronIndex>(at.t),
                     .place = static_cast<std::uint8_t>(at.edge()),
                     .choice = static_cast<std::uint8_t>(at.c > at.d),
                     .steps = static_cast<std::uint32_t>(steps)});
  };
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    corners.clear();
    const EdgeCorner first = triangulation.corners(e)[0];
    auto walk = EdgeWalk::start(first.tetrahedron(), first.edge());
    const std::size_t n = triangulation.valence(e);
    for (std::size_t i = 0; i < n; ++i, walk.step(gluings)) corners.push_back(walk);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i; j < n; ++j) {
        add(corners[i], j - i);
        if (i == j) continue;
        if (corners[i].t == corners[j].t && corners[i].c == corners[j].c) {
          add(corners[j], n - (j - i));
        } else if (gluings.neighbour(corners[i].t, corners[i].c) == corners[j].t &&
                   gluings.gluing(corners[i].t, corners[i].c)(corners[i].c) == corners[j].c) {
          // From behind the first face to behind the second, against the walk.
          EdgeWalk back = corners[(i + 1) % n];
          std::swap(back.c, back.d);
          add(back, n - (j - i));
        }
      }
  }
}

MoveRefusal refuse_face(const Gluings& gluings, const Move& move) {
  return gluings.is_open(move.tetrahedron, move.place) ? MoveRefusal::kOpenFace
                                                       : MoveRefusal::kNone;
}

// Vertex 0 of both new tetrahedra is the new vertex, so their faces 0 are the outer ones.
MoveChange apply_face(Gluings& gluings, const Move& move) {
  const int f = move.place;
  const auto x = static_cast<TetrahedronIndex>(gluings.tetrahedron_count());
  const TetrahedronIndex y = x + 1;
  gluings.resize(x + 2);
  const Perm4 swap = Perm4::from_images(0, 2, 1, 3);
  for (int inner = 1; inner < 4; ++inner) gluings.glue(x, inner, y, swap);
  // An odd permutation that carries f to 0.
  std::array<int, 4> images{0, 1, 2, 3};
  if (f == 0)
    std::swap(images[1], images[2]);
  else
    std::swap(images[0], images[static_cast<std::size_t>(f)]);
  const Perm4 map = Perm4::from_images(images[0], images[1], images[2], images[3]);
  cut_open(gluings, move.tetrahedron, f, x, map, y, swap * map);

  MoveChange change;
  change.added.push_back(x);
  change.added.push_back(y);
  change.inverse = Move{.kind = MoveKind::kTwoZeroVertex, .tetrahedron = x, .place = 0};
  return change;
}

}  // namespace

MoveInfo zero_two_edge_info() {
  return {.kind = MoveKind::kZeroTwoEdge,
          .name = "0-2 edge",
          .arrow = "0-2",
          .description = "two faces at an edge are cut open for two tetrahedra",
          .place = MovePlace::kEdge,
          .choice_name = "side",
          .has_steps = true,
          .tetrahedra = 2,
          .finite_vertices = 0,
          .inverse = MoveKind::kTwoZeroEdge,
          .refusal = refuse_opening_edge,
          .apply = open_edge,
          .ball = nullptr,
          .candidates = edge_candidates_with_steps};
}

MoveInfo zero_two_face_info() {
  return {.kind = MoveKind::kZeroTwoFace,
          .name = "0-2 face",
          .arrow = "0-2",
          .description = "a face is cut open for two tetrahedra around a new finite vertex",
          .place = MovePlace::kFace,
          .choice_name = {},
          .has_steps = false,
          .tetrahedra = 2,
          .finite_vertices = 1,
          .inverse = MoveKind::kTwoZeroVertex,
          .refusal = refuse_face,
          .apply = apply_face,
          .ball = nullptr,
          .candidates = [](const Triangulation& triangulation, std::vector<Move>& moves) {
            face_candidates(triangulation, MoveKind::kZeroTwoFace, moves);
          }};
}

}  // namespace tripus::topology::detail
