// Random diagrams: no crash, the right boundary, the group that Wirtinger says.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/triangulations.hpp"
#include "topology/covers/cover_homology.hpp"
#include "topology/diagrams/exterior.hpp"
#include "topology/diagrams/random_diagram.hpp"
#include "topology/diagrams/small_exterior.hpp"
#include "topology/diagrams/wirtinger.hpp"

namespace tripus::topology {
namespace {

/// Genera of the boundary, ascending, from the graph alone: components joined by strands and
/// vertices; 1 - vertices + strands each, and 1 for a knot.
std::vector<int> genera_of_graph(const Diagram& diagram) {
  const Strands all = strands(diagram);
  std::vector<std::uint32_t> root(diagram.node_count());
  for (std::uint32_t n = 0; n < root.size(); ++n) root[n] = n;
  const auto find = [&](std::uint32_t n) {
    while (root[n] != n) n = root[n] = root[root[n]];
    return n;
  };
  std::map<std::uint32_t, int> genus;
  std::vector<int> genera;
  for (const Strand& strand : all.all)
    if (!strand.closed)
      root[find(diagram.node(strand.darts.front()))] =
          find(diagram.node(diagram.mate(strand.darts.back())));
  for (const Strand& strand : all.all)
    strand.closed ? genera.push_back(1) : void(++genus[find(diagram.node(strand.darts.front()))]);
  for (std::uint32_t n = 0; n < root.size(); ++n)
    if (!diagram.is_crossing(n)) --genus[find(n)];
  for (const auto& [n, g] : genus) genera.push_back(g + 1);
  std::ranges::sort(genera);
  return genera;
}

std::vector<int> genera_of_links(const Triangulation& triangulation) {
  std::vector<int> genera;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).euler_characteristic < 2)
      genera.push_back(triangulation.link(v).genus());
  std::ranges::sort(genera);
  return genera;
}

// Seeds 0 to 999: up to 50 nodes, up to 6 of them vertices of degree 4.
TEST(RandomDiagrams, AThousandUpToFiftyCrossings) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::size_t nodes = 1 + seed % 50;
    const Diagram diagram = random_diagram(nodes, seed, std::min<std::size_t>(nodes, seed % 7));
    ASSERT_EQ(diagram.node_count(), nodes);
    const Triangulation octahedra(exterior(diagram).gluings);
    ASSERT_TRUE(octahedra.is_orientable());
    ASSERT_EQ(genera_of_links(octahedra), genera_of_graph(diagram));
    ASSERT_EQ(first_homology(octahedra),
              testing::abelianized(wirtinger_group(diagram).presentation));
    if (seed % 20 != 0) continue;
    const Triangulation small(small_exterior({.name = {}, .diagram = diagram}).gluings);
    ASSERT_EQ(genera_of_links(small), genera_of_graph(diagram));
    ASSERT_EQ(first_homology(small), first_homology(octahedra));
  }
}

TEST(RandomDiagrams, OfTenThousandCrossingsAreTriangulated) {
  const Diagram diagram = random_diagram(10'000, 1);
  const DiagramExterior made = exterior(diagram);
  const Triangulation octahedra(made.gluings);
  EXPECT_EQ(octahedra.tetrahedron_count(), 4 * (10'000 + made.kinks));
  EXPECT_EQ(genera_of_links(octahedra), genera_of_graph(diagram));
}

TEST(RandomDiagrams, AreAllTheMapsWithOneAndTwoNodes) {
  // Rooted maps with n nodes of degree 4: 2 with one, 9 with two (Tutte). With crossings above or
  // below, and without a root, there are fewer; but more than one of each size occurs.
  for (const std::size_t nodes : {1u, 2u}) {
    std::map<std::string, int> seen;
    for (std::uint64_t seed = 0; seed < 200; ++seed) ++seen[to_text(random_diagram(nodes, seed))];
    EXPECT_GT(seen.size(), 1u);
  }
}

}  // namespace
}  // namespace tripus::topology
