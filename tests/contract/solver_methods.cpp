// What every registered minimiser promises, on convex functions with known properties.
#include <cstdio>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "solver/method.hpp"
#include "solver/run.hpp"
#include "tests/support/analytic_problems.hpp"
#include "tests/support/printers.hpp"

namespace tripus::testing {
namespace {

using solver::Method;
using solver::Options;
using solver::Summary;
using solver::Termination;

constexpr std::uint32_t kSeed = 20240611;

class SolverContract : public ::testing::TestWithParam<Method> {
 protected:
  void SetUp() override { RecordProperty("seed", static_cast<int>(kSeed)); }

  /// Runs, and checks what must hold however the run ends.
  Summary run(Case& c, Vector& x, Options options = {}) {
    x = c.start;
    int observed = 0;
    double last = -1;
    options.observer = [&](const solver::Iterate& iterate) {
      EXPECT_EQ(iterate.iteration, observed);
      EXPECT_EQ(iterate.x.size(), c.problem->dimension());
      EXPECT_LT(solver::max_abs(iterate.x), 1e300);
      EXPECT_GE(iterate.seconds, 0);
      ++observed;
      last = iterate.max_gradient;
      EXPECT_NEAR(max_gradient(*c.problem, iterate.x), iterate.max_gradient, 1e-9 * (1 + last))
          << c.name;
      --c.problem->evaluations;
      return true;
    };
    c.problem->evaluations = 0;
    Summary summary = GetParam().minimise(*c.problem, as_span(x), options);
    EXPECT_EQ(summary.evaluations, c.problem->evaluations) << c.name;
    EXPECT_EQ(summary.iterations + 1, observed) << c.name;
    EXPECT_TRUE(x.allFinite()) << c.name;
    EXPECT_EQ(max_gradient(*c.problem, as_span(x)), summary.max_gradient) << c.name;
    if (summary.termination == Termination::kConverged) {
      EXPECT_LE(summary.max_gradient, options.tolerance) << c.name;
    }
    return summary;
  }
};

std::string describe(const Case& c, const Summary& s) {
  return c.name + ": " + std::string(to_string(s.termination)) + " " + s.message + ", " +
         std::to_string(s.iterations) + " iterations, " + std::to_string(s.evaluations) +
         " evaluations, max|g| = " + std::to_string(s.max_gradient * 1e12) + "e-12";
}

/// From the known minimiser; 0 where it is not known.
double distance(const Case& c, const Vector& x) {
  return c.minimiser.size() > 0 ? (x - c.minimiser).cwiseAbs().maxCoeff() : 0;
}

/// With TRIPUS_VERBOSE in the environment: what each run took.
void show(const Case& c, const Summary& s) {
  if (std::getenv("TRIPUS_VERBOSE") == nullptr) return;
  std::printf("%s, %ld linear iterations\n", describe(c, s).c_str(), s.linear_iterations);
}

std::string name_of(const ::testing::TestParamInfo<Method>& method) {
  return test_name(method.param.name);
}

TEST_P(SolverContract, ConvergesOnWellConditionedProblems) {
  for (Case& c : well_conditioned_cases(kSeed)) {
    Vector x;
    const Summary s = run(c, x);
    EXPECT_EQ(s.termination, Termination::kConverged) << describe(c, s);
    EXPECT_LT(distance(c, x), 1e-11) << c.name;
    show(c, s);
  }
}

TEST_P(SolverContract, ConvergesFromFlatAndSaturatedStarts) {
  // Levenberg-Marquardt sees no descent where the Hessian vanishes; it must say so.
  const bool needs_curvature = GetParam().name == "ceres-lm";
  for (Case& c : flat_start_cases(kSeed)) {
    Vector x;
    const Summary s = run(c, x);
    if (needs_curvature && s.termination != Termination::kConverged) continue;
    EXPECT_EQ(s.termination, Termination::kConverged) << describe(c, s);
    EXPECT_LT(distance(c, x), 1e-10) << c.name;
    show(c, s);
  }
}

TEST_P(SolverContract, NeverClaimsConvergenceWithoutAMinimiser) {
  for (Case& c : unbounded_cases()) {
    Vector x;
    const Summary s = run(c, x);
    EXPECT_NE(s.termination, Termination::kConverged) << describe(c, s);
    EXPECT_LT(s.evaluations, 20000) << describe(c, s);
    show(c, s);
  }
}

TEST_P(SolverContract, StopsAtAnUnreachableTolerance) {
  for (Case& c : well_conditioned_cases(kSeed + 1)) {
    Vector x;
    Options options;
    options.tolerance = 1e-300;
    const Summary s = run(c, x, options);
    show(c, s);
    EXPECT_TRUE(s.termination == Termination::kStalled || s.max_gradient == 0) << describe(c, s);
    EXPECT_LT(s.max_gradient, 1e-11) << describe(c, s);
  }
}

TEST_P(SolverContract, StaysInsideAnOpenDomain) {
  std::mt19937 random(kSeed);
  for (const Eigen::Index n : {1, 6}) {
    const Vector c = random_vector(n, random).array().abs() + 0.2;
    Case barrier{"log barrier", log_barrier(c), Vector::Constant(n, 0.05), c.cwiseInverse()};
    Vector x;
    const Summary s = run(barrier, x);
    EXPECT_EQ(s.termination, Termination::kConverged) << describe(barrier, s);
    EXPECT_LT((x - barrier.minimiser).cwiseAbs().maxCoeff(), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, SolverContract,
                         ::testing::ValuesIn(solver::methods().begin(), solver::methods().end()),
                         name_of);

}  // namespace
}  // namespace tripus::testing
