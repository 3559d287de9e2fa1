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

Enumerated enumerate_all(std::size_t tetrahedra, const EnumerationChoice& choice) {
  Enumerated all;
  for (const auto& piece : enumeration_pieces(tetrahedra, choice)) {
    const auto count =
        enumerate(tetrahedra, choice, piece, [&](const Gluings& gluings, unsigned symmetries) {
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

/// Calls f for all ways to glue the faces of labelled tetrahedra in pairs, orientable or not.
template <class F>
void for_all_gluings(Gluings& gluings, std::size_t first, const F& f) {
  const std::size_t faces = 4 * gluings.tetrahedron_count();
  while (first < faces && gluings.neighbour(first / 4, int(first % 4)) != kNoTetrahedron) ++first;
  if (first == faces) return f(gluings);
  for (std::size_t second = first + 1; second < faces; ++second) {
    if (gluings.neighbour(second / 4, int(second % 4)) != kNoTetrahedron) continue;
    for (int rank = 0; rank < 24; ++rank) {
      const Perm4 p = Perm4::from_rank(rank);
      if (p(int(first % 4)) != int(second % 4)) continue;
      Gluings next = gluings;
      next.glue(first / 4, int(first % 4), TetrahedronIndex(second / 4), p);
      for_all_gluings(next, first + 1, f);
    }
  }
}

// Of one and two tetrahedra nothing is missing: all 108 and 136,080 gluings. The weight of the list
// is their number over that of the relabellings.
TEST(Enumeration, GivesWhatAllGluingsGiveWithoutOrientationToo) {
  std::size_t found = 0;
  for (const std::size_t tetrahedra : {1u, 2u}) {
    struct Known {
      EnumerationChoice choice;
      std::set<std::string> signatures = {};
      double gluings = 0;
    };
    std::vector<Known> all;
    for (const LinkChoice links : {LinkChoice::kGeodesic, LinkChoice::kMixed, LinkChoice::kCusped})
      for (const Orientability orientability :
           {Orientability::kOrientable, Orientability::kNonOrientable, Orientability::kBoth})
        all.push_back({{links, orientability}});
    std::size_t count = 0;
    Gluings empty(tetrahedra);
    for_all_gluings(empty, 0, [&](const Gluings& gluings) {
      ++count;
      try {
        const Triangulation triangulation(gluings);
        if (!triangulation.is_connected()) return;
        for (Known& known : all) {
          if (!is_chosen(triangulation, known.choice)) continue;
          known.signatures.insert(isosig(gluings));
          ++known.gluings;
        }
      } catch (const InvalidInput&) {  // an edge glued to itself the other way round
      }
    });
    EXPECT_EQ(count, tetrahedra == 1 ? 108u : 136080u);
    const double relabellings = tetrahedra == 1 ? 24 : 2 * 24 * 24;
    for (const Known& known : all) {
      const Enumerated list = enumerate_all(tetrahedra, known.choice);
      EXPECT_EQ(sorted(list.signatures),
                std::vector<std::string>(known.signatures.begin(), known.signatures.end()));
      EXPECT_NEAR(list.weight * relabellings, known.gluings, 1e-9 * (1 + known.gluings));
      found +=
          known.choice.orientability == Orientability::kNonOrientable ? list.signatures.size() : 0;
    }
  }
  EXPECT_GT(found, 10u);
}

// The lists of both kinds are the list of all, and the random ones belong to them.
TEST(Enumeration, SplitsByOrientability) {
  std::mt19937_64 random(8);
  for (const LinkChoice links : {LinkChoice::kGeodesic, LinkChoice::kMixed, LinkChoice::kCusped}) {
    auto parts = enumerate_all(3, links).signatures;
    const auto twisted = enumerate_all(3, {links, Orientability::kNonOrientable}).signatures;
    parts.insert(parts.end(), twisted.begin(), twisted.end());
    EXPECT_EQ(sorted(parts), sorted(enumerate_all(3, {links, Orientability::kBoth}).signatures));
    const std::set<std::string> known(twisted.begin(), twisted.end());
    EXPECT_EQ(known.size(), twisted.size());
    for (int n = 0; n < 20; ++n)
      EXPECT_TRUE(known.contains(
          isosig(random_gluings(3, {links, Orientability::kNonOrientable}, random))));
  }
}

TEST(Enumeration, RefusesWhatIsTooLarge) {
  EXPECT_THROW(enumeration_pieces(0, LinkChoice::kGeodesic), InvalidInput);
  EXPECT_THROW(enumeration_pieces(kMaxEnumerated + 1, LinkChoice::kGeodesic), InvalidInput);
}

TEST(Enumeration, DrawingRefusesWhatHasNone) {
  std::mt19937_64 random(1);
  for (const LinkChoice links : {LinkChoice::kGeodesic, LinkChoice::kMixed, LinkChoice::kCusped})
    for (const std::size_t tetrahedra : {1u, 2u, 3u})
      for (const Orientability orientability :
           {Orientability::kOrientable, Orientability::kNonOrientable, Orientability::kBoth}) {
        const EnumerationChoice choice(links, orientability);
        if (enumerate_all(tetrahedra, choice).signatures.empty())
          EXPECT_THROW(random_gluings(tetrahedra, choice, random), InvalidInput);
        else
          EXPECT_TRUE(is_chosen(Triangulation(random_gluings(tetrahedra, choice, random)), choice));
      }
}

}  // namespace
}  // namespace tripus::topology
