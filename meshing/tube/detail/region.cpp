#include "meshing/tube/detail/region.hpp"

#include <array>

namespace tripus::meshing::tube {
namespace {

constexpr std::uint32_t kLeafSize = 4;

/// Enough for a tree of 2^32 segments split in halves.
constexpr std::size_t kDeepest = 64;

Point foot(const Point& p, const std::array<Point, 2>& segment) {
  const Point ab = segment[1] - segment[0];
  const double t = std::clamp(dot(p - segment[0], ab) / dot(ab, ab), 0.0, 1.0);
  return segment[0] + t * ab;
}

double squared_distance(const Point& p, const std::array<Point, 2>& segment) {
  const Point d = p - foot(p, segment);
  return dot(d, d);
}

}  // namespace

TubeRegion::TubeRegion(const TubeStrands& strands, double radius, double depth, double fillet)
    : outer_(strands.outer), radius_(radius), depth_(depth), fillet_(fillet) {
  for (const Segment& s : strands.segments) segments_.push_back({s.a, s.b});
  cells_.reserve(2 * segments_.size());
  build(0, std::uint32_t(segments_.size()));
}

std::uint32_t TubeRegion::build(std::uint32_t first, std::uint32_t last) {
  const auto index = std::uint32_t(cells_.size());
  Cell cell{{}, first, last, 0};
  for (std::uint32_t s = first; s < last; ++s)
    for (const Point& p : segments_[s]) cell.bounds.add(p);
  cells_.push_back(cell);
  if (last - first <= kLeafSize) return index;
  const Point size = cell.bounds.high - cell.bounds.low;
  const int axis = int(std::max_element(size.begin(), size.end()) - size.begin());
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(segments_.begin() + first, segments_.begin() + middle, segments_.begin() + last,
                   [&](const auto& x, const auto& y) {
                     return x[0][axis] + x[1][axis] < y[0][axis] + y[1][axis];
                   });
  build(first, middle);
  const std::uint32_t right = build(middle, last);
  cells_[index].right = right;
  return index;
}

template <class TooFar, class Visit>
void TubeRegion::walk(const Point& p, TooFar&& too_far, Visit&& visit) const {
  std::array<std::uint32_t, kDeepest> todo;
  std::size_t count = 0;
  todo[count++] = 0;
  while (count > 0) {
    const std::uint32_t c = todo[--count];
    const Cell& cell = cells_[c];
    if (too_far(cell.bounds.distance(p))) continue;
    if (cell.right != 0) {
      todo[count++] = cell.right;
      todo[count++] = c + 1;
      continue;
    }
    for (std::uint32_t s = cell.first; s < cell.last; ++s) visit(s);
  }
}

TubeRegion::Nearest TubeRegion::nearest(const Point& p, double beyond) const {
  Nearest best{beyond * beyond, kNone};
  walk(
      p, [&](double distance) { return distance * distance >= best.squared; },
      [&](std::uint32_t s) {
        if (const double d = squared_distance(p, segments_[s]); d < best.squared) best = {d, s};
      });
  return best;
}

double TubeRegion::graph_distance(const Point& p, double beyond) const {
  return std::sqrt(nearest(p, beyond).squared);
}

template <class Visit>
void TubeRegion::for_segments_within(const Point& p, double distance, Visit&& visit) const {
  walk(
      p, [&](double far) { return far >= distance; },
      [&](std::uint32_t s) { visit(segments_[s]); });
}

/// A smooth minimum of the distances d, e from two segments is d - (k - (e - d))^2 / 4k where they
/// differ by less than k. It counts as far as the segments are seen in different directions, so
/// that the joints of a bent strand stay as they are.
double TubeRegion::rounding(const Point& p, const Nearest& near) const {
  const double d = std::sqrt(near.squared);
  if (near.segment == kNone || d == 0 || !(std::abs(d - radius_) < fillet_)) return 0;
  const Point to_near = (1 / d) * (foot(p, segments_[near.segment]) - p);
  double most = 0;
  for_segments_within(p, d + fillet_, [&](const std::array<Point, 2>& segment) {
    const Point to = foot(p, segment) - p;
    const double e = norm(to), overlap = fillet_ - (e - d);
    if (e == 0 || overlap <= 0) return;
    const double apart = std::clamp(0.5 - dot(to, to_near) / e, 0.0, 0.5) * 2;
    most = std::max(most, apart * kFilletHeight * overlap * overlap / fillet_);
  });
  return most;
}

double TubeRegion::value(const Point& p) const {
  const double outer = outer_.value(p);
  if (outer_.exists() && outer >= depth_) return outer;  // no matter how far from the tube
  const Nearest near = nearest(p, radius_ + depth_);
  const double tube = radius_ - std::sqrt(near.squared) + (fillet_ > 0 ? rounding(p, near) : 0);
  return outer_.exists() ? std::max({outer, tube, -depth_}) : std::min(-tube, depth_);
}

double TubeRegion::full_value(const Point& p) const {
  const double tube = radius_ - std::sqrt(nearest(p, HUGE_VAL).squared);
  return outer_.exists() ? std::max(outer_.value(p), tube) : -tube;
}

Point TubeRegion::projected(Point p) const {
  const double sign = outer_.exists() ? 1 : -1;
  for (int step = 0; step < 3; ++step) {
    const double outer = outer_.value(p);
    const Nearest near = nearest(p, radius_ + depth_);
    const double tube = radius_ - std::sqrt(near.squared);
    if (near.segment != kNone && tube >= outer) {
      const Point d = p - foot(p, segments_[near.segment]);
      if (near.squared > 0) p = p + (tube / std::sqrt(near.squared)) * d;
    } else if (sign > 0 && outer > -depth_) {
      p = p - outer * outer_.normal(p);
    }
  }
  return p;
}

Bounds TubeRegion::bounds() const {
  if (outer_.exists()) return outer_.bounds();
  Bounds result;
  const Point r{radius_, radius_, radius_};
  for (const auto& s : segments_)
    for (const Point& p : s) {
      result.add(p - r);
      result.add(p + r);
    }
  return result;
}

}  // namespace tripus::meshing::tube
