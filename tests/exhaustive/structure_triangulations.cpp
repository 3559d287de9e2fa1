// Every triangulation of the lists: geometric exactly where it should be, and every solution obeys
// the sums of docs/theory.md section 6 and the paper's own formulae.
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "geometry/paper_formulae.hpp"
#include "geometry/volume.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/triangulations.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

void expect_finite(const Report& report) {
  EXPECT_TRUE(std::isfinite(report.volume) && std::isfinite(report.max_curvature));
  for (const double l : report.edge_lengths) EXPECT_TRUE(std::isfinite(l));
  for (const auto& angles : report.dihedral_angles)
    for (const double theta : angles) EXPECT_TRUE(theta >= 0 && theta <= std::numbers::pi) << theta;
}

/// The edge sums again, by the paper's route from the lengths to the angles.
void expect_metric_by_the_papers_formulae(const topology::Triangulation& triangulation,
                                          const Report& report) {
  std::vector<double> sums(triangulation.edge_count());
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    double l[6], theta[6];
    for (int e = 0; e < 6; ++e) l[e] = report.edge_lengths[triangulation.edge_class(t, e)];
    ASSERT_TRUE(geometry::paper_dihedral_angles(l, theta));
    for (int e = 0; e < 6; ++e) sums[triangulation.edge_class(t, e)] += theta[e];
  }
  for (const double sum : sums) EXPECT_NEAR(sum, 2 * std::numbers::pi, 1e-7);
}

void expect_metric(const topology::Triangulation& triangulation, const Report& report) {
  EXPECT_LE(report.max_curvature, 1e-12);
  EXPECT_TRUE(report.flat_tetrahedra.empty());
  for (const double l : report.edge_lengths) EXPECT_GT(l, 0);
  const auto tetrahedra = static_cast<double>(triangulation.tetrahedron_count());
  EXPECT_GT(report.volume, 0);
  EXPECT_LT(report.volume, tetrahedra * geometry::kOctahedronVolume);
  // (46): the area of each boundary component is that of its topology.
  for (const VertexReport& vertex : report.vertices) {
    EXPECT_EQ(vertex.link_euler_characteristic, 2 - 2 * vertex.genus);
    EXPECT_NEAR(vertex.area, -2 * std::numbers::pi * vertex.link_euler_characteristic, 1e-10);
  }
  expect_metric_by_the_papers_formulae(triangulation, report);
}

TEST(TwoTetrahedra, AreAllGeometric) {
  for (const auto& signature : testing::data_lines("triangulations-2.txt")) {
    SCOPED_TRACE(signature);
    const auto triangulation = testing::decode(signature);
    const Report report = solve(triangulation);
    ASSERT_EQ(report.outcome, Outcome::kGeometric);
    expect_metric(triangulation, report);
  }
}

TEST(ThreeTetrahedra, AreGeometricExactlyWhereTheListSays) {
  std::set<std::string> nongeometric;
  for (const auto& row : testing::data_table("nongeometric-3.tsv"))
    nongeometric.insert(row.at("isosig"));
  const auto signatures = testing::data_lines("triangulations-3.txt");
  ASSERT_EQ(signatures.size(), 240u);
  int geometric = 0;
  for (const auto& signature : signatures) {
    SCOPED_TRACE(signature);
    const auto triangulation = testing::decode(signature);
    const Report report = solve(triangulation);
    expect_finite(report);
    ASSERT_EQ(report.outcome == Outcome::kGeometric, !nongeometric.contains(signature))
        << report.message;
    if (report.outcome != Outcome::kGeometric) continue;
    ++geometric;
    expect_metric(triangulation, report);
  }
  EXPECT_EQ(geometric, 166);
}

TEST(FourTetrahedra, NeverCallWhatIsNoMetricGeometric) {
  std::set<std::string> boundary_cases;
  for (const auto& row : testing::data_table("boundary-case-4.tsv"))
    boundary_cases.insert(row.at("isosig"));
  const auto signatures = testing::data_lines("triangulations-4.txt");
  ASSERT_EQ(signatures.size(), 11048u);
  for (const auto& signature : signatures) {
    SCOPED_TRACE(signature);
    const auto triangulation = testing::decode(signature);
    const Report report = solve(triangulation);
    expect_finite(report);
    if (report.outcome != Outcome::kGeometric) continue;
    ASSERT_FALSE(boundary_cases.contains(signature));
    // An edge of valence 1 or 2 is never geometric (docs/theory.md section 5).
    for (std::size_t e = 0; e < triangulation.edge_count(); ++e)
      ASSERT_GE(triangulation.valence(e), 3u);
    expect_metric(triangulation, report);
  }
}

TEST(Relabelling, ChangesNeitherTheOutcomeNorTheVolumeNorTheLengths) {
  const auto signatures = testing::data_lines("triangulations-4.txt");
  for (std::size_t k = 0; k < signatures.size(); k += 23) {
    SCOPED_TRACE(signatures[k]);
    const auto original = testing::decode(signatures[k]);
    const topology::Triangulation shuffled(
        topology::random_relabelling(original.gluings(), 1000 + k));
    const Report a = solve(original), b = solve(shuffled);
    ASSERT_EQ(a.outcome, b.outcome);
    if (a.outcome != Outcome::kGeometric) continue;
    EXPECT_NEAR(a.volume, b.volume, 1e-12);
    std::vector<double> x = a.edge_lengths, y = b.edge_lengths;
    std::sort(x.begin(), x.end());
    std::sort(y.begin(), y.end());
    for (std::size_t e = 0; e < x.size(); ++e) EXPECT_NEAR(x[e], y[e], 1e-11);
  }
}

}  // namespace
}  // namespace tripus::structure
