// Two and more routes to the dihedral angles of one truncated tetrahedron.
#include <cmath>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "geometry/batch.hpp"
#include "geometry/kernel_choice.hpp"
#include "geometry/paper_formulae.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "geometry/volume.hpp"
#include "tests/support/reference_tetrahedron.hpp"
#include "tests/support/sample_lengths.hpp"

namespace tripus::geometry {
namespace {

using testing::Lengths;

constexpr double kEpsilon = 0x1p-53;

/// Error of the kernel's angles in units of what a relative change of the lengths by 2^-53 does to
/// them (plus the rounding of the result): the law "the angles are those of lengths changed by a
/// few ulp". Returns 0 for flat tetrahedra after checking that both routes call them flat.
double backward_error(const Lengths& l) {
  std::array<double, 6> theta;
  std::array<double, 36> jacobian;
  const TetrahedronKind kind = dihedral_angles(l, theta, jacobian);
  const auto reference = testing::reference_angles(l);
  if (kind != TetrahedronKind::kTruncated || reference.minus_determinant <= 0) {
    for (std::size_t e = 0; e < 6; ++e)
      EXPECT_NEAR(theta[e], reference.theta[e].convert_to<double>(), 1e-4) << "near the flat set";
    return 0;
  }
  double worst = 0;
  for (std::size_t e = 0; e < 6; ++e) {
    double reach = theta[e];
    for (std::size_t j = 0; j < 6; ++j) reach += std::fabs(jacobian[6 * e + j]) * l[j];
    const double error = abs(testing::Digits(theta[e]) - reference.theta[e]).convert_to<double>();
    // An angle below the normal numbers cannot have a small relative error.
    worst = std::max(worst, error / (kEpsilon * reach + 1e-320));
  }
  return worst;
}

TEST(GramKernel, IsBackwardStableForModerateLengths) {
  std::mt19937_64 random(11);
  double worst = 0;
  for (int n = 0; n < 1500; ++n)
    worst = std::max(worst, backward_error(testing::log_uniform_lengths(random, 1e-2, 5)));
}

TEST(GramKernel, IsBackwardStableForTinyAndMixedLengths) {
  std::mt19937_64 random(12);
  double worst = 0;
  for (int n = 0; n < 1000; ++n) {
    worst = std::max(worst, backward_error(testing::log_uniform_lengths(random, 1e-300, 1)));
    worst = std::max(worst, backward_error(testing::log_uniform_lengths(random, 1e-8, 50)));
  }
}

TEST(GramKernel, IsBackwardStableForHugeLengths) {
  std::mt19937_64 random(13);
  double worst = 0;
  for (const double scale : {5.0, 20.0, 60.0, 300.0, 1e3, 1e5})
    for (int n = 0; n < 150; ++n)
      worst = std::max(worst, backward_error(testing::balanced_lengths(random, scale)));
  for (int n = 0; n < 300; ++n)
    worst = std::max(worst, backward_error(testing::log_uniform_lengths(random, 1e-3, 1e5)));
}

// On triangulations with few edge classes the two longest pairs of opposite edges are often the
// same lengths. Such a tetrahedron is never flat, however thin; its angles are those of the exact
// tie.
TEST(GramKernel, ThinTetrahedraOnTheRidgeBetweenTwoWaysToBeFlat) {
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> small(0.01, 3), large(3, 150);
  for (int n = 0; n < 2000; ++n) {
    const double s = small(random), t = small(random), a = large(random), b = large(random);
    Lengths l{s, a, a, b, b, t};             // 02 = 03, 12 = 13
    if (n % 3 == 1) l = {s, a, b, a, b, t};  // 02 = 12, 03 = 13
    if (n % 3 == 2) l = {s, a, a, a, a, t};
    std::array<double, 6> theta;
    ASSERT_EQ(dihedral_angles(l, theta), TetrahedronKind::kTruncated);
    const auto reference = testing::reference_angles(l);
    for (std::size_t e = 0; e < 6; ++e)
      EXPECT_NEAR(theta[e], reference.theta[e].convert_to<double>(), 1e-13) << a << " " << b;
  }
  for (const double a : {400.0, 1e3, 1e5, 1e10, 1e300}) {
    const Lengths l{1, a, a, a, a, 2};
    std::array<double, 6> theta;
    ASSERT_EQ(dihedral_angles(l, theta), TetrahedronKind::kTruncated);
    EXPECT_NEAR(theta[0] + theta[5], 0, 1e-15);
    for (const std::size_t e : {1, 2, 3, 4}) EXPECT_NEAR(theta[e], std::acos(0.0), 1e-15);
  }
}

TEST(GramKernel, RegularTetrahedraOfEverySize) {
  for (const double l :
       {1e-308, 1e-300, 1e-100, 1e-8, 1.0, 37.8, 63.9, 64.1, 1e2, 1e5, 1e300, 1.7e308}) {
    const Lengths lengths{l, l, l, l, l, l};
    std::array<double, 6> theta;
    ASSERT_EQ(dihedral_angles(lengths, theta), TetrahedronKind::kTruncated) << l;
    // cosh l = cos t / (2 cos t - 1), theory (26), solved for t without cancellation:
    // 1 - cos t = (cosh l - 1) / (2 cosh l - 1), and half angles.
    const double half = l < 500 ? std::sinh(l / 2) : 0;
    const double expected =
        l < 500 ? 2 * std::asin(half / std::sqrt(1 + 4 * half * half)) : std::acos(0.5);
    for (const double t : theta) EXPECT_NEAR(t, expected, 4e-16 * expected) << l;
  }
}

TEST(GramKernel, AgreesWithThePapersFormulaeWhereThoseAreSound) {
  std::mt19937_64 random(14);
  for (int n = 0; n < 20000; ++n) {
    const Lengths l = testing::log_uniform_lengths(random, 0.2, 3);
    std::array<double, 6> theta;
    if (dihedral_angles(l, theta) != TetrahedronKind::kTruncated) continue;
    double lengths[6], paper[6];
    std::copy(l.begin(), l.end(), lengths);
    if (!paper_dihedral_angles(lengths, paper)) continue;  // acos of 1 + rounding, near flat
    // The arc cosine loses half the digits at 0 and pi.
    for (std::size_t e = 0; e < 6; ++e)
      EXPECT_NEAR(std::cos(theta[e]), std::cos(paper[e]), 1e-12 / std::sin(theta[e]));
  }
}

TEST(PaperFormulae, BreakDownWhereTheTriangleSideRoundsToZero) {
  const auto sound = [](double length) {
    double l[6], theta[6];
    std::fill(l, l + 6, length);
    return paper_dihedral_angles(l, theta);
  };
  EXPECT_TRUE(sound(18.0));
  EXPECT_FALSE(sound(37.8));
  EXPECT_FALSE(sound(100.0));
}

TEST(BatchKernels, EveryInstructionSetGivesTheBitsOfTheScalarKernel) {
  std::mt19937_64 random(15);
  const std::size_t blocks = 300;
  std::vector<double> lengths(blocks * 6 * kLanes);
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      Lengths l = testing::log_uniform_lengths(random, 0.3, 2);
      if (b % 5 == 1) l = testing::log_uniform_lengths(random, 1e-300, 1e3);
      if (b % 5 == 2) l = testing::balanced_lengths(random, 200);
      if (b % 5 == 3) l[lane % 6] = lane % 2 == 0 ? 0.0 : -1.5;  // extended by angle 0
      for (std::size_t e = 0; e < 6; ++e) lengths[(6 * b + e) * kLanes + lane] = l[e];
    }
  }
  for (const BatchKernels& kernels : all_batch_kernels()) {
    SCOPED_TRACE(kernels.name);
    std::vector<double> theta(blocks * 6 * kLanes), jacobian(blocks * kPackedJacobian * kLanes);
    const std::size_t flat = kernels.angles(blocks, lengths.data(), theta.data(), jacobian.data());
    std::vector<double> only_angles(theta.size());
    kernels.angles(blocks, lengths.data(), only_angles.data(), nullptr);
    EXPECT_EQ(theta, only_angles);
    std::size_t expected_flat = 0;
    for (std::size_t b = 0; b < blocks; ++b) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        Lengths l;
        for (std::size_t e = 0; e < 6; ++e) l[e] = lengths[(6 * b + e) * kLanes + lane];
        std::array<double, 6> one;
        std::array<double, 36> full;
        expected_flat += extended_dihedral_angles(l, one, full) != TetrahedronKind::kTruncated;
        std::size_t q = 0;
        for (std::size_t i = 0; i < 6; ++i) {
          ASSERT_EQ(theta[(6 * b + i) * kLanes + lane], one[i]);
          for (std::size_t j = i; j < 6; ++j, ++q)
            ASSERT_EQ(jacobian[(kPackedJacobian * b + q) * kLanes + lane], full[6 * i + j]);
        }
      }
    }
    EXPECT_EQ(flat, expected_flat);
  }
}

