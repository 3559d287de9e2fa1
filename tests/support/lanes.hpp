#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/batch.hpp"

namespace tripus::testing {

/// Expects of tetrahedron t among batched answers, [blocks][6][8] and [blocks][21][8], what the
/// kernel for one gives, to the bit.
inline void expect_lane(const std::vector<double>& theta, const std::vector<double>& jacobian,
                        std::size_t t, const std::array<double, 6>& angles,
                        const std::array<double, 36>& full) {
  using geometry::kLanes;
  using geometry::kPackedJacobian;
  for (std::size_t e = 0; e < 6; ++e)
    EXPECT_EQ(theta[(6 * (t / kLanes) + e) * kLanes + t % kLanes], angles[e]);
  for (std::size_t i = 0, q = 0; i < 6; ++i)
    for (std::size_t j = i; j < 6; ++j, ++q)
      EXPECT_EQ(jacobian[(kPackedJacobian * (t / kLanes) + q) * kLanes + t % kLanes],
                full[6 * i + j]);
}

}  // namespace tripus::testing
