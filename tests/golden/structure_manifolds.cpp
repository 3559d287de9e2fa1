// The paper's example and the published manifolds, to all their digits.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "topology/formats/formats.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

topology::Triangulation from_text(const std::string& text) {
  return topology::Triangulation(topology::read_triangulation(text).gluings);
}

void expect_knotted_y(const Report& report) {
  EXPECT_EQ(report.outcome, Outcome::kGeometric) << report.message;
  ASSERT_EQ(report.edge_lengths.size(), 1u);
  EXPECT_NEAR(std::cosh(report.edge_lengths[0]), (3 + std::sqrt(3.0)) / 4, 1e-14);
  EXPECT_NEAR(report.edge_lengths[0], 0.596133894890837, 1e-14);
  ASSERT_EQ(report.dihedral_angles.size(), 2u);
  for (const auto& tetrahedron : report.dihedral_angles)
    for (const double theta : tetrahedron) EXPECT_NEAR(theta, std::numbers::pi / 6, 1e-14);
  EXPECT_NEAR(report.volume, 6.4519902708350328653, 1e-14);
}

// The founding paper's gluing table as printed, design 2.1.
TEST(KnottedY, FromItsGluingTable) {
  const auto knotted_y = from_text(testing::data_text("knotted-y-gluings.json"));
  EXPECT_EQ(topology::isosig(knotted_y.gluings()), "cPcbbbihq");
  for (const double start : {0.0, 0.1, 1.0, 3.0}) {
    SolveOptions options;
    options.initial_length = start;
    expect_knotted_y(solve(knotted_y, options));
  }
}

TEST(KnottedY, FromItsSignature) { expect_knotted_y(solve(from_text("cPcbbbihq"))); }

// Frigerio, Martelli, Petronio, arXiv math/0211425: volumes to 20 digits, lengths to 15.
TEST(Manifolds, VolumesAndLengthsAsPublished) {
  const auto rows = testing::compact_manifolds();
  ASSERT_EQ(rows.size(), 158u);
  for (const auto& row : rows) {
    SCOPED_TRACE(row.at("isosig"));
    for (const double start : {0.0, 1.0}) {
      SolveOptions options;
      options.initial_length = start;
      const Report report = solve(from_text(row.at("isosig")), options);
      ASSERT_EQ(report.outcome, Outcome::kGeometric) << report.message;
      EXPECT_LE(report.max_curvature, 1e-12);
      EXPECT_NEAR(report.volume, std::stod(row.at("volume")), 1e-13);
      const auto lengths = testing::split(row.at("edge_lengths"), '|');
      ASSERT_EQ(lengths.size(), report.edge_lengths.size());
      for (std::size_t e = 0; e < lengths.size(); ++e)
        EXPECT_NEAR(report.edge_lengths[e], std::stod(lengths[e]), 5e-14);
    }
  }
}

}  // namespace
}  // namespace tripus::structure
