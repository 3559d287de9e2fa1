// Queries of a census in any spelling; what is none is refused and not just not found.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "canonical/census.hpp"
#include "canonical/identify.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::canonical {
namespace {

std::size_t count(const CensusQuery& query) { return select(shipped_census(), query).size(); }

TEST(CensusQueries, AreFreeInTheirSpelling) {
  for (const char* homology : {"2 Z + Z_3", "2Z+Z_3", "Z^2+Z/3", "Z_3 + Z + Z"})
    EXPECT_EQ(count({.homology = homology}), 19u) << homology;
  EXPECT_EQ(count({.homology = "2Z + Z_2 + Z_3"}), 2u);  // Z_6
  for (const char* boundary : {"g3", "G3", " g 3", "3", "genus 3"})
    EXPECT_EQ(count({.boundary = boundary}), 2108u) << boundary;
  EXPECT_EQ(parse_boundary("g3 + g2"), "g2+g3");
  EXPECT_EQ(parse_boundary("3,2"), "g2+g3");
  EXPECT_EQ(parse_boundary("K+n3+torus+genus 2 + T"), "g2+n3+T+T+K");
  for (const char* cells : {"1 octahedron", "octahedron", "1 Octahedra"})
    EXPECT_EQ(count({.cells = cells}), 78u + 2u) << cells;
  EXPECT_EQ(count({.cells = "2 pyramids"}), 4u + 2u);
  EXPECT_EQ(count({.tetrahedra = 2}), 8u + 4u);
  EXPECT_EQ(count({.tetrahedra = 0}), 0u);
  EXPECT_EQ(count({.boundary = "g9"}), 0u);
}

TEST(CensusQueries, ThatAreNoneAreRefused) {
  for (const char* boundary :
       {"banana", "g", "g1", "g0", "g-2", "g2+", "g2.5", "g99999999999999999999", "T3", "n2"})
    EXPECT_THROW(count({.boundary = boundary}), InvalidInput) << boundary;
  for (const char* homology : {"banana", "Z+", "2"})
    EXPECT_THROW(count({.homology = homology}), InvalidInput) << homology;
  for (const char* cells : {"banana", "0 octahedra", "2", "1 octahedron +", "polyhedron"})
    EXPECT_THROW(count({.cells = cells}), InvalidInput) << cells;
  EXPECT_THROW(count({.least_volume = 10, .greatest_volume = 6}), InvalidInput);
  EXPECT_THROW(count({.least_volume = std::numeric_limits<double>::quiet_NaN()}), InvalidInput);
}

TEST(CensusNames, HaveAForm) {
  for (const char* name : {"t3g2.13", "t2g2.1", "t12g2+g3.1", "t1K.1", "t3g2+T.1", "t4T+K+K.1"})
    EXPECT_TRUE(is_census_name(name));
  for (const char* name : {"", "t3g2", "t3g2.", "3g2.1", "t3.1", "t12345", "cPcbbbihq", "t3g2.1x",
                           "t2T", "t2T1.1", "t2X.1", "t2T+.1"})
    EXPECT_FALSE(is_census_name(name)) << name;
}

/// A line as if it had been classified.
CensusLine line_of(const std::string& triangulation, const std::string& signature) {
  CensusLine line;
  line.triangulation = triangulation;
  line.resolved = true;
  line.entry.boundary = "g2";
  line.entry.volume = 10;
  line.entry.signature = signature;
  return line;
}

TEST(CensusNames, BelongToOneManifold) {
  const CensusEntry& shipped = shipped_census().manifolds.at(100);
  const std::string other = "a signature that is not there, with a sign-";
  const Census census = make_census({line_of("eLMkbcdddheipi", other),
                                     line_of(shipped.triangulations.back(), shipped.signature)});
  ASSERT_EQ(census.manifolds.size(), 2u);
  EXPECT_EQ(census.find(shipped.signature)->name, shipped.name);
  EXPECT_EQ(census.find(shipped.signature + "-")->name, shipped.name);
  // The name claims nothing, and is an input.
  EXPECT_EQ(census.find(other)->name, other);
  for (const CensusEntry& entry : census.manifolds) {
    const CensusEntry* same = shipped_census().find(entry.name);
    if (same != nullptr) {
      EXPECT_EQ(same->signature, entry.signature);
    }
  }
}

TEST(CensusTables, KeepWhatIsUnresolved) {
  Census census = make_census({line_of("cPcbbbihq", "cPcbbbihq")});
  census.unresolved = {"dLQbcbcaekw", "dLQbcbcmebs"};
  const Census back = parse_tsv(to_tsv(census));
  EXPECT_EQ(back.unresolved, census.unresolved);
  EXPECT_EQ(back.manifolds, census.manifolds);
  // An annulus is seen in the first; of the second, a handlebody, nothing is.
  EXPECT_THAT(to_tsv(census),
              ::testing::HasSubstr("# unresolved dLQbcbcaekw\tnot hyperbolic: essential annulus\n"
                                   "# unresolved dLQbcbcmebs\n"));
  census.unresolved = {"no signature"};
  EXPECT_EQ(parse_tsv(to_tsv(census)).unresolved, census.unresolved);
}

TEST(CensusTables, SayWhichDigitsAreProved) {
  Census census = make_census({line_of("cPcbbbihq", "cPcbbbihq")});
  census.manifolds[0].volume = 6.5;
  EXPECT_THAT(to_tsv(census), ::testing::Not(::testing::HasSubstr("proved")));
  census.proved_digits = 13;
  const std::string text = to_tsv(census);
  EXPECT_THAT(text, ::testing::HasSubstr("digit 13 after the point"));
  EXPECT_THAT(text, ::testing::HasSubstr("\t6.5000000000000\t"));
  const Census back = parse_tsv(text);
  EXPECT_EQ(back.proved_digits, 13);
  EXPECT_EQ(back.manifolds, census.manifolds);
  for (const auto& [from, to] : {std::pair("digit 13 after", "digit 0 after"),
                                 std::pair("digit 13 after", "digit 99 after"),
                                 std::pair("digit 13 after", "digit x after"),
                                 std::pair("digit 13 after", "digit 12 after")}) {
    std::string wrong = text;
    wrong.replace(wrong.find(from), std::string(from).size(), to);
    EXPECT_THROW(parse_tsv(wrong), InvalidInput) << to;
  }
}

TEST(CensusTables, TheShippedOneHasWhatIsUnresolved) {
  const Census& census = shipped_census();
  EXPECT_EQ(census.unresolved.size(), 4915u);
  for (std::size_t k = 0; k < census.unresolved.size(); k += 500)
    EXPECT_EQ(census.find(census.unresolved[k]), nullptr);
}

TEST(Identification, FindsASimplification) {
  topology::Gluings gluings = topology::decode_isosig("cPcbbbihq");
  topology::randomize(gluings, {.count = 40, .seed = 11});
  const auto found = identify(topology::Triangulation(gluings), shipped_census());
  ASSERT_NE(found.entry, nullptr);
  EXPECT_EQ(found.entry, shipped_census().find("cPcbbbihq"));
  EXPECT_EQ(found.by, IdentifiedBy::kDecomposition);
}

}  // namespace
}  // namespace tripus::canonical
