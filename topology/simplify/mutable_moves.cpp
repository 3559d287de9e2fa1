#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "topology/moves/detail/surgery.hpp"
#include "topology/simplify/mutable_triangulation.hpp"

// The moves of topology/moves on a MutableTriangulation. What is glued to what comes from the ball
// of the move, as for plain tables; so do the labels: the ball's points name the vertex classes,
// pairs of points the edge classes, and a pair that no old tetrahedron had is a new edge.

namespace tripus::topology {
namespace {

constexpr MutableTriangulation::Label kNoLabel = 0xffffffffu;
constexpr std::size_t kMostPoints = 6;

using EdgeLabels = std::array<MutableTriangulation::Label, kMostPoints * kMostPoints>;

std::size_t pair(const detail::Points& points, int e) {
  const auto [a, b] = kEdgeEnds[static_cast<std::size_t>(e)];
  const auto [low, high] =
      std::minmax(points[static_cast<std::size_t>(a)], points[static_cast<std::size_t>(b)]);
  return static_cast<std::size_t>(low) * kMostPoints + static_cast<std::size_t>(high);
}

}  // namespace

// A 2-0 at an edge lays the two edges opposite to it upon each other, a 2-1 two edges of the
// neighbour; a vertex that goes must be one that no kept edge meets.
bool MutableTriangulation::hurts_kept(const Move& move) const {
  const TetrahedronIndex t = move.tetrahedron;
  switch (move.kind) {
    case MoveKind::kThreeTwo:
    case MoveKind::kFourFour:
      return kept(edge(t, move.place)) != 0;
    case MoveKind::kTwoZeroEdge: {
      auto walk = EdgeWalk::start(t, move.place);
      const int opposite = 5 - move.place;
      walk.step(gluings_);
      return kept(edge(t, move.place)) != 0 ||
             (kept(edge(t, opposite)) != 0 && kept(edge(walk.t, 5 - walk.edge())) != 0);
    }
    case MoveKind::kTwoOne: {
      const auto at = EdgeWalk::start(t, move.place);
      const int a = move.choice == 0 ? at.a : at.b;
      const TetrahedronIndex other = gluings_.neighbour(at.t, a);
      const Perm4 p = gluings_.gluing(at.t, a);
      const auto far = [&](int end) {
        return kEdgeNumber[static_cast<std::size_t>(p(a))][static_cast<std::size_t>(p(end))];
      };
      return kept(edge(t, move.place)) != 0 ||
             (kept(edge(other, far(at.c))) != 0 && kept(edge(other, far(at.d))) != 0);
    }
    case MoveKind::kTwoZeroVertex:
    case MoveKind::kFourOne:
      return !is_finite(vertex(t, move.place));
    default:
      return false;
  }
}

MoveRefusal MutableTriangulation::refusal(const Move& move) const {
  if (move.tetrahedron >= slot_count() || !is_live(move.tetrahedron))
    return MoveRefusal::kNoSuchPlace;
  if (!kept_.empty() && hurts_kept(move)) return MoveRefusal::kNoSuchPlace;
  if (move.kind == MoveKind::kTwoZeroEdge) {
    const MoveRefusal met = detail::refuse_pillow(gluings_, move);
    if (met != MoveRefusal::kNone) return met;
    auto walk = EdgeWalk::start(move.tetrahedron, move.place);
    walk.step(gluings_);
    return edge(move.tetrahedron, 5 - move.place) == edge(walk.t, 5 - walk.edge())
               ? MoveRefusal::kSameOppositeEdges
               : MoveRefusal::kNone;
  }
  if (move.kind == MoveKind::kTwoOne) {
    const MoveRefusal met = detail::refuse_fold(gluings_, move);
    if (met != MoveRefusal::kNone) return met;
    const auto at = EdgeWalk::start(move.tetrahedron, move.place);
    const int a = move.choice == 0 ? at.a : at.b;
    const TetrahedronIndex other = gluings_.neighbour(at.t, a);
    const Perm4 p = gluings_.gluing(at.t, a);
    const auto number = [&](int far) {
      return kEdgeNumber[static_cast<std::size_t>(p(a))][static_cast<std::size_t>(p(far))];
    };
    return edge(other, number(at.c)) == edge(other, number(at.d)) ? MoveRefusal::kSameOppositeEdges
                                                                  : MoveRefusal::kNone;
  }
  if (info(move.kind).ball == nullptr) return MoveRefusal::kNoSuchPlace;
  return info(move.kind).refusal(gluings_, move);
}

void MutableTriangulation::apply(const Move& move) {
  if (move.kind == MoveKind::kTwoOne)
    apply_two_one(move);
  else
    replace_ball(move);
}

// Two edges of the old tetrahedra between the same points: they are laid upon each other.
void MutableTriangulation::merge_edges(const detail::MoveBall& ball) {
  struct Corner {
    TetrahedronIndex t = kNoTetrahedron;
    int e = 0;
  };
  std::array<Corner, kMostPoints * kMostPoints> first{};
  for (const auto& [t, points] : ball.old)
    for (int e = 0; e < 6; ++e) {
      Corner& known = first[pair(points, e)];
      if (known.t == kNoTetrahedron) {
        known = {t, e};
        continue;
      }
      const Label one = edge(known.t, known.e);
      const Label two = edge(t, e);
      if (one == two) continue;
      if (valence(two) <= valence(one))
        relabel_edge(t, e, one);
      else
        relabel_edge(known.t, known.e, two);
    }
}

void MutableTriangulation::replace_ball(const Move& move) {
  if (steps_ != nullptr) steps_->push_move(move);
  detail::MoveBall ball = info(move.kind).ball(gluings_, move);
  const detail::Surgery surgery = detail::plan_ball(gluings_, ball);
  if (ball.fresh.empty()) merge_edges(ball);

  EdgeLabels edge_at;
  std::array<Label, kMostPoints> vertex_at;
  edge_at.fill(kNoLabel);
  vertex_at.fill(kNoLabel);
  for (const auto& [t, points] : ball.old) {
    for (int v = 0; v < 4; ++v)
      vertex_at[static_cast<std::size_t>(points[static_cast<std::size_t>(v)])] = vertex(t, v);
    for (int e = 0; e < 6; ++e) edge_at[pair(points, e)] = edge(t, e);
    uncount(t);
  }
  const EdgeLabels old_edges = edge_at;
  const auto old_vertices = vertex_at;

  std::array<TetrahedronIndex, 4> numbers{};
  for (std::size_t k = 0; k < ball.fresh.size(); ++k) numbers[k] = take_tetrahedron();
  touched_.clear();
  for (const auto& [t, f, other, p] : surgery.glues({numbers.data(), ball.fresh.size()})) {
    glue(t, f, other, p);
    if (ball.fresh.empty()) touched_.insert(touched_.end(), {t, other});
  }
  for (std::size_t k = 0; k < ball.fresh.size(); ++k) {
    const detail::Points& points = ball.fresh[k];
    for (int v = 0; v < 4; ++v) {
      Label& label = vertex_at[static_cast<std::size_t>(points[static_cast<std::size_t>(v)])];
      if (label == kNoLabel) label = take_vertex();
      set_vertex(numbers[k], v, label);
    }
    for (int e = 0; e < 6; ++e) {
      Label& label = edge_at[pair(points, e)];
      if (label == kNoLabel) label = take_edge();
      set_edge(numbers[k], e, label);
    }
    count(numbers[k]);
    touched_.push_back(numbers[k]);
  }
  for (const auto& [t, points] : ball.old) free_tetrahedron(t);
  for (std::size_t i = 0; i < old_edges.size(); ++i)
    if (old_edges[i] != kNoLabel && valence(old_edges[i]) == 0 &&
        std::find(old_edges.begin(), old_edges.begin() + static_cast<std::ptrdiff_t>(i),
                  old_edges[i]) == old_edges.begin() + static_cast<std::ptrdiff_t>(i))
      free_edge(old_edges[i]);
  for (const Label label : old_vertices)
    if (label != kNoLabel && degree(label) == 0) free_vertex(label);
}

// As its conditions were derived: a 2-3 at the face opposite the chosen end, then the edge has
// valence 2 and its tetrahedra are flattened.
void MutableTriangulation::apply_two_one(const Move& move) {
  const auto [a, b] = kEdgeEnds[move.place];
  const Label folded = edge(move.tetrahedron, move.place);
  replace_ball({.kind = MoveKind::kTwoThree,
                .tetrahedron = move.tetrahedron,
                .place = static_cast<std::uint8_t>(move.choice == 0 ? a : b)});
  const auto made = touched_;
  for (const TetrahedronIndex t : made)
    for (int e = 0; e < 6; ++e) {
      if (edge(t, e) != folded) continue;
      replace_ball({.kind = MoveKind::kTwoZeroEdge,
                    .tetrahedron = t,
                    .place = static_cast<std::uint8_t>(e)});
      for (const TetrahedronIndex left : made)
        if (is_live(left)) touched_.push_back(left);
      return;
    }
  throw InternalError("a 2-1 lost the edge that it folds around");
}

}  // namespace tripus::topology
