#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/hyperbolic_space.hpp"

namespace tripus::embedding::detail {

/// The middle of `count` points of the hyperboloid, given their sum: on the geodesic or the plane
/// through them. The product of the sum with itself is at most -count^2; where points are so far
/// out (beyond a distance of some 18) that rounding says otherwise, the result is still a finite
/// point.
inline geometry::Vector4 mean_point(const geometry::Vector4& sum, int count) {
  const double square = std::max(-geometry::lorentz_product(sum, sum), double(count) * count);
  return geometry::on_hyperboloid(sum / std::sqrt(square));
}

}  // namespace tripus::embedding::detail
