#include <algorithm>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "topology/homology.hpp"
#include "topology/isosig.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {
namespace {

std::vector<std::string> signatures(const std::string& file) {
  std::ifstream in(std::string(TRIPUS_DATA_DIR) + "/" + file);
  std::vector<std::string> found;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line[0] != '#') found.push_back(line);
  return found;
}

class Lists : public testing::TestWithParam<const char*> {};

// Laws T1, T2 and S1 of topology/README.md over every listed triangulation.
TEST_P(Lists, SkeletonAndSignatureLaws) {
  const auto list = signatures(GetParam());
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
                         testing::Values("triangulations-2.txt", "triangulations-3.txt",
                                         "triangulations-4.txt", "triangulations-cusped.txt"));

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> found(1);
  for (const char c : line) {
    if (c == '\t')
      found.emplace_back();
    else
      found.back() += c;
  }
  return found;
}

// Columns: n_tets boundary volume H1 kojima isosig canonical_isosig ...
TEST(ManifoldTable, SignaturesRoundTripAndHomologyIsAsListed) {
  std::size_t count = 0;
  for (const std::string& line : signatures("manifolds-2-3.tsv")) {
    if (line.starts_with("n_tets")) continue;
    SCOPED_TRACE(line);
    const auto row = fields(line);
    for (const std::size_t column : {5u, 6u})
      EXPECT_EQ(isosig(decode_isosig(row.at(column))), row.at(column));
    EXPECT_EQ(to_string(first_homology(Triangulation(decode_isosig(row.at(5))))), row.at(3));
    ++count;
  }
  EXPECT_EQ(count, 159u);
}

// Columns: isosig boundary edge_valences angle_margin H1
TEST(NongeometricTable, HomologyIsAsListed) {
  for (const std::string& line : signatures("nongeometric-3.tsv")) {
    if (line.starts_with("isosig")) continue;
    const auto row = fields(line);
    EXPECT_EQ(to_string(first_homology(Triangulation(decode_isosig(row.at(0))))), row.at(4))
        << line;
  }
}

}  // namespace
}  // namespace tripus::topology
