// The factorisations, the sparse solver and conjugate gradients, on problems too large for the
// contract tests.
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "energies/co_volume.hpp"
#include "solver/detail/dense_cholesky.hpp"
#include "solver/extreme_eigenvalues.hpp"
#include "solver/method.hpp"
#include "solver/newton_direction.hpp"
#include "solver/run.hpp"
#include "tests/support/analytic_problems.hpp"
#include "tests/support/grid_problem.hpp"
#include "topology/cyclic_cover.hpp"
#include "topology/isosig.hpp"

namespace tripus::testing {
namespace {

using solver::Summary;
using solver::Termination;

TEST(DenseCholesky, SolvesAndRecognisesIndefiniteMatrices) {
  std::mt19937 random(3);
  for (const Eigen::Index n : {1, 2, 7, 30}) {
    const Matrix B = Matrix::NullaryExpr(
        n, n, [&](Eigen::Index, Eigen::Index) { return random_vector(1, random)[0]; });
    const Matrix A = B * B.transpose() + 0.1 * Matrix::Identity(n, n);
    const auto size = static_cast<std::size_t>(n);
    Matrix L = A;
    ASSERT_TRUE(solver::detail::factor_cholesky({L.data(), size * size}, size));
    const Vector b = random_vector(n, random);
    Vector x = b;
    solver::detail::solve_cholesky({L.data(), size * size}, size, as_span(x));
    EXPECT_LT((A * x - b).norm(), 1e-12);
    Matrix indefinite = A;
    indefinite(n - 1, n - 1) = -1;
    EXPECT_FALSE(solver::detail::factor_cholesky({indefinite.data(), size * size}, size));
    Matrix zero = Matrix::Zero(n, n);
    EXPECT_FALSE(solver::detail::factor_cholesky({zero.data(), size * size}, size));
  }
}

/// The Hessian, dense, column by column from products with unit vectors.
Matrix dense_hessian(const solver::Evaluation& at) {
  std::vector<double> unit(at.gradient().size()), column(unit.size());
  const auto n = static_cast<Eigen::Index>(unit.size());
  Matrix H(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    std::fill(unit.begin(), unit.end(), 0.0);
    unit[static_cast<std::size_t>(j)] = 1;
    at.hessian_times(unit, column);
    for (Eigen::Index i = 0; i < n; ++i) H(i, j) = column[static_cast<std::size_t>(i)];
  }
  return H;
}

TEST(ExtremeEigenvalues, AreThoseOfTheDenseSpectrum) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> length(0.5, 1.1);  // none is flat
  for (const char* signature : {"cPcbbbihq", "eLAkbcbddhejqn", "jLLLzQQcdffhggihilvhhnkkawn"}) {
    const topology::Triangulation base(topology::decode_isosig(signature));
    for (const std::size_t degree : {1u, 2u, 7u, 100u}) {
      const auto shifts = topology::primitive_class(base);
      ASSERT_TRUE(shifts);
      const topology::Triangulation triangulation(
          topology::cyclic_cover(base.gluings(), *shifts, degree));
      const energies::CoVolume energy(triangulation);
      std::vector<double> x(triangulation.edge_count());
      for (double& l : x) l = length(random);
      const auto at = energy.at(x, solver::Order::kSecond);
      const Matrix H = dense_hessian(at);
      const Eigen::SelfAdjointEigenSolver<Matrix> dense(H);
      const auto found = solver::extreme_eigenvalues(at);
      const double largest = dense.eigenvalues().maxCoeff(), smallest = dense.eigenvalues()[0];
      EXPECT_NEAR(found.largest, largest, 1e-9 * largest);
      EXPECT_NEAR(found.smallest, smallest, 1e-8 * smallest + 1e-14 * largest);
      ASSERT_EQ(found.slowest.size(), x.size());
      const Eigen::Map<const Vector> v(found.slowest.data(), H.rows());
      EXPECT_LT((H * v - smallest * v).norm(), 1e-6 * largest);
    }
  }
}

TEST(ExtremeEigenvalues, OfASingularHessianAreZeroBelow) {
  // All tetrahedra are flat or at length 0: nothing bends.
  const topology::Triangulation triangulation(topology::decode_isosig("cPcbbbihq"));
  const energies::CoVolume energy(triangulation);
  const std::vector<double> x(1, -1.0);
  EXPECT_EQ(solver::extreme_eigenvalues(energy.at(x, solver::Order::kSecond)).smallest, 0);
}

TEST(MaxAbs, IsInfiniteForNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solver::max_abs(std::vector<double>{}), 0);
  EXPECT_EQ(solver::max_abs(std::vector<double>{1, -3, 2}), 3);
  EXPECT_EQ(solver::max_abs(std::vector<double>{1, nan, 2}),
            std::numeric_limits<double>::infinity());
}

