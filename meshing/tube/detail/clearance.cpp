// A lower bound for the radius at which the tube around a graph K first changes its shape.
//
// The tubes {d < r}, d the distance from K, change only where r passes a critical value: the value
// rho = d(x) at a point x that lies in the convex hull of its nearest points on K. Two of these
// then stand at an angle of at least acos(-1/3) = 109.47 degrees as seen from x (four unit vectors
// with 0 in their hull cannot all be closer).
//
// (C1) Let p, q be two such points and A an arc of K from p to q. At p the distance from x does not
//      fall along A, so A leaves p at 90 degrees or more from the direction to x, and so at q. By
//      Fenchel's theorem the closed curve A + q x + x p turns by 360 degrees in all, at most
//      90 + 90 + (180 - 109.47) of it at p, q, x. Hence A itself turns by 109.47 or more. So pieces
//      joined by an arc that turns less do not count, all others do: rho >= distance / 2.
// (C2) Two segments that meet in a sharp corner o, at an angle phi < 180 - 109.47, are joined by no
//      such arc, and their distance is 0. But x cannot have all its nearest points on segments at
//      o: with w_i = x - p_i and sum c_i w_i = 0, p_i nearest means w_i . (o - p_i) <= 0, and the
//      sum of c_i w_i . (o - x + w_i) is rho^2 > 0. So some nearest point r lies on a segment k not
//      at o. If p, q on the two segments at o are nearest, then |pq| <= 2 rho bounds the smaller of
//      |op|, |oq| by rho / sin(phi / 2), and |or| <= rho (2 + 1 / sin(phi / 2)).
//
// Against the outer surface: what lies inside must be deeper than 1.5 times the room, which with
// the grid of tube_surface.cpp keeps tube and outer surface apart by more than two cells.
#include "meshing/tube/detail/clearance.hpp"

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "meshing/tube/detail/vector3.hpp"

namespace tripus::meshing::tube {
namespace {

const double kTurn = std::acos(-1.0 / 3);

/// Two pieces at a node that leave in nearly the same direction are refused: no tube has room.
constexpr double kSharpest = 1e-6;

constexpr double kDepthPerRoom = 1.5;

class ClearanceSearch {
 public:
  explicit ClearanceSearch(const TubeStrands& strands)
      : strands_(strands),
        marked_by_(strands.segments.size(), kNone),
        turning_(strands.segments.size()) {}

  Clearance run() {
    check_size();
    check_depths();
    for (std::uint32_t n = 0; n < strands_.nodes.size(); ++n) check_corners(n);
    for (std::uint32_t s = 0; s < strands_.segments.size(); ++s) check_pairs(s);
    return std::move(best_);
  }

 private:
  template <class Place>
  void limit(double room, Place&& place) {
    if (room >= best_.room) return;
    best_ = {room, place()};
  }

  /// Direction in which segment s leaves one of its nodes.
  Point leaving(std::uint32_t s, std::uint32_t node) const {
    const Segment& segment = strands_.segments[s];
    return segment.node_a == node ? segment.b - segment.a : segment.a - segment.b;
  }

  /// What nothing else limits is limited by the drawing's own size.
  void check_size() {
    Bounds bounds;
    for (const Node& node : strands_.nodes)
      if (node.kind != NodeKind::kBeyond) bounds.add(node.point);
    limit(bounds.diagonal(),
          [&] { return "the whole drawing is " + as_text(bounds.diagonal()) + " large"; });
  }

  void check_depths() {
    if (!strands_.outer.exists()) return;
    for (const Node& node : strands_.nodes) {
      if (node.kind == NodeKind::kBeyond) continue;
      const bool crossing = node.kind == NodeKind::kCrossing;
      const double depth = crossing ? strands_.outer.distance_from_rim(node.point)
                                    : -strands_.outer.value(node.point);
      limit(depth / kDepthPerRoom, [&] {
        return "the point " + as_text(node.point) + " of " +
               name_of(strands_.segments[node.segments.front()]) + " is only " + as_text(depth) +
               (crossing ? " from the next face of the outer box" : " from the outer surface");
      });
    }
  }

