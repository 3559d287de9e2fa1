// What proofs claim, against the gluing equations solved in 60 digits: a route that shares no code.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "structure/proof/proof.hpp"
#include "structure/solve.hpp"
#include "studies/detail/algebraic_route.hpp"
#include "tests/support/data_files.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

TEST(ProofsAndTruth, IntervalsContainTheAlgebraicSolution) {
  std::size_t compared = 0;
  for (const auto& [file, step] :
       {std::pair("triangulations-2.txt", 1), std::pair("triangulations-3.txt", 8),
        std::pair("triangulations-4.txt", 170)}) {
    const auto lines = testing::data_lines(file);
    for (std::size_t k = 0; k < lines.size(); k += static_cast<std::size_t>(step)) {
      const topology::Triangulation triangulation(topology::decode_isosig(lines[k]));
      const Report report = solve(triangulation);
      if (report.outcome != Outcome::kGeometric) continue;
      const Proof proof = prove(triangulation, report.edge_lengths);
      ASSERT_TRUE(proof.proved) << lines[k];
      const auto truth = studies::detail::solve_algebraically(triangulation, {});
      if (!truth.found) continue;
      ++compared;
      for (std::size_t e = 0; e < proof.lengths.size(); ++e) {
        // The truth is rounded to a double.
        const double rounding = std::ldexp(truth.lengths[e], -53);
        EXPECT_LE(std::fabs(truth.lengths[e] - proof.lengths[e]), proof.radii[e] + rounding)
            << lines[k];
      }
      const double rounding = std::ldexp(truth.volume, -52);
      EXPECT_LE(proof.volume.lower, truth.volume + rounding) << lines[k];
      EXPECT_GE(proof.volume.upper, truth.volume - rounding) << lines[k];
    }
  }
  EXPECT_GT(compared, 50u);
}

}  // namespace
}  // namespace tripus::structure
