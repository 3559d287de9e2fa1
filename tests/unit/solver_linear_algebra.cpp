// The factorisations, the sparse solver and conjugate gradients, on problems too large for the
// contract tests.
#include <gtest/gtest.h>

#include "solver/detail/dense_cholesky.hpp"
#include "solver/method.hpp"
#include "solver/newton_direction.hpp"
#include "solver/run.hpp"
#include "tests/support/analytic_problems.hpp"
#include "tests/support/grid_problem.hpp"

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
    Vector x = random_vector(n, random), g = x, d = x;
    ASSERT_TRUE(problem->evaluate(as_span(x), as_span(g), {nullptr, true}));
    solver::NewtonDirection direction(*problem);
    direction.compute(as_span(x), as_span(g), as_span(d));
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
