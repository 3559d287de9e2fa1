// Cusps, cone angles, finite vertices: published volumes and those of other programs.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "geometry/volume.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/frigerio.hpp"
#include "tests/support/orb_examples.hpp"
#include "topology/formats/formats.hpp"
#include "topology/isosig.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::structure {
namespace {

using topology::ConeAngle;
using topology::Triangulation;
using topology::VertexKind;

Triangulation decoded(const std::string& isosig) {
  return Triangulation(topology::decode_isosig(isosig));
}

Report solved(const Triangulation& triangulation, std::vector<ConeAngle> cone_angles = {},
              double start = 0) {
  SolveOptions options;
  options.cone_angles = std::move(cone_angles);
  options.initial_length = start;
  return solve(triangulation, options);
}

void expect_volume(const Report& report, double volume, double within) {
  EXPECT_EQ(report.outcome, Outcome::kGeometric) << report.message;
  EXPECT_LE(report.max_curvature, 1e-12);
  EXPECT_NEAR(report.volume, volume, within);
}

// The figure-eight knot's complement and its sister: two regular ideal tetrahedra, 6
// Lobachevsky(pi/3).
TEST(Cusps, KnownByName) {
  expect_volume(solved(decoded("cPcbbbiht")), 2.0298832128193072500, 1e-13);
  expect_volume(solved(decoded("cPcbbbdxm")), 2.0298832128193072500, 1e-13);
  expect_volume(solved(decoded("bkaaid")), 1.0149416064096536250, 1e-13);  // Gieseking's
  expect_volume(solved(decoded("dLQacccjjkg")), 7.797636880294839658242, 1e-13);
}

// Cone orders 2 on both edges make the torus a hyperideal link; the tetrahedra become the tripus's.
TEST(Cusps, ATorusWithConePointsIsHyperideal) {
  const Triangulation m = decoded("cPcbbbiht");
  const Report report = solved(m, {ConeAngle::rational(1, 1), ConeAngle::rational(1, 1)});
  expect_volume(report, 6.45199027083503286530, 1e-13);
  ASSERT_EQ(report.vertices.size(), 1u);
  EXPECT_EQ(report.vertices[0].kind, VertexKind::kHyperideal);
  EXPECT_DOUBLE_EQ(report.vertices[0].orbifold_euler_characteristic, -2);
  EXPECT_NEAR(report.vertices[0].area, 4 * std::numbers::pi, 1e-12);
}

TEST(Cusps, SnapPysCensusUpToFiveTetrahedraFromTwoStarts) {
  const auto rows = testing::data_table("cusped-census-5.tsv");
  ASSERT_EQ(rows.size(), 415u);
  for (const auto& row : rows) {
    SCOPED_TRACE(row.at("isosig"));
    const Triangulation m = decoded(row.at("isosig"));
    ASSERT_EQ(m.is_orientable(), row.at("orientable") == "yes");
    for (const double start : {0.0, 2.0}) {
      const Report report = solved(m, {}, start);
      expect_volume(report, std::stod(row.at("volume")), 1e-12);
      EXPECT_EQ(std::to_string(report.vertices.size()), row.at("cusps"));
      for (const VertexReport& vertex : report.vertices) {
        EXPECT_EQ(vertex.kind, VertexKind::kIdeal);
        EXPECT_NEAR(vertex.area, std::sqrt(3.0) / 2, 1e-12);
      }
    }
  }
}

// M_{g,k} has the least number of tetrahedra, g + k: all with 3 and 4 of them are in the list, and
// there its volume is the only one that belongs to g = 3, k = 1 and to g = 2, k = 2 (arXiv
// math/0211425: 12 and 1 manifolds).
TEST(Cusps, VolumesOfFrigerioMartelliPetronio) {
  std::map<std::pair<int, int>, double> volume;
  for (const auto& row : testing::data_table("volumes-mgk.tsv"))
    volume[{std::stoi(row.at("g")), std::stoi(row.at("k"))}] = std::stod(row.at("volume"));
  std::map<std::pair<int, int>, int> met;
  for (const std::string& isosig : testing::data_lines("triangulations-cusped.txt")) {
    SCOPED_TRACE(isosig);
    const Triangulation m = decoded(isosig);
    const Report report = solved(m);
    if (report.outcome != Outcome::kGeometric) {
      EXPECT_EQ(report.outcome, Outcome::kInfeasible);
      ASSERT_TRUE(report.certificate);
      EXPECT_TRUE(check(m, *report.certificate)) << check(m, *report.certificate).reason;
      continue;
    }
    int genus = 0, cusps = 0;
    for (const VertexReport& vertex : report.vertices) {
      if (vertex.kind == VertexKind::kIdeal) ++cusps;
      if (vertex.kind == VertexKind::kHyperideal) genus += vertex.genus;
    }
    ++met[{genus, cusps}];
    if (static_cast<std::size_t>(genus + cusps) == m.tetrahedron_count())
      expect_volume(report, volume.at({genus, cusps}), 1e-13);
  }
  EXPECT_EQ((met[{3, 1}]), 12);
  EXPECT_GE((met[{2, 1}]), 18);
  EXPECT_GE((met[{2, 2}]), 1);
}

// Of all (g, k) of the table, however many tetrahedra they take.
TEST(Cusps, VolumesOfFrigerioMartelliPetronioForAnyGenus) {
  std::mt19937_64 random(20261130);
  for (const auto& row : testing::data_table("volumes-mgk.tsv")) {
    const auto g = std::stoul(row.at("g")), k = std::stoul(row.at("k"));
    if (g == k && g % 2 == 1) continue;
    for (int n = 0; n < 3; ++n) {
      const Triangulation m = testing::random_frigerio(g, k, random);
      SCOPED_TRACE(topology::isosig(m.gluings()));
      const Report report = solved(m);
      const double volume = std::stod(row.at("volume"));
      expect_volume(report, volume, std::max(1e-13, 4e-15 * volume));
      std::size_t genus = 0, cusps = 0;
      for (const VertexReport& vertex : report.vertices) {
        if (vertex.kind == VertexKind::kIdeal) ++cusps;
        if (vertex.kind == VertexKind::kHyperideal) genus += static_cast<std::size_t>(vertex.genus);
      }
      EXPECT_EQ(genus, g);
      EXPECT_EQ(cusps, k);
    }
  }
}

TEST(Orbifolds, ExamplesOfOrbThatAreGeometric) {
  int convex = 0, finite = 0;
  for (const auto& row : testing::data_table("orb-examples.tsv")) {
    if (row.at("solution") != "geometric_solution") continue;
    SCOPED_TRACE(row.at("name"));
    const testing::Labelled example = testing::orb_example(row);
    const bool has_finite = row.at("finite_vertices") == "yes";
    const Report report = solved(example.triangulation, example.cone_angles);
    expect_volume(report, std::stod(row.at("volume")), 1e-11);
    ++(has_finite ? finite : convex);
  }
  EXPECT_EQ(convex, 60);
  EXPECT_EQ(finite, 13);
}

// n V(2 pi / (d k)): every triangulation with uniform valence d, order k on every edge.
TEST(Orbifolds, UniformValencesAndOrders) {
  const auto regular = [](double t) {
    // docs/theory.md (27), by Simpson's rule on a fine grid.
    constexpr int kSteps = 4000;
    const auto l = [](double s) { return std::acosh(std::cos(s) / (2 * std::cos(s) - 1)); };
    double sum = 0;
    for (int i = 1; i <= kSteps; ++i) {
      const double a = t * (i - 1) / kSteps, b = t * i / kSteps;
      sum += (l(a) + 4 * l((a + b) / 2) + l(b)) * (b - a) / 6;
    }
    return 3.66386237670887606022 - 3 * sum;
  };
  for (const char* isosig : {"cPcbbbihq", "cPcbbbiht", "bkaaid"}) {
    const Triangulation m = decoded(isosig);
    const auto valence = static_cast<double>(m.valence(0));
    for (int k = 2; k <= 50; ++k) {
      SCOPED_TRACE(std::string(isosig) + " " + std::to_string(k));
      const Report report =
          solved(m, std::vector<ConeAngle>(m.edge_count(), ConeAngle::rational(2, k)));
      expect_volume(report,
                    static_cast<double>(m.tetrahedron_count()) *
                        regular(2 * std::numbers::pi / (valence * k)),
                    1e-9);
    }
  }
}

// The same for every triangulation of the lists that has one valence, by the volume of the regular
// tetrahedron with that angle.
TEST(Orbifolds, EveryUniformValenceOfTheLists) {
  std::vector<std::string> lines;
  for (const char* list : {"triangulations-2.txt", "triangulations-3.txt", "triangulations-4.txt",
                           "triangulations-cusped.txt"})
    for (const std::string& isosig : testing::data_lines(list)) lines.push_back(isosig);
  for (const auto& row : testing::data_table("cusped-census-5.tsv"))
    lines.push_back(row.at("isosig"));
  int uniform = 0;
  for (const std::string& isosig : lines) {
    const Triangulation m = decoded(isosig);
    bool alike = true;
    for (std::size_t e = 1; e < m.edge_count(); ++e) alike = alike && m.valence(e) == m.valence(0);
    if (!alike) continue;
    ++uniform;
    SCOPED_TRACE(isosig);
    for (int k = 2; k <= 50; ++k) {
      const double t = 2 * std::numbers::pi / (static_cast<double>(m.valence(0)) * k);
      const Report report =
          solved(m, std::vector<ConeAngle>(m.edge_count(), ConeAngle::rational(2, k)));
      ASSERT_EQ(report.outcome, Outcome::kGeometric) << k << ": " << report.message;
      ASSERT_NEAR(report.volume,
                  static_cast<double>(m.tetrahedron_count()) *
                      geometry::volume(std::array<double, 6>{t, t, t, t, t, t}),
                  1e-12);
    }
  }
  EXPECT_GT(uniform, 2000);
}

}  // namespace
}  // namespace tripus::structure
