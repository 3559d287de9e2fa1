// Large triangulations are compared by their shortest orthogonal arcs before they are canonized.
#include <gtest/gtest.h>

#include "canonical/compare.hpp"
#include "topology/covers/covers.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

std::vector<topology::Triangulation> covers_of(const char* name, std::size_t degree) {
  std::vector<topology::Triangulation> found;
  topology::for_each_cyclic_cover(
      topology::Triangulation(topology::decode_isosig(name)), degree,
      [&](const topology::Cover& cover) { return found.emplace_back(cover.gluings), true; });
  return found;
}

/// 27 tetrahedra: the arcs are compared first. That they agree decides nothing.
TEST(CanonicalCompareArcs, EqualArcsNeverProveThatManifoldsAreEqual) {
  const auto covers = covers_of("dLQbcbcdhjs", 9);
  ASSERT_FALSE(covers.empty());
  const Comparison comparison = compare(covers[0], covers[0]);
  EXPECT_EQ(comparison.verdict, Verdict::kHomeomorphic);
  EXPECT_EQ(comparison.decided_by, "decomposition");
}

}  // namespace
}  // namespace tripus::canonical
