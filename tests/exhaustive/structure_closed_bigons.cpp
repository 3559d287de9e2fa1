// The lemma of docs/theory.md section 5.1 over the lists.
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "structure/closed_bigon.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/triangulations.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

std::string consequence_of(const topology::Triangulation& triangulation) {
  const auto bigon = closed_bigon(triangulation);
  return bigon ? std::string(to_string(bigon->consequence)) : "no closed bigon";
}

std::map<std::string, int> consequences(const std::string& file) {
  std::map<std::string, int> counts;
  for (const std::string& signature : testing::data_lines(file))
    ++counts[consequence_of(testing::decode(signature))];
  return counts;
}

std::set<std::string> hyperbolic_triangulations() {
  std::set<std::string> all;
  for (const auto& row : testing::data_table("census.tsv"))
    for (const std::string& signature : testing::split(row.at("triangulations"), ' '))
      all.insert(signature);
  return all;
}

TEST(ClosedBigons, HaveTheCountsOfTheDocs) {
  using Counts = std::map<std::string, int>;
  EXPECT_EQ(consequences("triangulations-2.txt"), (Counts{{"no closed bigon", 8}}));
  EXPECT_EQ(consequences("triangulations-3.txt"),
            (Counts{{"essential annulus", 21}, {"no closed bigon", 219}}));
  // 760 + 574 + 225 = 1,559: a separate search found as many patterns.
  EXPECT_EQ(consequences("triangulations-4.txt"), (Counts{{"essential annulus", 574},
                                                          {"moebius band", 760},
                                                          {"no closed bigon", 9489},
                                                          {"none", 225}}));
}

// All triangulations of the 5,160 hyperbolic manifolds of the census, and the geometric ones with
// cusps: a surface in one of them would be a contradiction.
TEST(ClosedBigons, AreInNoHyperbolicManifold) {
  const std::set<std::string> hyperbolic = hyperbolic_triangulations();
  EXPECT_EQ(hyperbolic.size(), 6381u);
  for (const std::string& signature : hyperbolic)
    EXPECT_EQ(consequence_of(testing::decode(signature)), "no closed bigon") << signature;
}

TEST(ClosedBigons, DoNotDependOnLabels) {
  std::mt19937_64 random(20);
  int number = 0;
  for (const std::string& signature : testing::data_lines("triangulations-4.txt")) {
    if (++number % 10 != 0) continue;
    SCOPED_TRACE(signature);
    const auto triangulation = testing::decode(signature);
    const auto relabelled =
        topology::Triangulation(topology::random_relabelling(triangulation.gluings(), random()));
    EXPECT_EQ(consequence_of(relabelled), consequence_of(triangulation));
  }
}

}  // namespace
}  // namespace tripus::structure
