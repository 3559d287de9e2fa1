// Where methods begin: docs/theory.md (117), (118).
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "energies/co_volume.hpp"
#include "structure/starting_lengths.hpp"
#include "tests/support/frigerio.hpp"
#include "topology/components.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::structure {
namespace {

/// Glued at random and orientable, `coned` so that the vertices 0 meet each other only; nothing
/// where a vertex is finite or it is not connected.
std::optional<topology::Triangulation> random_triangulation(std::size_t tetrahedra, bool coned,
                                                            std::mt19937_64& random) {
  using topology::Perm4;
  topology::Gluings gluings(tetrahedra);
  std::vector<std::pair<std::size_t, int>> sides, bases;
  for (std::size_t t = 0; t < tetrahedra; ++t)
    for (int f = 0; f < 4; ++f) (coned && f == 0 ? bases : sides).push_back({t, f});
  for (auto* faces : {&sides, &bases}) {
    std::shuffle(faces->begin(), faces->end(), random);
    for (std::size_t i = 0; i < faces->size(); i += 2) {
      const auto [s, face] = (*faces)[i];
      const auto [t, other] = (*faces)[i + 1];
      Perm4 way;
      do {
        way = Perm4::from_rank(static_cast<int>(random() % 24));
      } while (!way.is_odd() || way(face) != other || (coned && way(0) != 0));
      gluings.glue(s, face, static_cast<topology::TetrahedronIndex>(t), way);
    }
  }
  if (topology::components(gluings).size() > 1) return std::nullopt;
  topology::Triangulation triangulation(gluings);
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).euler_characteristic > 0) return std::nullopt;
  return triangulation;
}

/// Of what the starting lengths speak: tetrahedra by their ideal vertices, and edge classes by
/// their ideal ends.
struct Seen {
  std::array<std::size_t, 5> tetrahedra = {};
  std::vector<std::size_t> ideal_ends;
};

Seen look_at(const topology::Triangulation& triangulation,
             std::span<const topology::ConeAngle> cone_angles) {
  const auto links = topology::orbifold_links(triangulation, cone_angles);
  const auto is_ideal = [&](std::size_t t, int v) {
    return links[triangulation.vertex_class(t, v)].kind == topology::VertexKind::kIdeal;
  };
  Seen seen;
  seen.ideal_ends.resize(triangulation.edge_count());
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    std::size_t ideal = 0;
    for (int v = 0; v < 4; ++v) ideal += is_ideal(t, v);
    ++seen.tetrahedra[ideal];
    for (std::size_t e = 0; e < 6; ++e)
      seen.ideal_ends[triangulation.edge_class(t, static_cast<int>(e))] =
          std::size_t(is_ideal(t, topology::kEdgeEnds[e][0])) +
          std::size_t(is_ideal(t, topology::kEdgeEnds[e][1]));
  }
  return seen;
}

double curvature_sum(const topology::Triangulation& triangulation, const SolveOptions& options,
                     const Seen& seen, std::size_t ideal_ends) {
  const energies::CoVolume energy(triangulation, options.cone_angles);
  const auto at = energy.at(starting_lengths(triangulation, options));
  double sum = 0;
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e)
    if (seen.ideal_ends[e] == ideal_ends) sum += at.gradient()[e];
  return sum;
}

// The kernel, which finds the angles at the start, knows nothing of how it was found.
TEST(StartingLengths, GiveEdgesBetweenHyperidealVerticesTheirMeanAngle) {
  std::mt19937_64 random(1);
  std::array<int, 5> tested = {};
  int without = 0, unreachable = 0;
  for (int n = 0; n < 100000; ++n) {
    const bool coned = n % 2 == 0;
    const std::size_t tetrahedra = coned ? 2 + 2 * (random() % 4) : 2 + random() % 4;
    const auto triangulation = random_triangulation(tetrahedra, coned, random);
    if (!triangulation) continue;
    SolveOptions options;
    if (n % 3 == 0) {
      options.cone_angles.assign(triangulation->edge_count(), topology::ConeAngle());
      options.cone_angles[random() % options.cone_angles.size()] =
          topology::ConeAngle::rational(2, 2 + static_cast<int>(random() % 5));
    }
    const Seen seen = look_at(*triangulation, options.cone_angles);
    if (seen.tetrahedra[4] == tetrahedra) continue;
    const bool between = std::ranges::count(seen.ideal_ends, 0U) > 0;
    double wanted = 0;
    for (std::size_t e = 0; e < triangulation->edge_count(); ++e)
      if (seen.ideal_ends[e] == (between ? 0 : 1))
        wanted +=
            options.cone_angles.empty() ? 2 * std::numbers::pi : options.cone_angles[e].radians();
    const auto [none, one, two, three, four] = seen.tetrahedra;
    const auto corners = double(between ? 6 * none + 3 * one + two : 3 * three);
    if (wanted > 0.999 * corners * std::numbers::pi / 3) {
      ++unreachable;
      continue;
    }
    EXPECT_NEAR(curvature_sum(*triangulation, options, seen, between ? 0 : 1), 0, 1e-9);
    without += !between;
    for (std::size_t k = 0; k < 5; ++k) tested[k] += seen.tetrahedra[k] > 0;
  }
  EXPECT_GT(tested[0], 10000);
  EXPECT_GT(tested[1], 1000);
  EXPECT_GT(tested[2], 10);
  EXPECT_GT(tested[3], 50);
  EXPECT_GT(without, 10);
  EXPECT_LT(unreachable, 1000);
}

// One edge between hyperideal vertices and one to each cusp: nothing is left to do.
TEST(StartingLengths, AreTheMetricOfFrigerioMartelliPetronio) {
  std::mt19937_64 random(2);
  for (const auto& [g, k] :
       {std::pair{2, 0}, {2, 1}, {3, 1}, {3, 2}, {4, 0}, {4, 2}, {4, 3}, {5, 2}}) {
    const auto triangulation = testing::random_frigerio(std::size_t(g), std::size_t(k), random);
    const energies::CoVolume energy(triangulation);
    const auto at = energy.at(starting_lengths(triangulation, {}));
    for (const double curvature : at.gradient()) EXPECT_NEAR(curvature, 0, 1e-12) << g << ", " << k;
  }
}

TEST(StartingLengths, KeepALengthThatIsGiven) {
  std::mt19937_64 random(3);
  const auto triangulation = testing::random_frigerio(3, 1, random);
  for (const double length : {1e-12, 0.3, 2.0, 1e4}) {
    SolveOptions options;
    options.initial_length = length;
    const auto lengths = starting_lengths(triangulation, options);
    EXPECT_EQ(std::ranges::count(lengths, length), 1);
    for (const double l : lengths) EXPECT_TRUE(std::isfinite(l));
  }
}

}  // namespace
}  // namespace tripus::structure
