// Proofs on the lists: every geometric triangulation is proved in doubles, and nothing wrong is.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "structure/proof/prove_report.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::structure {
namespace {

using topology::Triangulation;

struct Geometric {
  std::string signature;
  Triangulation triangulation;
  Report report;
  Proof proof;
};

/// The geometric ones among every `step`th line of a list, solved and proved.
std::vector<Geometric> proved_of(const std::string& file, std::size_t step = 1) {
  std::vector<Geometric> result;
  const auto lines = testing::data_lines(file);
  SolveOptions options;
  options.evidence = false;
  for (std::size_t k = 0; k < lines.size(); k += step) {
    Triangulation triangulation(topology::decode_isosig(lines[k]));
    Report report = solve(triangulation, options);
    if (report.outcome != Outcome::kGeometric) continue;
    Proof proof = prove(triangulation, report.edge_lengths);
    result.push_back({lines[k], std::move(triangulation), std::move(report), std::move(proof)});
  }
  return result;
}

/// Whether an interval of a proof may hold the true length, which `truth` encloses too.
bool may_contain(const Proof& claim, const Proof& truth) {
  for (std::size_t e = 0; e < claim.lengths.size(); ++e)
    if (std::fabs(claim.lengths[e] - truth.lengths[e]) >
        (claim.radii[e] + truth.radii[e]) * (1 + 1e-12))
      return false;
  return true;
}

TEST(Proofs, EveryGeometricTriangulationIsProvedInDoubles) {
  std::size_t count = 0;
  double widest = 0, widest_volume = 0;
  for (const char* file : {"triangulations-2.txt", "triangulations-3.txt", "triangulations-4.txt"})
    for (const Geometric& one : proved_of(file)) {
      ++count;
      ASSERT_TRUE(one.proof.proved) << one.signature << ": " << one.proof.reason;
      EXPECT_EQ(one.proof.bits, 53) << one.signature;
      EXPECT_EQ(one.proof.escalated, 0u) << one.signature;
      widest = std::max(widest, one.proof.largest_radius());
      widest_volume = std::max(widest_volume, one.proof.volume.upper - one.proof.volume.lower);
      EXPECT_LE(one.proof.volume.lower, one.report.volume + 1e-13) << one.signature;
      EXPECT_GE(one.proof.volume.upper, one.report.volume - 1e-13) << one.signature;
    }
  EXPECT_EQ(count, 5994u);
  EXPECT_LT(widest, 1e-13);
  EXPECT_LT(widest_volume, 1e-11);
}

TEST(Proofs, ContainTheVolumesOfTheTables) {
  for (const auto& row : testing::compact_manifolds()) {
    const Triangulation triangulation(topology::decode_isosig(row.at("isosig")));
    const Proof proof = prove(triangulation, solve(triangulation).edge_lengths);
    ASSERT_TRUE(proof.proved);
    // 20 digits after the point: more than a double holds.
    const long double volume = std::stold(row.at("volume"));
    EXPECT_LE(proof.volume.lower, volume) << row.at("isosig");
    EXPECT_GE(proof.volume.upper, volume) << row.at("isosig");
  }
}

TEST(Proofs, DoNotDependOnTheNumberOfThreads) {
  const auto all = proved_of("triangulations-3.txt", 50);
  for (const Geometric& one : all) {
    Context context;
    context.threads = 3;
    const Proof again = prove(one.triangulation, one.report.edge_lengths, {}, context);
    EXPECT_EQ(again.radii, one.proof.radii);
    EXPECT_EQ(again.volume.lower, one.proof.volume.lower);
  }
}

TEST(Proofs, OfChangedLengthsAreRefusedOrStillTrue) {
  std::mt19937_64 random(20261129);
  std::uniform_real_distribution<double> sign(-1, 1);
  std::size_t refused = 0, still_true = 0;
  const auto all = proved_of("triangulations-4.txt", 23);
  ProveOptions doubles;  // alone: they are what is quick enough to be tried so often
  doubles.most_bits = 53;
  doubles.volume = false;
  for (int k = 0; k < 100000; ++k) {
    const Geometric& one = all[random() % all.size()];
    auto lengths = one.report.edge_lengths;
    const double size = std::pow(10, -12 + 6 * (1 + sign(random)));
    for (double& l : lengths) l *= 1 + size * sign(random);
    const Proof claim = prove(one.triangulation, lengths, doubles);
    claim.proved ? ++still_true : ++refused;
    if (claim.proved) {
      EXPECT_TRUE(may_contain(claim, one.proof)) << one.signature;
    }
  }
  EXPECT_GT(refused, 10000u);
  EXPECT_GT(still_true, 10000u);
}

TEST(Proofs, WithLengthsBeyondTheirRadiiAreRefusedByTheChecker) {
  std::mt19937_64 random(20261129);
  const auto all = proved_of("triangulations-4.txt", 397);
  for (int k = 0; k < 60; ++k) {
    const Geometric& one = all[random() % all.size()];
    ProofText text = proof_text(one.proof);
    EXPECT_TRUE(check_proof(one.triangulation, text)) << one.signature;
    const std::size_t e = random() % text.lengths.size();
    // Just beyond twice the radius: the true length cannot be in both intervals.
    const double change = one.proof.radii[e] * (k % 2 == 0 ? 2.2 : 1e4) * (k % 4 < 2 ? 1 : -1);
    text.lengths[e] = std::to_string(0);
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.25e", one.proof.lengths[e] + change);
    text.lengths[e] = buffer;
    const ProofCheck check = check_proof(one.triangulation, text);
    EXPECT_FALSE(check) << one.signature;
    EXPECT_NE(check.reason.find("which is not <="), std::string::npos) << check.reason;
  }
}

TEST(Proofs, OfOtherTriangulationsAndSwappedEdgesAreRefused) {
  const auto all = proved_of("triangulations-3.txt", 5);
  int refused = 0;
  for (std::size_t k = 0; k + 1 < all.size(); ++k) {
    const Geometric &one = all[k], &other = all[k + 1];
    if (one.proof.lengths.size() == other.proof.lengths.size() &&
        std::fabs(one.report.volume - other.report.volume) > 1e-6) {
      EXPECT_FALSE(prove(other.triangulation, one.report.edge_lengths).proved);
      EXPECT_FALSE(check_proof(other.triangulation, proof_text(one.proof)));
      ++refused;
    }
    auto swapped = one.report.edge_lengths;
    if (swapped.size() < 2 || std::fabs(swapped[0] - swapped[1]) < 1e-6) continue;
    std::swap(swapped[0], swapped[1]);
    EXPECT_FALSE(prove(one.triangulation, swapped).proved) << one.signature;
    ProofText text = proof_text(one.proof);
    std::swap(text.lengths[0], text.lengths[1]);
    EXPECT_FALSE(check_proof(one.triangulation, text)) << one.signature;
    ++refused;
  }
  EXPECT_GT(refused, 10);
}

TEST(Proofs, OfFlatTetrahedraAndSenselessLengthsAreRefused) {
  const Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  for (const double l : {0.0, -1.0, 1e-300, 50.0, 1e300, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    const Proof proof = prove(tripus, std::vector<double>{l});
    EXPECT_FALSE(proof.proved) << l;
    EXPECT_FALSE(proof.reason.empty());
  }
  EXPECT_THROW(prove(tripus, std::vector<double>{1, 1}), InvalidInput);
  ProveOptions flat;
  flat.flat = {0};
  EXPECT_FALSE(prove(tripus, solve(tripus).edge_lengths, flat).proved);
}

TEST(Proofs, OfVolumesAndAnglesAreCheckedToo) {
  const Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  const Report report = solve(tripus);
  ProofText text = prove_report(tripus, report, {.digits = 30});
  ASSERT_TRUE(text.proved);
  EXPECT_TRUE(check_proof(tripus, text));
  EXPECT_TRUE(text.volume->lower.starts_with("6.4519902708350328652982344210"));
  ProofText volume = text;
  volume.volume->lower = "6.4519902708350328652982344210604";
  EXPECT_FALSE(check_proof(tripus, volume));
  ProofText angle = text;
  angle.dihedral_angles[1][3].upper = angle.dihedral_angles[1][3].lower;
  EXPECT_FALSE(check_proof(tripus, angle));
  ProofText radius = text;
  radius.radii[0] = "1e-60";
  EXPECT_FALSE(check_proof(tripus, radius));
  EXPECT_TRUE(check_proof(tripus, parse_proof(to_json(text))));
}

TEST(Proofs, GiveManyDigitsOnEveryTriangulation) {
  for (const Geometric& one : proved_of("triangulations-4.txt", 499)) {
    const Digits digits = prove_digits(one.triangulation, one.proof, 40);
    ASSERT_TRUE(digits.proved) << one.signature << ": " << digits.reason;
    for (std::size_t e = 0; e < digits.lengths.size(); ++e)
      EXPECT_LE(
          std::fabs(std::stold(digits.lengths[e]) - static_cast<long double>(one.proof.lengths[e])),
          one.proof.radii[e]);
    EXPECT_TRUE(check_proof(one.triangulation, proof_text(one.proof, &digits))) << one.signature;
  }
}

TEST(Proofs, OfSkewedTriangulationsReachedByRandomMoves) {
  const auto lines = testing::data_lines("triangulations-3.txt");
  std::size_t geometric = 0, escalated = 0;
  double longest = 0;
  SolveOptions options;
  options.evidence = false;
  for (std::size_t k = 0; k < 500; ++k) {
    topology::Gluings gluings = topology::decode_isosig(lines[7 * k % lines.size()]);
    topology::RandomMovesOptions moves;
    moves.count = 1 + k % 40;
    moves.seed = k;
    moves.max_tetrahedra = 4 + k % 20;
    topology::randomize(gluings, moves);
    const Triangulation triangulation(gluings);
    const Report report = solve(triangulation, options);
    if (report.outcome != Outcome::kGeometric) continue;
    ++geometric;
    const Proof proof = prove(triangulation, report.edge_lengths);
    EXPECT_TRUE(proof.proved) << topology::isosig(gluings) << ": " << proof.reason;
    escalated += proof.escalated > 0;
    longest = std::max(longest, *std::ranges::max_element(report.edge_lengths));
  }
  std::printf("%zu proved, %zu of them by escalation; longest edge %g\n", geometric, escalated,
              longest);
  EXPECT_GT(geometric, 20u);
}

TEST(Proofs, OfOneTetrahedronAtATimeInArb) {
  // Lengths beyond the doubles' domain are refused there and go to Arb: no metric has them here, so
  // nothing is proved, but nothing goes wrong either.
  const Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  for (const double l : {41.0, 60.0, 300.0}) EXPECT_FALSE(prove(tripus, std::vector{l}).proved);
}

TEST(Proofs, HeedAStop) {
  const Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  const Report report = solve(tripus);
  std::stop_source stop;
  stop.request_stop();
  Context context;
  context.stop = stop.get_token();
  const Proof proof = prove(tripus, report.edge_lengths, {}, context);
  EXPECT_FALSE(proof.proved);
  EXPECT_NE(proof.reason.find("stopped"), std::string::npos);
  EXPECT_FALSE(prove_digits(tripus, prove(tripus, report.edge_lengths), 20, context).proved);
}

TEST(Proofs, OfFlatMinimisers) {
  std::size_t proved = 0, degenerate = 0;
  const auto lines = testing::data_lines("triangulations-4.txt");
  for (std::size_t k = 0; k < lines.size(); k += 29) {
    const Triangulation triangulation(topology::decode_isosig(lines[k]));
    const Report report = solve(triangulation);
    if (report.outcome != Outcome::kDegenerate) continue;
    ++degenerate;
    ProofText text = prove_report(triangulation, report);
    proved += text.proved;
    if (!text.proved) continue;
    EXPECT_TRUE(check_proof(triangulation, text)) << lines[k];
    text.flat[0] = text.flat[0] == 0 ? 1 : 0;
    EXPECT_FALSE(check_proof(triangulation, text)) << lines[k];
  }
  std::printf("%zu of %zu degenerate verdicts proved\n", proved, degenerate);
  EXPECT_GT(degenerate, 0u);
}

}  // namespace
}  // namespace tripus::structure
