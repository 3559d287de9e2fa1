#include "geometry/ideal_tetrahedron.hpp"

#include <algorithm>
#include <numbers>

#include "geometry/batch.hpp"
#include "geometry/clausen.hpp"
#include "geometry/detail/ideal_kernel.hpp"

namespace tripus::geometry {

TetrahedronKind ideal_dihedral_angles(std::span<const double, 6> l, std::span<double, 6> theta,
                                      std::span<double> jacobian) {
  double packed[kPackedJacobian];
  const double excess = ideal_kernel(l.data(), theta.data(), jacobian.empty() ? nullptr : packed);
  if (!jacobian.empty())
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        jacobian[static_cast<std::size_t>(6 * i + j)] =
            packed[packed_index(std::min(i, j), std::max(i, j))];
  if (excess > 0) return TetrahedronKind::kTruncated;
  if (theta[0] > std::numbers::pi / 2) return TetrahedronKind::kFlat01_23;
  return theta[1] > std::numbers::pi / 2 ? TetrahedronKind::kFlat02_13
                                         : TetrahedronKind::kFlat03_12;
}

double ideal_volume(std::span<const double, 6> theta) {
  double sum = 0;
  for (std::size_t e = 0; e < 3; ++e) sum += clausen2(2 * theta[e]);
  return std::max(sum / 2, 0.0);
}

}  // namespace tripus::geometry
