#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "topology/isosig.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {
namespace {

TEST(Isosig, KnottedYOfThePaper) {
  Gluings y(2);
  y.glue(0, 0, 1, Perm4::from_images(1, 2, 3, 0));
  y.glue(0, 1, 1, Perm4::from_images(3, 0, 1, 2));
  y.glue(0, 2, 1, Perm4::from_images(0, 3, 2, 1));
  y.glue(0, 3, 1, Perm4::from_images(0, 2, 1, 3));
  EXPECT_EQ(isosig(y), "cPcbbbihq");
}

// The labelling of a decoded signature, as `regina-python` 7.3 prints it for cPcbbbihq:
// rows of the gluing table, faces 012 013 023 123.
TEST(Isosig, DecodesWithReginasLabelling) {
  const Gluings y = decode_isosig(" cPcbbbihq\n");
  EXPECT_EQ(y.gluing(0, 3), Perm4::from_images(2, 3, 0, 1));
  EXPECT_EQ(y.gluing(0, 2), Perm4::from_images(1, 0, 3, 2));
  EXPECT_EQ(y.gluing(0, 1), Perm4::from_images(1, 2, 0, 3));
  EXPECT_EQ(y.gluing(0, 0), Perm4());
}

// Signatures made by Regina 7.3 (random gluings of n tetrahedra, `Triangulation3.isoSig()`).
TEST(Isosig, EmptyAndOpenTriangulations) {
  EXPECT_EQ(isosig(Gluings()), "a");
  EXPECT_EQ(isosig(Gluings(1)), "baa");
  EXPECT_EQ(isosig(Gluings(2)), "baabaa");
  EXPECT_EQ(decode_isosig("a").tetrahedron_count(), 0u);
  EXPECT_EQ(decode_isosig("baabaa"), Gluings(2));
}

TEST(Isosig, StopsAtTheWorkLimit) {
  const Gluings y = decode_isosig("cPcbbbihq");
  EXPECT_EQ(isosig(y, 1), std::nullopt);
  EXPECT_EQ(isosig(y, 100000), "cPcbbbihq");
}

TEST(Isosig, CanonicalLabellingLeadsToTheDecodedTable) {
  const Gluings y = decode_isosig("eLAkbccdddprdk");
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Gluings shuffled = random_relabelling(y, seed);
    const CanonicalLabelling canonical = canonical_labelling(shuffled);
    EXPECT_EQ(canonical.signature, "eLAkbccdddprdk");
    EXPECT_EQ(relabelled(shuffled, canonical.isomorphism), y);
  }
}

TEST(Isomorphism, FindsAndListsThem) {
  const Gluings y = decode_isosig("cPcbbbihq");
  const Gluings other = random_relabelling(y, 7);
  const auto found = find_isomorphism(y, other);
  ASSERT_TRUE(found);
  EXPECT_EQ(relabelled(y, *found), other);
  const auto all = all_isomorphisms(y, other);
  EXPECT_EQ(all.size(), all_isomorphisms(y, y).size());
  for (const Isomorphism& each : all) EXPECT_EQ(relabelled(y, each), other);
  EXPECT_FALSE(is_isomorphic(y, decode_isosig("cMcabbjds")));
}

TEST(Isomorphism, MatchesComponentsInAnyOrder) {
  const Gluings a = decode_isosig("cPcbbbihqcMcabbjds");
  const Gluings b = random_relabelling(decode_isosig("cMcabbjdscPcbbbihq"), 3);
  const auto found = find_isomorphism(a, b);
  ASSERT_TRUE(found);
  EXPECT_EQ(relabelled(a, *found), b);
  EXPECT_EQ(isosig(b), "cMcabbjdscPcbbbihq");
  EXPECT_THROW((void)all_isomorphisms(a, b), InvalidInput);
}

}  // namespace
}  // namespace tripus::topology
