// The enumeration against the lists, which were made by other means, and against a count of all
// gluings by Burnside's lemma in reverse: labelled gluings = sum over classes of relabellings /
// symmetries.
#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/support/data_files.hpp"
#include "topology/enumerate.hpp"
#include "topology/isosig.hpp"
#include "topology/random_gluings.hpp"

namespace tripus::topology {
namespace {

using tripus::testing::data_lines;

struct Enumerated {
  std::vector<std::string> signatures;
  double weight = 0;  ///< sum of 1 / symmetries
};

Enumerated enumerate_all(std::size_t tetrahedra, LinkChoice links) {
  Enumerated all;
  for (const auto& piece : enumeration_pieces(tetrahedra, links)) {
    const auto count =
        enumerate(tetrahedra, links, piece, [&](const Gluings& gluings, unsigned symmetries) {
          all.signatures.push_back(isosig(gluings));
          all.weight += 1.0 / symmetries;
        });
    EXPECT_LE(count, all.signatures.size());
  }
  return all;
}

std::vector<std::string> sorted(std::vector<std::string> lines) {
  std::ranges::sort(lines);
  return lines;
}

TEST(Enumeration, GivesExactlyTheLists) {
  EXPECT_TRUE(enumerate_all(1, LinkChoice::kGeodesic).signatures.empty());
  for (const std::size_t tetrahedra : {2u, 3u, 4u})
    EXPECT_EQ(sorted(enumerate_all(tetrahedra, LinkChoice::kGeodesic).signatures),
              sorted(data_lines("triangulations-" + std::to_string(tetrahedra) + ".txt")));
}

TEST(Enumeration, GivesExactlyTheListWithCusps) {
  std::vector<std::string> mixed = enumerate_all(3, LinkChoice::kMixed).signatures;
  for (auto& each : enumerate_all(4, LinkChoice::kMixed).signatures) mixed.push_back(each);
  EXPECT_EQ(sorted(mixed), sorted(data_lines("triangulations-cusped.txt")));
}

// No two are isomorphic, and all links are as asked for.
TEST(Enumeration, OfCuspsIsFreeOfRepetitions) {
  for (const std::size_t tetrahedra : {1u, 2u, 3u, 4u}) {
    const auto all = sorted(enumerate_all(tetrahedra, LinkChoice::kCusped).signatures);
    EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size());
    for (const std::string& each : all)
      EXPECT_TRUE(has_links(Triangulation(decode_isosig(each)), LinkChoice::kCusped)) << each;
    EXPECT_FALSE(tetrahedra >= 2 && all.empty());
  }
}

// The mean of a random gluing's chance to be wanted, by drawing, is the weight of the list times
// the relabellings over all gluings: 24^T T! / 2^... of oriented tables.
TEST(Enumeration, AgreesWithDrawing) {
  std::mt19937_64 random(5);
  for (const std::size_t tetrahedra : {2u, 3u, 4u}) {
    std::size_t draws = 0, hits = 20000;
    for (std::size_t k = 0; k < hits; ++k)
      random_gluings(tetrahedra, LinkChoice::kGeodesic, random, &draws);
    // Oriented tables: (4T - 1)!! pairings, three gluings a pair. A class has T! 12^T labellings of
    // each orientation, divided by its symmetries.
    double tables = std::pow(3.0, 2.0 * static_cast<double>(tetrahedra)), labellings = 2;
    for (std::size_t k = 4 * tetrahedra - 1; k > 1; k -= 2) tables *= static_cast<double>(k);
    for (std::size_t k = 1; k <= tetrahedra; ++k) labellings *= 12 * static_cast<double>(k);
    const double expected =
        enumerate_all(tetrahedra, LinkChoice::kGeodesic).weight * labellings / tables;
    const double found = static_cast<double>(hits) / static_cast<double>(draws);
    // Five standard deviations.
    EXPECT_NEAR(found, expected, 5 * expected / std::sqrt(static_cast<double>(hits))) << tetrahedra;
  }
}

TEST(Enumeration, RefusesWhatIsTooLarge) {
  EXPECT_THROW(enumeration_pieces(0, LinkChoice::kGeodesic), InvalidInput);
  EXPECT_THROW(enumeration_pieces(kMaxEnumerated + 1, LinkChoice::kGeodesic), InvalidInput);
}

TEST(Enumeration, DrawingRefusesWhatHasNone) {
  std::mt19937_64 random(1);
  for (const LinkChoice links : {LinkChoice::kGeodesic, LinkChoice::kMixed, LinkChoice::kCusped})
    for (const std::size_t tetrahedra : {1u, 2u, 3u}) {
      if (enumerate_all(tetrahedra, links).signatures.empty())
        EXPECT_THROW(random_gluings(tetrahedra, links, random), InvalidInput);
      else
        EXPECT_TRUE(has_links(Triangulation(random_gluings(tetrahedra, links, random)), links));
    }
}

}  // namespace
}  // namespace tripus::topology
