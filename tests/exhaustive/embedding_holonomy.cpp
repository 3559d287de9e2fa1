// Law E3 of embedding/README.md in large fundamental domains: cyclic covers.
#include <algorithm>

#include <gtest/gtest.h>

#include "embedding/holonomy.hpp"
#include "tests/support/embedded_manifolds.hpp"
#include "topology/covers/covers.hpp"

namespace tripus {
namespace {

/// The first cyclic cover of the degree, with the metric of the base.
testing::Embedded cyclic_cover(const testing::Embedded& base, std::size_t degree) {
  topology::Gluings gluings = base.triangulation.gluings();
  topology::for_each_cyclic_cover(base.triangulation, degree, [&](const topology::Cover& cover) {
    gluings = cover.gluings;
    return false;
  });
  topology::Triangulation triangulation(gluings);
  std::vector<double> lengths(triangulation.edge_count());
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const topology::EdgeCorner corner = triangulation.corners(e)[0];
    lengths[e] = base.report.edge_lengths[base.triangulation.edge_class(
        corner.tetrahedron() % base.triangulation.tetrahedron_count(), corner.edge())];
  }
  embedding::Embedding embedding = embedding::embed(triangulation, lengths);
  return {std::move(triangulation), base.report, std::move(embedding)};
}

void expect_honest(const char* name, std::size_t first, std::size_t last) {
  const testing::Embedded base = testing::try_embed(name).value();
  for (std::size_t degree = first; degree <= last; ++degree) {
    SCOPED_TRACE(::testing::Message() << name << ", degree " << degree);
    const testing::Embedded cover = cyclic_cover(base, degree);
    ASSERT_EQ(cover.triangulation.tetrahedron_count(),
              degree * base.triangulation.tetrahedron_count());
    const embedding::Holonomy holonomy = embedding::holonomy(cover.embedding, cover.triangulation);
    EXPECT_EQ(holonomy.orientable, cover.triangulation.is_orientable());
    if (base.triangulation.is_orientable()) {
      EXPECT_TRUE(holonomy.orientable);
    }
    EXPECT_EQ(holonomy.orientable,
              std::ranges::none_of(holonomy.moebius, &geometry::MoebiusMap::reverses));
    EXPECT_LT(holonomy.local_defect, 1e-10);
    const auto defects = embedding::relator_defects(holonomy);
    const auto bounds = embedding::relator_bounds(holonomy);
    ASSERT_EQ(defects.size(), bounds.size());
    for (std::size_t r = 0; r < defects.size(); ++r) EXPECT_LE(defects[r], bounds[r]) << r;
    if (degree <= 5) {
      EXPECT_LT(*std::ranges::max_element(defects), 1e-9);
    }
    ::testing::Test::RecordProperty(
        ("degree" + std::to_string(degree)),
        ::testing::PrintToString(*std::ranges::max_element(defects)) + " " +
            ::testing::PrintToString(*std::ranges::max_element(bounds)));
  }
}

TEST(HolonomyOfCovers, OfTheTripusKeepsItsBoundsAndItsOrientation) {
  expect_honest("cPcbbbihq", 5, 30);
}

TEST(HolonomyOfCovers, OfThreeTetrahedraKeepsItsBoundsAndItsOrientation) {
  expect_honest("dLQbcccdhkw", 7, 12);
  expect_honest("dLQbccchrqg", 7, 12);  // not orientable; some covers are
}

}  // namespace
}  // namespace tripus
