#include "meshing/tube/detail/pipe_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "meshing/tube/detail/clearance.hpp"

namespace tripus::meshing::tube {
namespace {

constexpr std::uint32_t kPiecesInLeaf = 4;

}  // namespace

SegmentTree::SegmentTree(std::vector<Piece> pieces)
    : pieces_(std::move(pieces)), order_(pieces_.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  if (!pieces_.empty()) build(0, std::uint32_t(pieces_.size()));
}

void SegmentTree::build(std::uint32_t first, std::uint32_t last) {
  const std::size_t cell = cells_.size();
  cells_.emplace_back();
  Bounds bounds, middles;
  const auto middle = [&](std::uint32_t i) { return 0.5 * (pieces_[i].a + pieces_[i].b); };
  for (std::uint32_t i = first; i < last; ++i) {
    bounds.add(pieces_[order_[i]].a);
    bounds.add(pieces_[order_[i]].b);
    middles.add(middle(order_[i]));
  }
  cells_[cell].bounds = bounds;
  if (last - first <= kPiecesInLeaf) {
    cells_[cell].first = first;
    cells_[cell].last = last;
    return;
  }
  const Point size = middles.high - middles.low;
  const auto axis = std::size_t(std::max_element(size.begin(), size.end()) - size.begin());
  const std::uint32_t half = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                   [&](std::uint32_t i, std::uint32_t j) {
                     const double x = middle(i)[axis], y = middle(j)[axis];
                     return x < y || (x == y && i < j);
                   });
  build(first, half);
  cells_[cell].right = std::uint32_t(cells_.size());
  build(half, last);
}

double SegmentTree::gap(const Bounds& a, const Bounds& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double d = std::max({a.low[k] - b.high[k], b.low[k] - a.high[k], 0.0});
    sum += d * d;
  }
  return std::sqrt(sum);
}

namespace {

/// Part of a distance that each of two takes, and of an angle.
constexpr double kShare = 0.45;

/// The cone of a pipe is never wider than this; a straight bend would allow 90 degrees.
constexpr double kWidestCone = std::numbers::pi / 4;

/// The last bend before an opening is so far from the outer surface, in parts of what is free
/// around the place; the pipe comes out within 60 degrees of the normal, so that the bend is less
/// than twice as far away.
constexpr double kLastBend = 0.2;

class PipePlanner {
 public:
  explicit PipePlanner(const TubeStrands& strands) : strands_(strands) {
    plan_.outer = strands.outer;
  }

  PipePlan make() {
    for (const Node& node : strands_.nodes) plan_.joints.push_back({.point = node.point});
    for (std::uint32_t s = 0; s < strands_.segments.size(); ++s)
      if (const Segment& segment = strands_.segments[s]; !segment.beyond)
        plan_.pipes.push_back({.a = segment.node_a, .b = segment.node_b, .segment = s});
    bend_openings();
    for (std::uint32_t p = 0; p < plan_.pipes.size(); ++p)
      for (const std::uint32_t j : {plan_.pipes[p].a, plan_.pipes[p].b})
        plan_.joints[j].pipes.push_back(p);
    const SegmentTree tree = tree_of_pipes();
    for (std::uint32_t j = 0; j < plan_.joints.size(); ++j) set_ball(tree, j);
    for (std::uint32_t p = 0; p < plan_.pipes.size(); ++p) set_pipe(tree, p);
    return std::move(plan_);
  }

 private:
  SegmentTree tree_of_pipes() const {
    std::vector<SegmentTree::Piece> pieces;
    for (const Pipe& p : plan_.pipes)
      pieces.push_back({plan_.joints[p.a].point, plan_.joints[p.b].point});
    return SegmentTree(std::move(pieces));
  }

  /// Distance from a point to the nearest pipe that does not end at joint j.
  double free_around(const SegmentTree& tree, const Point& point, std::uint32_t j) const {
    Bounds bounds;
    bounds.add(point);
    const auto ends_here = [&](std::uint32_t p) {
      return plan_.pipes[p].a == j || plan_.pipes[p].b == j;
    };
    return tree
        .nearest(bounds, ends_here,
                 [&](std::uint32_t p) {
                   return point_segment_distance(point, tree.piece(p).a, tree.piece(p).b);
                 })
        .distance;
  }

  /// All openings move by less than half of the way to anything else: one after the other, or all
  /// at once, that is an isotopy.
  void bend_openings() {
    const SegmentTree tree = tree_of_pipes();
    const std::size_t count = plan_.pipes.size();
    for (std::size_t p = 0; p < count; ++p)
      for (const bool at_a : {true, false}) {
        const std::uint32_t j = at_a ? plan_.pipes[p].a : plan_.pipes[p].b;
        if (strands_.nodes[j].kind != NodeKind::kCrossing) continue;
        const Point exit = strands_.nodes[j].point;
        const SegmentTree::Piece& piece = tree.piece(std::uint32_t(p));
        const Point inward = (at_a ? piece.b : piece.a) - exit;
        const double free = std::min({free_around(tree, exit, j), norm(inward),
                                      strands_.outer.distance_from_rim(exit), outer_size() / 4});
        const Point normal = strands_.outer.normal(exit), in = unit(inward);
        const double steep = std::max(-dot(in, normal), 0.5);
        plan_.joints[j].point = exit + (kLastBend * free / steep) * in;
        add_opening(j, normal, plan_.pipes[p].segment);
      }
  }

