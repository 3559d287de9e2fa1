// Proofs with cusps, cone angles and parabolic edges: every metric of the lists is proved, the
// truth is inside, and nothing wrong is accepted.
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "structure/proof/detail/cone_metric.hpp"
#include "structure/proof/prove_report.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/orb_examples.hpp"
#include "topology/cyclic_cover.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::structure {
namespace {

using topology::ConeAngle;
using topology::Triangulation;

struct Proved {
  Triangulation triangulation;
  std::vector<ConeAngle> cone_angles;
  Report report;
  Proof proof;
};

Proved proved(Triangulation triangulation, std::vector<ConeAngle> cone_angles = {}) {
  SolveOptions options;
  options.cone_angles = cone_angles;
  Report report = solve(triangulation, options);
  EXPECT_EQ(report.outcome, Outcome::kGeometric) << report.message;
  ProveOptions prove_options;
  prove_options.cone_angles = cone_angles;
  Proof proof = prove(triangulation, report.edge_lengths, prove_options);
  EXPECT_TRUE(proof.proved) << proof.reason;
  return {std::move(triangulation), std::move(cone_angles), std::move(report), std::move(proof)};
}

Proved proved(const std::string& isosig, std::vector<ConeAngle> cone_angles = {}) {
  return proved(Triangulation(topology::decode_isosig(isosig)), std::move(cone_angles));
}

/// Whether a decimal number of 20 significant digits, rounded, may be in the interval.
void expect_within(const DecimalInterval& interval, const std::string& value) {
  const long double truth = std::stold(value), error = 1e-18L * std::fabs(truth);
  EXPECT_LE(std::stold(interval.lower), truth + error);
  EXPECT_GE(std::stold(interval.upper), truth - error);
}

ProofText with_digits(const Proved& one, int digits) {
  return prove_report(one.triangulation, one.report,
                      {.digits = digits, .cone_angles = one.cone_angles});
}

TEST(CuspedProofs, SnapPysCensusUpToFiveTetrahedra) {
  std::size_t count = 0;
  for (const auto& row : testing::data_table("cusped-census-5.tsv")) {
    SCOPED_TRACE(row.at("isosig"));
    const Proved one = proved(row.at("isosig"));
    EXPECT_EQ(one.proof.bits, 53);
    EXPECT_EQ(one.proof.escalated, 0u);
    EXPECT_LT(one.proof.largest_radius(), 1e-12);
    const long double volume = std::stold(row.at("volume"));
    EXPECT_LE(one.proof.volume.lower, volume + 2e-18L * volume);
    EXPECT_GE(one.proof.volume.upper, volume - 2e-18L * volume);
    EXPECT_LT(one.proof.volume.upper - one.proof.volume.lower, 1e-13);
    if (count++ % 5 != 0) continue;
    const ProofCheck check = check_proof(one.triangulation, proof_text(one.proof));
    EXPECT_TRUE(check) << check.reason;
  }
  EXPECT_EQ(count, 415u);
}

TEST(CuspedProofs, ManyDigits) {
  std::size_t k = 0;
  for (const auto& row : testing::data_table("cusped-census-5.tsv")) {
    if (k++ % 20 != 0) continue;
    SCOPED_TRACE(row.at("isosig"));
    const Proved one = proved(row.at("isosig"));
    const ProofText text = with_digits(one, 30);
    ASSERT_TRUE(text.proved) << text.reason;
    expect_within(*text.volume, row.at("volume"));
    EXPECT_EQ(text.volume->lower.substr(0, 25), text.volume->upper.substr(0, 25));
    const ProofCheck check = check_proof(one.triangulation, text);
    EXPECT_TRUE(check) << check.reason;
  }
}

// Geodesic boundary and cusps; those that carry no metric have a certificate instead.
TEST(CuspedProofs, BesideGeodesicBoundary) {
  std::size_t geometric = 0;
  for (const std::string& isosig : testing::data_lines("triangulations-cusped.txt")) {
    SCOPED_TRACE(isosig);
    const Triangulation m(topology::decode_isosig(isosig));
    if (solve(m).outcome != Outcome::kGeometric) continue;
    ++geometric;
    const Proved one = proved(m);
    const ProofCheck check = check_proof(m, proof_text(one.proof));
    EXPECT_TRUE(check) << check.reason;
    // No box reaches lengths <= 0 between hyperideal vertices, where there is no tetrahedron.
    const detail::ConeMetric metric(m, {});
    for (std::size_t e = 0; e < m.edge_count(); ++e)
      if (!metric.may_be_negative(e)) {
        EXPECT_LT(one.proof.box[e], one.proof.lengths[e]);
      }
  }
  EXPECT_EQ(geometric, 41u);
}

TEST(CuspedProofs, OrbifoldsOfOrb) {
  std::size_t count = 0;
  for (const auto& row : testing::data_table("orb-examples.tsv")) {
    if (row.at("solution") != "geometric_solution" || row.at("finite_vertices") == "yes") continue;
    SCOPED_TRACE(row.at("name"));
    const testing::Labelled example = testing::orb_example(row);
    const Proved one = proved(example.triangulation, example.cone_angles);
    EXPECT_NEAR(one.proof.volume.lower, std::stod(row.at("volume")), 1e-11);
    const ProofText text = proof_text(one.proof);
    const ProofCheck check = check_proof(one.triangulation, parse_proof(to_json(text)));
    EXPECT_TRUE(check) << check.reason;
    ++count;
  }
  EXPECT_EQ(count, 60u);
}

// Two cone angles at a cusp, one wider and one narrower by as much: floating point solves for it,
// but the angles are doubles, and their sum is not what a cusp needs.
TEST(CuspedProofs, NotOfCuspsThatAreThereWithinRoundingOnly) {
  std::size_t count = 0;
  for (const auto& row : testing::data_table("cusped-census-5.tsv")) {
    if (row.at("tetrahedra") == "5") continue;
    SCOPED_TRACE(row.at("isosig"));
    const topology::Triangulation triangulation(topology::decode_isosig(row.at("isosig")));
    if (triangulation.edge_count() < 2 || !triangulation.is_orientable()) continue;
    const detail::ConeMetric whole(triangulation, {});
    const auto [a, b] = whole.ends(0);
    const auto [c, d] = whole.ends(1);
    if (a != b || c != d || a != c) continue;
    SolveOptions options;
    options.cone_angles.resize(triangulation.edge_count());
    for (const double sign : {1.0, -1.0}) {
      ConeAngle& angle = options.cone_angles[sign > 0 ? 0 : 1];
      angle = ConeAngle(angle.radians() + sign * 0x1p-7);
      ASSERT_FALSE(angle.is_rational());
    }
    const Report report = solve(triangulation, options);
    if (report.outcome != Outcome::kGeometric) continue;
    ++count;
    ProveOptions prove_options;
    prove_options.cone_angles = options.cone_angles;
    const Proof proof = prove(triangulation, report.edge_lengths, prove_options);
    EXPECT_FALSE(proof.proved);
    EXPECT_NE(proof.reason.find("cusp only within rounding"), std::string::npos) << proof.reason;
    ProofText claimed;
    claimed.proved = true;
    claimed.cone_angles = options.cone_angles;
    claimed.lengths.assign(triangulation.edge_count(), "0.5");
    claimed.radii.assign(triangulation.edge_count(), "1e-3");
    EXPECT_NE(check_proof(triangulation, claimed).reason.find("no cusp at its end"),
              std::string::npos);
  }
  EXPECT_GT(count, 50u);
}

// The tripus with cone angle k at its one edge: volumes fall as the angle grows (Schlaefli), and
// the parabolic edge is the limit. Angles that are no fraction of pi are exact as doubles.
TEST(CuspedProofs, OfOneEdgeWithEveryConeAngle) {
  const Proved parabolic = proved("cPcbbbihq", {ConeAngle::rational(0, 1)});
  double above = parabolic.proof.volume.lower;
  EXPECT_EQ(parabolic.proof.largest_radius(), 0);
  for (const ConeAngle angle :
       {ConeAngle::rational(2, 50), ConeAngle::rational(2, 7), ConeAngle(1.234),
        ConeAngle::rational(1, 1), ConeAngle(4.0), ConeAngle(), ConeAngle(7.0)}) {
    SCOPED_TRACE(angle.radians());
    const Proved one = proved("cPcbbbihq", {angle});
    EXPECT_LT(one.proof.volume.upper, above);
    above = one.proof.volume.lower;
    const ProofText text = parse_proof(to_json(proof_text(one.proof)));
    EXPECT_EQ(text.cone_angles.empty(), angle.is_full());
    EXPECT_TRUE(check_proof(one.triangulation, text));
    ProofText other = text;
    other.cone_angles = {ConeAngle(angle.radians() * (1 + 1e-12))};
    EXPECT_FALSE(check_proof(one.triangulation, other));
  }
}

// The tripus with the cone angles that make its edge 1e-3 to 16 long, and covers of it, each
// tetrahedron with that one length.
TEST(CuspedProofs, OfEdgesFromAThousandthToSixteen) {
  const Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  std::size_t count = 0, escalated = 0, polished = 0;
  for (const std::size_t sheets : {1u, 5u, 50u}) {
    const Triangulation cover(
        topology::cyclic_cover(tripus.gluings(), *topology::primitive_class(tripus), sheets));
    for (double l = 1e-3; l < 16.01; l *= 1.3) {
      SCOPED_TRACE(l);
      // theory (26): cos t = c / (2 c - 1), c = cosh l, so that sin t = sqrt((3c-1)(c-1)) / (2c-1).
      const double less = 2 * std::sinh(l / 2) * std::sinh(l / 2), c = 1 + less;
      const double angle = 12 * std::atan2(std::sqrt((3 * c - 1) * less), c);
      ProveOptions options;
      options.cone_angles.assign(cover.edge_count(), ConeAngle(angle));
      SolveOptions solve_options;
      solve_options.cone_angles = options.cone_angles;
      const Report report = solve(cover, solve_options);
      ASSERT_EQ(report.outcome, Outcome::kGeometric) << report.message;
      EXPECT_NEAR(report.edge_lengths[0], l, 1e-6 * l);
      const Proof proof = prove_near(cover, report.edge_lengths, options);
      EXPECT_TRUE(proof.proved) << proof.reason;
      EXPECT_LT(proof.largest_radius(), 1e-9);
      polished += !prove(cover, report.edge_lengths, options).proved;
      escalated += proof.escalated > 0;
      ++count;
    }
  }
  std::printf("%zu proved, %zu by escalation, %zu after Newton's method in Arb\n", count, escalated,
              polished);
  EXPECT_EQ(count, 111u);
}

// Several cusps, and covers, whose volumes are multiples.
TEST(CuspedProofs, OfCovers) {
  for (const std::string isosig : {"cPcbbbiht", "dLQacccjjkg"}) {
    const Triangulation m(topology::decode_isosig(isosig));
    const Proved below = proved(m);
    const auto shifts = topology::primitive_class(m);
    ASSERT_TRUE(shifts);
    for (const std::size_t sheets : {2u, 3u, 40u}) {
      SCOPED_TRACE(isosig + " " + std::to_string(sheets));
      const Proved above =
          proved(Triangulation(topology::cyclic_cover(m.gluings(), *shifts, sheets)));
      const auto times = static_cast<double>(sheets);
      EXPECT_LE(above.proof.volume.lower, times * below.proof.volume.upper);
      EXPECT_GE(above.proof.volume.upper, times * below.proof.volume.lower);
      const ProofCheck check = check_proof(above.triangulation, proof_text(above.proof));
      EXPECT_TRUE(check) << check.reason;
    }
  }
}

/// Adds c to the length of an edge for each of its ends at a cusp.
std::vector<double> moved_horosphere(const Proved& one, std::size_t cusp, double c) {
  std::vector<double> lengths = one.report.edge_lengths;
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const topology::EdgeCorner corner = one.triangulation.corners(e)[0];
    for (const int end : topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())])
      if (one.triangulation.vertex_class(corner.tetrahedron(), end) == cusp) lengths[e] += c;
  }
  return lengths;
}

