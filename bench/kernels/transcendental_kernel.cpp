// The transcendental functions that one evaluation of a block needs, and nothing else: the lower
// bound that the kernels of geometry/ are measured against. Compiled once for each instruction set,
// with the flags of geometry/batch_kernel.cpp.
#include "bench/kernels/transcendental_kernel.hpp"

#include <cstddef>
#include <cstring>

#include "geometry/batch.hpp"
#include "geometry/detail/elementary.hpp"

namespace tripus::bench {

void TRIPUS_TRANSCENDENTALS(std::size_t blocks, const double* lengths, double* out) {
  using geometry::kLanes;
  using Lanes = geometry::Pack<TRIPUS_PACK_WIDTH>;
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::size_t lane = 0; lane < kLanes; lane += TRIPUS_PACK_WIDTH) {
      Lanes sum = geometry::broadcast<Lanes>(0.0);
      for (std::size_t e = 0; e < 6; ++e) {
        const std::size_t at = (6 * b + e) * kLanes + lane;
        Lanes l;
        std::memcpy(&l, lengths + at, sizeof l);
        const auto h = geometry::sinh_cosh(l);
        const Lanes angle = geometry::upper_atan2(h.sinh, h.cosh - 1.1);
        sum += angle;
        std::memcpy(out + at, &angle, sizeof angle);
      }
      sum = geometry::square_root(sum);
      std::memcpy(out + 6 * kLanes * b + lane, &sum, sizeof sum);
    }
  }
}

}  // namespace tripus::bench