  double outer_size() const { return strands_.outer.bounds().diagonal(); }

  void add_opening(std::uint32_t bend, const Point& normal_at_exit, std::uint32_t segment) {
    const OuterSurface& outer = strands_.outer;
    const Point& from = plan_.joints[bend].point;
    const Point normal = outer.is_sphere() ? outer.normal(from) : normal_at_exit;
    plan_.pipes.push_back({.a = bend, .b = std::uint32_t(plan_.joints.size()), .segment = segment});
    Point exit = outer.exit_point(from, from + normal);
    if (!outer.is_sphere())  // exactly in the face
      for (std::size_t k = 0; k < 3; ++k)
        if (normal[k] != 0) exit[k] = (normal[k] > 0 ? outer.bounds().high : outer.bounds().low)[k];
    plan_.joints.push_back({.point = exit, .opening = true, .normal = normal});
  }

  double length(const Pipe& p) const {
    return distance(plan_.joints[p.a].point, plan_.joints[p.b].point);
  }

  double depth(const Joint& joint) const {
    if (!plan_.outer.exists()) return HUGE_VAL;
    return joint.opening ? plan_.outer.distance_from_rim(joint.point)
                         : -plan_.outer.value(joint.point);
  }

  void set_ball(const SegmentTree& tree, std::uint32_t j) {
    Joint& joint = plan_.joints[j];
    if (joint.opening || joint.pipes.empty()) return;
    double free = std::min(free_around(tree, joint.point, j), depth(joint));
    for (const std::uint32_t p : joint.pipes) free = std::min(free, length(plan_.pipes[p]));
    joint.radius = kShare * free;
  }

  Point leaving(std::uint32_t p, std::uint32_t j) const {
    const Pipe& pipe = plan_.pipes[p];
    return plan_.joints[pipe.a == j ? pipe.b : pipe.a].point - plan_.joints[j].point;
  }

  /// Half the angle of the cone at joint j in which pipe p stays.
  double cone(std::uint32_t p, std::uint32_t j) const {
    double least = kWidestCone / kShare;
    for (const std::uint32_t other : plan_.joints[j].pipes)
      if (other != p) least = std::min(least, angle_between(leaving(p, j), leaving(other, j)));
    return kShare * least;
  }

  double free_around_pipe(const SegmentTree& tree, std::uint32_t p) const {
    const Pipe& pipe = plan_.pipes[p];
    const SegmentTree::Piece& axis = tree.piece(p);
    const auto touches = [&](std::uint32_t other) {
      const Pipe& q = plan_.pipes[other];
      return q.a == pipe.a || q.a == pipe.b || q.b == pipe.a || q.b == pipe.b;
    };
    Bounds bounds;
    bounds.add(axis.a);
    bounds.add(axis.b);
    const auto nearest = tree.nearest(bounds, touches, [&](std::uint32_t other) {
      return segment_distance(axis.a, axis.b, tree.piece(other).a, tree.piece(other).b);
    });
    double free = std::min(
        {nearest.distance, depth(plan_.joints[pipe.a]), depth(plan_.joints[pipe.b]), length(pipe)});
    for (const std::uint32_t j : {pipe.a, pipe.b})
      for (const std::uint32_t other : plan_.joints[j].pipes)
        if (other != p)
          free = std::min(free, point_segment_distance(plan_.joints[j].point + leaving(other, j),
                                                       axis.a, axis.b));
    return free;
  }

  void set_pipe(const SegmentTree& tree, std::uint32_t p) {
    Pipe& pipe = plan_.pipes[p];
    const Joint &a = plan_.joints[pipe.a], &b = plan_.joints[pipe.b];
    const double cone_a = cone(p, pipe.a), cone_b = cone(p, pipe.b);
    double most = kShare * free_around_pipe(tree, p);
    // Each end lies in the cone from the other one; the balls take less than half of the way.
    const double half = 0.5 * length(pipe);
    if (!b.opening) most = std::min(most, half * std::tan(cone_b));
    if (!a.opening) most = std::min(most, half * std::tan(cone_a));
    const auto end = [&](const Joint& joint, double angle) {
      return joint.opening ? most : std::min(most, joint.radius * std::sin(angle));
    };
    pipe.radius_a = end(a, cone_a);
    pipe.radius_b = end(b, cone_b);
  }

  const TubeStrands& strands_;
  PipePlan plan_;
};

}  // namespace

PipePlan plan_pipes(const TubeStrands& strands) { return PipePlanner(strands).make(); }

}  // namespace tripus::meshing::tube
