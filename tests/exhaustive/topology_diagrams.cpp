// Every diagram of the tables: the triangulated exterior against the Wirtinger presentation, which
// knows nothing of tetrahedra; and the tetrahedra that simplifying must reach.
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/data_files.hpp"
#include "tests/support/triangulations.hpp"
#include "topology/covers/cover_homology.hpp"
#include "topology/diagrams/exterior.hpp"
#include "topology/diagrams/small_exterior.hpp"
#include "topology/diagrams/tables.hpp"
#include "topology/diagrams/wirtinger.hpp"

namespace tripus::topology {
namespace {

/// Subgroups of index d.
std::uint64_t subgroups(const Presentation& group, std::size_t degree) {
  std::uint64_t count = 0;
  for_each_transitive_action(reduced(group).presentation, degree, [&](const TransitiveAction& a) {
    count += degree / a.deck_group_order;
    return true;
  });
  return count;
}

class EveryTable : public ::testing::TestWithParam<DiagramTable> {};

TEST_P(EveryTable, ExteriorsHaveTheGroupThatWirtingerSays) {
  for (const TabledDiagram& entry : table_of(GetParam())) {
    SCOPED_TRACE(entry.name);
    const Triangulation octahedra(exterior(entry.diagram).gluings);
    const Triangulation small(small_exterior({.name = {}, .diagram = entry.diagram}).gluings);
    const Presentation group = wirtinger_group(entry.diagram).presentation;
    ASSERT_EQ(first_homology(octahedra), testing::abelianized(group));
    ASSERT_EQ(first_homology(small), testing::abelianized(group));
    const Presentation from_faces = fundamental_group(small).presentation;
    for (const std::size_t degree : {2u, 3u, 4u})
      ASSERT_EQ(subgroups(from_faces, degree), subgroups(group, degree)) << "index " << degree;
  }
}

// A component of the graph with V vertices and E strands bounds a surface of genus 1 - V + E.
TEST_P(EveryTable, BoundariesAreThoseOfTheGraph) {
  for (const TabledDiagram& entry : table_of(GetParam())) {
    SCOPED_TRACE(entry.name);
    const Triangulation octahedra(exterior(entry.diagram).gluings);
    const Triangulation small(small_exterior({.name = {}, .diagram = entry.diagram}).gluings);
    const bool is_graph =
        GetParam() == DiagramTable::kThetaCurves || GetParam() == DiagramTable::kHandlebodyKnots;
    std::size_t knots = 0;
    for (const Strand& strand : strands(entry.diagram).all) knots += strand.closed;
    EXPECT_EQ(octahedra.vertex_count(), small.vertex_count() + 2);
    if (entry.name == "0_1") knots = 1;  // a circle with a vertex on it
    EXPECT_EQ(small.vertex_count(), is_graph ? 1 : knots);
    for (std::size_t v = 0; v < small.vertex_count(); ++v)
      EXPECT_EQ(small.link(v).genus(), is_graph ? 2 : 1);
  }
}

// The meridian and the longitude of a knot or link component commute, in every action.
TEST_P(EveryTable, LongitudesCommuteWithMeridians) {
  for (const TabledDiagram& entry : table_of(GetParam())) {
    SCOPED_TRACE(entry.name);
    const WirtingerGroup group = wirtinger_group(entry.diagram);
    const ReducedPresentation few = reduced(group.presentation);
    const auto image = [](const TransitiveAction& action, const Word& word, std::uint32_t sheet) {
      for (const Letter letter : word) {
        const auto& p = action.images[generator_of(letter)];
        sheet = letter > 0 ? p[sheet]
                           : static_cast<std::uint32_t>(std::ranges::find(p, sheet) - p.begin());
      }
      return sheet;
    };
    for_each_transitive_action(few.presentation, 4, [&](const TransitiveAction& reduced_action) {
      const TransitiveAction action = extended(reduced_action, few);
      for (std::size_t s = 0; s < group.strands.all.size(); ++s) {
        if (!group.strands.all[s].closed) continue;
        Word one = group.meridians[s], two = group.longitudes[s];
        one.insert(one.end(), group.longitudes[s].begin(), group.longitudes[s].end());
        two.insert(two.end(), group.meridians[s].begin(), group.meridians[s].end());
        for (std::uint32_t sheet = 0; sheet < 4; ++sheet)
          EXPECT_EQ(image(action, one, sheet), image(action, two, sheet));
      }
      return !::testing::Test::HasFailure();
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Diagrams, EveryTable, ::testing::ValuesIn(kDiagramTables),
                         [](const auto& each) {
                           std::string name(table_name(each.param));
                           std::erase(name, '-');
                           return name;
                         });

TEST(Diagrams, SimplifyToTheKnownNumberOfTetrahedra) {
  std::size_t rows = 0;
  for (const auto& row : testing::data_table("diagrams-expected.tsv")) {
    const TabledDiagram* entry = find_diagram(row.at("name"));
    ASSERT_NE(entry, nullptr) << row.at("name");
    ++rows;
    EXPECT_LE(small_exterior({.name = {}, .diagram = entry->diagram}).gluings.tetrahedron_count(),
              std::stoul(row.at("tetrahedra")))
        << entry->name;
  }
  EXPECT_EQ(rows, 127u);
}

}  // namespace
}  // namespace tripus::topology
