// Isometry groups of the eight manifolds with two tetrahedra, and the margins of the signs.
#include <gtest/gtest.h>

#include "canonical/canonize.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

struct Known {
  const char* isosig;
  std::size_t keeping, reversing;
};

class TwoTetrahedra : public ::testing::TestWithParam<Known> {};

// All cells are tetrahedra, so that the group is that of the relabellings: a second route.
TEST_P(TwoTetrahedra, HaveTheKnownIsometryGroups) {
  const auto [isosig, keeping, reversing] = GetParam();
  const topology::Triangulation triangulation(topology::decode_isosig(isosig));
  const auto answer = canonize(triangulation);
  ASSERT_TRUE(answer.manifold);
  const IsometryGroup& group = answer.manifold->isometries;
  EXPECT_EQ(group.orientation_preserving, keeping);
  EXPECT_EQ(group.order - group.orientation_preserving, reversing);
  EXPECT_EQ(group.is_amphicheiral, reversing > 0);
  EXPECT_EQ(answer.manifold->signature.unoriented, isosig);
  EXPECT_EQ(topology::all_isomorphisms(triangulation.gluings(), triangulation.gluings()).size(),
            group.order);
}

INSTANTIATE_TEST_SUITE_P(Isometries, TwoTetrahedra,
                         ::testing::Values(Known{"cMcabbjdw", 1, 1}, Known{"cMcabbjij", 1, 0},
                                           Known{"cMcabbjds", 2, 0}, Known{"cMcabbjik", 2, 0},
                                           Known{"cMcabbjmk", 2, 0}, Known{"cPcbbbdht", 2, 0},
                                           Known{"cPcbbbdhq", 6, 0}, Known{"cPcbbbihq", 6, 0}),
                         [](const auto& known) { return std::string(known.param.isosig); });

}  // namespace
}  // namespace tripus::canonical
