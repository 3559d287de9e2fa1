// The batched kernels. CMake compiles this file once for each instruction set, with
// TRIPUS_KERNELS naming the table to define and TRIPUS_PACK_WIDTH the lanes of a register;
// everything else in here is internal to the translation unit.
#include <cstring>
#include <utility>

#include "geometry/batch.hpp"
#include "geometry/detail/gram_kernel.hpp"
#include "geometry/detail/scaled_kernel.hpp"
#include "geometry/detail/volume_kernel.hpp"

namespace tripus::geometry {
namespace {

constexpr int kWidth = TRIPUS_PACK_WIDTH;
using Lanes = Pack<kWidth>;

inline Lanes load(const double* from) {
  Lanes x;
  std::memcpy(&x, from, sizeof x);
  return x;
}
inline void store(double* to, Lanes x) { std::memcpy(to, &x, sizeof x); }

/// True if some lane satisfies the comparison mask.
template <class Mask>
inline bool any(Mask mask) {
  std::int64_t bits = 0;
  for (int i = 0; i < kWidth; ++i) bits |= mask[i];
  return bits != 0;
}

/// One pack of lanes; returns the number of flat ones.
template <bool kWithJacobian>
inline std::size_t angles_of_pack(const double* lengths, double* theta_out, double* jacobian_out) {
  const Lanes zero = broadcast<Lanes>(0.0);
  const Lanes limit = broadcast<Lanes>(kUnscaledLimit);
  Lanes c[6], s[6], theta[6], jacobian[kPackedJacobian];
  auto too_long = zero > limit;
  for (int e = 0; e < 6; ++e) {
    const Lanes l = maximum(load(lengths + kLanes * static_cast<std::size_t>(e)), zero);
    too_long |= l > limit;
    const SinhCosh<Lanes> h = sinh_cosh(minimum(l, limit));
    s[e] = h.sinh;
    c[e] = h.cosh;
  }
  const Lanes det = gram_kernel(c, s, UnitDiagonal{}, opposite_products(c, s), theta,
                                kWithJacobian ? jacobian : nullptr);
  for (std::size_t e = 0; e < 6; ++e) store(theta_out + kLanes * e, theta[e]);
  if constexpr (kWithJacobian) {
    // The diagonal is the one entry that does not vanish by itself where a length is <= 0.
    for (int e = 0; e < 6; ++e) {
      Lanes& entry = jacobian[packed_index(e, e)];
      entry = s[e] > zero ? entry : zero;
    }
    for (std::size_t q = 0; q < kPackedJacobian; ++q) store(jacobian_out + kLanes * q, jacobian[q]);
  }
  const auto flat = !(det > zero);
  std::size_t flat_count = 0;
  if (__builtin_expect(any(flat) || any(too_long), 0)) {
    for (int i = 0; i < kWidth; ++i) {
      if (too_long[i]) {
        flat_count += scaled_angles_of_lane(lengths + i, theta_out + i,
                                            kWithJacobian ? jacobian_out + i : nullptr);
      } else {
        flat_count += flat[i] != 0;
      }
    }
  }
  return flat_count;
}

template <bool kWithJacobian>
std::size_t angles_of_blocks(std::size_t blocks, const double* lengths, double* theta,
                             double* jacobian) {
  std::size_t flat = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::size_t lane = 0; lane < kLanes; lane += kWidth) {
      flat += angles_of_pack<kWithJacobian>(
          lengths + 6 * kLanes * b + lane, theta + 6 * kLanes * b + lane,
          kWithJacobian ? jacobian + kPackedJacobian * kLanes * b + lane : nullptr);
    }
  }
  return flat;
}

std::size_t angles(std::size_t blocks, const double* lengths, double* theta, double* jacobian) {
  return jacobian == nullptr ? angles_of_blocks<false>(blocks, lengths, theta, jacobian)
                             : angles_of_blocks<true>(blocks, lengths, theta, jacobian);
}

/// Lanes whose lengths the unscaled Gram matrix cannot hold, or that are not positive.
void volume_of_lane(const double* theta, double* volume_out) {
  double angles_of_lane[6];
  for (std::size_t e = 0; e < 6; ++e) angles_of_lane[e] = theta[kLanes * e];
  *volume_out = volume(angles_of_lane);
}

void volumes(std::size_t blocks, const double* lengths, const double* theta, double* volume_out) {
  const Lanes zero = broadcast<Lanes>(0.0);
  const Lanes limit = broadcast<Lanes>(kUnscaledLimit);
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::size_t lane = 0; lane < kLanes; lane += kWidth) {
      Lanes c[6], s[6], angle[6];
      auto outside = zero > limit;
      for (std::size_t e = 0; e < 6; ++e) {
        const std::size_t at = (6 * b + e) * kLanes + lane;
        const Lanes l = load(lengths + at);
        outside |= !((l > zero) & (l <= limit));
        const SinhCosh<Lanes> h = sinh_cosh(minimum(maximum(l, zero), limit));
        s[e] = h.sinh;
        c[e] = h.cosh;
        angle[e] = load(theta + at);
      }
      store(volume_out + kLanes * b + lane, volume_kernel(c, s, angle));
      if (__builtin_expect(any(outside), 0))
        for (std::size_t i = 0; i < kWidth; ++i)
          if (outside[i])
            volume_of_lane(theta + 6 * kLanes * b + lane + i, volume_out + kLanes * b + lane + i);
    }
  }
}

void jacobian_times(const double* jacobian, const double* x, double* y) {
  for (std::size_t lane = 0; lane < kLanes; lane += kWidth) {
    Lanes in[6], out[6];
    for (std::size_t e = 0; e < 6; ++e) {
      in[e] = load(x + kLanes * e + lane);
      out[e] = broadcast<Lanes>(0.0);
    }
    for_packed_pairs(
        [&]<int A, int B>() {
          const Lanes entry =
              load(jacobian + kLanes * static_cast<std::size_t>(packed_index(A, B)) + lane);
          out[A] += entry * in[B];
          if constexpr (A != B) out[B] += entry * in[A];
        },
        std::make_integer_sequence<int, 36>{});
    for (std::size_t e = 0; e < 6; ++e) store(y + kLanes * e + lane, out[e]);
  }
}

}  // namespace

// In ideal_batch_kernel.cpp and mixed_batch_kernel.cpp.
std::size_t TRIPUS_IDEAL_ANGLES(std::size_t blocks, const double* lengths, double* theta,
                                double* jacobian);
std::size_t TRIPUS_MIXED_ANGLES(std::size_t blocks, const double* lengths, const double* diagonal,
                                double* theta, double* jacobian);

extern const BatchKernels TRIPUS_KERNELS;
const BatchKernels TRIPUS_KERNELS{TRIPUS_KERNELS_NAME, angles,         TRIPUS_MIXED_ANGLES,
                                  TRIPUS_IDEAL_ANGLES, jacobian_times, volumes};

}  // namespace tripus::geometry
