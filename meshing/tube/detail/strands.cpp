#include "meshing/tube/detail/strands.hpp"

#include <algorithm>
#include <map>
#include <numbers>

#include "base/error.hpp"
#include "meshing/tube/detail/vector3.hpp"
#include "topology/disjoint_sets.hpp"

namespace tripus::meshing::tube {
namespace {

/// A pipe whose axis meets the outer surface at a larger angle to its normal is refused: the hole
/// would be more than twice as long as it is wide.
constexpr double kSteepest = 0.5;  // cosine

std::string edge_name(std::size_t edge) { return "edge " + std::to_string(edge); }

class StrandMaker {
 public:
  StrandMaker(const SpatialGraph& graph, const OuterSurface& outer) : graph_(graph) {
    result_.outer = outer;
  }

  TubeStrands make() {
    if (graph_.edges.empty())
      throw InvalidInput("the spatial graph has no edges; give at least one polyline");
    add_vertices();
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
      drop_repeated_points(e);
      add_edge(e);
    }
    for (std::size_t v = 0; v < graph_.vertices.size(); ++v)
      if (result_.nodes[v].segments.empty())
        throw InvalidInput("vertex " + std::to_string(v) + " at " + as_text(graph_.vertices[v]) +
                           " is the end of no edge; leave it out or write the edge's first or last "
                           "point exactly so");
    return std::move(result_);
  }

 private:
  void add_vertices() {
    for (std::size_t v = 0; v < graph_.vertices.size(); ++v) {
      const Point& point = graph_.vertices[v];
      const std::string name = "vertex " + std::to_string(v) + " at " + as_text(point);
      if (const auto [other, fresh] = vertex_at_.emplace(point, std::uint32_t(v)); !fresh)
        throw InvalidInput(name + " is vertex " + std::to_string(other->second) + " again");
      if (result_.outer.value(point) >= 0)
        throw InvalidInput(name + " does not lie inside the outer surface; make that larger");
      add_node(point, NodeKind::kInside);
    }
  }

  std::uint32_t add_node(const Point& point, NodeKind kind) {
    result_.nodes.push_back({point, kind, {}});
    return std::uint32_t(result_.nodes.size() - 1);
  }

  void add_segment(std::uint32_t a, std::uint32_t b, std::size_t edge, std::size_t number,
                   bool beyond = false) {
    const auto index = std::uint32_t(result_.segments.size());
    result_.segments.push_back({result_.nodes[a].point, result_.nodes[b].point, a, b,
                                std::uint32_t(edge), std::uint32_t(number), beyond});
    result_.nodes[a].segments.push_back(index);
    result_.nodes[b].segments.push_back(index);
  }

  std::uint32_t vertex_of(const Point& point) const {
    const auto found = vertex_at_.find(point);
    return found == vertex_at_.end() ? kNone : found->second;
  }

  /// Points that follow themselves say nothing.
  void drop_repeated_points(std::size_t edge) {
    auto& points = graph_.edges[edge];
    numbers_.clear();
    std::size_t kept = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (kept > 0 && points[p] == points[kept - 1]) continue;
      points[kept++] = points[p];
      numbers_.push_back(p);
    }
    const bool dropped = kept < points.size();
    points.resize(kept);
    if (dropped && kept == 1)
      throw InvalidInput(edge_name(edge) + " is the point " + as_text(points[0]) +
                         " alone; leave it out, or draw it longer");
  }

  void check_points(std::size_t edge) const {
    const auto& points = graph_.edges[edge];
    if (points.size() < 2)
      throw InvalidInput(edge_name(edge) + " has " + std::to_string(points.size()) +
                         " points; a polyline has 2 or more");
    if (points.front() == points.back() && points.size() < 4)
      throw InvalidInput(edge_name(edge) +
                         " ends where it begins; such a loop has 4 points or more, the first "
                         "repeated at the end");
    for (std::size_t p = 1; p + 1 < points.size(); ++p)
      if (const std::uint32_t v = vertex_of(points[p]); v != kNone)
        throw InvalidInput(edge_name(edge) + ": point " + std::to_string(numbers_[p]) +
                           " is vertex " + std::to_string(v) + "; split the edge there");
  }

