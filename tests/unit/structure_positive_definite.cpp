// The proved bound for the least eigenvalue is one, and it is near.
#include <random>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "structure/proof/detail/checked_convexity.hpp"
#include "structure/proof/detail/cone_metric.hpp"
#include "structure/proof/detail/positive_definite.hpp"
#include "tests/support/data_files.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure::detail {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// A random sparse symmetric matrix with the diagonal 1 + shift.
Eigen::MatrixXd random_matrix(int n, double shift, std::mt19937_64& random) {
  std::uniform_real_distribution<double> entry(-0.4, 0.4);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    dense(i, i) = 1 + shift;
    for (int k = 0; k < 3; ++k) {
      const int j = static_cast<int>(random() % static_cast<unsigned>(n));
      if (j != i) dense(i, j) = dense(j, i) = entry(random);
    }
  }
  return dense;
}

EnclosedMatrix enclosed(const Eigen::MatrixXd& dense, double radius) {
  const Sparse full = dense.sparseView();
  EnclosedMatrix matrix{full.triangularView<Eigen::Lower>(), Sparse()};
  matrix.radius = matrix.mid;
  for (int j = 0; j < matrix.radius.outerSize(); ++j)
    for (Sparse::InnerIterator it(matrix.radius, j); it; ++it) it.valueRef() = radius;
  return matrix;
}

double least_eigenvalue(const Eigen::MatrixXd& dense) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .minCoeff();
}

TEST(LeastEigenvalueBound, IsBelowTheLeastEigenvalueAndNearIt) {
  std::mt19937_64 random(20261130);
  int positive = 0, indefinite = 0;
  for (int k = 0; k < 300; ++k) {
    const int n = 1 + static_cast<int>(random() % 60);
    const Eigen::MatrixXd dense = random_matrix(n, 0.02 * static_cast<double>(k % 40) - 0.2, random);
    const double least = least_eigenvalue(dense),
                 bound = least_eigenvalue_bound(enclosed(dense, 0));
    if (least < -1e-12) {
      EXPECT_EQ(bound, 0);
      ++indefinite;
    } else if (least > 1e-3) {
      EXPECT_LE(bound, least * (1 + 1e-12));
      EXPECT_GE(bound, 0.5 * least);
      ++positive;
    }
  }
  EXPECT_GT(positive, 50);
  EXPECT_GT(indefinite, 50);
}

// Every member counts: entries may be anywhere in their balls.
TEST(LeastEigenvalueBound, HoldsForEveryMember) {
  std::mt19937_64 random(20261130);
  std::uniform_real_distribution<double> offset(-1, 1);
  for (int k = 0; k < 100; ++k) {
    Eigen::MatrixXd dense = random_matrix(20, 0.6, random);
    const double radius = 0.01;
    const double bound = least_eigenvalue_bound(enclosed(dense, radius));
    for (int i = 0; i < 20; ++i)
      for (int j = 0; j <= i; ++j)
        if (dense(i, j) != 0) dense(i, j) = dense(j, i) = dense(i, j) + radius * offset(random);
    EXPECT_LE(bound, least_eigenvalue(dense));
  }
}

TEST(LeastEigenvalueBound, OfWhatIsNotFiniteIsNone) {
  EnclosedMatrix matrix = enclosed(Eigen::MatrixXd::Identity(3, 3), 0);
  matrix.mid.coeffRef(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(least_eigenvalue_bound(matrix), 0);
  matrix = enclosed(Eigen::MatrixXd::Identity(3, 3), std::numeric_limits<double>::infinity());
  EXPECT_EQ(least_eigenvalue_bound(matrix), 0);
  EXPECT_EQ(least_eigenvalue_bound({}), 0);
}

// The checker's share is relative to the diagonal, by elimination in balls.
TEST(CheckedShare, AgreesWithTheEigenvaluesOfTheScaledMatrix) {
  std::mt19937_64 random(20261130);
  const Precision precision(128);
  int positive = 0;
  for (int k = 0; k < 60; ++k) {
    const int n = 1 + static_cast<int>(random() % 25);
    const double shift = 0.02 * static_cast<double>(k % 30);
    const Eigen::MatrixXd dense = random_matrix(n, shift, random);
    CheckedMatrix matrix(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        if (dense(i, j) != 0)
          matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = Arb(dense(i, j));
    const double least = least_eigenvalue(dense) / (1 + shift), share = checked_share(matrix);
    if (least > 1e-3) {
      ++positive;
      EXPECT_LE(share, least * (1 + 1e-12));
      EXPECT_GE(share, 0.5 * least);
    } else if (least < 0) {
      EXPECT_EQ(share, 0);
    }
  }
  EXPECT_GT(positive, 20);
}

/// The determinant of the numbers of ends of the pins at the cusps.
double ends_determinant(const topology::Triangulation& m, const std::vector<std::size_t>& pins) {
  const auto n = static_cast<Eigen::Index>(m.vertex_count());
  Eigen::MatrixXd ends = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t row = 0; row < pins.size(); ++row) {
    const topology::EdgeCorner corner = m.corners(pins[row])[0];
    for (const int end : topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())])
      ends(static_cast<Eigen::Index>(row), m.vertex_class(corner.tetrahedron(), end)) += 1;
  }
  return ends.determinant();
}

TEST(Pins, HoldEveryHorosphereInProverAndChecker) {
  std::size_t several = 0;
  for (const auto& row : testing::data_table("cusped-census-5.tsv")) {
    const topology::Triangulation m(topology::decode_isosig(row.at("isosig")));
    several += m.vertex_count() > 1;
    const ConeMetric metric(m, {});
    const auto checked = checked_pins(m, topology::orbifold_links(m));
    ASSERT_EQ(metric.pins().size(), m.vertex_count()) << row.at("isosig");
    ASSERT_EQ(checked.size(), m.vertex_count()) << row.at("isosig");
    EXPECT_GE(std::fabs(ends_determinant(m, metric.pins())), 1 - 1e-9);
    EXPECT_GE(std::fabs(ends_determinant(m, checked)), 1 - 1e-9);
  }
  EXPECT_GT(several, 10u);
}

}  // namespace
}  // namespace tripus::structure::detail
