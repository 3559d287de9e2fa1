// The shipped table of knots and links against SnapPy's symmetry groups and canonical forms.
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "manifold/diagram_table.hpp"
#include "tests/support/data_files.hpp"

namespace tripus {
namespace {

using topology::DiagramTable;

/// SnapPy's names as ours.
std::string our_name(const std::string& group) {
  static const std::map<std::string, std::string> kNames{
      {"0", "trivial"},
      {"D3", "dihedral of order 6"},
      {"D4", "dihedral of order 8"},
      {"D6", "dihedral of order 12"},
      {"D8", "dihedral of order 16"},
      {"Z/2", "cyclic of order 2"},
      {"Z/2 + Z/2", "Z_2 + Z_2"},
      {"Z/2 + Z/2 + Z/2", "Z_2 + Z_2 + Z_2"},
      {"Z/2 x D4", "Z_2 x dihedral of order 8"},
      {"Z/2 x octahedral group", "Z_2 x symmetric S_4"},
      {"nonabelian group of order 64", "non-abelian of order 64"}};
  const auto found = kNames.find(group);
  return found == kNames.end() ? "unknown: " + group : found->second;
}

TEST(DiagramSymmetries, KnotsAndLinksHaveThoseOfSnapPy) {
  std::map<std::string, std::map<std::string, std::string>> expected;
  std::map<std::string, std::set<std::string>> same;
  for (const auto& row : testing::data_table("diagrams-golden-symmetries.tsv")) {
    expected[row.at("name")] = {row.begin(), row.end()};
    same[row.at("canonical")].insert(row.at("name"));
  }
  std::size_t compared = 0;
  for (const DiagramTable table : {DiagramTable::kKnots, DiagramTable::kLinks})
    for (const DiagramRow& row : shipped_rows(table)) {
      const auto known = expected.find(row.name);
      ASSERT_EQ(row.hyperbolic.has_value(), known != expected.end()) << row.name;
      if (known == expected.end()) continue;
      ++compared;
      EXPECT_EQ(row.isometries, std::stoul(known->second.at("isometries"))) << row.name;
      EXPECT_EQ(row.reversing, std::stoul(known->second.at("reversing"))) << row.name;
      EXPECT_EQ(row.group, our_name(known->second.at("group"))) << row.name;
      std::set<std::string> others = same.at(known->second.at("canonical"));
      others.erase(row.name);
      EXPECT_EQ(std::set<std::string>(row.same_as.begin(), row.same_as.end()), others) << row.name;
    }
  EXPECT_EQ(compared, 195u);
}

}  // namespace
}  // namespace tripus
