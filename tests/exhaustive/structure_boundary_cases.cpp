// Minimisers at which the angles are not smooth, theory (54'): no verdict is left open, and the
// lengths reported are those of a minimiser by formulae of the tests' own.
#include <gtest/gtest.h>

#include "energies/co_volume.hpp"
#include "solver/method.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/verdict_trials.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::structure {
namespace {

using tripus::testing::decode;

/// Degenerate, with a strict angle structure, and max|K| within the tolerance in long double.
void expect_boundary_case(const std::string& signature, std::size_t flat) {
  SCOPED_TRACE(signature);
  const auto triangulation = decode(signature);
  const Report report = solve(triangulation);
  ASSERT_EQ(report.outcome, Outcome::kDegenerate) << report.message;
  EXPECT_EQ(report.flat_tetrahedra.size(), flat);
  ASSERT_TRUE(report.strict_angles);
  EXPECT_TRUE(check(triangulation, *report.strict_angles));
  EXPECT_LE(tripus::testing::flat_evidence(triangulation, report).max_curvature, 1e-12L);
  for (const std::size_t t : report.flat_tetrahedra) {
    std::array<long double, 6> l;
    for (int e = 0; e < 6; ++e)
      l[std::size_t(e)] = report.edge_lengths[triangulation.edge_class(t, e)];
    // |cosine| >= 1 but for rounding: flat by the lengths, not only by what is reported.
    long double largest = 0;
    for (const long double c : tripus::testing::unclipped_cosines(l))
      largest = std::max(largest, std::fabs(c));
    EXPECT_GE(largest, 1 - 1e-12L) << t;
  }
}

// A tetrahedron lies in a plane of the manifold's metric: this is the tripus, with its volume.
TEST(BoundaryCases, CoplanarVertices) {
  expect_boundary_case("gLLPQccdefffhkgedsr", 1);
  EXPECT_NEAR(solve(decode("gLLPQccdefffhkgedsr")).volume, 6.451990270835033, 1e-13);
}

// Edges with corners in flat tetrahedra only: the length is free in an interval, or in a point.
TEST(BoundaryCases, FreeEdges) {
  expect_boundary_case("jLLLzQQcdffhggihilvhhnkkawn", 3);
  expect_boundary_case("kLvAMLQkcdegfhijijjpvahcguqmlo", 3);
}

// One thin tetrahedron makes the cheap bound of the convexity useless; the true one is large.
TEST(BoundaryCases, ThinTetrahedra) { expect_boundary_case("kvLLAMQkdfegighjjijopsplcfbsso", 1); }

TEST(BoundaryCases, NoVerdictIsLeftOpenAfterRandomMoves) {
  using topology::MoveKind;
  static constexpr std::array<MoveKind, 3> kKinds{MoveKind::kTwoThree, MoveKind::kThreeTwo,
                                                  MoveKind::kFourFour};
  const auto all = tripus::testing::data_lines("triangulations-4.txt");
  int degenerate = 0;
  for (std::size_t k = 0; k < all.size(); k += 211) {
    for (std::uint64_t walk = 1; walk <= 30; ++walk) {
      topology::Gluings gluings = topology::decode_isosig(all[k]);
      topology::randomize(gluings, {.count = 2 + walk % 12, .seed = walk, .kinds = kKinds});
      SCOPED_TRACE(topology::isosig(gluings));
      const topology::Triangulation triangulation(std::move(gluings));
      const Report report = solve(triangulation);
      ASSERT_NE(report.outcome, Outcome::kUnresolved) << report.message;
      if (report.outcome != Outcome::kDegenerate) continue;
      ++degenerate;
      EXPECT_LE(tripus::testing::flat_evidence(triangulation, report).max_curvature, 1e-12L);
    }
  }
  EXPECT_GT(degenerate, 50);
}

// Between piecewise linear pieces the bends of H are narrower than an ulp of these lengths.
TEST(FarStarts, OfEqualLengthsFindTheMetricByThemselves) {
  for (const char* method : {"newton", "newton-cg"}) {
    for (const char* signature : {"cPcbbbihq", "eLAkbcbddhejqn", "dLQbcbcheww"}) {
      const auto triangulation = decode(signature);
      const Report metric = solve(triangulation);
      ASSERT_EQ(metric.outcome, Outcome::kGeometric) << signature;
      for (double length = 1e2; length <= 1e8; length *= 3.7) {
        energies::CoVolume energy(triangulation);
        std::vector<double> x(triangulation.edge_count(), length);
        const auto summary = solver::find_method(method)->minimise(energy, x, {});
        EXPECT_EQ(summary.termination, solver::Termination::kConverged)
            << method << ", " << signature << " from " << length;
        for (std::size_t e = 0; e < x.size(); ++e) EXPECT_NEAR(x[e], metric.edge_lengths[e], 1e-10);
      }
    }
  }
}

}  // namespace
}  // namespace tripus::structure