  void check_corners(std::uint32_t n) {
    const auto& at = strands_.nodes[n].segments;
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t j = i + 1; j < at.size(); ++j) {
        const double phi = angle_between(leaving(at[i], n), leaving(at[j], n));
        if (phi < kSharpest)
          throw InvalidInput(name_of(strands_.segments[at[i]]) + " and " +
                             name_of(strands_.segments[at[j]]) + " leave the same direction from " +
                             as_text(strands_.nodes[n].point) + "; move one of them aside");
        if (phi < std::numbers::pi - kTurn) check_sharp_corner(n, phi, at[i], at[j]);
      }
  }

  void check_sharp_corner(std::uint32_t n, double phi, std::uint32_t i, std::uint32_t j) {
    const Point& corner = strands_.nodes[n].point;
    const double factor = 2 + 1 / std::sin(phi / 2);
    for (const Segment& s : strands_.segments) {
      if (s.node_a == n || s.node_b == n) continue;
      const double far = point_segment_distance(corner, s.a, s.b);
      limit(far / factor, [&] {
        return name_of(strands_.segments[i]) + " and " + name_of(strands_.segments[j]) +
               " meet at only " + as_text(phi * 180 / std::numbers::pi) + " degrees, and " +
               name_of(s) + " is " + as_text(far) + " from their corner";
      });
    }
  }

  /// Marks the segments that an arc joins to s with little turning, and those that meet s.
  void mark_near(std::uint32_t s) {
    marked_by_[s] = s;
    turning_[s] = 0;
    todo_.clear();
    const auto from = [&](std::uint32_t segment, std::uint32_t node, double turned) {
      for (const std::uint32_t next : strands_.nodes[node].segments) {
        if (next == segment) continue;
        const Point ahead = -1.0 * leaving(segment, node);
        const double turn = turned + angle_between(ahead, leaving(next, node));
        if (marked_by_[next] == s && turning_[next] <= turn) continue;
        if (turn >= kTurn && segment != s) continue;
        marked_by_[next] = s;
        turning_[next] = turn;
        if (turn < kTurn) todo_.push_back({next, node, turn});
      }
    };
    from(s, strands_.segments[s].node_a, 0);
    from(s, strands_.segments[s].node_b, 0);
    while (!todo_.empty()) {
      const Step step = todo_.back();
      todo_.pop_back();
      const Segment& segment = strands_.segments[step.segment];
      from(step.segment, segment.node_a == step.entered ? segment.node_b : segment.node_a,
           step.turned);
    }
  }

  void check_pairs(std::uint32_t i) {
    mark_near(i);
    const Segment& s = strands_.segments[i];
    const Point middle = 0.5 * (s.a + s.b);
    const double half = 0.5 * distance(s.a, s.b);
    for (std::uint32_t j = i + 1; j < strands_.segments.size(); ++j) {
      if (marked_by_[j] == i) continue;
      const Segment& t = strands_.segments[j];
      const double reach = half + 0.5 * distance(t.a, t.b) + 2 * best_.room;
      const Point between = 0.5 * (t.a + t.b) - middle;
      if (dot(between, between) > reach * reach) continue;
      const double apart = segment_distance(s.a, s.b, t.a, t.b);
      limit(apart / 2, [&] {
        return name_of(s) + " and " + name_of(t) +
               (apart > 0 ? " come within " + as_text(apart) + " of each other"
                          : std::string(" touch"));
      });
    }
  }

  struct Step {
    std::uint32_t segment, entered;
    double turned;
  };

  const TubeStrands& strands_;
  Clearance best_;
  std::vector<std::uint32_t> marked_by_;
  std::vector<double> turning_;
  std::vector<Step> todo_;
};

}  // namespace

double point_segment_distance(const Point& p, const Point& a, const Point& b) {
  const Point ab = b - a;
  const double t = std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0);
  return distance(p, a + t * ab);
}

double segment_distance(const Point& a, const Point& b, const Point& c, const Point& d) {
  double least = std::min({point_segment_distance(a, c, d), point_segment_distance(b, c, d),
                           point_segment_distance(c, a, b), point_segment_distance(d, a, b)});
  // Where both nearest points are inside: the foot of the common perpendicular.
  const Point u = b - a, v = d - c, w = a - c;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double det = uu * vv - uv * uv;
  if (det > 0) {
    const double s = (uv * vw - vv * uw) / det, t = (uu * vw - uv * uw) / det;
    if (s > 0 && s < 1 && t > 0 && t < 1) least = std::min(least, distance(a + s * u, c + t * v));
  }
  return least;
}

Clearance find_clearance(const TubeStrands& strands) { return ClearanceSearch(strands).run(); }

}  // namespace tripus::meshing::tube