TEST(BatchKernels, AreChosenByName) {
  const auto all = all_batch_kernels();
  for (const BatchKernels& kernels : all)
    EXPECT_EQ(&named_batch_kernels(std::string(kernels.name).c_str()), &kernels);
  EXPECT_EQ(&named_batch_kernels(nullptr), &all.back());
  EXPECT_EQ(&named_batch_kernels(""), &all.back());
  for (const char* name : {"none", "AVX2", "avx", "avx5122", "portable "}) {
    try {
      named_batch_kernels(name);
      ADD_FAILURE() << name;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string_view(error.what()).find("this processor runs portable"),
                std::string_view::npos);
    }
  }
}

TEST(BatchKernels, JacobianTimesVector) {
  std::mt19937_64 random(16);
  std::uniform_real_distribution<double> sample(-1, 1);
  std::vector<double> jacobian(kPackedJacobian * kLanes), x(6 * kLanes);
  for (double& a : jacobian) a = sample(random);
  for (double& a : x) a = sample(random);
  for (const BatchKernels& kernels : all_batch_kernels()) {
    std::vector<double> y(6 * kLanes);
    kernels.jacobian_times(jacobian.data(), x.data(), y.data());
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      double expected[6] = {};
      std::size_t q = 0;
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = i; j < 6; ++j, ++q) {
          expected[i] += jacobian[q * kLanes + lane] * x[j * kLanes + lane];
          if (i != j) expected[j] += jacobian[q * kLanes + lane] * x[i * kLanes + lane];
        }
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(y[i * kLanes + lane], expected[i], 1e-14) << kernels.name;
    }
  }
}

