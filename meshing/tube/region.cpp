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

Region::Region(const Strands& strands, double radius, double depth)
    : outer_(strands.outer), radius_(radius), depth_(depth) {
  for (const Segment& s : strands.segments) segments_.push_back({s.a, s.b});
  cells_.reserve(2 * segments_.size());
  build(0, std::uint32_t(segments_.size()));
}

std::uint32_t Region::build(std::uint32_t first, std::uint32_t last) {
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

Region::Nearest Region::nearest(const Point& p, double beyond) const {
  Nearest best{beyond * beyond, kNone};
  std::array<std::uint32_t, kDeepest> todo;
  std::size_t count = 0;
  todo[count++] = 0;
  while (count > 0) {
    const std::uint32_t c = todo[--count];
    const Cell& cell = cells_[c];
    const double far = cell.bounds.distance(p);
    if (far * far >= best.squared) continue;
    if (cell.right != 0) {
      todo[count++] = cell.right;
      todo[count++] = c + 1;
      continue;
    }
    for (std::uint32_t s = cell.first; s < cell.last; ++s)
      if (const double d = squared_distance(p, segments_[s]); d < best.squared) best = {d, s};
  }
  return best;
}

double Region::graph_distance(const Point& p, double beyond) const {
  return std::sqrt(nearest(p, beyond).squared);
}

double Region::value(const Point& p) const {
  if (!outer_.exists()) return std::min(graph_distance(p, radius_ + depth_) - radius_, depth_);
  const double outer = outer_.value(p);
  if (outer >= depth_) return outer;  // far outside: no matter how far from the tube
  return std::max({outer, radius_ - graph_distance(p, radius_ + depth_), -depth_});
}

double Region::full_value(const Point& p) const {
  const double tube = radius_ - std::sqrt(nearest(p, HUGE_VAL).squared);
  return outer_.exists() ? std::max(outer_.value(p), tube) : -tube;
}

Point Region::projected(Point p) const {
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

Bounds Region::bounds() const {
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
