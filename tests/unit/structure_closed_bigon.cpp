// Hand-made triangulations of the lemma of docs/theory.md section 5.1.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "structure/closed_bigon.hpp"
#include "structure/solve.hpp"
#include "tests/support/triangulations.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::structure {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Consequence = ClosedBigon::Consequence;

TEST(ClosedBigon, IsAnAnswerOfSolve) {
  const Report report = solve(testing::decode("dLQbcbcaekw"));
  EXPECT_EQ(report.outcome, Outcome::kInfeasible);
  ASSERT_TRUE(report.closed_bigon);
  EXPECT_EQ(*report.closed_bigon, (ClosedBigon{Consequence::kEssentialAnnulus, 1, 0}));
  EXPECT_THAT(report.message, HasSubstr("The manifold is not hyperbolic: an essential annulus"));
  EXPECT_THAT(report.message, Not(HasSubstr("its manifold may")));
  EXPECT_EQ(report.advice, Advice::kNone);
}

TEST(ClosedBigon, IsNotLookedForWithoutEvidence) {
  SolveOptions quick;
  quick.evidence = false;
  EXPECT_FALSE(solve(testing::decode("dLQbcbcaekw"), quick).closed_bigon);
}

TEST(ClosedBigon, LeavesTheVerdictWithConeAnglesAlone) {
  const auto triangulation = testing::decode("dLQbcbcaekw");
  SolveOptions options;
  options.cone_angles.assign(triangulation.edge_count(), {});
  options.cone_angles[0] = topology::parse_cone_order("3");
  EXPECT_FALSE(solve(triangulation, options).closed_bigon);
}

TEST(ClosedBigon, NeedsAnEdgeOfValenceTwo) {
  EXPECT_FALSE(closed_bigon(testing::decode("cPcbbbihq")));
  EXPECT_FALSE(closed_bigon(testing::decode("dLQbcbcmebs")));  // valences 17 and 1
}

TEST(ClosedBigon, SaysNothingOutsideItsDomain) {
  EXPECT_FALSE(closed_bigon(testing::decode("bkaaid")));     // not orientable
  EXPECT_FALSE(closed_bigon(testing::decode("cMcabbgqs")));  // finite vertices
}

}  // namespace
}  // namespace tripus::structure