// A metric's lengths for other horospheres are as good; any other change beyond the radii is not.
TEST(CuspedProofs, OfChangedLengthsAreRefusedUnlessAHorosphereMoved) {
  std::mt19937_64 random(20261130);
  std::uniform_real_distribution<double> sign(-1, 1);
  const auto rows = testing::data_table("cusped-census-5.tsv");
  std::size_t refused = 0;
  for (std::size_t k = 7; k < rows.size(); k += 13) {
    SCOPED_TRACE(rows[k].at("isosig"));
    const Proved one = proved(rows[k].at("isosig"));
    const auto moved = moved_horosphere(one, 0, 0.5 * sign(random));
    const Proof again = prove(one.triangulation, moved);
    EXPECT_TRUE(again.proved) << again.reason;
    EXPECT_NEAR(again.volume.lower, one.proof.volume.lower, 1e-13);
    EXPECT_TRUE(check_proof(one.triangulation, proof_text(again)));
    if (one.triangulation.edge_count() < 2) continue;
    auto lengths = one.report.edge_lengths;
    for (double& l : lengths) l += 1e-5 * sign(random);
    const Proof changed = prove(one.triangulation, lengths);
    // Either way there is a metric near: what is claimed has to hold it, up to horospheres.
    ProofText text = proof_text(one.proof);
    for (std::size_t e = 0; e < lengths.size(); ++e) {
      char buffer[64];
      std::snprintf(buffer, sizeof buffer, "%a", lengths[e]);
      text.lengths[e] = buffer;
    }
    EXPECT_FALSE(check_proof(one.triangulation, text));
    ++refused;
    if (changed.proved) {
      EXPECT_GT(changed.largest_radius(), 1e-8);
    }
  }
  EXPECT_GT(refused, 20u);
}

