// The batched kernel for tetrahedra whose vertices are all ideal. Like mixed_batch_kernel.cpp it is
// compiled once for each instruction set, with TRIPUS_IDEAL_ANGLES naming the function.
#include <cstring>

#include "geometry/batch.hpp"
#include "geometry/detail/ideal_kernel.hpp"

namespace tripus::geometry {
namespace {

constexpr int kIdealWidth = TRIPUS_PACK_WIDTH;
using IdealLanes = Pack<kIdealWidth>;

/// One pack of lanes; returns the number of flat ones.
template <bool kWithJacobian>
inline std::size_t ideal_angles_of_pack(const double* lengths, double* theta_out,
                                        double* jacobian_out) {
  IdealLanes l[6], theta[6], jacobian[kPackedJacobian];
  for (std::size_t e = 0; e < 6; ++e) std::memcpy(&l[e], lengths + kLanes * e, sizeof l[e]);
  const IdealLanes excess = ideal_kernel(l, theta, kWithJacobian ? jacobian : nullptr);
  for (std::size_t e = 0; e < 6; ++e)
    std::memcpy(theta_out + kLanes * e, &theta[e], sizeof theta[e]);
  if constexpr (kWithJacobian)
    for (std::size_t q = 0; q < kPackedJacobian; ++q)
      std::memcpy(jacobian_out + kLanes * q, &jacobian[q], sizeof jacobian[q]);
  const auto flat = !(excess > broadcast<IdealLanes>(0.0));
  std::int64_t flat_count = 0;  // a true lane is -1
  for (int i = 0; i < kIdealWidth; ++i) flat_count -= flat[i];
  return static_cast<std::size_t>(flat_count);
}

template <bool kWithJacobian>
std::size_t ideal_angles_of_blocks(std::size_t blocks, const double* lengths, double* theta,
                                   double* jacobian) {
  std::size_t flat = 0;
  for (std::size_t b = 0; b < blocks; ++b)
    for (std::size_t lane = 0; lane < kLanes; lane += kIdealWidth)
      flat += ideal_angles_of_pack<kWithJacobian>(
          lengths + 6 * kLanes * b + lane, theta + 6 * kLanes * b + lane,
          kWithJacobian ? jacobian + kPackedJacobian * kLanes * b + lane : nullptr);
  return flat;
}

}  // namespace

std::size_t TRIPUS_IDEAL_ANGLES(std::size_t blocks, const double* lengths, double* theta,
                                double* jacobian);
std::size_t TRIPUS_IDEAL_ANGLES(std::size_t blocks, const double* lengths, double* theta,
                                double* jacobian) {
  return jacobian == nullptr ? ideal_angles_of_blocks<false>(blocks, lengths, theta, jacobian)
                             : ideal_angles_of_blocks<true>(blocks, lengths, theta, jacobian);
}

}  // namespace tripus::geometry