  /// The run of points inside the outer surface, with the loose ends cut off outside.
  struct Inside {
    std::size_t first, last;
  };

  Inside inside_run(std::size_t edge, bool loose_first, bool loose_last) const {
    const auto& points = graph_.edges[edge];
    const auto outside = [&](std::size_t p) { return result_.outer.value(points[p]) >= 0; };
    Inside run{0, points.size() - 1};
    if (loose_first)
      while (run.first < points.size() && outside(run.first)) ++run.first;
    if (run.first == points.size())
      throw InvalidInput(edge_name(edge) +
                         " has no point inside the outer surface; give it one, or leave it out");
    if (loose_last)
      while (outside(run.last)) --run.last;
    for (std::size_t p = run.first; p <= run.last; ++p)
      if (outside(p))
        throw InvalidInput(edge_name(edge) + ": point " + std::to_string(numbers_[p]) + " at " +
                           as_text(points[p]) +
                           " does not lie inside the outer surface, and the edge comes back from "
                           "there; make that surface larger");
    return run;
  }

  /// A pipe straight through the outer surface, both of whose ends lie outside, gets a point
  /// inside: the deepest one of its segments.
  void add_point_inside(std::size_t edge) {
    auto& points = graph_.edges[edge];
    const OuterSurface& outer = result_.outer;
    if (!std::all_of(points.begin(), points.end(),
                     [&](const Point& p) { return outer.value(p) >= 0; }))
      return;
    for (std::size_t p = 0; p + 1 < points.size(); ++p) {
      const Point a = points[p], b = points[p + 1];
      double low = 0, high = 1;  // by thirds: the function is convex
      for (int step = 0; step < 100; ++step) {
        const double s = low + (high - low) / 3, t = high - (high - low) / 3;
        if (outer.value(a + s * (b - a)) < outer.value(a + t * (b - a)))
          high = t;
        else
          low = s;
      }
      const Point deepest = a + 0.5 * (low + high) * (b - a);
      if (outer.value(deepest) >= 0) continue;
      points.insert(points.begin() + std::ptrdiff_t(p) + 1, deepest);
      numbers_.insert(numbers_.begin() + std::ptrdiff_t(p) + 1, numbers_[p]);
      return;
    }
  }

  void add_edge(std::size_t edge) {
    check_points(edge);
    const auto& points = graph_.edges[edge];
    const std::uint32_t start = vertex_of(points.front()), end = vertex_of(points.back());
    const bool knot = start == kNone && points.front() == points.back();
    bool loose_first = start == kNone && !knot, loose_last = end == kNone && !knot;
    if ((loose_first || loose_last) && !result_.outer.exists()) {
      result_.loose_inside.push_back(std::uint32_t(edge));
      add_pieces(edge, {0, points.size() - 1}, start, end);
      return;
    }
    if (loose_first && loose_last) add_point_inside(edge);
    Inside run = inside_run(edge, loose_first, loose_last);
    std::uint32_t from = start, to = end;
    if (knot) from = to = add_node(points.front(), NodeKind::kInside);
    if (loose_first) from = add_opening(edge, run.first, +1);
    if (loose_last) to = add_opening(edge, run.last, -1);
    // A loose end that lies inside is moved on to the outer surface, along its own segment.
    if (loose_first && run.first > 0) --run.first;
    if (loose_last && run.last + 1 < points.size()) ++run.last;
    add_pieces(edge, run, from, to);
  }

