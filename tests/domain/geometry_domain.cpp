// Lengths and angles at and beyond the edge of the domain.
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "geometry/volume.hpp"
#include "tests/support/sample_lengths.hpp"

namespace tripus::geometry {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(DihedralAngles, RefusesWhatIsNoLength) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, kInfinity, -kInfinity, std::nan("")}) {
    for (std::size_t e = 0; e < 6; ++e) {
      std::array<double, 6> l{1, 1, 1, 1, 1, 1}, theta;
      l[e] = bad;
      try {
        dihedral_angles(l, theta);
        FAIL() << bad;
      } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("edge length " + std::to_string(e)),
                  std::string::npos)
            << error.what();
      }
    }
  }
}

TEST(DihedralAngles, FlatTetrahedraHaveExactlyOnePatternOfAnglesAndNoJacobian) {
  std::mt19937_64 random(21);
  int seen[4] = {};
  for (int n = 0; n < 20000; ++n) {
    const auto l = testing::log_uniform_lengths(random, 1e-4, n % 2 == 0 ? 20 : 1e5);
    std::array<double, 6> theta;
    std::array<double, 36> jacobian;
    const TetrahedronKind kind = dihedral_angles(l, theta, jacobian);
    ++seen[static_cast<int>(kind)];
    if (kind == TetrahedronKind::kTruncated) {
      for (const double t : theta) EXPECT_TRUE(t >= 0 && t <= kPi);
      for (const double j : jacobian) EXPECT_TRUE(std::isfinite(j));
      continue;
    }
    const std::size_t straight = static_cast<std::size_t>(kind) - 1;
    for (std::size_t e = 0; e < 6; ++e)
      EXPECT_EQ(theta[e], e == straight || e == 5 - straight ? kPi : 0.0);
    for (const double j : jacobian) EXPECT_EQ(j, 0.0);
  }
  for (const int count : seen) EXPECT_GT(count, 500);
}

TEST(ExtendedAngles, AreContinuousAcrossTheFlatSetAndAcrossZero) {
  std::mt19937_64 random(22);
  std::uniform_real_distribution<double> sample(-0.5, 3);
  int crossed = 0;
  for (int n = 0; n < 4000; ++n) {
    std::array<double, 6> a, b;
    for (double& x : a) x = sample(random);
    for (double& x : b) x = sample(random);
    // Angles move by O(sqrt(step)) at most: bisect the segment and watch the jump vanish.
    double low = 0, high = 1;
    std::array<double, 6> theta_low, theta_high, l;
    const auto at = [&](double t, std::array<double, 6>& theta) {
      for (std::size_t e = 0; e < 6; ++e) l[e] = (1 - t) * a[e] + t * b[e];
      return extended_dihedral_angles(l, theta);
    };
    if (at(0, theta_low) == at(1, theta_high)) continue;
    const TetrahedronKind kind_low = at(0, theta_low);
    for (int k = 0; k < 50; ++k) {
      const double middle = (low + high) / 2;
      (at(middle, theta_low) == kind_low ? low : high) = middle;
    }
    at(low, theta_low);
    at(high, theta_high);
    for (std::size_t e = 0; e < 6; ++e) EXPECT_NEAR(theta_low[e], theta_high[e], 1e-5);
    ++crossed;
  }
  EXPECT_GT(crossed, 1000);
}

TEST(ExtendedAngles, ALengthBelowZeroCountsAsZeroAndHasAngleZero) {
  std::mt19937_64 random(23);
  for (int n = 0; n < 1000; ++n) {
    auto l = testing::log_uniform_lengths(random, 0.1, 2);
    const std::size_t e = static_cast<std::size_t>(n % 6);
    std::array<double, 6> at_zero, below;
    std::array<double, 36> jacobian;
    l[e] = 0;
    const auto kind = extended_dihedral_angles(l, at_zero);
    l[e] = -3;
    EXPECT_EQ(extended_dihedral_angles(l, below, jacobian), kind);
    EXPECT_EQ(at_zero, below);
    if (kind == TetrahedronKind::kTruncated) {
      EXPECT_EQ(below[e], 0.0);
      for (std::size_t j = 0; j < 6; ++j) EXPECT_EQ(jacobian[6 * e + j], 0.0);
    }
  }
}

TEST(LengthsFromAngles, RefusesAnglesOutsideTheOpenPolytope) {
  std::array<double, 6> l{7, 7, 7, 7, 7, 7};
  const double third = 1.0471975511965979;  // the double just above pi/3
  for (const std::array<double, 6>& theta :
       {std::array<double, 6>{third, third, third, third, third, third},
        std::array<double, 6>{0, 0.1, 0.1, 0.1, 0.1, 0.1},
        std::array<double, 6>{-0.1, 0.1, 0.1, 0.1, 0.1, 0.1},
        std::array<double, 6>{kPi, 0, 0, 0, 0, kPi},
        std::array<double, 6>{std::nan(""), 0.1, 0.1, 0.1, 0.1, 0.1}}) {
    EXPECT_FALSE(lengths_from_angles(theta, l));
    for (const double x : l) EXPECT_EQ(x, 7);
  }
}

TEST(Volume, FlatTetrahedraHaveNone) {
  EXPECT_EQ(volume(std::array<double, 6>{kPi, 0, 0, 0, 0, kPi}), 0.0);
  EXPECT_EQ(volume(std::array<double, 6>{0, kPi, 0, 0, kPi, 0}), 0.0);
  EXPECT_EQ(volume(std::array<double, 6>{0, 0, kPi, kPi, 0, 0}), 0.0);
}

TEST(Volume, LiesBetweenZeroAndTheOctahedrons) {
  std::mt19937_64 random(24);
  for (int n = 0; n < 20000; ++n) {
    std::array<double, 6> theta;
    dihedral_angles(testing::log_uniform_lengths(random, 1e-5, 60), theta);
    const double v = volume(theta);
    EXPECT_TRUE(v >= 0 && v <= kOctahedronVolume) << v;
  }
}

TEST(Volume, GoesToZeroWhereATetrahedronGoesFlat) {
  // Bisect the segment from a true tetrahedron to a flat one: the volume tends to 0 like the square
  // root of the distance.
  std::array<double, 6> theta;
  const auto at = [&](double l) {
    return dihedral_angles(std::array<double, 6>{l, 0.5, 0.5, 0.5, 0.5, l}, theta);
  };
  double low = 0.5, high = 3;
  ASSERT_EQ(at(low), TetrahedronKind::kTruncated);
  ASSERT_EQ(at(high), TetrahedronKind::kFlat01_23);
  double previous = kOctahedronVolume;
  while (high - low > 1e-12) {
    const double middle = (low + high) / 2;
    if (at(middle) == TetrahedronKind::kTruncated) {
      low = middle;
      EXPECT_LT(volume(theta), previous + 1e-14);
      previous = volume(theta);
    } else {
      high = middle;
      EXPECT_EQ(volume(theta), 0.0);
    }
  }
  EXPECT_LT(previous, 1e-4);
}

}  // namespace
}  // namespace tripus::geometry
