// Tetrahedra with ideal and finite vertices: one kernel against another, against derivatives and
// against Schlaefli's formula.
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "geometry/batch.hpp"
#include "geometry/mixed_tetrahedron.hpp"
#include "geometry/volume.hpp"
#include "tests/support/lanes.hpp"
#include "tests/support/ridders.hpp"

namespace tripus::geometry {
namespace {

using Six = std::array<double, 6>;
using Four = std::array<double, 4>;
using Jacobian = std::array<double, 36>;

constexpr int kEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

struct Sample {
  Four diagonal;
  Six l;
};

/// True tetrahedra with all patterns of hyperideal and ideal vertices; with `finite`, of all three.
std::vector<Sample> samples(bool finite) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double a, double b) {
    return a + (b - a) * (double(random() >> 11) * 0x1p-53);
  };
  std::vector<Sample> found;
  for (int pattern = 0; pattern < (finite ? 81 : 16); ++pattern) {
    Four d;
    for (int v = 0, rest = pattern; v < 4; ++v, rest /= (finite ? 3 : 2))
      d[std::size_t(v)] = 1 - rest % (finite ? 3 : 2);
    for (int tries = 0, count = 0; tries < 4000 && count < 6; ++tries) {
      Sample sample{d, {}};
      for (auto& l : sample.l) l = uniform(0.3, 1.5);
      Six theta;
      if (!general_dihedral_angles(sample.l, d, theta)) continue;
      bool thick = true;
      for (const double angle : theta) thick = thick && angle > 0.05 && angle < 3.0;
      if (!thick) continue;
      found.push_back(sample);
      ++count;
    }
  }
  return found;
}

TEST(MixedTetrahedron, BothKernelsAgree) {
  const auto all = samples(false);
  ASSERT_GT(all.size(), 80u);
  for (const Sample& sample : all) {
    Six a, b;
    Jacobian ja, jb;
    ASSERT_EQ(mixed_dihedral_angles(sample.l, sample.diagonal, a, ja), TetrahedronKind::kTruncated);
    ASSERT_TRUE(general_dihedral_angles(sample.l, sample.diagonal, b, jb));
    for (std::size_t e = 0; e < 6; ++e) EXPECT_NEAR(a[e], b[e], 1e-13);
    for (std::size_t q = 0; q < 36; ++q) EXPECT_NEAR(ja[q], jb[q], 1e-11 * (1 + std::fabs(jb[q])));
  }
}

TEST(MixedTetrahedron, HyperidealOnesAreThoseOfTheOldKernel) {
  for (const Sample& sample : samples(false)) {
    if (sample.diagonal != Four{1, 1, 1, 1}) continue;
    Six a, b;
    mixed_dihedral_angles(sample.l, sample.diagonal, a);
    extended_dihedral_angles(sample.l, b);
    for (std::size_t e = 0; e < 6; ++e) EXPECT_NEAR(a[e], b[e], 4e-15);
  }
}

TEST(MixedTetrahedron, TheJacobianIsTheDerivativeAndSymmetric) {
  const auto all = samples(true);
  ASSERT_GT(all.size(), 200u);
  for (const Sample& sample : all) {
    Six theta;
    Jacobian jacobian;
    ASSERT_TRUE(general_dihedral_angles(sample.l, sample.diagonal, theta, jacobian));
    for (std::size_t b = 0; b < 6; ++b)
      for (std::size_t a = 0; a < 6; ++a) {
        const auto derivative = testing::ridders(
            [&](double step) {
              Six l = sample.l, angles;
              l[b] += step;
              general_dihedral_angles(l, sample.diagonal, angles);
              return angles[a];
            },
            1e-3);
        EXPECT_NEAR(jacobian[6 * a + b], derivative.value,
                    1e-7 * (1 + std::fabs(derivative.value)) + 10 * derivative.error);
        EXPECT_NEAR(jacobian[6 * a + b], jacobian[6 * b + a],
                    1e-10 * (1 + std::fabs(jacobian[6 * a + b])));
      }
  }
}

// The length of an edge with an ideal end is a distance from a horosphere: Schlaefli's formula (23)
// holds only if the entries between ideal and other vertices are those of one horosphere (77).
TEST(MixedTetrahedron, SchlaeflisFormulaForEveryMixtureOfVertices) {
  for (const Sample& sample : samples(true)) {
    Six theta;
    Jacobian jacobian;
    ASSERT_TRUE(general_dihedral_angles(sample.l, sample.diagonal, theta, jacobian));
    for (std::size_t b = 0; b < 6; ++b) {
      const auto derivative = testing::ridders(
          [&](double step) {
            Six l = sample.l, angles;
            l[b] += step;
            general_dihedral_angles(l, sample.diagonal, angles);
            return volume(angles);
          },
          1e-3);
      double schlaefli = 0;
      for (std::size_t a = 0; a < 6; ++a) schlaefli -= sample.l[a] * jacobian[6 * a + b] / 2;
      EXPECT_NEAR(derivative.value, schlaefli,
                  1e-7 * (1 + std::fabs(schlaefli)) + 10 * derivative.error);
    }
  }
}

