#include "geometry/batch.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "base/error.hpp"
#include "geometry/kernel_choice.hpp"

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
  // What throws is asked again the next time.
  static const BatchKernels& chosen = named_batch_kernels(std::getenv("TRIPUS_SIMD"));
  return chosen;
}

const BatchKernels& named_batch_kernels(const char* name) {
  const std::span all = all_batch_kernels();
  if (name == nullptr || *name == '\0') return all.back();
  const auto found = std::ranges::find(all, std::string_view(name), &BatchKernels::name);
  if (found != all.end()) return *found;
  std::string names;
  for (const BatchKernels& kernels : all)
    names += (names.empty() ? "" : ", ") + std::string(kernels.name);
  throw InvalidInput("the environment variable TRIPUS_SIMD is " + quoted(name) +
                     "; this processor runs " + names +
                     ". Leave it out, and the fastest are chosen");
}

}  // namespace tripus::geometry
