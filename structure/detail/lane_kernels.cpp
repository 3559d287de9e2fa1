#include "structure/detail/lane_kernels.hpp"

namespace tripus::structure::detail {

extern const LaneKernels kPortableLanes;
#ifdef TRIPUS_X86_KERNELS
extern const LaneKernels kAvx2Lanes;
extern const LaneKernels kAvx512Lanes;
#endif

const LaneKernels& lane_kernels([[maybe_unused]] const geometry::BatchKernels& for_tetrahedra) {
#ifdef TRIPUS_X86_KERNELS
  if (for_tetrahedra.name == "avx512") return kAvx512Lanes;
  if (for_tetrahedra.name == "avx2") return kAvx2Lanes;
#endif
  return kPortableLanes;
}

}  // namespace tripus::structure::detail
