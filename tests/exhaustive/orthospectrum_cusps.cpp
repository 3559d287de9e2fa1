// The laws of orthospectrum/README.md with cusps beside the geodesic boundary, on every cusped
// triangulation with three and four tetrahedra; and proved lengths.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "orthospectrum/identities.hpp"
#include "orthospectrum/proved_lengths.hpp"
#include "structure/proof/arc_lengths.hpp"
#include "tests/support/spectra.hpp"
#include "topology/covers/covers.hpp"
#include "topology/isomorphism.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::orthospectrum {
namespace {

using topology::Triangulation;

struct Cusped {
  std::string name;
  Triangulation triangulation;
  structure::Report report;
};

std::optional<structure::Report> metric_on(const Triangulation& triangulation) {
  structure::SolveOptions options;
  options.evidence = false;
  structure::Report report = structure::solve(triangulation, options);
  if (report.outcome != structure::Outcome::kGeometric) return std::nullopt;
  return report;
}

std::vector<Cusped> cusped() {
  std::vector<Cusped> result;
  for (const std::string& name : testing::data_lines("triangulations-cusped.txt")) {
    Triangulation triangulation(topology::decode_isosig(name));
    if (auto report = metric_on(triangulation))
      result.push_back({name, std::move(triangulation), *std::move(report)});
  }
  return result;
}

std::vector<double> lengths_up_to(const Triangulation& triangulation,
                                  const structure::Report& report, double length) {
  return testing::lengths_of(testing::spectrum_of(triangulation, report, length));
}

// O2
TEST(OrthospectrumCusps, PartialSumsStayBelowAndTailsAgree) {
  const auto manifolds = cusped();
  EXPECT_GE(manifolds.size(), 31u);
  for (const Cusped& each : manifolds) {
    const double area = testing::boundary_area(each.report), volume = each.report.volume;
    for (const double length : {2.0, 5.0, 7.0}) {
      SpectrumOptions options;
      options.length = length;
      options.keep_arcs = false;
      const Spectrum spectrum =
          orthospectrum(each.triangulation, each.report.edge_lengths, options);
      EXPECT_LT(spectrum.sums.area(), area) << each.name;
      EXPECT_LT(spectrum.sums.volume(), volume) << each.name;
      EXPECT_EQ(spectrum.sums.oriented_count() % 2, 0u) << each.name;
      if (length < 7) continue;
      const Identities found = identities_of(spectrum.sums, length, area, volume);
      ASSERT_TRUE(found.area.tail && found.volume_from_area) << each.name;
      EXPECT_NEAR(found.area.counted + found.area.tail->value, area, found.area.tail->uncertainty)
          << each.name;
      EXPECT_NEAR(found.volume_from_area->value, volume, found.volume_from_area->uncertainty)
          << each.name;
      EXPECT_LT(found.volume_from_area->uncertainty, 5e-3 * volume) << each.name;
    }
  }
}

// O3
TEST(OrthospectrumCusps, TriangulationsByMovesHaveTheSameSpectrum) {
  const auto manifolds = cusped();
  std::size_t pairs = 0;
  for (std::uint64_t seed = 0; pairs < 60; ++seed) {
    ASSERT_LT(seed, 3000u);
    const Cusped& each = manifolds[seed % manifolds.size()];
    topology::Gluings gluings = each.triangulation.gluings();
    topology::RandomMovesOptions moves;
    moves.count = 1 + seed % 4;
    moves.seed = seed;
    moves.max_tetrahedra = gluings.tetrahedron_count() + 3;
    topology::randomize(gluings, moves);
    if (topology::is_isomorphic(gluings, each.triangulation.gluings())) continue;
    const Triangulation other(gluings);
    const auto report = metric_on(other);
    if (!report) continue;
    ++pairs;
    EXPECT_LT(testing::difference(lengths_up_to(each.triangulation, each.report, 5),
                                  lengths_up_to(other, *report, 5)),
              1e-9)
        << each.name;
  }
}

// O4
TEST(OrthospectrumCusps, EachArcHasTwoLiftsInADoubleCover) {
  std::size_t covers = 0;
  for (const Cusped& each : cusped()) {
    const auto below = lengths_up_to(each.triangulation, each.report, 5);
    topology::for_each_cover(each.triangulation, 2, [&](const topology::Cover& cover) {
      const Triangulation above(cover.gluings);
      const auto report = metric_on(above);
      EXPECT_TRUE(report) << each.name;
      const auto lifted = lengths_up_to(above, *report, 5);
      EXPECT_EQ(lifted.size(), 2 * below.size()) << each.name;
      for (std::size_t k = 0; k < std::min(lifted.size(), 2 * below.size()); ++k)
        EXPECT_NEAR(lifted[k], below[k / 2], 1e-9) << each.name;
      ++covers;
      return false;
    });
  }
  EXPECT_GT(covers, 20u);
}

// O6
TEST(OrthospectrumCusps, FacesAndTilesGiveTheLengthsAgain) {
  std::size_t arcs = 0;
  for (const Cusped& each : cusped()) {
    const Spectrum spectrum = testing::spectrum_of(each.triangulation, each.report, 5, true);
    for (const Arc& arc : spectrum.arcs) {
      const auto faces = std::span(spectrum.faces).subspan(arc.first_face, arc.face_count);
      const double cosh = cosh_along(each.triangulation, each.report.edge_lengths, arc.start.tile,
                                     faces, arc.end.tile);
      EXPECT_NEAR(std::acosh(cosh), arc.length, 1e-10) << each.name;
      ++arcs;
    }
  }
  EXPECT_GT(arcs, 1000u);
}

TEST(ProvedLengths, EncloseWhatDoublesFindOnAllManifoldsOfTwoAndThreeTetrahedra) {
  for (const testing::Row& row : testing::compact_manifolds()) {
    const std::string& name = row.at("isosig");
    const Triangulation triangulation(topology::decode_isosig(name));
    const auto report = metric_on(triangulation);
    ASSERT_TRUE(report) << name;
    const Spectrum spectrum = testing::spectrum_of(triangulation, *report, 5, true);
    const ProvedLengths proved = prove_lengths(triangulation, report->edge_lengths, spectrum);
    ASSERT_TRUE(proved.proved) << name << " " << proved.reason;
    for (std::size_t n = 0; n < spectrum.arcs.size(); ++n) {
      const structure::Interval& interval = *proved.arcs[n];
      EXPECT_LE(interval.lower, interval.upper);
      EXPECT_LT(interval.upper - interval.lower, 1e-14) << name;
      EXPECT_NEAR(interval.lower, spectrum.arcs[n].length, 1e-11) << name;
    }
    const Grouping grouping = group_arcs(spectrum, triangulation);
    for (const ArcGroup& group : grouping.groups) {
      // All arcs of a group enclose one number here: equal lengths are equal by symmetry.
      const auto hull = proved.of(grouping, group);
      ASSERT_TRUE(hull) << name;
      EXPECT_LT(hull->upper - hull->lower, 1e-9) << name;
    }
  }
}

TEST(ProvedLengths, OfLongArcsTakeMoreDigitsThanTheProofHas) {
  const Triangulation triangulation(topology::decode_isosig("dLQabccjkjn"));
  const auto report = metric_on(triangulation);
  SpectrumOptions options;
  options.length = 9;
  options.keep_faces = true;
  const Spectrum spectrum = orthospectrum(triangulation, report->edge_lengths, options);
  const ProvedLengths proved = prove_lengths(triangulation, report->edge_lengths, spectrum);
  ASSERT_TRUE(proved.proved) << proved.reason;
  EXPECT_GT(proved.arcs.size(), 5000u);
  for (std::size_t n = 0; n < proved.arcs.size(); ++n) {
    EXPECT_NEAR(proved.arcs[n]->lower, spectrum.arcs[n].length, 1e-10);
    EXPECT_LT(proved.arcs[n]->upper - proved.arcs[n]->lower, 1e-14);
  }
}

// Beside cusps too: the lengths do not depend on the horospheres from which edges are measured.
TEST(ProvedLengths, HoldTheComputedOnesBesideCusps) {
  std::size_t arcs = 0;
  for (const std::string& isosig : testing::data_lines("triangulations-cusped.txt")) {
    const topology::Triangulation triangulation(topology::decode_isosig(isosig));
    const auto report = structure::solve(triangulation);
    if (report.outcome != structure::Outcome::kGeometric) continue;
    const auto spectrum = testing::spectrum_of(triangulation, report, 3.5, true);
    const ProvedLengths proved = prove_lengths(triangulation, report.edge_lengths, spectrum);
    ASSERT_TRUE(proved.proved) << isosig << ": " << proved.reason;
    std::vector<double> moved = report.edge_lengths;
    for (std::size_t e = 0; e < moved.size(); ++e) {
      const topology::EdgeCorner corner = triangulation.corners(e)[0];
      for (const int end : topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())])
        if (triangulation.link(triangulation.vertex_class(corner.tetrahedron(), end))
                .euler_characteristic == 0)
          moved[e] += 0.25;
    }
    const ProvedLengths again = prove_lengths(triangulation, moved, spectrum);
    ASSERT_TRUE(again.proved) << isosig << ": " << again.reason;
    for (std::size_t n = 0; n < spectrum.arcs.size(); ++n) {
      const double length = spectrum.arcs[n].length;
      EXPECT_LE(proved.arcs[n]->lower, length + 1e-11) << isosig;
      EXPECT_GE(proved.arcs[n]->upper, length - 1e-11) << isosig;
      EXPECT_LT(proved.arcs[n]->upper - proved.arcs[n]->lower, 1e-11) << isosig;
      EXPECT_LE(std::max(proved.arcs[n]->lower, again.arcs[n]->lower),
                std::min(proved.arcs[n]->upper, again.arcs[n]->upper))
          << isosig;
      ++arcs;
    }
  }
  EXPECT_GT(arcs, 500u);
}

