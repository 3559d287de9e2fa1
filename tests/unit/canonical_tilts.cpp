// Tilts against their definition, and the second pass in 50 digits.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "canonical/tilts.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "structure/solve.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

// t_i = R_i - sum_j R_j cos theta(faces i, j), R_j = sqrt(N_jj), N = G^-1; by cofactors of 3 x 3
// minors that are expanded here, and angles of the kernel.
TEST(Tilts, AgreeWithTheirDefinition) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> sample(0.3, 3.0);
  int tried = 0;
  while (tried < 200) {
    std::array<double, 6> l, theta;
    for (double& x : l) x = sample(random);
    if (geometry::dihedral_angles(l, theta) != geometry::TetrahedronKind::kTruncated) continue;
    ++tried;
    double G[4][4];
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        G[i][j] = i == j ? 1 : -std::cosh(l[static_cast<std::size_t>(topology::kEdgeNumber[i][j])]);
    const auto minor = [&](int r, int c) {
      int a[3], b[3];
      for (int k = 0, x = 0, y = 0; k < 4; ++k) {
        if (k != r) a[x++] = k;
        if (k != c) b[y++] = k;
      }
      double sum = 0;
      for (int k = 0; k < 3; ++k) {
        sum += G[a[0]][b[k]] * (G[a[1]][b[(k + 1) % 3]] * G[a[2]][b[(k + 2) % 3]] -
                                G[a[1]][b[(k + 2) % 3]] * G[a[2]][b[(k + 1) % 3]]);
      }
      return sum;
    };
    double det = 0;
    for (int c = 0; c < 4; ++c) det += (c % 2 == 0 ? 1 : -1) * G[0][c] * minor(0, c);
    double R[4];
    for (int i = 0; i < 4; ++i) R[i] = std::sqrt(minor(i, i) / det);
    const auto found = tilts(l);
    for (int i = 0; i < 4; ++i) {
      double expected = R[i];
      for (int j = 0; j < 4; ++j) {
        if (j == i) continue;
        // Faces i and j meet at the edge of the other two vertices.
        const int e = 5 - topology::kEdgeNumber[i][j];
        expected -= R[j] * std::cos(theta[static_cast<std::size_t>(e)]);
      }
      EXPECT_NEAR(found[static_cast<std::size_t>(i)], expected,
                  1e-8 * (1 + std::fabs(expected) + R[i]));
    }
  }
}

FaceKinds kinds_of(const std::string& isosig) {
  const topology::Triangulation triangulation(topology::decode_isosig(isosig));
  return face_kinds(triangulation, structure::solve(triangulation).edge_lengths);
}

TEST(FaceKinds, RegularTetrahedraHaveTrueFaces) {
  const FaceKinds faces = kinds_of("cPcbbbihq");
  EXPECT_FALSE(faces.precise);
  EXPECT_FALSE(faces.has_concave());
  // With a = cosh l = (3 + sqrt 3)/4 all c_ij are a (a + 1)^2 and all p_i (2 a - 1) (a + 1)^2.
  const double a = (3 + std::sqrt(3.0)) / 4;
  const double p = (2 * a - 1) * (a + 1) * (a + 1), c = a * (a + 1) * (a + 1);
  EXPECT_NEAR(faces.margin, 2 * (3 * c - p) / std::sqrt(p * (p + 3 * a * c)), 1e-12);
}

// A triangulation that cuts the octahedron: its zeros are settled in 50 digits.
TEST(FaceKinds, ZerosAreZeroToAllDigits) {
  const FaceKinds faces = kinds_of("eLAkccbddhpjuw");
  ASSERT_FALSE(faces.has_concave());
  EXPECT_TRUE(faces.precise);
  EXPECT_LT(faces.largest_zero, 1e-40);
  EXPECT_GT(faces.margin, 1e-4);
}

}  // namespace
}  // namespace tripus::canonical
