#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/data_files.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {
namespace {

class Lists : public ::testing::TestWithParam<const char*> {};

// Laws T1, T2 and S1 of topology/README.md over every listed triangulation.
TEST_P(Lists, SkeletonAndSignatureLaws) {
  const auto list = tripus::testing::data_lines(GetParam());
  ASSERT_FALSE(list.empty());
  std::uint64_t seed = 1;
  for (const std::string& signature : list) {
    SCOPED_TRACE(signature);
    const Gluings gluings = decode_isosig(signature);
    ASSERT_EQ(isosig(gluings), signature);
    const Gluings shuffled = random_relabelling(gluings, seed++);
    ASSERT_EQ(isosig(shuffled), signature);

    const Triangulation triangulation(shuffled);
    const std::size_t count = triangulation.tetrahedron_count();
    ASSERT_TRUE(triangulation.is_connected());
    ASSERT_TRUE(triangulation.is_orientable());
    std::size_t corners = 0;
    for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
      corners += triangulation.valence(e);
      for (const EdgeCorner corner : triangulation.corners(e))
        ASSERT_EQ(triangulation.edge_class(corner.tetrahedron(), corner.edge()), e);
    }
    ASSERT_EQ(corners, 6 * count);
    std::int64_t boundary = 0;
    std::size_t triangles = 0;
    for (std::size_t v = 0; v < triangulation.vertex_count(); ++v) {
      const VertexLink& link = triangulation.link(v);
      ASSERT_TRUE(link.orientable);
      boundary += link.euler_characteristic;
      triangles += link.triangle_count;
    }
    ASSERT_EQ(triangles, 4 * count);
    ASSERT_EQ(2 * static_cast<std::int64_t>(triangulation.edge_count()),
              2 * static_cast<std::int64_t>(count) + boundary);
  }
}

INSTANTIATE_TEST_SUITE_P(Data, Lists,
                         ::testing::Values("triangulations-2.txt", "triangulations-3.txt",
                                           "triangulations-4.txt", "triangulations-cusped.txt"));

TEST(ManifoldTable, SignaturesRoundTripAndHomologyIsAsListed) {
  const auto rows = tripus::testing::data_table("manifolds-2-3.tsv");
  for (const auto& row : rows) {
    SCOPED_TRACE(row.at("isosig"));
    for (const char* column : {"isosig", "canonical_isosig"})
      EXPECT_EQ(isosig(decode_isosig(row.at(column))), row.at(column));
    EXPECT_EQ(to_string(first_homology(Triangulation(decode_isosig(row.at("isosig"))))),
              row.at("H1"));
  }
  EXPECT_EQ(rows.size(), 159u);
}

TEST(NongeometricTable, HomologyIsAsListed) {
  for (const auto& row : tripus::testing::data_table("nongeometric-3.tsv")) {
    EXPECT_EQ(to_string(first_homology(Triangulation(decode_isosig(row.at("isosig"))))),
              row.at("H1"))
        << row.at("isosig");
  }
}

}  // namespace
}  // namespace tripus::topology
