#include <map>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/data_files.hpp"
#include "topology/isosig.hpp"
#include "topology/simplify/collapse.hpp"

namespace tripus::topology {
namespace {

// Where Regina collapses an edge and where it refuses, and the signature of the result.
TEST(CollapseGolden, AgreesWithRegina) {
  std::map<CollapseRefusal, int> counts;
  for (const auto& row : testing::data_table("collapse-golden.tsv")) {
    SCOPED_TRACE(row.at("isosig") + " " + row.at("tetrahedron") + " " + row.at("edge"));
    const auto t = static_cast<TetrahedronIndex>(std::stoul(row.at("tetrahedron")));
    const int edge = std::stoi(row.at("edge"));
    MutableTriangulation m{Triangulation(decode_isosig(row.at("isosig")))};
    EdgeCollapse collapse(m);
    const CollapseRefusal reason = collapse.try_apply(t, edge);
    ++counts[reason];
    ASSERT_EQ(reason == CollapseRefusal::kNone, row.at("result") != "-") << to_string(reason);
    if (reason == CollapseRefusal::kNone) {
      EXPECT_EQ(isosig(m.compacted()), row.at("result"));
    }
  }
  EXPECT_GE(counts[CollapseRefusal::kNone], 100);
  for (const CollapseRefusal reason : {CollapseRefusal::kSameEnds, CollapseRefusal::kNoFiniteEnd,
                                       CollapseRefusal::kMeetsItself, CollapseRefusal::kEdgeCycle})
    EXPECT_GE(counts[reason], 5) << to_string(reason);
}

}  // namespace
}  // namespace tripus::topology