TEST(BatchKernels, VolumesAreThoseOfTheAngles) {
  // Two routes: the sines and cosines of the angles from the lengths, and from the angles.
  std::mt19937_64 random(19);
  constexpr std::size_t kBlocks = 2000;
  std::vector<double> lengths(kBlocks * 6 * kLanes);
  for (std::size_t b = 0; b < kBlocks; ++b)
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      Lengths l =
          testing::log_uniform_lengths(random, b % 3 == 0 ? 1e-3 : 0.3, b % 4 == 0 ? 90 : 4);
      if (b % 100 == 0) l[lane % 6] = -1.0 + static_cast<double>(lane / 6);  // -1 or 0
      if (b % 5 == 0) l.fill(l[0]);                                          // regular
      for (std::size_t e = 0; e < 6; ++e) lengths[(6 * b + e) * kLanes + lane] = l[e];
    }
  std::vector<double> theta(lengths.size()), first;
  for (const BatchKernels& kernels : all_batch_kernels()) {
    SCOPED_TRACE(kernels.name);
    kernels.angles(kBlocks, lengths.data(), theta.data(), nullptr);
    std::vector<double> volumes(kBlocks * kLanes, -1);
    kernels.volumes(kBlocks, lengths.data(), theta.data(), volumes.data());
    std::size_t true_ones = 0;
    for (std::size_t k = 0; k < volumes.size(); ++k) {
      std::array<double, 6> angles;
      double longest = 0;
      for (std::size_t e = 0; e < 6; ++e) {
        const std::size_t at = (6 * (k / kLanes) + e) * kLanes + k % kLanes;
        angles[e] = theta[at];
        longest = std::max(longest, lengths[at]);
      }
      // By Schlaefli's formula an ulp of each of the six angles is worth half of its length.
      ASSERT_NEAR(volumes[k], volume(angles), 4e-15 + 6 * longest / 2 * 0x1p-51);
      true_ones += volumes[k] > 0;
    }
    EXPECT_GT(true_ones, volumes.size() / 4);
    if (first.empty()) first = volumes;
    EXPECT_EQ(first, volumes);  // to the bit
  }
}

