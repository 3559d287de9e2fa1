// The batched kernel with ideal vertices. Like batch_kernel.cpp it is compiled once for each
// instruction set, with TRIPUS_MIXED_ANGLES naming the function; it has a file of its own so that
// the purely hyperideal kernel is compiled as if this one did not exist.
#include <cstring>

#include "geometry/batch.hpp"
#include "geometry/detail/mixed_kernel.hpp"

namespace tripus::geometry {
namespace {

constexpr int kMixedWidth = TRIPUS_PACK_WIDTH;
using MixedLanes = Pack<kMixedWidth>;

inline MixedLanes load_lanes(const double* from) {
  MixedLanes x;
  std::memcpy(&x, from, sizeof x);
  return x;
}
inline void store_lanes(double* to, MixedLanes x) { std::memcpy(to, &x, sizeof x); }

/// One pack of lanes; returns the number of flat ones.
template <bool kWithJacobian>
inline std::size_t mixed_angles_of_pack(const double* lengths, const double* diagonal,
                                        double* theta_out, double* jacobian_out) {
  MixedLanes l[6], d[4], c[6], s[6], theta[6], jacobian[kPackedJacobian];
  for (std::size_t e = 0; e < 6; ++e) l[e] = load_lanes(lengths + kLanes * e);
  for (std::size_t v = 0; v < 4; ++v) d[v] = load_lanes(diagonal + kLanes * v);
  const auto too_long = mixed_edges(l, d, c, s);
  const MixedLanes det = mixed_gram_kernel(c, s, d, theta, kWithJacobian ? jacobian : nullptr);
  for (std::size_t e = 0; e < 6; ++e) store_lanes(theta_out + kLanes * e, theta[e]);
  if constexpr (kWithJacobian)
    for (std::size_t q = 0; q < kPackedJacobian; ++q)
      store_lanes(jacobian_out + kLanes * q, jacobian[q]);
  const auto flat = !(det > broadcast<MixedLanes>(0.0));
  std::int64_t special = 0;
  for (int i = 0; i < kMixedWidth; ++i) special |= too_long[i] | flat[i];
  if (__builtin_expect(special == 0, 1)) return 0;
  std::size_t flat_count = 0;
  for (int i = 0; i < kMixedWidth; ++i) {
    if (too_long[i] != 0) {
      flat_count += mixed_scaled_angles_of_lane(lengths + i, diagonal + i, theta_out + i,
                                                kWithJacobian ? jacobian_out + i : nullptr);
    } else {
      flat_count += flat[i] != 0;
    }
  }
  return flat_count;
}

template <bool kWithJacobian>
std::size_t mixed_angles_of_blocks(std::size_t blocks, const double* lengths,
                                   const double* diagonal, double* theta, double* jacobian) {
  std::size_t flat = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::size_t lane = 0; lane < kLanes; lane += kMixedWidth) {
      flat += mixed_angles_of_pack<kWithJacobian>(
          lengths + 6 * kLanes * b + lane, diagonal + 4 * kLanes * b + lane,
          theta + 6 * kLanes * b + lane,
          kWithJacobian ? jacobian + kPackedJacobian * kLanes * b + lane : nullptr);
    }
  }
  return flat;
}

}  // namespace

std::size_t TRIPUS_MIXED_ANGLES(std::size_t blocks, const double* lengths, const double* diagonal,
                                double* theta, double* jacobian);
std::size_t TRIPUS_MIXED_ANGLES(std::size_t blocks, const double* lengths, const double* diagonal,
                                double* theta, double* jacobian) {
  return jacobian == nullptr
             ? mixed_angles_of_blocks<false>(blocks, lengths, diagonal, theta, jacobian)
             : mixed_angles_of_blocks<true>(blocks, lengths, diagonal, theta, jacobian);
}

}  // namespace tripus::geometry
