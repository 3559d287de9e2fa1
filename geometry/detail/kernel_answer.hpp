#pragma once

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <span>

#include "geometry/batch.hpp"
#include "geometry/truncated_tetrahedron.hpp"

namespace tripus::geometry {

/// A packed Jacobian as [6 x 6]; nothing if none is wanted.
inline void unpack_jacobian(const double* packed, std::span<double> jacobian) {
  if (jacobian.empty()) return;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      jacobian[static_cast<std::size_t>(6 * i + j)] =
          packed[packed_index(std::min(i, j), std::max(i, j))];
}

/// What the sign of -det G (or of the kernel's measure for it) and extended angles say.
inline TetrahedronKind kind_of(double minus_det, const double* theta) {
  if (minus_det > 0) return TetrahedronKind::kTruncated;
  if (theta[0] > std::numbers::pi / 2) return TetrahedronKind::kFlat01_23;
  return theta[1] > std::numbers::pi / 2 ? TetrahedronKind::kFlat02_13
                                         : TetrahedronKind::kFlat03_12;
}

}  // namespace tripus::geometry
