#include "geometry/ideal_tetrahedron.hpp"

#include <algorithm>

#include "geometry/batch.hpp"
#include "geometry/clausen.hpp"
#include "geometry/detail/ideal_kernel.hpp"
#include "geometry/detail/kernel_answer.hpp"

namespace tripus::geometry {

TetrahedronKind ideal_dihedral_angles(std::span<const double, 6> l, std::span<double, 6> theta,
                                      std::span<double> jacobian) {
  double packed[kPackedJacobian];
  const double excess = ideal_kernel(l.data(), theta.data(), jacobian.empty() ? nullptr : packed);
  unpack_jacobian(packed, jacobian);
  return kind_of(excess, theta.data());
}

double ideal_volume(std::span<const double, 6> theta) {
  double sum = 0;
  for (std::size_t e = 0; e < 3; ++e) sum += clausen2(2 * theta[e]);
  return std::max(sum / 2, 0.0);
}

}  // namespace tripus::geometry
