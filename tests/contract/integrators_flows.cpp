// What every flow promises with every stepper, on convex functions with known properties.
#include <cstdio>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "integrators/integrate.hpp"
#include "tests/support/analytic_problems.hpp"
#include "tests/support/printers.hpp"

namespace tripus::testing {
namespace {

using integrators::Flow;
using integrators::FlowOptions;
using integrators::Stepper;
using solver::Options;
using solver::Summary;
using solver::Termination;

constexpr std::uint32_t kSeed = 20240612;

class FlowContract : public ::testing::TestWithParam<FlowAndStepper> {
 protected:
  const Flow& flow() const { return std::get<0>(GetParam()); }
  const Stepper& stepper() const { return std::get<1>(GetParam()); }

  Summary run(Case& c, Vector& x, Options options = {}) {
    RecordProperty("seed", static_cast<int>(kSeed));
    x = c.start;
    int observed = 0;
    double time = -1;
    options.observer = [&](const solver::Iterate& iterate) {
      EXPECT_EQ(iterate.iteration, observed++);
      EXPECT_GT(iterate.time, time);
      time = iterate.time;
      return true;
    };
    c.problem->evaluations = 0;
    Summary s = integrate(*c.problem, flow(), stepper(), as_span(x), options);
    EXPECT_EQ(s.evaluations, c.problem->evaluations) << c.name;
    EXPECT_EQ(s.iterations + 1, observed) << c.name;
    EXPECT_TRUE(x.allFinite()) << c.name;
    EXPECT_EQ(max_gradient(*c.problem, as_span(x)), s.max_gradient) << c.name;
    if (std::getenv("TRIPUS_VERBOSE") != nullptr) std::puts(describe(c, s).c_str());
    return s;
  }

