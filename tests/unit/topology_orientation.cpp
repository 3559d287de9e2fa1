// Signatures with a sign: they keep the orientation, and nothing else changes them.
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/support/data_files.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"
#include "topology/orientation.hpp"
#include "topology/simplify/small_triangulations.hpp"

namespace tripus::topology {
namespace {

std::vector<std::string> some_signatures() {
  std::vector<std::string> result = tripus::testing::data_lines("triangulations-2.txt");
  for (const auto& line : tripus::testing::data_lines("triangulations-3.txt"))
    result.push_back(line);
  const auto four = tripus::testing::data_lines("triangulations-4.txt");
  for (std::size_t k = 0; k < four.size(); k += 101) result.push_back(four[k]);
  return result;
}

/// Labels of a random order in which every tetrahedron is relabelled by even, or by odd,
/// permutations.
Gluings relabelled_with_parity(const Gluings& gluings, bool odd, std::uint64_t seed) {
  Isomorphism isomorphism = random_isomorphism(gluings.tetrahedron_count(), seed);
  constexpr Perm4 kSwap = Perm4::from_images(1, 0, 2, 3);
  for (Perm4& perm : isomorphism.perms)
    if (perm.is_odd() != odd) perm = perm * kSwap;
  return relabelled(gluings, isomorphism);
}

/// By definition: an isomorphism of oriented tables keeps the orientation if its permutations are
/// even.
bool is_oriented_isomorphic(const Gluings& a, const Gluings& b, bool reversing) {
  for (const Isomorphism& each : all_isomorphisms(oriented(a), oriented(b)))
    if (each.perms.front().is_odd() == reversing) return true;
  return false;
}

TEST(SignedSignatures, MeanWhatTheySay) {
  std::size_t amphicheiral = 0, minus = 0;
  std::uint64_t seed = 0;
  for (const std::string& line : some_signatures()) {
    SCOPED_TRACE(line);
    const Gluings plain = decode_isosig(line);
    ASSERT_TRUE(is_orientable(plain));
    for (int trial = 0; trial < 3; ++trial) {
      const Gluings gluings = random_relabelling(plain, ++seed);
      const Isosig signature = full_isosig(gluings);
      EXPECT_EQ(signature.isosig, isosig(gluings));
      const bool same = is_oriented_isomorphic(plain, gluings, false);
      const bool reversed = is_oriented_isomorphic(plain, gluings, true);
      EXPECT_EQ(signature.is_amphicheiral, same && reversed);
      EXPECT_EQ(signature.sign, same ? '+' : '-');
      minus += signature.sign == '-';
      amphicheiral += signature.is_amphicheiral;
      const Gluings back = decode_isosig(signature.oriented());
      EXPECT_TRUE(is_oriented_isomorphic(gluings, back, false));
      EXPECT_EQ(back, oriented(back));
      EXPECT_EQ(full_isosig(back).oriented(), signature.oriented());
    }
  }
  EXPECT_GT(minus, 100u);
  EXPECT_GT(amphicheiral, 5u);
}

TEST(SignedSignatures, DependOnTheOrientationAlone) {
  for (const std::string& line : some_signatures()) {
    SCOPED_TRACE(line);
    const Gluings gluings = oriented(decode_isosig(line));
    const Isosig signature = full_isosig(gluings);
    const Isosig mirror = full_isosig(mirrored(gluings));
    EXPECT_EQ(signature.oriented() == mirror.oriented(), signature.is_amphicheiral);
    EXPECT_EQ(full_isosig(relabelled_with_parity(gluings, false, 5)).oriented(),
              signature.oriented());
    EXPECT_EQ(full_isosig(relabelled_with_parity(gluings, true, 6)).oriented(), mirror.oriented());
  }
}

TEST(SignedSignatures, OfLargeTriangulations) {
  // Symmetric ones, where frames are skipped, and others.
  Gluings walked = oriented(decode_isosig("cPcbbbihq"));
  randomize(walked, {.count = 60, .seed = 3});
  ASSERT_GT(walked.tetrahedron_count(), 24u);
  const Isosig signature = full_isosig(walked);
  EXPECT_EQ(full_isosig(relabelled_with_parity(walked, false, 1)).oriented(), signature.oriented());
  EXPECT_EQ(full_isosig(relabelled_with_parity(walked, true, 2)).oriented(),
            signature.isosig + (signature.sign == '+' ? '-' : '+'));
  EXPECT_EQ(oriented(walked), walked);
}

TEST(SignedSignatures, AreReadAndRefused) {
  EXPECT_EQ(isosig_sign(" cPcbbbihq+\n"), '+');
  EXPECT_EQ(isosig_sign("cPcbbbihq-"), '-');
  EXPECT_EQ(isosig_sign("cPcbbbihq"), '\0');
  EXPECT_EQ(isosig_sign("+"), '\0');
  EXPECT_EQ(without_sign(" cPcbbbihq- "), "cPcbbbihq");
  EXPECT_EQ(isosig(decode_isosig("cPcbbbihq-")), "cPcbbbihq");
  const auto message = [](const char* text) -> std::string {
    try {
      decode_isosig(text);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(message("bkaaid+"), ::testing::HasSubstr("not orientable"));  // Gieseking
  EXPECT_THAT(message("cPcbbbihqcPcbbbihq+"), ::testing::HasSubstr("several components"));
  EXPECT_EQ(full_isosig(decode_isosig("bkaaid")).oriented(), "bkaaid");
  EXPECT_EQ(full_isosig(decode_isosig("cPcbbbihqcPcbbbihq")).sign, '\0');
}

TEST(SmallTriangulations, KeepTheOrientation) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Gluings walked = oriented(decode_isosig("cPcbbbihq-"));
    randomize(walked, {.count = 30, .seed = seed});
    const auto small = small_triangulations(walked, 2);
    ASSERT_FALSE(small.empty());
    EXPECT_EQ(full_isosig(small.front()).oriented(), "cPcbbbihq-");
  }
}

}  // namespace
}  // namespace tripus::topology
