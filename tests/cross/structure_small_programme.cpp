// The programme of few tetrahedra, in whole numbers, against GLPK's exact simplex method and
// against Newton's method run to its end.
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "structure/detail/angle_programme.hpp"
#include "structure/detail/existence_routes.hpp"
#include "structure/detail/small_decision.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

/// Every triangulation of the lists; of four tetrahedra every 5th.
template <class Visit>
void for_each_listed(const Visit& visit) {
  std::uint64_t number = 0;
  for (const char* list : {"triangulations-2.txt", "triangulations-3.txt", "triangulations-4.txt"})
    for (const std::string& signature : tripus::testing::data_lines(list)) {
      const bool is_four = signature.front() == 'e';
      if (++number % 5 != 0 && is_four) continue;
      SCOPED_TRACE(signature);
      visit(topology::Triangulation(
          topology::random_relabelling(topology::decode_isosig(signature), number)));
    }
}

TEST(SmallProgramme, DecidesAsTheExactSimplexMethod) {
  for_each_listed([](const topology::Triangulation& triangulation) {
    detail::AngleProgramme programme(triangulation);
    ASSERT_TRUE(programme.solve_exactly());
    const auto expected = detail::by_exact_basis(triangulation, programme);
    ASSERT_TRUE(expected);
    const auto found = detail::decide_small(triangulation, {});
    ASSERT_TRUE(found);
    const auto* certificate = std::get_if<Certificate>(&*expected);
    ASSERT_EQ(found->certificate.has_value(), certificate != nullptr);
    if (certificate == nullptr) return;
    EXPECT_EQ(found->certificate->kind, certificate->kind);
    EXPECT_TRUE(check(triangulation, *found->certificate));
  });
}

TEST(SmallProgramme, ItsAnglesAreTheOptimum) {
  for_each_listed([](const topology::Triangulation& triangulation) {
    detail::SmallProgramme programme(triangulation);
    ASSERT_TRUE(programme.solve());
    const auto one = programme.denominator();
    std::vector<std::int64_t> edge_sum(triangulation.edge_count());
    std::int64_t greatest = 0;
    const auto angles = programme.angles();
    for (std::size_t t = 0; t < angles.size(); ++t) {
      std::array<std::int64_t, 4> vertex_sum{};
      for (std::size_t e = 0; e < 6; ++e) {
        ASSERT_GE(angles[t][e], 0);
        edge_sum[triangulation.edge_class(t, static_cast<int>(e))] += angles[t][e];
        for (const int v : topology::kEdgeEnds[e])
          vertex_sum[static_cast<std::size_t>(v)] += angles[t][e];
      }
      for (const auto sum : vertex_sum) greatest = std::max(greatest, sum);
    }
    for (const auto sum : edge_sum) ASSERT_EQ(sum, 2 * one);
    EXPECT_EQ((greatest > one) - (greatest < one), programme.sign());
    // Duality: no other angles have smaller sums.
    std::int64_t bound = 0, weight = 0;
    const auto w = programme.vertex_multipliers();
    for (const auto& four : w)
      for (const auto each : four) {
        ASSERT_GE(each, 0);
        weight += each;
      }
    for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
      std::int64_t least = weight;
      for (const auto corner : triangulation.corners(e)) {
        const auto& ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
        least = std::min(least, w[corner.tetrahedron()][static_cast<std::size_t>(ends[0])] +
                                    w[corner.tetrahedron()][static_cast<std::size_t>(ends[1])]);
      }
      bound += 2 * least;
    }
    EXPECT_EQ(bound * one, greatest * weight);
  });
}

// Newton's method with limits of its own is not cut short by the quick decision.
TEST(SmallProgramme, RulesOutNoMinimiserThatNewtonFinds) {
  std::size_t degenerate = 0, ruled_out = 0;
  for_each_listed([&](const topology::Triangulation& triangulation) {
    const auto decided = detail::decide_small(triangulation, {});
    ASSERT_TRUE(decided);
    if (!decided->certificate) return;
    SolveOptions slow;
    slow.max_iterations = 100;
    const Report report = solve(triangulation, slow);
    EXPECT_NE(report.outcome, Outcome::kGeometric);
    ruled_out += !decided->may_be_degenerate;
    if (report.outcome != Outcome::kDegenerate) return;
    ++degenerate;
    EXPECT_TRUE(decided->may_be_degenerate);
  });
  EXPECT_GT(degenerate, 30u);
  EXPECT_GT(ruled_out, 800u);
}

TEST(SmallProgramme, LeavesOthersToOthers) {
  const topology::Triangulation cusp(topology::decode_isosig("cPcbbbiht"));
  EXPECT_FALSE(detail::decide_small(cusp, {}));
  const topology::Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  EXPECT_TRUE(detail::decide_small(tripus, {}));
  EXPECT_FALSE(detail::decide_small(tripus, std::vector{topology::parse_cone_order("3")}));
}

}  // namespace
}  // namespace tripus::structure
