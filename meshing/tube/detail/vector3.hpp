#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing::tube {

inline Point operator+(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point operator-(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point operator*(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Point& a) { return std::sqrt(dot(a, a)); }
inline double distance(const Point& a, const Point& b) { return norm(a - b); }
inline Point unit(const Point& a) { return (1 / norm(a)) * a; }

/// Twice the area of a triangle, as a vector along its normal.
inline Point area_vector(const Point& a, const Point& b, const Point& c) {
  return cross(b - a, c - a);
}

/// Angle between two vectors, in [0, pi].
inline double angle_between(const Point& a, const Point& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

/// 1 for an equilateral triangle, 0 for a degenerate one: 4 sqrt(3) area / (sum of squared sides).
inline double triangle_quality(const Point& a, const Point& b, const Point& c) {
  const Point x = b - a, y = c - a, z = c - b;
  const double squares = dot(x, x) + dot(y, y) + dot(z, z);
  return squares > 0 ? 2 * std::sqrt(3.0) * norm(cross(x, y)) / squares : 0;
}

/// Box with sides along the axes; empty until something is added.
struct Bounds {
  Point low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const Point& p) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  bool meets(const Bounds& other) const {
    for (int k = 0; k < 3; ++k)
      if (low[k] > other.high[k] || high[k] < other.low[k]) return false;
    return true;
  }
  /// Distance of a point from the box; 0 inside.
  double distance(const Point& p) const {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const double d = std::max({low[k] - p[k], p[k] - high[k], 0.0});
      sum += d * d;
    }
    return std::sqrt(sum);
  }
  Point center() const { return 0.5 * (low + high); }
  double diagonal() const { return tube::distance(low, high); }
};

/// A number with the 6 digits that a message needs.
inline std::string as_text(double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, 6);
  return {buffer.data(), end.ptr};
}

inline std::string as_text(const Point& p) {
  return "(" + as_text(p[0]) + ", " + as_text(p[1]) + ", " + as_text(p[2]) + ")";
}

}  // namespace tripus::meshing::tube
