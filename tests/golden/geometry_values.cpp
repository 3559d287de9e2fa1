// Published and derived numbers of single tetrahedra, to all their digits.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/truncated_tetrahedron.hpp"
#include "geometry/volume.hpp"

namespace tripus::geometry {
namespace {

std::array<double, 6> regular(double x) { return {x, x, x, x, x, x}; }

// design 2.3: one-edge triangulations with genus g boundary have volume g V(pi / 3g).
TEST(RegularTetrahedron, VolumesOfOneEdgeTriangulations) {
  constexpr double kVolume[4] = {6.45199027083503287, 10.42860158023565817, 14.23817002481015732,
                                 17.98726236750444991};
  for (int g = 2; g <= 5; ++g)
    EXPECT_NEAR(g * volume(regular(std::numbers::pi / (3 * g))), kVolume[g - 2], 1e-14);
}

// The founding paper's example: theta = pi/6, cosh l = (3 + sqrt 3)/4.
TEST(RegularTetrahedron, KnottedY) {
  const double l = std::acosh((3 + std::sqrt(3.0)) / 4);
  EXPECT_NEAR(l, 0.596133894890837, 1e-15);
  std::array<double, 6> theta, again;
  EXPECT_EQ(dihedral_angles(regular(l), theta), TetrahedronKind::kTruncated);
  for (const double t : theta) EXPECT_NEAR(t, std::numbers::pi / 6, 1e-15);
  ASSERT_TRUE(lengths_from_angles(regular(std::numbers::pi / 6), again));
  for (const double x : again) EXPECT_NEAR(x, l, 1e-15);
}

TEST(RegularTetrahedron, VolumeTendsToTheIdealOctahedrons) {
  // V(t) = V8 - 3 int_0^t l(s) ds and l(s) = s + O(s^3): V8 - V(t) = 3/2 t^2 + O(t^4).
  for (const double t : {1e-2, 1e-3, 1e-4})
    EXPECT_NEAR((kOctahedronVolume - volume(regular(t))) / (t * t), 1.5,
                10 * t * t + 1e-14 / t / t);
  EXPECT_LE(volume(regular(1e-9)), kOctahedronVolume);
}

}  // namespace
}  // namespace tripus::geometry
