// Limits, interruptions and broken input of the flows.
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "integrators/integrate.hpp"
#include "tests/support/analytic_problems.hpp"
#include "tests/support/printers.hpp"

namespace tripus::testing {
namespace {

using integrators::FlowOptions;
using solver::Iterate;
using solver::Options;
using solver::Summary;
using solver::Termination;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class FlowDomain : public ::testing::TestWithParam<FlowAndStepper> {
 protected:
  FlowDomain() {
    std::mt19937 random(11);
    problem_ = quadratic(Vector::LinSpaced(4, 1, 3), 20, random);
    x_ = Vector::Constant(4, 0.5);
  }
  Summary integrate(const Options& options = {}, const FlowOptions& flow_options = {}) {
    return integrators::integrate(*problem_, std::get<0>(GetParam()), std::get<1>(GetParam()),
                                  as_span(x_), options, flow_options);
  }
  std::unique_ptr<DenseProblem> problem_;
  Vector x_;
};

TEST_P(FlowDomain, RefusesAStartThatIsNotFinite) {
  x_[2] = kNaN;
  const Summary s = integrate();
  EXPECT_EQ(s.termination, Termination::kNumericalFailure);
  EXPECT_LE(s.evaluations, 1);
}

TEST_P(FlowDomain, RefusesAStartOutsideTheDomain) {
  problem_ = log_barrier(Vector::Ones(4));
  x_[1] = -1;
  EXPECT_EQ(integrate().termination, Termination::kNumericalFailure);
}

TEST_P(FlowDomain, RefusesBadOptions) {
  Options options;
  options.tolerance = 0;
  EXPECT_THROW(integrate(options), InvalidInput);
  for (const double bad : {-1.0, kNaN, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(integrate({}, {.step = bad}), InvalidInput);
    EXPECT_THROW(integrate({}, {.relative_error = bad}), InvalidInput);
  }
  x_ = Vector::Ones(3);
  EXPECT_THROW(integrate(), InvalidInput);
}

TEST_P(FlowDomain, StopsAtTheLimits) {
  Options options;
  options.max_iterations = 1;
  const Summary one = integrate(options, {.step = 1e-3});
  EXPECT_EQ(one.termination, Termination::kIterationLimit);
  EXPECT_EQ(one.iterations, 1);
  options = {};
  options.time_limit = 1e-9;
  EXPECT_EQ(integrate(options).termination, Termination::kTimeLimit);
  EXPECT_TRUE(x_.allFinite());
}

TEST_P(FlowDomain, StopsWhenTheObserverAsks) {
  Options options;
  options.observer = [](const Iterate& iterate) { return iterate.iteration < 2; };
  const Summary s = integrate(options, {.step = 1e-3});
  EXPECT_EQ(s.termination, Termination::kInterrupted);
  EXPECT_EQ(s.iterations, 2);
}

TEST_P(FlowDomain, KeepsToAnOpenDomain) {
  problem_ = log_barrier(Vector::Constant(4, 30));
  x_ = Vector::Constant(4, 2.0);
  Options options;
  options.observer = [](const Iterate& iterate) {
    for (const double value : iterate.x) EXPECT_GT(value, 0);
    return true;
  };
  // Longer than the distance to the boundary: has to be cut.
  const Summary s = integrate(options, {.step = 0});
  EXPECT_EQ(s.termination, Termination::kConverged);
  x_ = Vector::Constant(4, 2.0);
  options.max_iterations = 3;
  integrate(options, {.step = 0.5});
  EXPECT_GT(x_.minCoeff(), 0);
}

/// `newton-flow` is not stiff; unstable steps of `scaled` leave the domain and are cut.
class StiffFlow : public FlowDomain {};

TEST_P(StiffFlow, ReportsAnUnstableStep) {
  const Summary s = integrate({}, {.step = 3});
  EXPECT_EQ(s.termination, Termination::kNumericalFailure);
  EXPECT_NE(s.message.find("too long"), std::string::npos);
  EXPECT_TRUE(x_.allFinite());
}

std::string name_of(const ::testing::TestParamInfo<FlowAndStepper>& both) {
  return test_name(both.param);
}

INSTANTIATE_TEST_SUITE_P(Flows, FlowDomain, ::testing::ValuesIn(flows_but({})), name_of);
INSTANTIATE_TEST_SUITE_P(Flows, StiffFlow,
                         ::testing::ValuesIn(flows_but({"newton-flow", "scaled"})), name_of);

}  // namespace
}  // namespace tripus::testing
