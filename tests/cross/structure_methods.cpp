// Every method, every flow and both forms of the energy find the same metric.
#include <gtest/gtest.h>

#include "solver/method.hpp"
#include "structure/method.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/printers.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

class Methods : public ::testing::TestWithParam<std::string> {};

TEST_P(Methods, FindEveryManifoldsMetric) {
  const SolveMethod method = find_solve_method(GetParam(), 1);
  const bool newton = method.minimiser != nullptr && method.minimiser->second_order;
  const double accuracy = newton ? 1e-12 : 1e-8;  // the paper's bar for its flow
  for (const auto& row : testing::compact_manifolds()) {
    SCOPED_TRACE(row.at("isosig"));
    const topology::Triangulation manifold(topology::decode_isosig(row.at("isosig")));
    SolveOptions options;
    options.method = GetParam();
    options.initial_length = 1;  // the paper's start, far from the default one
    const Report report = solve(manifold, options);
    ASSERT_EQ(report.outcome, Outcome::kGeometric) << report.message;
    EXPECT_NEAR(report.volume, std::stod(row.at("volume")), accuracy);
    const auto lengths = testing::split(row.at("edge_lengths"), '|');
    for (std::size_t e = 0; e < lengths.size(); ++e)
      EXPECT_NEAR(report.edge_lengths[e], std::stod(lengths[e]), accuracy);
  }
}

std::string name_of(const ::testing::TestParamInfo<std::string>& method) {
  return testing::test_name(method.param);
}

INSTANTIATE_TEST_SUITE_P(All, Methods, ::testing::ValuesIn(solve_method_names()), name_of);

}  // namespace
}  // namespace tripus::structure
