#include <array>
#include <optional>
#include <utility>

#include "topology/moves/detail/surgery.hpp"

// 2-1 at an edge ab of valence 1: two faces of its tetrahedron abcd are folded together around it,
// c upon d. The tetrahedron wbcd behind the face opposite a (a: the end that is chosen) is merged
// with it: a 2-3 at that face gives ab valence 2, and the 2-0 there leaves one tetrahedron awcd,
// folded around aw. Its conditions are those of the two:
//  - wbcd is another tetrahedron;
//  - its edges wc and wd, which will be merged, are distinct classes. The faces wbc and wbd, which
//    will be merged too, are then not glued to each other: bc is bd already, so any gluing of the
//    two triangles would make wc and wd one edge.
//
// 1-2 is the inverse: at an edge wc of a tetrahedron awcd that is folded around aw, walk on around
// wc, away from the fold; the face met after `steps` corners is the one to be cut open. It must
// not be the fold itself. Where two edges of the tetrahedron have valence 1 (then it is a component
// by itself) the one that comes first is taken.

namespace tripus::topology::detail {
namespace {

bool is_folded(const Gluings& gluings, const EdgeWalk& at) {
  EdgeWalk next = at;
  if (gluings.is_open(next.t, next.c)) return false;
  next.step(gluings);
  return is_same_corner(next, at);
}

/// a, b, c, d as above, a the chosen end.
EdgeWalk two_one_corner(const Move& move) {
  auto corner = EdgeWalk::start(move.tetrahedron, move.place);
  if (move.choice != 0) std::swap(corner.a, corner.b);
  return corner;
}

MoveRefusal refuse_two_one(const Gluings& gluings, const Move& move) {
  const MoveRefusal met = refuse_fold(gluings, move);
  if (met != MoveRefusal::kNone) return met;
  const EdgeWalk at = two_one_corner(move);
  const TetrahedronIndex other = gluings.neighbour(at.t, at.a);
  const Perm4 p = gluings.gluing(at.t, at.a);
  const auto edge = [&](int far) {
    return kEdgeNumber[static_cast<std::size_t>(p(at.a))][static_cast<std::size_t>(p(far))];
  };
  if (is_same_edge(gluings, other, edge(at.c), other, edge(at.d)))
    return MoveRefusal::kSameOppositeEdges;
  return MoveRefusal::kNone;
}

// The new tetrahedron has the labels of the folded one, with w in the place of b.
MoveChange apply_two_one(Gluings& gluings, const Move& move) {
  const EdgeWalk at = two_one_corner(move);
  const auto t = static_cast<TetrahedronIndex>(at.t);
  const TetrahedronIndex other = gluings.neighbour(t, at.a);
  const Perm4 p = gluings.gluing(t, at.a);
  Surgery surgery(gluings);
  surgery.remove(t);
  surgery.remove(other);
  const int merged = surgery.add();
  surgery.carry(t, at.b, merged, Perm4());
  surgery.carry(other, p(at.b), merged, Perm4::transposition(at.a, at.b) * p.inverse());
  surgery.flatten(other, p(at.c), other, Perm4::transposition(p(at.c), p(at.d)));
  surgery.join(merged, at.c, merged, Perm4::transposition(at.c, at.d));
  return surgery.apply(gluings);
}

/// The tetrahedron as above, with w in the place of b: folded around ab, the given edge is bc.
std::optional<EdgeWalk> fold_beside(const Gluings& gluings, std::size_t t, int edge) {
  for (int folded = 0; folded < 6; ++folded) {
    auto at = EdgeWalk::start(t, folded);
    if (folded == edge || folded == 5 - edge || !is_folded(gluings, at)) continue;
    const auto ends = kEdgeEnds[static_cast<std::size_t>(edge)];
    if (at.a == ends[0] || at.a == ends[1]) std::swap(at.a, at.b);
    if (at.d == ends[0] || at.d == ends[1]) std::swap(at.c, at.d);
    return at;
  }
  return std::nullopt;
}

/// Along wc from w, about to leave the folded tetrahedron through the face opposite a.
EdgeWalk away_from_fold(const EdgeWalk& fold) { return {fold.t, fold.b, fold.c, fold.a, fold.d}; }

MoveRefusal refuse_one_two(const Gluings& gluings, const Move& move) {
  if (has_open_face(gluings, move.tetrahedron)) return MoveRefusal::kOpenFace;
  const auto fold = fold_beside(gluings, move.tetrahedron, move.place);
  if (!fold) return MoveRefusal::kNotFolded;
  EdgeWalk seam = away_from_fold(*fold);
  const std::size_t count = valence(gluings, seam);
  if (count == 0) return MoveRefusal::kOpenFace;
  if (move.steps >= count) return MoveRefusal::kNoSuchPlace;
  for (std::uint32_t i = 0; i < move.steps; ++i) seam.step(gluings);
  if (seam.t == fold->t && (seam.c == fold->c || seam.c == fold->d)) return MoveRefusal::kNotFolded;
  return MoveRefusal::kNone;
}

// The folded tetrahedron awcd becomes abcd in place; the new one has w at vertex a, b at b, and
// c and d swapped, so that it is glued by an odd permutation.
MoveChange apply_one_two(Gluings& gluings, const Move& move) {
  const EdgeWalk at = *fold_beside(gluings, move.tetrahedron, move.place);
  EdgeWalk seam = away_from_fold(at);
  for (std::uint32_t i = 0; i < move.steps; ++i) seam.step(gluings);

  const auto t = static_cast<TetrahedronIndex>(at.t);
  const auto other = static_cast<TetrahedronIndex>(gluings.tetrahedron_count());
  gluings.resize(other + 1);
  const Perm4 swap = Perm4::transposition(at.c, at.d);
  const Perm4 moved =
      Perm4::transposition(at.a, at.b) * swap;  // old labels of face wcd in the new one
  const TetrahedronIndex behind = gluings.neighbour(t, at.a);
  const Perm4 p = gluings.gluing(t, at.a);
  gluings.glue(other, moved(at.a), behind, p * moved.inverse());
  gluings.glue(t, at.a, other, swap);
  if (seam.t == t && seam.c == at.a)
    seam = {other, moved(seam.a), moved(seam.b), moved(seam.c), moved(seam.d)};

  // Cut the seam open: near side to wbc, far side to wbd, of the new tetrahedron.
  const int w = at.a;
  const int b = at.b;
  const int c = at.d;
  const int d = at.c;
  const TetrahedronIndex far = gluings.neighbour(seam.t, seam.c);
  const Perm4 r = gluings.gluing(seam.t, seam.c);
  const auto to = [&](int first, int second, int third, int opposite) {
    std::array<int, 4> images{};
    images[static_cast<std::size_t>(seam.a)] = first;
    images[static_cast<std::size_t>(seam.b)] = second;
    images[static_cast<std::size_t>(seam.d)] = third;
    images[static_cast<std::size_t>(seam.c)] = opposite;
    return Perm4::from_images(images[0], images[1], images[2], images[3]);
  };
  gluings.glue(seam.t, seam.c, other, to(w, c, b, d));
  gluings.glue(far, r(seam.c), other, to(w, d, b, c) * r.inverse());

  MoveChange change;
  change.removed.push_back(t);
  change.added.push_back(t);
  change.added.push_back(other);
  const int edge = kEdgeNumber[static_cast<std::size_t>(at.a)][static_cast<std::size_t>(at.b)];
  change.inverse = Move{.kind = MoveKind::kTwoOne,
                        .tetrahedron = t,
                        .place = static_cast<std::uint8_t>(edge),
                        .choice = static_cast<std::uint8_t>(at.a > at.b)};
  return change;
}

/// At edge wc from c to d; the walks that begin at wd are the same ones backwards.
void one_two_candidates(const Triangulation& triangulation, std::vector<Move>& moves) {
  const Gluings& gluings = triangulation.gluings();
  for (TetrahedronIndex t = 0; t < triangulation.tetrahedron_count(); ++t)
    for (int edge = 0; edge < 6; ++edge) {
      const auto fold = fold_beside(gluings, t, edge);
      if (!fold || fold->c > fold->d) continue;
      const auto n =
          static_cast<std::uint32_t>(triangulation.valence(triangulation.edge_class(t, edge)));
      for (std::uint32_t steps = 0; steps + 1 < n; ++steps)
        moves.push_back({.kind = MoveKind::kOneTwo,
                         .tetrahedron = t,
                         .place = static_cast<std::uint8_t>(edge),
                         .steps = steps});
    }
}

}  // namespace

MoveRefusal refuse_fold(const Gluings& gluings, const Move& move) {
  const EdgeWalk at = two_one_corner(move);
  if (has_open_face(gluings, at.t)) return MoveRefusal::kOpenFace;
  if (!is_folded(gluings, at)) return MoveRefusal::kWrongValence;
  const TetrahedronIndex other = gluings.neighbour(at.t, at.a);
  if (other == at.t) return MoveRefusal::kNotDistinct;
  return has_open_face(gluings, other) ? MoveRefusal::kOpenFace : MoveRefusal::kNone;
}

MoveInfo two_one_info() {
  return {.kind = MoveKind::kTwoOne,
          .name = "2-1",
          .arrow = "2-1",
          .description = "a tetrahedron folded around an edge is merged with the one beside it",
          .place = MovePlace::kEdge,
          .choice_name = "end",
          .has_steps = false,
          .tetrahedra = -1,
          .finite_vertices = 0,
          .inverse = MoveKind::kOneTwo,
          .refusal = refuse_two_one,
          .apply = apply_two_one,
          .ball = nullptr,
          .candidates = [](const Triangulation& triangulation, std::vector<Move>& moves) {
            edge_candidates(triangulation, MoveKind::kTwoOne, 2, moves);
          }};
}

MoveInfo one_two_info() {
  return {.kind = MoveKind::kOneTwo,
          .name = "1-2",
          .arrow = "1-2",
          .description = "a folded tetrahedron and a face beside it make room for another",
          .place = MovePlace::kEdge,
          .choice_name = {},
          .has_steps = true,
          .tetrahedra = 1,
          .finite_vertices = 0,
          .inverse = MoveKind::kTwoOne,
          .refusal = refuse_one_two,
          .apply = apply_one_two,
          .ball = nullptr,
          .candidates = one_two_candidates};
}

}  // namespace tripus::topology::detail
