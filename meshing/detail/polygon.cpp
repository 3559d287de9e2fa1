#include "meshing/detail/polygon.hpp"

#include <algorithm>
#include <cmath>

#include "base/tolerances.hpp"

namespace tripus::meshing::detail {
namespace {

Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The sum of the cross products of the sides as seen from the first corner: twice the area.
Point normal_of(const std::vector<Point>& points, std::span<const std::uint32_t> corners) {
  Point normal{};
  const Point& origin = points[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Point part =
        cross(difference(points[corners[i]], origin), difference(points[corners[i + 1]], origin));
    for (std::size_t k = 0; k < 3; ++k) normal[k] += part[k];
  }
  return normal;
}

/// The ears of a polygon that gets smaller, as a ring of corners.
class Ears {
 public:
  Ears(const std::vector<Point>& points, std::span<const std::uint32_t> corners,
       std::span<const std::uint8_t> sides)
      : points_(points), corners_(corners), sides_(sides), normal_(normal_of(points, corners)) {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      next_.push_back((i + 1) % n);
      before_.push_back((i + n - 1) % n);
    }
    quality_.resize(n);
    for (std::size_t i = 0; i < n; ++i) quality_[i] = quality_of(i);
  }

  void cut(std::vector<Triangle>& triangles) {
    std::size_t left = corners_.size(), start = 0;
    for (; left > 3; --left) {
      std::size_t best = start;
      for (std::size_t i = next_[start]; i != start; i = next_[i])
        if (quality_[i] > quality_[best]) best = i;
      triangles.push_back(ear(best));
      const std::size_t a = before_[best], b = next_[best];
      next_[a] = b;
      before_[b] = a;
      start = a;
      quality_[a] = quality_of(a);
      quality_[b] = quality_of(b);
    }
    triangles.push_back(ear(start));
  }

 private:
  Triangle ear(std::size_t i) const {
    return {corners_[before_[i]], corners_[i], corners_[next_[i]]};
  }
  const Point& point(std::size_t i) const { return points_[corners_[i]]; }

  /// Twice the area over the square of the longest side, negative at a reflex corner; an ear that
  /// another corner lies in is taken only when there is no other.
  double quality_of(std::size_t i) const {
    constexpr double kLast = 10, kNever = 20;
    if (!sides_.empty() && (sides_[before_[i]] & sides_[next_[i]]) != 0) return -kNever;
    const Point &a = point(before_[i]), &b = point(i), &c = point(next_[i]);
    const Point ab = difference(b, a), bc = difference(c, b), ca = difference(a, c);
    const Point across = cross(ab, bc);
    const double longest = std::max({dot(ab, ab), dot(bc, bc), dot(ca, ca)});
    if (!(longest > 0)) return -kLast;
    const double size = std::sqrt(dot(across, across)) / longest;
    if (dot(across, normal_) <= 0) return -size - 1;
    for (std::size_t j = next_[next_[i]]; j != before_[i]; j = next_[j]) {
      const Point& p = point(j);
      if (p != a && p != b && p != c && contains(a, b, c, p)) return size - kLast;
    }
    return size;
  }
  /// As seen along the normal.
  bool contains(const Point& a, const Point& b, const Point& c, const Point& p) const {
    return side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0;
  }
  double side(const Point& a, const Point& b, const Point& p) const {
    return dot(cross(difference(b, a), difference(p, a)), normal_);
  }

  const std::vector<Point>& points_;
  std::span<const std::uint32_t> corners_;
  std::span<const std::uint8_t> sides_;
  Point normal_;
  std::vector<std::size_t> next_, before_;
  std::vector<double> quality_;
};

}  // namespace

void cut_polygon(const std::vector<Point>& points, std::span<const std::uint32_t> corners,
                 std::vector<Triangle>& triangles, std::span<const std::uint8_t> sides) {
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  Ears(points, corners, sides).cut(triangles);
}

bool is_planar(const std::vector<Point>& points, std::span<const std::uint32_t> corners) {
  const Point normal = normal_of(points, corners);
  const double length = std::sqrt(dot(normal, normal));
  if (!(length > 0)) return false;
  // The normal's length is twice the area: its root is the size of the polygon.
  double largest = std::sqrt(length);
  for (const std::uint32_t corner : corners)
    for (const double x : points[corner]) largest = std::max(largest, std::fabs(x));
  const Point& origin = points[corners[0]];
  return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
    return std::fabs(dot(difference(points[corner], origin), normal)) <=
           tolerance::kPlanarFace * largest * length;
  });
}

Point unit_normal(const Point& a, const Point& b, const Point& c) {
  const Point normal = cross(difference(b, a), difference(c, a));
  const double length = std::sqrt(dot(normal, normal));
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {normal[0] / length, normal[1] / length, normal[2] / length};
}

}  // namespace tripus::meshing::detail
