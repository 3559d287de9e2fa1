// Law C6 of topology/README.md: whatever moves are made, the manifold stays the same, as far as H1,
// the links, orientability and the homology of its covers with two and three sheets tell.
#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/triangulations.hpp"
#include "topology/covers/cover_homology.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"
#include "topology/simplify/collapse.hpp"
#include "topology/simplify/simplify.hpp"
#include "topology/subdivide.hpp"

namespace tripus::topology {
namespace {

struct Fingerprint {
  std::string homology;
  bool orientable = false;
  std::vector<std::tuple<int, bool>> links;  // Euler characteristic, orientable; no spheres
  CoverHomology double_covers, triple_covers;

  explicit Fingerprint(const Gluings& gluings) {
    const Triangulation triangulation(gluings);
    homology = to_string(first_homology(triangulation));
    orientable = triangulation.is_orientable();
    for (std::size_t v = 0; v < triangulation.vertex_count(); ++v) {
      const VertexLink& link = triangulation.link(v);
      if (link.euler_characteristic != 2)
        links.emplace_back(link.euler_characteristic, link.orientable);
    }
    std::ranges::sort(links);
    double_covers = cover_homology(triangulation, 2);
    triple_covers = cover_homology(triangulation, 3);
  }
  friend auto operator<=>(const Fingerprint&, const Fingerprint&) = default;
};

/// Of all kinds: boundary of genus 2 and 3, cusps, closed, non-orientable; every nth of the lists.
std::vector<std::string> triangulations() {
  std::vector<std::string> found;
  const auto take = [&found](const std::vector<std::string>& lines, std::size_t stride) {
    for (std::size_t i = 0; i < lines.size(); i += stride) found.push_back(lines[i]);
  };
  take(testing::data_lines("triangulations-2.txt"), 1);
  take(testing::data_lines("triangulations-3.txt"), 12);
  take(testing::data_lines("triangulations-4.txt"), 400);
  take(testing::data_lines("triangulations-cusped.txt"), 2);
  std::set<std::string> golden;
  for (const testing::Row& row : testing::data_table("covers-golden.tsv"))
    golden.insert(row.at("isosig"));
  take({golden.begin(), golden.end()}, 2);
  return found;
}

TEST(ManifoldStays, UnderRandomMovesOfEveryKind) {
  const auto kinds = testing::every_kind_of_move();
  std::map<MoveKind, std::size_t> made;
  std::uint64_t seed = 20261122;
  for (const std::string& signature : triangulations()) {
    SCOPED_TRACE(signature + ", seed " + std::to_string(seed));
    Gluings gluings = random_relabelling(decode_isosig(signature), seed);
    const Fingerprint before(gluings);
    for (int round = 0; round < 12; ++round) {
      for (const Move& move :
           randomize(gluings, {.count = 12, .seed = seed++, .kinds = kinds, .max_tetrahedra = 14}))
        ++made[move.kind];
      ASSERT_TRUE(Fingerprint(gluings) == before) << isosig(gluings);
    }
  }
  for (const MoveKind kind : kinds) EXPECT_GE(made[kind], 50u) << info(kind).name;
}

/// Collapses random edges, as often as it says or until few are left to try; returns how many.
std::size_t collapse_at_random(Gluings& gluings, std::size_t most, std::mt19937_64& random) {
  std::size_t made = 0;
  for (int attempt = 0; attempt < 200 && made < most; ++attempt) {
    const auto t = static_cast<TetrahedronIndex>(random() % gluings.tetrahedron_count());
    const auto edge = static_cast<int>(random() % 6);
    try {
      gluings = collapse_edge(gluings, t, edge);
      ++made;
    } catch (const InvalidInput&) {
      // Refused there; elsewhere, then.
    }
  }
  return made;
}

TEST(ManifoldStays, UnderCollapseSubdivisionAndSimplification) {
  const auto kinds = testing::every_kind_of_move();
  std::mt19937_64 random(20261122);
  std::size_t collapses = 0;
  std::size_t smaller = 0;
  for (const std::string& signature : triangulations()) {
    SCOPED_TRACE(signature);
    Gluings gluings = decode_isosig(signature);
    const Fingerprint before(gluings);
    for (int round = 0; round < 3; ++round) {
      randomize(gluings, {.count = 20, .seed = random(), .kinds = kinds, .max_tetrahedra = 12});
      collapses += collapse_at_random(gluings, 4, random);
      ASSERT_TRUE(Fingerprint(gluings) == before) << "collapsed: " << isosig(gluings);
    }
    Gluings fine = barycentric_subdivision(gluings);
    collapses += collapse_at_random(fine, 8, random);
    ASSERT_TRUE(Fingerprint(fine) == before) << "subdivided and collapsed: " << isosig(fine);
    const std::size_t size = fine.tetrahedron_count();
    SimplifyOptions options;
    options.seed = random();
    options.effort = 0.1;
    gluings = simplify(fine, options).gluings;
    smaller += gluings.tetrahedron_count() < size;
    ASSERT_TRUE(Fingerprint(gluings) == before) << "simplified: " << isosig(gluings);
  }
  EXPECT_GT(collapses, 500u);
  EXPECT_EQ(smaller, triangulations().size());
}

// The fingerprint would notice: it tells many manifolds apart that H1 and the boundary do not.
TEST(ManifoldStays, IsSeenByTheHomologyOfCovers) {
  std::set<Fingerprint> all;
  std::set<std::tuple<std::string, std::string>> coarse;
  for (const testing::Row& row : testing::compact_manifolds()) {
    all.insert(Fingerprint(decode_isosig(row.at("isosig"))));
    coarse.emplace(row.at("boundary"), row.at("H1"));
  }
  EXPECT_GE(all.size(), 2 * coarse.size());
}

}  // namespace
}  // namespace tripus::topology
