#include "geometry/enclosure.hpp"

#include <array>

namespace tripus::geometry {

extern const EnclosureKernels kPortableEnclosures;
#ifdef TRIPUS_X86_KERNELS
extern const EnclosureKernels kAvx2Enclosures;
extern const EnclosureKernels kAvx512Enclosures;
#endif

std::span<const EnclosureKernels> all_enclosure_kernels() {
  // The same sets in the same order as the batched kernels, which ask the processor.
  static const std::array all = {
      kPortableEnclosures,
#ifdef TRIPUS_X86_KERNELS
      kAvx2Enclosures,
      kAvx512Enclosures,
#endif
  };
  return std::span(all).first(all_batch_kernels().size());
}

const EnclosureKernels& enclosure_kernels() {
  static const EnclosureKernels& chosen = all_enclosure_kernels()[static_cast<std::size_t>(
      &batch_kernels() - all_batch_kernels().data())];
  return chosen;
}

}  // namespace tripus::geometry
