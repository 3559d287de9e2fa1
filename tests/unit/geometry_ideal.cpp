// Tetrahedra whose vertices are all ideal: their kernel against that for any kind of vertex,
// against a triangle in long doubles, and their volume against the formula for all angles.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "geometry/batch.hpp"
#include "geometry/ideal_tetrahedron.hpp"
#include "geometry/mixed_tetrahedron.hpp"
#include "geometry/volume.hpp"
#include "tests/support/lanes.hpp"

namespace tripus::geometry {
namespace {

using Six = std::array<double, 6>;
using Jacobian = std::array<double, 36>;

/// Lengths with both signs, on several scales; every fourth with two opposite pairs alike.
std::vector<Six> sample_lengths() {
  std::mt19937_64 random(29);
  const auto uniform = [&](double a, double b) {
    return a + (b - a) * (double(random() >> 11) * 0x1p-53);
  };
  std::vector<Six> all;
  for (int n = 0; n < 4000; ++n) {
    const double scale = std::array{0.1, 1.0, 5.0, 40.0}[std::size_t(n % 4)];
    Six l;
    for (double& each : l) each = uniform(-scale, scale);
    if (n % 16 < 4) {
      l[1] = l[5];
      l[4] = l[0];
    }
    all.push_back(l);
  }
  return all;
}

double longest_of(const Six& l) {
  double longest = 0;
  for (const double each : l) longest = std::max(longest, std::fabs(each));
  return longest;
}

TEST(IdealTetrahedron, AgreesWithTheKernelForAnyKindOfVertex) {
  int flat = 0;
  for (const Six& l : sample_lengths()) {
    Six theta, other;
    Jacobian jacobian, other_jacobian;
    const auto kind = ideal_dihedral_angles(l, theta, jacobian);
    ASSERT_EQ(kind, mixed_dihedral_angles(l, std::array<double, 4>{}, other, other_jacobian));
    flat += kind != TetrahedronKind::kTruncated;
    // What a few ulp of the longest length are worth.
    const double error = 1e-14 * (1 + longest_of(l));
    const double steepest = std::ranges::max(jacobian);
    for (std::size_t e = 0; e < 6; ++e) EXPECT_NEAR(theta[e], other[e], error * (1 + steepest));
    for (std::size_t q = 0; q < 36; ++q)
      EXPECT_NEAR(jacobian[q], other_jacobian[q],
                  error * (1 + steepest) * (1 + steepest) * (1 + steepest));
  }
  EXPECT_GT(flat, 500);
  EXPECT_LT(flat, 3500);
}

// The angles of a triangle with sides exp((l + l') / 2), which is rounded once as in the kernel, in
// long doubles: small ones to their last digits, as no lengths are subtracted but those that the
// geometry subtracts.
TEST(IdealTetrahedron, HasTheAnglesOfItsLinkTriangle) {
  int thin = 0;
  for (const Six& l : sample_lengths()) {
    Six theta;
    if (ideal_dihedral_angles(l, theta) != TetrahedronKind::kTruncated) continue;
    std::array<long double, 3> t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = 0.5 * l[k] + 0.5 * l[5 - k];
    const long double most = std::ranges::max(t);
    std::array<long double, 3> a;
    for (std::size_t k = 0; k < 3; ++k) a[k] = std::exp(t[k] - most);
    std::array<long double, 3> s = a;
    std::ranges::sort(s, std::greater<>{});
    const long double area = std::sqrt((s[0] + (s[1] + s[2])) * (s[2] - (s[0] - s[1])) *
                                       (s[2] + (s[0] - s[1])) * (s[0] + (s[1] - s[2])));
    if (s[2] - (s[0] - s[1]) < 1e-3L * s[2]) continue;  // nearly flat: digits are lost by nature
    thin += s[2] < 1e-3L;
    for (std::size_t k = 0; k < 3; ++k) {
      const long double b = a[(k + 1) % 3], c = a[(k + 2) % 3];
      const long double angle = std::atan2(
          area, (b > c ? (b - a[k]) * (b + a[k]) + c * c : (c - a[k]) * (c + a[k]) + b * b));
      const double unit = longest_of(l);
      EXPECT_NEAR(theta[k], double(angle), 2e-13 * (1 + unit) * double(angle) + 1e-15);
      EXPECT_EQ(theta[k], theta[5 - k]);
    }
    EXPECT_NEAR(theta[0] + theta[1] + theta[2], std::numbers::pi, 4e-15);
  }
  EXPECT_GT(thin, 50);
}

TEST(IdealTetrahedron, FlatOnesHaveExactAnglesAndHugeLengthsAreNoTrouble) {
  Six theta;
  Jacobian jacobian;
  const double huge = 1e308;
  EXPECT_EQ(ideal_dihedral_angles(Six{0, 0, 3, 3, 0, 0}, theta, jacobian),
            TetrahedronKind::kFlat03_12);
  EXPECT_EQ(theta, (Six{0, 0, std::numbers::pi, std::numbers::pi, 0, 0}));
  for (const double entry : jacobian) EXPECT_EQ(entry, 0);
  EXPECT_EQ(ideal_dihedral_angles(Six{huge, -huge, 0, 0, -huge, huge}, theta),
            TetrahedronKind::kFlat01_23);
  EXPECT_EQ(ideal_volume(theta), 0);
  // Two long pairs of the same length: thin, not flat.
  EXPECT_EQ(ideal_dihedral_angles(Six{huge, huge, 0, 0, huge, huge}, theta, jacobian),
            TetrahedronKind::kTruncated);
  EXPECT_NEAR(theta[0], std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(theta[1], std::numbers::pi / 2, 1e-15);
  EXPECT_LT(theta[2], 1e-100);
  EXPECT_GT(theta[2], 0);
  for (const double entry : jacobian) EXPECT_EQ(entry, 0) << "beyond the largest entry";
}

TEST(IdealTetrahedron, EveryInstructionSetGivesTheBitsOfTheScalarKernel) {
  const std::vector<Six> all = sample_lengths();
  const std::size_t blocks = block_count(all.size());
  std::vector<double> lengths(blocks * 6 * kLanes, 1.0);
  std::size_t flat = 0;
  for (std::size_t t = 0; t < all.size(); ++t) {
    Six theta;
    flat += ideal_dihedral_angles(all[t], theta) != TetrahedronKind::kTruncated;
    for (std::size_t e = 0; e < 6; ++e)
      lengths[(6 * (t / kLanes) + e) * kLanes + t % kLanes] = all[t][e];
  }
  for (const BatchKernels& kernels : all_batch_kernels()) {
    SCOPED_TRACE(kernels.name);
    std::vector<double> theta(blocks * 6 * kLanes), alone(theta.size()),
        jacobian(blocks * kPackedJacobian * kLanes);
    EXPECT_EQ(kernels.ideal_angles(blocks, lengths.data(), theta.data(), jacobian.data()), flat);
    kernels.ideal_angles(blocks, lengths.data(), alone.data(), nullptr);
    EXPECT_EQ(alone, theta);
    for (std::size_t t = 0; t < all.size(); ++t) {
      Six angles;
      Jacobian full;
      ideal_dihedral_angles(all[t], angles, full);
      testing::expect_lane(theta, jacobian, t, angles, full);
    }
  }
}

// The formula for all angles loses digits where a tetrahedron is thin and all its sums are pi.
TEST(IdealTetrahedron, VolumesAreThoseOfTheFormulaForAllAngles) {
  int thick = 0;
  for (const Six& l : sample_lengths()) {
    Six theta;
    ideal_dihedral_angles(l, theta);
    EXPECT_GE(ideal_volume(theta), 0);
    EXPECT_LT(ideal_volume(theta), 1.0149416064096537);
    if (std::ranges::min(theta) < 0.1) {
      EXPECT_NEAR(ideal_volume(theta), volume(theta), 1e-6);
      continue;
    }
    ++thick;
    EXPECT_NEAR(ideal_volume(theta), volume(theta), 1e-12);
  }
  EXPECT_GT(thick, 500);
  Six theta;
  ideal_dihedral_angles(Six{}, theta);
  EXPECT_NEAR(ideal_volume(theta), 1.01494160640965362502, 1e-15);
}

}  // namespace
}  // namespace tripus::geometry
