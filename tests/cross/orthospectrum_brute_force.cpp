// Unfolding against all pairs of boundary planes among the cells of the universal cover: no
// windows, no pruning, no rule for ties. In full: scripts/orthospectra.
#include <gtest/gtest.h>

#include "tests/support/spectra.hpp"

namespace tripus::orthospectrum {
namespace {

void expect_same(const std::string& name, double length) {
  const auto manifold = testing::try_embed(name);
  ASSERT_TRUE(manifold) << name;
  const auto expected = testing::counted_by_length(testing::brute_force_arcs(*manifold, length));
  const auto found = testing::counted_by_length(
      testing::spectrum_of(manifold->triangulation, manifold->report, length));
  ASSERT_EQ(found.size(), expected.size()) << name;
  for (std::size_t n = 0; n < found.size(); ++n) {
    EXPECT_NEAR(found[n].length, expected[n].length, 1e-7) << name;
    EXPECT_NEAR(found[n].count, expected[n].count, 1e-9) << name << " at " << found[n].length;
  }
}

TEST(OrthospectrumBruteForce, FindsTheSameArcs) {
  // Symmetric, with edges of several lengths, genus 3 and 4, non-orientable.
  for (const char* name : {"cPcbbbihq", "dLQbcbcdhjw", "dLQbccchrqg", "dLQabccjjks"})
    expect_same(name, 3.6);
  expect_same("eLAkbbcdddujdj", 3.3);
}

}  // namespace
}  // namespace tripus::orthospectrum
