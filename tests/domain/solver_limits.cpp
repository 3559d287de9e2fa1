// Limits, interruptions and broken input: every method stops as documented, with a finite point.
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "solver/method.hpp"
#include "tests/support/analytic_problems.hpp"
#include "tests/support/printers.hpp"

namespace tripus::testing {
namespace {

using solver::Iterate;
using solver::Method;
using solver::Options;
using solver::Summary;
using solver::Termination;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class SolverDomain : public ::testing::TestWithParam<Method> {
 protected:
  SolverDomain() {
    std::mt19937 random(7);
    minimiser_ = random_vector(6, random, 3);
    problem_ = quadratic(minimiser_, 500, random);
    x_ = Vector::Zero(6);
  }
  Summary minimise(const Options& options = {}) {
    return GetParam().minimise(*problem_, as_span(x_), options);
  }
  Vector minimiser_, x_;
  std::unique_ptr<DenseProblem> problem_;
};

TEST_P(SolverDomain, RefusesAStartThatIsNotFinite) {
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    x_ = Vector::Zero(6);
    x_[3] = bad;
    const Summary s = minimise();
    EXPECT_EQ(s.termination, Termination::kNumericalFailure);
    EXPECT_LE(s.evaluations, 1);
    EXPECT_FALSE(s.message.empty());
  }
}

TEST_P(SolverDomain, RefusesAStartOutsideTheDomain) {
  problem_ = log_barrier(Vector::Ones(6));
  x_ = Vector::Constant(6, -1);
  const Summary s = minimise();
  EXPECT_EQ(s.termination, Termination::kNumericalFailure);
  EXPECT_EQ(s.evaluations, 1);
  EXPECT_EQ(x_, Vector::Constant(6, -1));
}

TEST_P(SolverDomain, RefusesAStartOfTheWrongLength) {
  x_ = Vector::Zero(5);
  EXPECT_THROW(minimise(), InvalidInput);
}

TEST_P(SolverDomain, RefusesBadOptions) {
  for (const double bad : {0.0, -1.0, kNaN, kInfinity}) {
    Options options;
    options.tolerance = bad;
    EXPECT_THROW(minimise(options), InvalidInput);
  }
  for (const double bad : {0.0, -1.0, kNaN}) {
    Options options;
    options.time_limit = bad;
    EXPECT_THROW(minimise(options), InvalidInput);
  }
  Options options;
  options.max_iterations = -1;
  EXPECT_THROW(minimise(options), InvalidInput);
}

TEST_P(SolverDomain, StopsAtTheIterationLimit) {
  x_ = Vector::Constant(6, 1e4);
  Options options;
  options.max_iterations = 1;
  const Summary s = minimise(options);
  EXPECT_EQ(s.termination, Termination::kIterationLimit);
  EXPECT_EQ(s.iterations, 1);
  EXPECT_TRUE(x_.allFinite());
}

TEST_P(SolverDomain, StopsAtTheTimeLimit) {
  Options options;
  options.time_limit = 1e-9;
  const Summary s = minimise(options);
  EXPECT_EQ(s.termination, Termination::kTimeLimit);
  EXPECT_LE(s.evaluations, 2);
  EXPECT_TRUE(x_.allFinite());
}

TEST_P(SolverDomain, StopsWhenTheObserverAsks) {
  for (const int last : {0, 1}) {
    x_ = Vector::Constant(6, 1e4);
    Options options;
    options.observer = [&](const Iterate& iterate) { return iterate.iteration < last; };
    const Summary s = minimise(options);
    EXPECT_EQ(s.termination, Termination::kInterrupted);
    EXPECT_EQ(s.iterations, last);
    EXPECT_TRUE(x_.allFinite());
  }
}

TEST_P(SolverDomain, LetsExceptionsPass) {
  Options options;
  options.observer = [](const Iterate& iterate) {
    if (iterate.iteration == 1) throw std::out_of_range("from the observer");
    return true;
  };
  x_ = Vector::Constant(6, 1e4);
  EXPECT_THROW(minimise(options), std::out_of_range);
  int calls = 0;
  DenseProblem throwing(1, [&](const Vector& x, double& f, Vector& g, Matrix* H) {
    if (++calls == 2) throw std::out_of_range("from the problem");
    f = x.squaredNorm();
    g = 2 * x;
    if (H != nullptr) H->setConstant(2);
    return true;
  });
  Vector x = Vector::Constant(1, 5.0);
  EXPECT_THROW(GetParam().minimise(throwing, as_span(x), {}), std::out_of_range);
}

TEST_P(SolverDomain, SurvivesAFunctionThatFailsAwayFromTheStart) {
  bool first = true;
  DenseProblem failing(2, [&](const Vector&, double& f, Vector& g, Matrix* H) {
    if (!std::exchange(first, false)) return false;
    f = 1;
    g = Vector::Ones(2);
    if (H != nullptr) *H = Matrix::Identity(2, 2);
    return true;
  });
  Vector x = Vector::Zero(2);
  const Summary s = GetParam().minimise(failing, as_span(x), {});
  EXPECT_NE(s.termination, Termination::kConverged);
  EXPECT_TRUE(x.allFinite());
  EXPECT_LT(s.evaluations, 1000);
}

TEST_P(SolverDomain, SurvivesNaNGradients) {
  DenseProblem nan(1, [](const Vector& x, double& f, Vector& g, Matrix* H) {
    f = x[0];
    g[0] = x[0] < -3 ? kNaN : 1;
    if (H != nullptr) H->setConstant(1);
    return true;
  });
  Vector x = Vector::Zero(1);
  const Summary s = GetParam().minimise(nan, as_span(x), {});
  EXPECT_NE(s.termination, Termination::kConverged);
  EXPECT_TRUE(x.allFinite());
  EXPECT_LT(s.evaluations, 20000);
}

std::string name_of(const ::testing::TestParamInfo<Method>& method) {
  return test_name(method.param.name);
}

INSTANTIATE_TEST_SUITE_P(Methods, SolverDomain,
                         ::testing::ValuesIn(solver::methods().begin(), solver::methods().end()),
                         name_of);

TEST(SolverBfgs, RefusesToKeepAHugeMatrix) {
  DenseProblem large(1001, [](const Vector& x, double&, Vector& g, Matrix*) {
    g = x;
    return true;
  });
  Vector x = Vector::Ones(1001);
  const Summary s = solver::find_method("ceres-bfgs")->minimise(large, as_span(x), {});
  EXPECT_EQ(s.termination, Termination::kNumericalFailure);
  EXPECT_NE(s.message.find("ceres-lbfgs"), std::string::npos);
  EXPECT_EQ(x, Vector::Ones(1001));
}

}  // namespace
}  // namespace tripus::testing
