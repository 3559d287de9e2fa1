// Proofs with finite vertices: closed manifolds and orbifolds, and vertices put into others.
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "structure/proof/prove_report.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/orb_examples.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::structure {
namespace {

using topology::Triangulation;

struct ProvedFinite {
  Report report;
  Proof proof;
};

ProvedFinite proved(const testing::Labelled& example) {
  SolveOptions options;
  options.cone_angles = example.cone_angles;
  Report report = solve(example.triangulation, options);
  if (report.outcome != Outcome::kGeometric) return {std::move(report), {}};
  ProveOptions prove_options;
  prove_options.cone_angles = example.cone_angles;
  Proof proof = prove(example.triangulation, report.edge_lengths, prove_options);
  EXPECT_TRUE(proof.proved) << proof.reason;
  return {std::move(report), std::move(proof)};
}

/// Texts that claim too much.
void expect_refused(const Triangulation& m, const ProofText& text) {
  const std::size_t last = text.lengths.size() - 1;
  ProofText other = text;
  for (std::string& radius : other.radii)
    if (radius != "0") radius = "1e-300";
  EXPECT_FALSE(check_proof(m, other));
  other = text;
  other.volume->lower = other.volume->upper;
  EXPECT_FALSE(check_proof(m, other));
  // A length that is not held, and is off; and one length more that is held.
  std::size_t e = last;
  while (text.radii[e] == "0") --e;
  other = text;
  other.lengths[e] = std::to_string(std::stod(text.lengths[e]) + 1e-5);
  EXPECT_FALSE(check_proof(m, other));
  other = text;
  other.radii[e] = "0";
  EXPECT_FALSE(check_proof(m, other));
}

TEST(FiniteProofs, ExamplesOfOrb) {
  std::size_t geometric = 0;
  for (const auto& row : testing::data_table("orb-examples.tsv")) {
    if (row.at("finite_vertices") != "yes") continue;
    SCOPED_TRACE(row.at("name"));
    const testing::Labelled example = testing::orb_example(row);
    const auto [report, proof] = proved(example);
    if (report.outcome != Outcome::kGeometric) continue;
    ++geometric;
    EXPECT_LT(proof.largest_radius(), 1e-11);
    EXPECT_NEAR(proof.volume.lower, std::stod(row.at("volume")), 1e-9);
    EXPECT_LT(proof.volume.upper - proof.volume.lower, 1e-13);
    EXPECT_NEAR(proof.volume.lower, report.volume, 1e-11);
    const ProofText text = parse_proof(to_json(proof_text(proof)));
    const ProofCheck check = check_proof(example.triangulation, text);
    EXPECT_TRUE(check) << check.reason;
    expect_refused(example.triangulation, text);
  }
  EXPECT_EQ(geometric, 13u);
}

// Lengths that are off are refused, or, where that only moved a vertex, the volume is the same.
TEST(FiniteProofs, OfChangedLengths) {
  std::mt19937_64 random(20261201);
  std::uniform_real_distribution<double> sign(-1, 1);
  for (const auto& row : testing::data_table("orb-examples.tsv")) {
    if (row.at("finite_vertices") != "yes") continue;
    const testing::Labelled example = testing::orb_example(row);
    if (example.triangulation.tetrahedron_count() > 30) continue;
    SCOPED_TRACE(row.at("name"));
    const auto [report, proof] = proved(example);
    if (report.outcome != Outcome::kGeometric) continue;
    ProveOptions options;
    options.cone_angles = example.cone_angles;
    for (const double size : {1e-12, 1e-7, 1e-2}) {
      std::vector<double> lengths = report.edge_lengths;
      for (double& l : lengths) l += size * sign(random);
      const Proof changed = prove(example.triangulation, lengths, options);
      if (size > 1e-3) {
        EXPECT_FALSE(changed.proved);
      }
      if (!changed.proved) continue;
      EXPECT_LE(changed.volume.lower, proof.volume.upper);
      EXPECT_GE(changed.volume.upper, proof.volume.lower);
    }
  }
}

// The same holds exactly: with a vertex moved by hand the lengths are another proof of one metric.
TEST(FiniteProofs, OfAVertexPutIntoATetrahedron) {
  std::size_t count = 0, k = 0;
  for (const std::string& isosig : testing::data_lines("triangulations-3.txt")) {
    if (k++ % 8 != 0) continue;
    SCOPED_TRACE(isosig);
    topology::Gluings gluings = topology::decode_isosig(isosig);
    const Triangulation before(gluings);
    const Report report = solve(before);
    if (report.outcome != Outcome::kGeometric) continue;
    const Proof without = prove(before, report.edge_lengths);
    topology::apply(gluings, {.kind = topology::MoveKind::kOneFour});
    const auto [after, with] = proved({Triangulation(gluings), {}});
    if (after.outcome != Outcome::kGeometric) continue;
    EXPECT_LE(with.volume.lower, without.volume.upper);
    EXPECT_GE(with.volume.upper, without.volume.lower);
    ++count;
  }
  std::printf("%zu manifolds\n", count);
  EXPECT_GT(count, 8u);
}

// What holds for some other cone angle does not hold for this one.
TEST(FiniteProofs, OfOtherConeAnglesAreRefused) {
  for (const auto& row : testing::data_table("orb-examples.tsv")) {
    if (row.at("name") != "A1") continue;
    const testing::Labelled example = testing::orb_example(row);
    const auto [report, proof] = proved(example);
    for (std::size_t e = 0; e < example.cone_angles.size(); ++e) {
      ProveOptions options;
      options.cone_angles = example.cone_angles;
      if (example.cone_angles[e].is_full()) continue;
      options.cone_angles[e] = topology::ConeAngle(example.cone_angles[e].radians() * (1 - 1e-6));
      EXPECT_FALSE(prove(example.triangulation, report.edge_lengths, options).proved);
    }
  }
}

}  // namespace
}  // namespace tripus::structure