  /// Makes the crossing where a loose end leaves, and the spur beyond it. `inside` is the point
  /// inside nearest to the end, `inward` the direction of the points that follow it.
  std::uint32_t add_opening(std::size_t edge, std::size_t inside, int inward) {
    const auto& points = graph_.edges[edge];
    const bool at_end = inside == (inward > 0 ? 0 : points.size() - 1);
    const Point from = at_end ? points[inside + std::size_t(inward)] : points[inside];
    const Point to = at_end ? points[inside] : points[inside - std::size_t(inward)];
    if (result_.outer.value(from) >= 0)
      throw InvalidInput(edge_name(edge) +
                         " has one point inside the outer surface; give it two there");
    const Point crossing = result_.outer.exit_point(from, to);
    const Point normal = result_.outer.normal(crossing);
    if (dot(normal, unit(to - from)) < kSteepest)
      throw InvalidInput(edge_name(edge) + " meets the outer surface at " + as_text(crossing) +
                         " too flatly, " +
                         as_text(angle_between(normal, to - from) * 180 / std::acos(-1.0)) +
                         " degrees from its normal; bring it out within 60 degrees");
    const std::uint32_t node = add_node(crossing, NodeKind::kCrossing);
    const double length = result_.outer.bounds().diagonal();
    const std::uint32_t tip = add_node(crossing + length * normal, NodeKind::kBeyond);
    add_segment(node, tip, edge, 0, true);
    return node;
  }

  void add_pieces(std::size_t edge, Inside run, std::uint32_t from, std::uint32_t to) {
    const auto& points = graph_.edges[edge];
    if (from == kNone) from = add_node(points[run.first], NodeKind::kInside);
    if (to == kNone) to = add_node(points[run.last], NodeKind::kInside);
    std::uint32_t previous = from;
    for (std::size_t p = run.first + 1; p <= run.last; ++p) {
      const std::uint32_t next = p == run.last ? to : add_node(points[p], NodeKind::kInside);
      add_segment(previous, next, edge, numbers_[p - 1]);
      previous = next;
    }
  }

  SpatialGraph graph_;
  TubeStrands result_;
  std::map<Point, std::uint32_t> vertex_at_;
  std::vector<std::size_t> numbers_;  ///< of the points of the edge at hand, in the drawing
};

}  // namespace

std::string name_of(const Segment& segment) {
  return (segment.beyond ? "the open end of " + edge_name(segment.edge)
                         : edge_name(segment.edge) + " segment " + std::to_string(segment.number));
}

TubeStrands make_strands(const SpatialGraph& graph, const OuterSurface& outer) {
  return StrandMaker(graph, outer).make();
}

double TubeStrands::sharpest_angle() const {
  double least = std::numbers::pi;
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    const auto leaving = [&](std::uint32_t s) {
      return segments[s].node_a == n ? segments[s].b - segments[s].a
                                     : segments[s].a - segments[s].b;
    };
    const auto& at = nodes[n].segments;
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t j = i + 1; j < at.size(); ++j)
        least = std::min(least, angle_between(leaving(at[i]), leaving(at[j])));
  }
  return least;
}

TubeStrands::Expected TubeStrands::expected() const {
  topology::DisjointSets parts(nodes.size());
  for (const Segment& s : segments) parts.join(s.node_a, s.node_b);
  struct Count {
    long characteristic = 0, openings = 0;
  };
  std::map<std::uint32_t, Count> components;
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n].kind == NodeKind::kBeyond) continue;
    ++components[parts.root(n)].characteristic;
    if (nodes[n].kind == NodeKind::kCrossing) ++components[parts.root(n)].openings;
  }
  for (const Segment& s : segments)
    if (!s.beyond) --components[parts.root(s.node_a)].characteristic;
  // A ball less pipes with n openings in all, chi of their graph: 2 + 2 chi - 2 n.
  Expected result;
  long outer_characteristic = 2;
  for (const auto& [node, count] : components) {
    if (count.openings > 0)
      outer_characteristic += 2 * count.characteristic - 2 * count.openings;
    else
      result.euler_characteristics.push_back(2 * count.characteristic);
  }
  if (outer.exists()) result.euler_characteristics.push_back(outer_characteristic);
  std::sort(result.euler_characteristics.begin(), result.euler_characteristics.end());
  return result;
}

}  // namespace tripus::meshing::tube
