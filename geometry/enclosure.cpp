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
  static const EnclosureKernels& best = all_enclosure_kernels().back();
  return best;
}

}  // namespace tripus::geometry
