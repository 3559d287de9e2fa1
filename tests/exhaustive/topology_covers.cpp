// Laws C2 to C6 of topology/README.md over all manifolds with two and three tetrahedra.
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "topology/covers/cover_homology.hpp"
#include "topology/covers/covers.hpp"
#include "topology/covers/cyclic_classes.hpp"
#include "topology/isosig.hpp"

namespace tripus::topology {
namespace {

using Signatures = std::map<std::string, int>;  // with the number of covers
using Permutation = std::vector<std::uint32_t>;
using Images = std::vector<Permutation>;

Triangulation manifold(const testing::Row& row) {
  return Triangulation(decode_isosig(row.at("isosig")));
}

std::vector<Permutation> permutations(std::size_t degree) {
  Permutation p(degree);
  for (std::uint32_t k = 0; k < degree; ++k) p[k] = k;
  std::vector<Permutation> all;
  do all.push_back(p);
  while (std::next_permutation(p.begin(), p.end()));
  return all;
}

std::uint32_t image(const Images& images, Letter letter, std::uint32_t k) {
  const Permutation& p = images[generator_of(letter)];
  if (letter > 0) return p[k];
  return static_cast<std::uint32_t>(std::ranges::find(p, k) - p.begin());
}

bool satisfies(const Images& images, const Presentation& group) {
  for (const Word& relator : group.relators)
    for (std::uint32_t k = 0; k < images[0].size(); ++k) {
      std::uint32_t at = k;
      for (const Letter letter : relator) at = image(images, letter, at);
      if (at != k) return false;
    }
  return true;
}

bool is_transitive(const Images& images) {
  std::set<std::uint32_t> met{0};
  for (std::size_t before = 0; before != met.size();) {
    before = met.size();
    for (const std::uint32_t k : std::set(met))
      for (const Permutation& p : images) met.insert(p[k]);
  }
  return met.size() == images[0].size();
}

/// The least of the tables that other numbers of the sheets give.
Images least_conjugate(const Images& images, const std::vector<Permutation>& all) {
  Images least = images;
  for (const Permutation& number : all) {
    Images renumbered = images;
    for (std::size_t g = 0; g < images.size(); ++g)
      for (std::size_t k = 0; k < number.size(); ++k)
        renumbered[g][number[k]] = number[images[g][k]];
    least = std::min(least, renumbered);
  }
  return least;
}

/// All permutations at all generators, with the full presentation.
Signatures covers_by_force(const Triangulation& base, std::size_t degree) {
  const FundamentalGroup group = fundamental_group(base);
  const auto all = permutations(degree);
  const std::size_t generators = group.presentation.generator_count;
  std::size_t cases = 1;
  for (std::size_t g = 0; g < generators; ++g) cases *= all.size();
  std::set<Images> found;
  for (std::size_t code = 0; code < cases; ++code) {
    Images images(generators);
    std::size_t rest = code;
    for (Permutation& p : images) {
      p = all[rest % all.size()];
      rest /= all.size();
    }
    if (is_transitive(images) && satisfies(images, group.presentation))
      found.insert(least_conjugate(images, all));
  }
  Signatures signatures;
  for (const Images& images : found)
    ++signatures[isosig(cover_of_action(base.gluings(), group, {degree, images, 1}))];
  return signatures;
}

Signatures covers_by_search(const Triangulation& base, std::size_t degree) {
  Signatures signatures;
  for_each_cover(base, degree,
                 [&](const Cover& cover) { return ++signatures[isosig(cover.gluings)] > 0; });
  return signatures;
}

TEST(CoversOfManifolds, AreThoseFoundByForce) {
  for (const testing::Row& row : testing::compact_manifolds()) {
    const Triangulation base = manifold(row);
    for (const std::size_t degree : {2u, 3u})
      EXPECT_EQ(covers_by_search(base, degree), covers_by_force(base, degree))
          << row.at("isosig") << ", degree " << degree;
  }
}

TEST(CoversOfManifolds, CyclicOnesAreAmongThem) {
  for (const testing::Row& row : testing::compact_manifolds()) {
    SCOPED_TRACE(row.at("isosig"));
    const Triangulation base = manifold(row);
    for (std::size_t degree = 2; degree <= 5; ++degree) {
      if (degree == 5 && row.at("boundary") != "g2") continue;  // some 10^5 covers
      Signatures regular;
      for_each_cover(base, degree, [&](const Cover& cover) {
        if (cover.is_regular()) ++regular[isosig(cover.gluings)];
        return true;
      });
      Signatures cyclic;
      for_each_cyclic_cover(
          base, degree, [&](const Cover& cover) { return ++cyclic[isosig(cover.gluings)] > 0; });
      ASSERT_FALSE(cyclic.empty());
      if (degree != 4) {  // a group of prime order is cyclic
        EXPECT_EQ(cyclic, regular) << degree;
        continue;
      }
      for (const auto& [signature, count] : cyclic) EXPECT_LE(count, regular[signature]);
    }
  }
}

std::map<std::size_t, std::size_t> valences(const Triangulation& triangulation,
                                            std::size_t copies) {
  std::map<std::size_t, std::size_t> result;
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e)
    result[triangulation.valence(e)] += copies;
  return result;
}

int euler_characteristic(const Triangulation& triangulation) {
  int sum = 0;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    sum += triangulation.link(v).euler_characteristic;
  return sum;
}

TEST(CoversOfManifolds, MultiplyWhatIsLocal) {
  for (const testing::Row& row : testing::compact_manifolds()) {
    SCOPED_TRACE(row.at("isosig"));
    const Triangulation base = manifold(row);
    for (std::size_t degree = 1; degree <= 4; ++degree) {
      const auto scale = static_cast<int>(degree);
      CoverHomology homology;
      for_each_cover(base, degree, [&](const Cover& cover) {
        const Triangulation above(cover.gluings);
        EXPECT_TRUE(above.is_connected());
        EXPECT_EQ(above.tetrahedron_count(), degree * base.tetrahedron_count());
        EXPECT_EQ(valences(above, 1), valences(base, degree));
        EXPECT_EQ(euler_characteristic(above), scale * euler_characteristic(base));
        // Half of the boundary's homology lives on: at least its genus in all.
        const AbelianGroup above_homology = first_homology(above);
        const auto components = static_cast<int>(above.vertex_count());
        EXPECT_GE(2 * static_cast<int>(above_homology.rank),
                  2 * components - euler_characteristic(above));
        ++homology[to_string(above_homology)];
        return true;
      });
      // From the triangulations and from the presentation of the group.
      EXPECT_EQ(homology, cover_homology(base, degree)) << degree;
    }
  }
}

// From a random start, so that the answer is not just carried over.
TEST(CoversOfManifolds, MultiplyTheVolume) {
  std::mt19937_64 random(20261122);
  std::uniform_real_distribution<double> length(0.3, 1.2);
  std::size_t solved = 0;
  for (const testing::Row& row : testing::compact_manifolds()) {
    SCOPED_TRACE(row.at("isosig"));
    const Triangulation base = manifold(row);
    const double volume = std::stod(row.at("volume"));
    for (std::size_t degree = 2; degree <= 4; ++degree) {
      for_each_cover(base, degree, [&](const Cover& cover) {
        const Triangulation above(cover.gluings);
        structure::SolveOptions options;
        options.initial_lengths.resize(above.edge_count());
        for (double& x : options.initial_lengths) x = length(random);
        const structure::Report report = structure::solve(above, options);
        EXPECT_EQ(report.outcome, structure::Outcome::kGeometric);
        const double expected = static_cast<double>(degree) * volume;
        EXPECT_NEAR(report.volume, expected, 1e-9 * expected);
        return ++solved > 0;
      });
    }
  }
  EXPECT_GT(solved, 10'000u);
}

}  // namespace
}  // namespace tripus::topology
