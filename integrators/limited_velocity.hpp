#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace tripus::integrators {

/// How fast a flow that divides by H may go, in multiples of 1 + max|x|.
inline constexpr double kLargestVelocity = 4;

/// Shortens a velocity [n] to kLargestVelocity (1 + max|x|): where H vanishes towards infinity, a
/// flow that divides by it would get there in finite time.
inline void limit_velocity(std::span<const double> x, std::span<double> velocity) {
  double size = 1, speed = 0;
  for (const double value : x) size = std::max(size, 1 + std::abs(value));
  for (const double value : velocity) speed = std::max(speed, std::abs(value));
  if (!(speed > kLargestVelocity * size)) return;
  for (double& value : velocity) value *= kLargestVelocity * size / speed;
}

}  // namespace tripus::integrators
