#include "topology/moves/edge_images.hpp"

#include <optional>

#include "topology/edge_walk.hpp"
#include "topology/moves/detail/surgery.hpp"

namespace tripus::topology {
namespace {

using detail::MoveBall;
using detail::Points;

/// A 2-1 as a ball: abcd and wbcd become awcd, in the labels of the former (see two_one.cpp).
MoveBall two_one_ball(const Gluings& gluings, const Move& move) {
  auto at = EdgeWalk::start(move.tetrahedron, move.place);
  if (move.choice != 0) std::swap(at.a, at.b);
  constexpr int kFar = 4;
  MoveBall ball;
  ball.old.push_back({move.tetrahedron, {0, 1, 2, 3}});
  const Perm4 p = gluings.gluing(move.tetrahedron, at.a);
  ball.old.push_back({gluings.neighbour(move.tetrahedron, at.a), {}});
  for (int v = 0; v < 4; ++v)
    ball.old[1].points[static_cast<std::size_t>(p(v))] = v == at.a ? kFar : v;
  Points merged{0, 1, 2, 3};
  merged[static_cast<std::size_t>(at.b)] = kFar;
  ball.fresh.push_back(merged);
  return ball;
}

std::optional<MoveBall> ball_of(const Gluings& gluings, const Move& move) {
  if (move.kind == MoveKind::kTwoOne) return two_one_ball(gluings, move);
  const MoveInfo& kind = info(move.kind);
  if (kind.ball == nullptr) return std::nullopt;
  MoveBall ball = kind.ball(gluings, move);
  // This may turn new tetrahedra round, as it did when the move was made.
  detail::plan_ball(gluings, ball);
  return ball;
}

/// The edge between two points of a tetrahedron, if both are among its own.
std::optional<int> edge_between(const Points& points, int first, int second) {
  const unsigned both = (1u << first) | (1u << second);
  if ((both & ~detail::point_mask(points)) != 0) return std::nullopt;
  return detail::edge_at(points, first, second);
}

}  // namespace

std::vector<std::uint32_t> edge_images(const Triangulation& before, const Move& move,
                                       const MoveChange& change, const Triangulation& after) {
  std::vector<std::uint32_t> images(before.edge_count(), kNoEdge);
  // Tetrahedra that were there keep their labels.
  std::vector<TetrahedronIndex> number(before.tetrahedron_count());
  for (std::size_t t = 0; t < number.size(); ++t) number[t] = static_cast<TetrahedronIndex>(t);
  for (const auto& renumbered : change.renumbered) number[renumbered.from] = renumbered.to;
  for (const TetrahedronIndex t : change.removed) number[t] = kNoTetrahedron;
  for (std::size_t t = 0; t < number.size(); ++t) {
    if (number[t] == kNoTetrahedron) continue;
    for (int e = 0; e < 6; ++e) images[before.edge_class(t, e)] = after.edge_class(number[t], e);
  }
  // Others by the points of the ball.
  const std::optional<MoveBall> ball = ball_of(before.gluings(), move);
  if (!ball) return images;
  for (const detail::Piece& piece : ball->old) {
    for (int e = 0; e < 6; ++e) {
      const auto ends = kEdgeEnds[static_cast<std::size_t>(e)];
      const int first = piece.points[static_cast<std::size_t>(ends[0])];
      const int second = piece.points[static_cast<std::size_t>(ends[1])];
      for (std::size_t k = 0; k < ball->fresh.size(); ++k)
        if (const auto edge = edge_between(ball->fresh[k], first, second))
          images[before.edge_class(piece.t, e)] = after.edge_class(change.added[k], *edge);
    }
  }
  return images;
}

std::optional<NewDiagonal> new_diagonal(const Triangulation& before, const Move& move,
                                        const MoveChange& change) {
  if (move.kind != MoveKind::kTwoThree && move.kind != MoveKind::kFourFour) return std::nullopt;
  const std::optional<MoveBall> ball = ball_of(before.gluings(), move);
  const Points& points = ball->fresh[0];
  for (int e = 0; e < 6; ++e) {
    const auto ends = kEdgeEnds[static_cast<std::size_t>(e)];
    const auto across = kEdgeEnds[static_cast<std::size_t>(5 - e)];
    const auto at = [&](int v) { return points[static_cast<std::size_t>(v)]; };
    bool is_old = false;
    NewDiagonal found{change.added[0], e, {}};
    for (const detail::Piece& piece : ball->old) {
      is_old = is_old || edge_between(piece.points, at(ends[0]), at(ends[1]));
      if (const auto edge = edge_between(piece.points, at(across[0]), at(across[1])))
        found.corners.emplace_back(piece.t, *edge);
    }
    if (!is_old) return found;
  }
  return std::nullopt;
}

std::optional<std::vector<ConeAngle>> carried_labels(std::span<const ConeAngle> labels,
                                                     std::span<const std::uint32_t> images,
                                                     std::size_t edge_count) {
  if (labels.empty()) return std::vector<ConeAngle>{};
  std::vector<ConeAngle> result(edge_count);
  for (std::size_t e = 0; e < labels.size(); ++e) {
    if (labels[e].is_full()) continue;
    if (images[e] == kNoEdge || !result[images[e]].is_full()) return std::nullopt;
    result[images[e]] = labels[e];
  }
  return result;
}

}  // namespace tripus::topology