TEST(ProvedLengths, OfWaysThatAreNone) {
  const Triangulation triangulation(topology::decode_isosig("cPcbbbihq"));
  const auto report = metric_on(triangulation);
  const structure::Proof proof = structure::prove(triangulation, report->edge_lengths);
  ASSERT_TRUE(proof.proved);
  // From a plane to itself, at once and across a face and back.
  const std::uint8_t there = 1;
  const topology::Perm4 p = triangulation.gluings().gluing(0, there);
  const std::array<std::uint8_t, 2> back{there, static_cast<std::uint8_t>(p(there))};
  for (const structure::ArcPath& path :
       {structure::ArcPath{0, 0, {}, 0}, structure::ArcPath{0, 0, back, 0}}) {
    const auto lengths = structure::prove_arc_lengths(triangulation, proof, std::span(&path, 1));
    EXPECT_FALSE(lengths.at(0));
  }
  const std::uint8_t no_face = 7;
  for (const structure::ArcPath& path :
       {structure::ArcPath{2, 0, {}, 1}, structure::ArcPath{0, 4, {}, 1},
        structure::ArcPath{0, 0, {}, -1}, structure::ArcPath{0, 0, std::span(&no_face, 1), 1}})
    EXPECT_THROW(structure::prove_arc_lengths(triangulation, proof, std::span(&path, 1)),
                 InvalidInput);
  // Nothing without a proof.
  const structure::ArcPath edge{0, 0, {}, 1};
  EXPECT_FALSE(structure::prove_arc_lengths(triangulation, {}, std::span(&edge, 1)).at(0));
}

}  // namespace
}  // namespace tripus::orthospectrum
