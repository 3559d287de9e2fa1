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

/// Cyclic covers with seven sheets of t4g3.1539 and t4g3.1596: volume, boundary and first homology
/// agree. Canonical decompositions, the other route, say the same.
TEST(CanonicalCompareArcs, DifferentArcsDecide) {
  const topology::Triangulation first(topology::decode_isosig(
      "CvvLvLLvALPwLAQQQQQkgkoplmnpsyvywurBAxvtzBvzAzxABdlsprjfdtmeatnwbknwbfvvjgwcws"));
  const topology::Triangulation second(topology::decode_isosig(
      "CLvvLvvPMLQAPvAQQQMkbiroomlssrlpwvyyzwAxAvvzxzBBBlaliitdiuudldaimaahedaieiappa"));
  const Comparison comparison = compare(first, second);
  EXPECT_EQ(comparison.verdict, Verdict::kDifferent);
  EXPECT_EQ(comparison.decided_by, "orthospectrum");
  const CanonizeAnswer a = canonize(first), b = canonize(second);
  ASSERT_TRUE(a.manifold && b.manifold);
  EXPECT_NEAR(a.manifold->report.volume, b.manifold->report.volume, 1e-9);
  EXPECT_NE(a.manifold->signature.unoriented, b.manifold->signature.unoriented);
}

}  // namespace
}  // namespace tripus::canonical
