// Volumes of the knots and links of the tables, from their diagrams, against SnapPy's.
#include <string>

#include <gtest/gtest.h>

#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "topology/diagrams/small_exterior.hpp"
#include "topology/diagrams/tables.hpp"

namespace tripus {
namespace {

using topology::DiagramTable;

TEST(DiagramVolumes, KnotsAndLinksHaveThoseOfSnapPy) {
  std::map<std::string, double> expected;
  for (const auto& row : testing::data_table("diagrams-golden-volumes.tsv"))
    expected[row.at("name")] = std::stod(row.at("volume"));
  std::size_t hyperbolic = 0;
  for (const DiagramTable table : {DiagramTable::kKnots, DiagramTable::kLinks})
    for (const topology::TabledDiagram& entry : topology::table_of(table)) {
      const topology::Triangulation exterior(
          topology::small_exterior({.name = {}, .diagram = entry.diagram}).gluings);
      structure::SolveOptions options;
      options.evidence = false;
      const structure::Report report = structure::solve(exterior, options);
      const auto known = expected.find(entry.name);
      const bool found = report.outcome == structure::Outcome::kGeometric;
      EXPECT_EQ(found, known != expected.end()) << entry.name;
      if (!found || known == expected.end()) continue;
      ++hyperbolic;
      EXPECT_NEAR(report.volume, known->second, 1e-9) << entry.name;
    }
  EXPECT_EQ(hyperbolic, 195u);  // 79 knots, 116 links
}

}  // namespace
}  // namespace tripus