// Triangulations whose minimiser has flat tetrahedra: the "no" is proved, and checked.
TEST(CuspedProofs, OfFlatMinimisers) {
  std::vector<std::string> signatures = testing::data_lines("triangulations-cusped.txt");
  // 2-3 moves at every face of some of SnapPy's manifolds.
  const auto rows = testing::data_table("cusped-census-5.tsv");
  for (std::size_t k = 0; k < rows.size(); k += 12) {
    const topology::Gluings start = topology::decode_isosig(rows[k].at("isosig"));
    for (topology::TetrahedronIndex t = 0; t < start.tetrahedron_count(); ++t)
      for (std::uint8_t f = 0; f < 4; ++f) {
        topology::Gluings gluings = start;
        const topology::Move move{
            .kind = topology::MoveKind::kTwoThree, .tetrahedron = t, .place = f};
        if (!topology::can_apply(gluings, move)) continue;
        topology::apply(gluings, move);
        signatures.push_back(topology::isosig(gluings));
      }
  }
  std::size_t degenerate = 0, proofs = 0;
  for (const std::string& isosig : signatures) {
    SCOPED_TRACE(isosig);
    const Triangulation m(topology::decode_isosig(isosig));
    const Report report = solve(m);
    if (report.outcome != Outcome::kDegenerate) continue;
    ++degenerate;
    const ProofText text = prove_report(m, report, {});
    // Flat tetrahedra with det G = 0 have no box.
    if (!text.proved) continue;
    ++proofs;
    const ProofCheck check = check_proof(m, parse_proof(to_json(text)));
    EXPECT_TRUE(check) << check.reason;
    ProofText other = text;
    other.flat.clear();
    EXPECT_FALSE(check_proof(m, other));
    other = text;
    other.claim = Proof::Claim::kMetric;
    EXPECT_FALSE(check_proof(m, other));
  }
  std::printf("%zu of %zu\n", proofs, degenerate);
  EXPECT_GT(proofs, 80u);
  EXPECT_GT(degenerate, proofs);
}

TEST(CuspedProofs, WhatIsOutOfReachIsSaid) {
  const Triangulation m(topology::decode_isosig("cPcbbbihq"));
  ProveOptions parabolic;
  parabolic.cone_angles = {ConeAngle::rational(0, 1)};
  EXPECT_FALSE(prove(m, std::vector{0.5}, parabolic).proved);
  EXPECT_FALSE(prove(m, std::vector{-0.5}).proved);
}

}  // namespace
}  // namespace tripus::structure
