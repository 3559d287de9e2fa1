// What theorems say from the valences, against the triangulations of the lists.
#include <map>
#include <random>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "structure/solve.hpp"
#include "structure/valence_theorem.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/frigerio.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

using topology::Triangulation;
using Claim = ValenceTheorem::Claim;

TEST(ValenceTheorem, NoTriangulationOfTheListsContradictsIt) {
  std::map<std::string, std::string> hyperbolic;  // by the certificates of data/hyperbolicity.tsv
  for (const auto& row : testing::data_table("hyperbolicity.tsv"))
    hyperbolic[row.at("input")] = row.at("hyperbolic");
  std::map<Claim, int> met;
  for (const char* file :
       {"triangulations-2.txt", "triangulations-3.txt", "triangulations-4.txt"}) {
    for (const std::string& isosig : testing::data_lines(file)) {
      const Triangulation m(topology::decode_isosig(isosig));
      const auto theorem = valence_theorem(m);
      if (!theorem) continue;
      ++met[theorem->claim()];
      EXPECT_EQ(hyperbolic.at(isosig), "true") << isosig;
      if (theorem->claim() != Claim::kGeometric) continue;
      EXPECT_GE(theorem->least_valence, 7u);
      EXPECT_EQ(solve(m).outcome, Outcome::kGeometric) << isosig;
    }
  }
  // One edge: valences 12, 18 and 24. 5 and more edges have none of 9 with four tetrahedra.
  EXPECT_GE(met[Claim::kGeometric], 8 + 74 + 2340);
  EXPECT_GT(met[Claim::kHyperbolic], 100);
}

// Edges alike, which our own proof covers: the metric is the symmetric one, whose volume
// Schlaefli's formula gives by quadrature elsewhere; here the solver finds it, and finds nothing to
// do.
TEST(ValenceTheorem, EdgesThatAreAlikeCarryTheSymmetricMetric) {
  int met = 0;
  const auto expect_symmetric = [&](const Triangulation& m, const std::string& name) {
    const auto theorem = valence_theorem(m);
    if (!theorem || theorem->condition != ValenceTheorem::Condition::kAlike) return;
    ++met;
    const Report report = solve(m);
    EXPECT_EQ(report.outcome, Outcome::kGeometric) << name;
    EXPECT_LE(report.iterations, 1) << name;  // a last one to rounding
  };
  for (const char* file : {"triangulations-2.txt", "triangulations-3.txt", "triangulations-4.txt",
                           "triangulations-cusped.txt"})
    for (const std::string& isosig : testing::data_lines(file))
      expect_symmetric(Triangulation(topology::decode_isosig(isosig)), isosig);
  EXPECT_GT(met, 10);
  std::mt19937_64 random(1);
  for (const auto& [g, k] : {std::pair{2, 1}, {3, 1}, {3, 2}, {4, 2}, {4, 3}}) {
    const int before = met;
    expect_symmetric(testing::random_frigerio(std::size_t(g), std::size_t(k), random), "M_{g,k}");
    EXPECT_EQ(met, before + 1) << g << ", " << k;
  }
}

TEST(ValenceTheorem, SaysNothingBeyondItsConditions) {
  const Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  ASSERT_TRUE(valence_theorem(tripus));
  EXPECT_EQ(valence_theorem(tripus)->source(), "arXiv 2601.15174");
  EXPECT_FALSE(valence_theorem(tripus, std::vector<topology::ConeAngle>{3.0}));
  // No geodesic boundary: valences 6 and 6.
  EXPECT_FALSE(valence_theorem(Triangulation(topology::decode_isosig("cPcbbbiht"))));
  // An edge of valence 2.
  EXPECT_FALSE(valence_theorem(Triangulation(topology::decode_isosig("dLQbcbcaekw"))));
}

}  // namespace
}  // namespace tripus::structure
