#include <string>

#include <gtest/gtest.h>

#include "canonical/canonize.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/manifold_invariants.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"
#include "topology/simplify/simplify.hpp"
#include "topology/subdivide.hpp"

// Laws M1 and R2 of topology/README.md over the known manifolds and the lists.

namespace tripus::topology {
namespace {

using testing::ManifoldInvariants;

/// Subdivided, relabelled and made small again: no larger than it was, the same invariants.
Gluings there_and_back(const std::string& signature, std::uint64_t seed) {
  const Gluings gluings = decode_isosig(signature);
  const Gluings fine = random_relabelling(barycentric_subdivision(gluings), seed);
  const Simplified result = simplify(fine, {.seed = seed});
  EXPECT_LE(result.tetrahedron_count(), gluings.tetrahedron_count());
  EXPECT_EQ(result.finite_vertices_left, 0u);
  testing::expect_kept(ManifoldInvariants(Triangulation(gluings)),
                       ManifoldInvariants(Triangulation(result.gluings)), 0);
  return result.gluings;
}

// The isometry signature is a complete invariant, and the volume is found by solving the small
// triangulation (or one near it that carries the metric).
TEST(SimplifyManifolds, AllComeBackToTheirLeastSizeAndAreIsometric) {
  std::uint64_t seed = 1;
  for (const auto& row : testing::data_table("manifolds-2-3.tsv")) {
    SCOPED_TRACE(row.at("isosig"));
    const Gluings small = there_and_back(row.at("isosig"), seed++);
    if (row.at("boundary").find('T') != std::string::npos) continue;  // a cusp: no metric here yet
    const auto answer = canonical::canonize(Triangulation(small));
    const auto given = canonical::canonize(Triangulation(decode_isosig(row.at("isosig"))));
    ASSERT_TRUE(answer.manifold && given.manifold) << answer.message;
    EXPECT_NEAR(answer.manifold->report.volume, std::stod(row.at("volume")), 1e-10);
    EXPECT_EQ(answer.manifold->signature.unoriented, given.manifold->signature.unoriented);
    if (HasFailure()) return;
  }
}

TEST(SimplifyManifolds, EveryListedTriangulationComesBack) {
  std::uint64_t seed = 1;
  const auto check = [&](const std::string& file, std::size_t stride) {
    const auto lines = testing::data_lines(file);
    for (std::size_t i = 0; i < lines.size() && !HasFailure(); i += stride) {
      SCOPED_TRACE(lines[i]);
      there_and_back(lines[i], seed++);
    }
  };
  check("triangulations-2.txt", 1);
  check("triangulations-3.txt", 3);
  check("triangulations-4.txt", 150);
  check("triangulations-cusped.txt", 2);
}

}  // namespace
}  // namespace tripus::topology
