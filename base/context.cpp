#include "base/context.hpp"

#include <algorithm>
#include <limits>

namespace tripus {

double Context::seconds_left() const {
  if (!deadline) return std::numeric_limits<double>::infinity();
  // Never 0, which as a time limit would be an error of the caller's.
  return std::max(1e-9, std::chrono::duration<double>(*deadline - Clock::now()).count());
}

}  // namespace tripus