  static std::string describe(const Case& c, const Summary& s) {
    return c.name + ": " + std::string(to_string(s.termination)) + " " + s.message + ", " +
           std::to_string(s.iterations) + " steps, " + std::to_string(s.evaluations) +
           " evaluations, max|g| = " + std::to_string(s.max_gradient * 1e12) + "e-12";
  }
};

TEST_P(FlowContract, ConvergesOnWellConditionedProblems) {
  std::mt19937 random(kSeed);
  for (const Eigen::Index n : {1, 3, 20}) {
    for (const double condition : {1.0, 10.0, 100.0}) {
      const Vector minimiser = random_vector(n, random).array().abs() + 2;
      Case c{"quadratic n=" + std::to_string(n) + " condition=" + std::to_string(condition),
             quadratic(minimiser, condition, random), Vector::Constant(n, 1.5), minimiser};
      Vector x;
      const Summary s = run(c, x);
      EXPECT_EQ(s.termination, Termination::kConverged) << describe(c, s);
      EXPECT_LT((x - minimiser).cwiseAbs().maxCoeff(), 1e-11) << describe(c, s);
    }
    const Vector c = random_vector(n, random).array().abs() + 0.2;
    Case barrier{"log barrier n=" + std::to_string(n), log_barrier(c), Vector::Constant(n, 0.3),
                 c.cwiseInverse()};
    Vector x;
    const Summary s = run(barrier, x);
    EXPECT_EQ(s.termination, Termination::kConverged) << describe(barrier, s);
    EXPECT_LT((x - barrier.minimiser).cwiseAbs().maxCoeff(), 1e-9);
  }
}

/// All but those that move by a power of the Hessian, which stand still where it vanishes.
class FlowThroughFlatRegions : public FlowContract {};

TEST_P(FlowThroughFlatRegions, Converges) {
  for (const Eigen::Index n : {1, 4}) {
    const Vector centre = Vector::LinSpaced(n, 20, 35);
    Case c{"huber n=" + std::to_string(n),
           ridge_sum(huber, Matrix::Identity(n, n), centre, Vector::Zero(n)),
           Vector::Constant(n, 2.0), centre};
    Vector x;
    const Summary s = run(c, x);
    EXPECT_EQ(s.termination, Termination::kConverged) << describe(c, s);
    EXPECT_LT((x - centre).cwiseAbs().maxCoeff(), 1e-11);
  }
}

TEST_P(FlowContract, NeverClaimsConvergenceWithoutAMinimiser) {
  for (Case& c : unbounded_cases()) {
    if (flow().name == "scaled") c.start = c.start.array().abs() + 0.5;
    Vector x;
    Options options;
    options.max_iterations = 20000;
    const Summary s = run(c, x, options);
    EXPECT_NE(s.termination, Termination::kConverged) << describe(c, s);
  }
}

TEST_P(FlowContract, StopsAtAnUnreachableTolerance) {
  std::mt19937 random(kSeed);
  Case c{"log barrier",
         log_barrier(random_vector(5, random).array().abs() + 0.3),
         Vector::Constant(5, 0.5),
         {}};
  Vector x;
  Options options;
  options.tolerance = 1e-300;
  const Summary s = run(c, x, options);
  EXPECT_TRUE(s.termination == Termination::kStalled || s.max_gradient == 0) << describe(c, s);
  EXPECT_LT(s.max_gradient, 1e-12) << describe(c, s);
}

/// Of the error at time 1, by halving the step.
struct MeasuredOrder {
  double order = 0;
  double fine = 0;       // the smaller error
  int sign_changes = 0;  // of components of g on the way
};

class OrderOfFlow : public FlowContract {
 protected:
  MeasuredOrder measured_order(const Vector& start, int steps) {
    std::mt19937 random(kSeed);
    const Matrix A = Matrix::NullaryExpr(
        6, 3, [&](Eigen::Index, Eigen::Index) { return random_vector(1, random)[0]; });
    const Vector c = random_vector(6, random);
    const auto problem = log_sum_exp(A, c), observed = log_sum_exp(A, c);
    MeasuredOrder result;
    const auto end = [&](int count) {
      Vector x = start, before, g(start.size());
      Options options;
      options.tolerance = 1e-300;
      options.max_iterations = count;
      options.observer = [&](const solver::Iterate& iterate) {
        const auto at = observed->at(iterate.x);
        EXPECT_TRUE(at);
        g = Eigen::Map<const Vector>(at->gradient().data(), start.size());
        if (before.size() != 0)
          result.sign_changes += static_cast<int>((g.array() * before.array() <= 0).count());
        before = g;
        return true;
      };
      const Summary s = integrate(*problem, flow(), stepper(), as_span(x), options,
                                  FlowOptions{.step = 1.0 / count});
      EXPECT_EQ(s.termination, Termination::kIterationLimit);
      return x;
    };
    // Euler's errors are of the form c h + O(h^2).
    const Vector reference = stepper().order == 1 ? Vector(2 * end(32768) - end(16384)) : end(3000);
    const double coarse = (end(steps) - reference).norm();
    result.fine = (end(2 * steps) - reference).norm();
    result.order = std::log2(coarse / result.fine);
    return result;
  }
};

/// Not p-Calabi with p = 1.5 and 3, whose weights are not smooth where a component of g vanishes.
class SmoothFlow : public OrderOfFlow {};

TEST_P(SmoothFlow, HasTheDeclaredOrder) {
  // The errors of `diagonal` by dopri5 fall faster at long steps, like h^6.5 at 16 steps, h^6 at
  // 32, h^5.6 at 64 and h^5.2 at 128: a term of higher order is the largest there.
  const int steps = stepper().order == 1 ? 64 : stepper().order == 4 ? 16 : 24;
  const bool diagonal = flow().name == "diagonal" && stepper().order == 5;
  const MeasuredOrder measured = measured_order(Vector::LinSpaced(3, 1, 2), diagonal ? 64 : steps);
  EXPECT_GT(measured.fine, 1e-14) << "too accurate to tell";
  EXPECT_NEAR(measured.order, stepper().order, 0.5) << measured.fine;
}

/// Those whose weights have a kink where a component of g vanishes, on a path where none does.
class FlowWithKinks : public OrderOfFlow {};

TEST_P(FlowWithKinks, HasTheDeclaredOrderBetweenThem) {
  const int steps = stepper().order == 1 ? 64 : stepper().order == 4 ? 16 : 4;
  const MeasuredOrder measured = measured_order(Eigen::Vector3d(3, 1, 2), steps);
  EXPECT_EQ(measured.sign_changes, 0);
  EXPECT_GT(measured.fine, 1e-14) << "too accurate to tell";
  EXPECT_NEAR(measured.order, stepper().order, 0.5) << measured.fine;
}

std::vector<FlowAndStepper> flows_with_kinks() {
  std::vector<FlowAndStepper> found;
  for (const FlowAndStepper& both : flows_but({}))
    if (std::get<0>(both).name == "calabi-1.5" || std::get<0>(both).name == "calabi-3")
      found.push_back(both);
  return found;
}

std::string name_of(const ::testing::TestParamInfo<FlowAndStepper>& both) {
  return test_name(both.param);
}

INSTANTIATE_TEST_SUITE_P(Flows, FlowContract, ::testing::ValuesIn(flows_but({})), name_of);
INSTANTIATE_TEST_SUITE_P(Flows, SmoothFlow,
                         ::testing::ValuesIn(flows_but({"calabi-1.5", "calabi-3"})), name_of);
INSTANTIATE_TEST_SUITE_P(Flows, FlowWithKinks, ::testing::ValuesIn(flows_with_kinks()), name_of);
INSTANTIATE_TEST_SUITE_P(Flows, FlowThroughFlatRegions,
                         ::testing::ValuesIn(flows_but({"calabi", "calabi-1.5", "calabi-3",
                                                        "calabi-4", "fractional-0.5"})),
                         name_of);

}  // namespace
}  // namespace tripus::testing
