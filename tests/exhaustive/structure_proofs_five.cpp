// A sample of the triangulations with five tetrahedra: every metric is proved in doubles.
#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

#include "structure/proof/digits.hpp"
#include "structure/proof/proof.hpp"
#include "structure/proof/proof_text.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

TEST(ProofsOfFive, EveryGeometricOneOfTheSampleIsProvedInDoubles) {
  std::size_t geometric = 0, high = 0, all = 0;
  for (const std::string& isosig : testing::data_lines("triangulations-5-sample.txt")) {
    SCOPED_TRACE(isosig);
    const topology::Triangulation m(topology::decode_isosig(isosig));
    ASSERT_EQ(m.tetrahedron_count(), 5u);
    ++all;
    SolveOptions options;
    options.evidence = false;
    const Report report = solve(m, options);
    std::size_t least = m.valence(0);
    for (std::size_t e = 1; e < m.edge_count(); ++e) least = std::min(least, m.valence(e));
    // Costantino, Frigerio, Martelli and Petronio ask whether this is always so.
    if (least >= 6) {
      ++high;
      EXPECT_EQ(report.outcome, Outcome::kGeometric);
    }
    if (report.outcome != Outcome::kGeometric) continue;
    ++geometric;
    const Proof proof = prove(m, report.edge_lengths);
    EXPECT_TRUE(proof.proved) << proof.reason;
    EXPECT_EQ(proof.bits, 53);
    EXPECT_LT(proof.largest_radius(), 1e-13);
  }
  std::printf("%zu geometric of %zu, %zu with all valences >= 6\n", geometric, all, high);
  EXPECT_EQ(all, 2004u);
  EXPECT_GT(geometric, 900u);
  EXPECT_GT(high, 600u);
}

// Two that are so nearly flat that convexity is not shown in a box that is large enough.
TEST(ProofsOfFive, NearlyFlatOnesAreProvedByIntervalNewton) {
  for (const char* isosig : {"fLLQcbcdeeepffeth", "fLLQcbcdeeepfkeuq"}) {
    SCOPED_TRACE(isosig);
    const topology::Triangulation m(topology::decode_isosig(isosig));
    const Proof proof = prove(m, solve(m).edge_lengths);
    EXPECT_TRUE(proof.proved) << proof.reason;
    EXPECT_LT(proof.largest_radius(), 1e-13);
    const ProofText text = parse_proof(to_json(proof_text(proof)));
    EXPECT_TRUE(text.interval_newton);
    const ProofCheck check = check_proof(m, text);
    EXPECT_TRUE(check) << check.reason;
    EXPECT_FALSE(prove_digits(m, proof, 20).proved);
  }
}

}  // namespace
}  // namespace tripus::structure
