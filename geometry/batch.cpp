#include "geometry/batch.hpp"

#include <array>

namespace tripus::geometry {

extern const BatchKernels kPortableKernels;
#ifdef TRIPUS_X86_KERNELS
extern const BatchKernels kAvx2Kernels;
extern const BatchKernels kAvx512Kernels;
#endif

namespace {

struct Available {
  std::array<BatchKernels, 3> kernels{};
  std::size_t count = 0;
};

Available detect() {
  Available found;
  found.kernels[found.count++] = kPortableKernels;
#ifdef TRIPUS_X86_KERNELS
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2")) found.kernels[found.count++] = kAvx2Kernels;
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl")) {
    found.kernels[found.count++] = kAvx512Kernels;
  }
#endif
  return found;
}

}  // namespace

std::span<const BatchKernels> all_batch_kernels() {
  static const Available found = detect();
  return std::span(found.kernels).first(found.count);
}

const BatchKernels& batch_kernels() {
  static const BatchKernels& best = all_batch_kernels().back();
  return best;
}

}  // namespace tripus::geometry
