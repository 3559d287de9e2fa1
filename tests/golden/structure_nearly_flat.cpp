#include <gtest/gtest.h>

#include "base/tolerances.hpp"
#include "structure/solve.hpp"
#include "topology/isosig.hpp"
#include "topology/simplify/small_triangulations.hpp"

// Triangulations of 26 tetrahedra with edges of length 25, found by random 2-3 moves: doubles do
// not tell their flat tetrahedra from nearly flat ones.

namespace tripus::structure {
namespace {

Report solved(const char* signature) {
  return solve(topology::Triangulation(topology::decode_isosig(signature)));
}

TEST(NearlyFlat, CarryTheMetricOfTheirManifold) {
  for (const char* signature :
       {"AvLLvALPLvAPPLQQAQcedgkmljmtmvrwpqtyuvxuvyzxzzccaaqachaaaktbfbauppauepgud",
        "AvLLLLzMPvvQQMzQQPcdghflhonmtpsqupuusxywxwyzzzomqqkfaditngocgwocaippmdjss",
        "ALvPvvvPvLQPLAQQQQcafeoqrtltwpnxrsyzysvuuzwxxznaxggppgaibkapilaeisoosvgnv"}) {
    const Report report = solved(signature);
    ASSERT_EQ(report.outcome, Outcome::kGeometric) << signature;
    EXPECT_TRUE(report.flat_tetrahedra.empty());
    const auto small = topology::small_triangulations(topology::decode_isosig(signature), 1);
    ASSERT_FALSE(small.empty());
    const Report other = solve(topology::Triangulation(small.front()));
    ASSERT_EQ(other.outcome, Outcome::kGeometric);
    // Where doubles just reach max|K| = 1e-12, long edges make that 1e-11 of the volume.
    EXPECT_NEAR(report.volume, other.volume, tolerance::kVolumeAgreement * other.volume);
  }
}

TEST(NearlyFlat, OrAreFlat) {
  for (const auto& [signature, flat] :
       {std::pair{"ALvAvzMzzvMAwAPQQQccdeghhjpqnoqupwuszxxuwzxyyztvanojinmsjqlfdwbanvbbtjqlv", 2},
        std::pair{"AvLLvALPLwAwwQMQPQcedgkmljmnsmnpqsxwuxvyzvwyzzccaaqachmaavbfbappekcikvsqd",
                  4}}) {
    const Report report = solved(signature);
    ASSERT_EQ(report.outcome, Outcome::kDegenerate) << signature;
    EXPECT_EQ(report.flat_tetrahedra.size(), std::size_t(flat));
    EXPECT_LE(report.max_curvature, 1e-30);
    ASSERT_TRUE(report.strict_angles);  // no certificate: the minimum is attained
  }
}

}  // namespace
}  // namespace tripus::structure
