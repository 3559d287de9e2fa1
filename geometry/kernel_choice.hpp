#pragma once

#include "geometry/batch.hpp"

namespace tripus::geometry {

/// The kernels of this name, which the environment variable TRIPUS_SIMD may be; of null or an empty
/// name the fastest. Throws InvalidInput for a name that this processor does not run, and says
/// which it does.
const BatchKernels& named_batch_kernels(const char* name);

}  // namespace tripus::geometry
