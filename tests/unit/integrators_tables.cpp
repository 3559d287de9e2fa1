#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "integrators/integrate.hpp"

namespace tripus::integrators {
namespace {

TEST(IntegratorsTables, NamesAreUniqueAndFound) {
  std::set<std::string_view> names;
  for (const Flow& flow : flows()) {
    EXPECT_TRUE(names.insert(flow.name).second) << flow.name;
    EXPECT_EQ(find_flow(flow.name), &flow);
    EXPECT_FALSE(flow.description.empty());
  }
  for (const Stepper& stepper : steppers()) {
    EXPECT_TRUE(names.insert(stepper.name).second) << stepper.name;
    EXPECT_EQ(find_stepper(stepper.name), &stepper);
  }
  EXPECT_EQ(find_flow("no such flow"), nullptr);
  EXPECT_EQ(find_stepper(""), nullptr);
}

TEST(IntegratorsTables, ParsesFlowMethods) {
  const auto both = parse_flow_method("flow:curvature/rk4");
  ASSERT_TRUE(both.has_value());
  EXPECT_EQ(both->first->name, "curvature");
  EXPECT_EQ(both->second->name, "rk4");
  const auto defaulted = parse_flow_method("flow:calabi");
  ASSERT_TRUE(defaulted.has_value());
  EXPECT_EQ(defaulted->second->name, "dopri5");
  for (const char* bad : {"", "newton", "flow:", "flow:/rk4", "flow:curvature/", "flow:curvature/x",
                          "flow:x/rk4", "curvature/rk4", "flow:curvature/rk4/"}) {
    EXPECT_FALSE(parse_flow_method(bad).has_value()) << bad;
  }
}

/// The stability limit in the table is that of dx/dt = -x: a step just below it contracts, one just
/// above it does not.
TEST(IntegratorsTables, StabilityLimitsAreSharp) {
  const Rhs decay = [](const State& x, State& v) { v = {-x[0]}; };
  for (const Stepper& stepper : steppers()) {
    const auto method = stepper.make(1);
    const auto factor = [&](double dt) {
      State x{1}, v{-1}, new_x(1), new_v(1), error(1);
      method->step(decay, x, v, dt, new_x, new_v, error);
      EXPECT_DOUBLE_EQ(new_v[0], -new_x[0]);
      return std::abs(new_x[0]);
    };
    EXPECT_LE(factor(stepper.stability), 1) << stepper.name;
    EXPECT_GT(factor(1.01 * stepper.stability), 1) << stepper.name;
  }
}

}  // namespace
}  // namespace tripus::integrators
