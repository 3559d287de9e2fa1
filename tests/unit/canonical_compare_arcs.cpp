// Large triangulations are told apart by their shortest orthogonal arcs, before they are canonized.
#include <gtest/gtest.h>

#include "canonical/compare.hpp"
#include "topology/covers/covers.hpp"
#include "topology/homology.hpp"
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

/// 27 tetrahedra each. The 3 covers of one manifold have the arcs of that manifold, each nine
/// times; those of another one have others.
TEST(CanonicalCompareArcs, ArcsDecideBetweenLargeTriangulationsAndNeverProveThemEqual) {
  const auto first = covers_of("dLQbcbcdhjs", 9), second = covers_of("dLQbcbcdhws", 9);
  ASSERT_FALSE(first.empty() || second.empty());
  std::size_t decided = 0;
  for (const auto& a : first) {
    for (const auto& b : second) {
      const bool same_homology = to_string(first_homology(a)) == to_string(first_homology(b));
      if (!same_homology || a.vertex_count() != b.vertex_count()) continue;
      const Comparison comparison = compare(a, b);
      EXPECT_EQ(comparison.verdict, Verdict::kDifferent);
      decided += comparison.decided_by == "orthospectrum";
    }
  }
  EXPECT_GT(decided, 0u);
  EXPECT_NE(compare(first[0], first[0]).decided_by, "orthospectrum");
  EXPECT_EQ(compare(first[0], first[0]).verdict, Verdict::kHomeomorphic);
}

}  // namespace
}  // namespace tripus::canonical
