// The same functions as transcendental_kernel.cpp by libmvec, which GCC calls for plain loops under
// -ffast-math. Only a yardstick: nothing in the library is compiled so.
#include <cmath>
#include <cstddef>

#include "bench/kernels/transcendental_kernel.hpp"

namespace tripus::bench {

void TRIPUS_TRANSCENDENTALS(std::size_t blocks, const double* lengths, double* out) {
  for (std::size_t b = 0; b < blocks; ++b) {
    double sinhs[48], coshs[48];
    for (std::size_t i = 0; i < 48; ++i) sinhs[i] = std::sinh(lengths[48 * b + i]);
    for (std::size_t i = 0; i < 48; ++i) coshs[i] = std::cosh(lengths[48 * b + i]);
    for (std::size_t i = 0; i < 48; ++i) out[48 * b + i] = std::atan2(sinhs[i], coshs[i] - 1.1);
    for (std::size_t i = 0; i < 8; ++i) out[48 * b + i] = std::sqrt(out[48 * b + i]);
  }
}

}  // namespace tripus::bench