TEST(NewtonDirection, IsThatOfNewton) {
  std::mt19937 random(5);
  for (const Eigen::Index n : {3, 80}) {
    const Vector minimiser = random_vector(n, random);
    const auto problem = quadratic(minimiser, 50, random);
    Vector x = random_vector(n, random), d = x;
    const auto at = problem->at(as_span(x), solver::Order::kSecond);
    ASSERT_TRUE(at);
    solver::NewtonDirection direction(*problem);
    direction.compute(as_span(x), *at, as_span(d));
    EXPECT_LT((x + d - minimiser).norm(), 1e-12);
  }
}

/// The methods meant for many variables, on a nonlinear grid with 16,384 of them.
TEST(LargeProblems, NewtonAndConjugateGradientsAgree) {
  std::vector<double> reference;
  for (const char* name : {"newton", "newton-cg", "newton-cg-block"}) {
    GridProblem grid(128);
    std::vector<double> x(grid.dimension(), 0.0);
    const Summary s = solver::find_method(name)->minimise(grid, x, {});
    EXPECT_EQ(s.termination, Termination::kConverged) << name << ' ' << s.message;
    EXPECT_LT(s.iterations, 15) << name;
    EXPECT_LT(s.linear_iterations, 10 * s.iterations) << name;
    if (reference.empty()) reference = x;
    for (std::size_t i = 0; i < x.size(); ++i) ASSERT_NEAR(x[i], reference[i], 1e-12);
  }
}

TEST(LargeProblems, CeresAgrees) {
  GridProblem grid(40);
  std::vector<double> reference(grid.dimension(), 0.0);
  solver::find_method("newton")->minimise(grid, reference, {});
  for (const char* name : {"ceres-lbfgs", "ceres-cg", "ceres-lm"}) {
    std::vector<double> x(grid.dimension(), 0.0);
    const Summary s = solver::find_method(name)->minimise(grid, x, {});
    EXPECT_EQ(s.termination, Termination::kConverged) << name << ' ' << s.message;
    for (std::size_t i = 0; i < x.size(); ++i) ASSERT_NEAR(x[i], reference[i], 1e-11);
  }
}

/// The sparse factorisation meets zero rows and must go on.
TEST(LargeProblems, CrossFlatRegions) {
  const Eigen::Index n = 100;
  const Vector centre = Vector::LinSpaced(n, -30, 30);
  for (const char* name : {"newton", "newton-cg", "newton-cg-block"}) {
    const auto problem = ridge_sum(huber, Matrix::Identity(n, n), centre, Vector::Zero(n));
    Vector x = Vector::Zero(n);
    const Summary s = solver::find_method(name)->minimise(*problem, as_span(x), {});
    EXPECT_EQ(s.termination, Termination::kConverged) << name << ' ' << s.message;
    EXPECT_LT((x - centre).cwiseAbs().maxCoeff(), 1e-12) << name;
  }
}

}  // namespace
}  // namespace tripus::testing