TEST(MixedTetrahedron, HorospheresDoNotMatter) {
  for (const Sample& sample : samples(false)) {
    Six theta, moved_theta;
    Jacobian jacobian;
    mixed_dihedral_angles(sample.l, sample.diagonal, theta, jacobian);
    for (const double shift : {-30.0, -1.0, 0.25, 50.0, 300.0})
      for (int v = 0; v < 4; ++v) {
        if (sample.diagonal[std::size_t(v)] != 0) continue;
        Six moved = sample.l;
        for (int e = 0; e < 6; ++e)
          if (kEnds[e][0] == v || kEnds[e][1] == v) moved[std::size_t(e)] += shift;
        mixed_dihedral_angles(moved, sample.diagonal, moved_theta);
        for (std::size_t e = 0; e < 6; ++e) EXPECT_NEAR(moved_theta[e], theta[e], 2e-12);
        // and the Jacobian has that null vector.
        for (std::size_t a = 0; a < 6; ++a) {
          double sum = 0;
          for (std::size_t e = 0; e < 6; ++e)
            if (kEnds[e][0] == v || kEnds[e][1] == v) sum += jacobian[6 * a + e];
          EXPECT_NEAR(sum, 0, 1e-11 * (1 + std::fabs(jacobian[7 * a])));
        }
      }
  }
}

TEST(MixedTetrahedron, VertexSumsArePiAtIdealVertices) {
  constexpr int kAt[4][3] = {{0, 1, 2}, {0, 3, 4}, {1, 3, 5}, {2, 4, 5}};
  for (const Sample& sample : samples(false)) {
    Six theta;
    mixed_dihedral_angles(sample.l, sample.diagonal, theta);
    for (std::size_t v = 0; v < 4; ++v) {
      double sum = 0;
      for (const int e : kAt[v]) sum += theta[std::size_t(e)];
      if (sample.diagonal[v] == 0) {
        EXPECT_NEAR(sum, std::numbers::pi, 1e-13);
      } else {
        EXPECT_LT(sum, std::numbers::pi);
      }
    }
  }
}

TEST(MixedTetrahedron, FlatOnesHaveOnePairOfAnglesPi) {
  std::mt19937_64 random(3);
  int flat = 0;
  for (int n = 0; n < 3000; ++n) {
    Four d;
    for (auto& each : d) each = double(random() % 2);
    Six l, theta;
    for (auto& each : l) each = 6 * double(random() >> 11) * 0x1p-53;
    if (mixed_dihedral_angles(l, d, theta) == TetrahedronKind::kTruncated) continue;
    ++flat;
    int zero = 0, pi = 0;
    for (const double angle : theta) {
      zero += angle == 0;
      pi += angle > 3.14;
    }
    EXPECT_EQ(zero, 4);
    EXPECT_EQ(pi, 2);
  }
  EXPECT_GT(flat, 300);
}

TEST(MixedTetrahedron, EveryInstructionSetGivesTheBitsOfTheScalarKernel) {
  const auto all = samples(false);
  const std::size_t blocks = block_count(all.size());
  std::vector<double> lengths(blocks * 6 * kLanes, 1.0), diagonal(blocks * 4 * kLanes, 1.0);
  for (std::size_t t = 0; t < all.size(); ++t) {
    const double stretch = t % 5 == 0 ? 70 : 0;  // by the scaled Gram matrix
    for (std::size_t e = 0; e < 6; ++e)
      lengths[(6 * (t / kLanes) + e) * kLanes + t % kLanes] = all[t].l[e] + stretch;
    for (std::size_t v = 0; v < 4; ++v)
      diagonal[(4 * (t / kLanes) + v) * kLanes + t % kLanes] = all[t].diagonal[v];
  }
  for (const BatchKernels& kernels : all_batch_kernels()) {
    SCOPED_TRACE(kernels.name);
    std::vector<double> theta(blocks * 6 * kLanes), jacobian(blocks * kPackedJacobian * kLanes);
    kernels.mixed_angles(blocks, lengths.data(), diagonal.data(), theta.data(), jacobian.data());
    for (std::size_t t = 0; t < all.size(); ++t) {
      Six l, angles;
      Jacobian full;
      for (std::size_t e = 0; e < 6; ++e)
        l[e] = lengths[(6 * (t / kLanes) + e) * kLanes + t % kLanes];
      mixed_dihedral_angles(l, all[t].diagonal, angles, full);
      testing::expect_lane(theta, jacobian, t, angles, full);
    }
  }
}

// Known tetrahedra: the regular ideal one, and the regular finite one of a given angle.
TEST(MixedTetrahedron, RegularOnes) {
  Six theta;
  mixed_dihedral_angles(Six{}, Four{}, theta);
  for (const double angle : theta) EXPECT_NEAR(angle, std::numbers::pi / 3, 1e-15);
  EXPECT_NEAR(volume(theta), 1.01494160640965362502, 1e-14);
  // cosh l = cos t / (1 - 2 cos t) has the sign of (26) turned: vertices inside.
  const double t = 1.1, l = std::acosh(std::cos(t) / (1 - 2 * std::cos(t)));
  const Six lengths = {l, l, l, l, l, l};
  ASSERT_TRUE(general_dihedral_angles(lengths, Four{-1, -1, -1, -1}, theta));
  for (const double angle : theta) EXPECT_NEAR(angle, t, 1e-14);
}

}  // namespace
}  // namespace tripus::geometry