TEST(LengthsFromAngles, InvertsTheAngles) {
  // Backward: the angles of the lengths found are the angles given, up to their rounding.
  // Forward: where they are well enough conditioned to determine the lengths.
  std::mt19937_64 random(17);
  int well_conditioned = 0;
  for (int n = 0; n < 5000; ++n) {
    const Lengths l = testing::log_uniform_lengths(random, 0.05, 3);
    std::array<double, 6> theta, found, again;
    std::array<double, 36> jacobian;
    if (dihedral_angles(l, theta, jacobian) != TetrahedronKind::kTruncated) continue;
    const Eigen::Map<Eigen::Matrix<double, 6, 6>> j(jacobian.data());
    const double norm = j.norm(), inverse_norm = j.inverse().norm();
    ASSERT_TRUE(lengths_from_angles(theta, found));
    dihedral_angles(found, again);
    for (std::size_t e = 0; e < 6; ++e) EXPECT_NEAR(again[e], theta[e], 4e-15 * (1 + norm));
    if (inverse_norm > 30 || norm > 30) continue;
    for (std::size_t e = 0; e < 6; ++e) EXPECT_NEAR(found[e], l[e], 1e-13);
    ++well_conditioned;
  }
  EXPECT_GT(well_conditioned, 500);
}

TEST(Volume, DerivativeIsSchlaeflis) {
  // dV = -1/2 sum l d theta, integrated along a segment of angle structures by Gauss-Legendre.
  std::mt19937_64 random(18);
  constexpr double kNode[5] = {-0.90617984593866399280, -0.53846931010568309104, 0.0,
                               0.53846931010568309104, 0.90617984593866399280};
  constexpr double kWeight[5] = {0.23692688505618908751, 0.47862867049936646804,
                                 0.56888888888888888889, 0.47862867049936646804,
                                 0.23692688505618908751};
  int checked = 0;
  while (checked < 300) {
    std::array<double, 6> a, b;
    if (dihedral_angles(testing::log_uniform_lengths(random, 0.5, 1.1), a) !=
            TetrahedronKind::kTruncated ||
        dihedral_angles(testing::log_uniform_lengths(random, 0.5, 1.1), b) !=
            TetrahedronKind::kTruncated)
      continue;
    const int panels = 64;
    double integral = 0;
    for (int p = 0; p < panels; ++p) {
      for (int k = 0; k < 5; ++k) {
        const double t = (p + (1 + kNode[k]) / 2) / panels;
        std::array<double, 6> theta, l;
        for (std::size_t e = 0; e < 6; ++e) theta[e] = (1 - t) * a[e] + t * b[e];
        ASSERT_TRUE(lengths_from_angles(theta, l));
        for (std::size_t e = 0; e < 6; ++e)
          integral -= kWeight[k] / 2 / panels * l[e] * (b[e] - a[e]) / 2;
      }
    }
    EXPECT_NEAR(volume(b) - volume(a), integral, 1e-12);
    ++checked;
  }
}

}  // namespace
}  // namespace tripus::geometry
