#include "viewer/window/pace.hpp"

#include <algorithm>
#include <cmath>

namespace tripus::viewer {

double next_quality(double quality, double milliseconds) {
  const double wanted = quality * std::sqrt(kMovingFrame / std::max(milliseconds, 1.0));
  const double slowly = std::min(1.06 * quality, std::max(0.4 * quality, wanted));
  return std::clamp(slowly, kCoarsest, 1.0);
}

}  // namespace tripus::viewer
