// Cusps and cone angles by two routes: methods, starts, labels, covers, quadrature.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "energies/co_volume.hpp"
#include "structure/existence.hpp"
#include "structure/horospheres.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/ridders.hpp"
#include "topology/covers/covers.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

using topology::ConeAngle;
using topology::Triangulation;

Triangulation decoded(const std::string& isosig) {
  return Triangulation(topology::decode_isosig(isosig));
}

/// Cusped manifolds with and without geodesic boundary, orientable and not.
std::vector<std::string> some_cusped() {
  std::vector<std::string> found = {"bkaaid", "cPcbbbiht", "dLQacccjjkg"};
  const auto rows = testing::data_table("cusped-census-5.tsv");
  for (std::size_t i = 0; i < rows.size(); i += 23) found.push_back(rows[i].at("isosig"));
  const auto mixed = testing::data_lines("triangulations-cusped.txt");
  for (std::size_t i = 1; i < mixed.size(); i += 9) found.push_back(mixed[i]);
  return found;
}

Report solved(const Triangulation& m, std::vector<ConeAngle> cone_angles = {}) {
  SolveOptions options;
  options.cone_angles = std::move(cone_angles);
  return solve(m, options);
}

TEST(Cusps, EveryMethodFindsTheSameMetric) {
  for (const std::string& isosig : some_cusped()) {
    const Triangulation m = decoded(isosig);
    const Report newton = solved(m);
    for (const char* method : {"newton-cg", "newton-cg-block", "ceres-lbfgs", "ceres-bfgs",
                               "ceres-cg", "ceres-lm", "flow:curvature/dopri5"}) {
      SCOPED_TRACE(isosig + " " + method);
      SolveOptions options;
      options.method = method;
      options.tolerance = 1e-11;
      const Report report = solve(m, options);
      ASSERT_EQ(report.outcome, newton.outcome) << report.message;
      if (newton.outcome != Outcome::kGeometric) continue;
      EXPECT_NEAR(report.volume, newton.volume, 1e-10);
      for (std::size_t e = 0; e < m.edge_count(); ++e)
        EXPECT_NEAR(report.edge_lengths[e], newton.edge_lengths[e], 1e-8);
    }
  }
}

TEST(Cusps, StartAndHorospheresDoNotMatter) {
  std::mt19937_64 random(11);
  for (const std::string& isosig : some_cusped()) {
    SCOPED_TRACE(isosig);
    const Triangulation m = decoded(isosig);
    const Report first = solved(m);
    const energies::CoVolume energy(m);
    for (int n = 0; n < 8; ++n) {
      SolveOptions options;
      for (std::size_t e = 0; e < m.edge_count(); ++e) {
        const double x = double(random() >> 11) * 0x1p-53;
        const bool plain = energy.is_between_hyperideal(e);
        options.initial_lengths.push_back(plain ? std::exp(6 * x - 3) : 40 * x - 20);
      }
      const Report report = solve(m, options);
      ASSERT_EQ(report.outcome, first.outcome) << report.message;
      if (first.outcome != Outcome::kGeometric) continue;
      EXPECT_NEAR(report.volume, first.volume, 1e-11);
      for (std::size_t e = 0; e < m.edge_count(); ++e)
        EXPECT_NEAR(report.edge_lengths[e], first.edge_lengths[e], 1e-9);
    }
  }
}

TEST(Cusps, LabelsOfTheTriangulationDoNotMatter) {
  std::mt19937_64 random(5);
  for (const std::string& isosig : some_cusped()) {
    SCOPED_TRACE(isosig);
    const Triangulation m = decoded(isosig);
    const Report first = solved(m);
    topology::Isomorphism shuffle;
    for (std::size_t t = 0; t < m.tetrahedron_count(); ++t) {
      shuffle.tetrahedron_images.push_back(static_cast<topology::TetrahedronIndex>(t));
      shuffle.perms.push_back(topology::Perm4::from_rank(static_cast<int>(random() % 24)));
    }
    std::ranges::shuffle(shuffle.tetrahedron_images, random);
    const Report second = solved(Triangulation(topology::relabelled(m.gluings(), shuffle)));
    EXPECT_EQ(second.outcome, first.outcome);
    if (first.outcome != Outcome::kGeometric) continue;
    EXPECT_NEAR(second.volume, first.volume, 1e-12);
    auto a = first.edge_lengths, b = second.edge_lengths;
    std::ranges::sort(a);
    std::ranges::sort(b);
    for (std::size_t e = 0; e < a.size(); ++e) EXPECT_NEAR(a[e], b[e], 1e-10);
  }
}

/// All double covers that are orientable have twice the volume, and so have the others.
TEST(Cusps, DoubleCoversHaveTwiceTheVolume) {
  int covers = 0, orienting = 0;
  for (const auto& row : testing::data_table("cusped-census-5.tsv")) {
    if (row.at("orientable") == "yes") continue;
    SCOPED_TRACE(row.at("isosig"));
    const Triangulation m = decoded(row.at("isosig"));
    topology::for_each_cyclic_cover(m, 2, [&](const topology::Cover& cover) {
      const Triangulation doubled(cover.gluings);
      ++covers;
      orienting += doubled.is_orientable();
      const Report report = solved(doubled);
      EXPECT_EQ(report.outcome, Outcome::kGeometric) << report.message;
      EXPECT_NEAR(report.volume, 2 * std::stod(row.at("volume")), 1e-11);
      return true;
    });
  }
  EXPECT_GE(covers, 200);
  EXPECT_EQ(orienting, 114);  // one for each manifold
}

TEST(Cusps, TheGradientIsThatOfTheValueAndHorospheresChangeNeither) {
  std::mt19937_64 random(2);
  for (const std::string& isosig : some_cusped()) {
    SCOPED_TRACE(isosig);
    const Triangulation m = decoded(isosig);
    const Report report = solved(m);
    if (report.outcome != Outcome::kGeometric) continue;
    const energies::CoVolume energy(m);
    std::vector<double> x = report.edge_lengths, d(x.size()), Hd(x.size());
    for (std::size_t e = 0; e < x.size(); ++e) {
      x[e] += 0.02 * (double(random() >> 11) * 0x1p-53 - 0.5);
      d[e] = double(random() >> 11) * 0x1p-52 - 1;
    }
    const auto at = energy.at(x, solver::Order::kSecond);
    ASSERT_TRUE(at.is_defined());
    at.hessian_times(d, Hd);
    const std::vector<double> g(at.gradient().begin(), at.gradient().end());
    const auto along = [&](double step) {
      std::vector<double> moved = x;
      for (std::size_t e = 0; e < x.size(); ++e) moved[e] += step * d[e];
      return energy.at(moved);
    };
    const auto slope = testing::ridders([&](double s) { return along(s).value(); }, 1e-2);
    double expected = 0;
    for (std::size_t e = 0; e < x.size(); ++e) expected += g[e] * d[e];
    EXPECT_NEAR(slope.value, expected, 1e-8 + 10 * slope.error);
    const auto bend = testing::ridders(
        [&](double s) {
          const auto there = along(s);
          double sum = 0;
          for (std::size_t e = 0; e < x.size(); ++e) sum += there.gradient()[e] * d[e];
          return sum;
        },
        1e-2);
    double quadratic = 0;
    for (std::size_t e = 0; e < x.size(); ++e) quadratic += Hd[e] * d[e];
    EXPECT_NEAR(bend.value, quadratic, 1e-7 * (1 + quadratic) + 10 * bend.error);
    // Curvature sums to 0 over the edge ends at a cusp, anywhere: nothing lies along the shifts.
    std::vector<double> across = g;
    remove_horosphere_shifts(m, energy, across);
    for (std::size_t e = 0; e < x.size(); ++e) EXPECT_NEAR(across[e], g[e], 1e-13);
  }
}

// Schlaefli: dV/dk_e = -l_e / 2 along a path of cone angles, by Gauss's rule with 12 nodes on
// panels, from the order-2 orbifold to the order-3 one.
TEST(ConeAngles, SchlaefliQuadratureGivesTheVolume) {
  constexpr double kNodes[6] = {0.1252334085114689, 0.3678314989981802, 0.5873179542866175,
                                0.7699026741943047, 0.9041172563704749, 0.9815606342467193};
  constexpr double kWeights[6] = {0.2491470458134028, 0.2334925365383548, 0.2031674267230659,
                                  0.1600783285433462, 0.1069393259953184, 0.0471753363865118};
  for (const char* isosig : {"cPcbbbihq", "cPcbbbiht", "dLQacccjjkg"}) {
    SCOPED_TRACE(isosig);
    const Triangulation m = decoded(isosig);
    const energies::CoVolume plain(m);
    const double from = std::numbers::pi, to = 2 * std::numbers::pi / 3;
    // In dLQacccjjkg only edges between hyperideal vertices are labelled.
    const auto angles_at = [&](double k) {
      std::vector<ConeAngle> angles(m.edge_count());
      for (std::size_t e = 0; e < angles.size(); ++e)
        if (isosig != std::string("dLQacccjjkg") || plain.is_between_hyperideal(e)) angles[e] = k;
      return angles;
    };
    const auto integrand = [&](double k) {
      const auto angles = angles_at(k);
      const Report report = solved(m, angles);
      EXPECT_EQ(report.outcome, Outcome::kGeometric) << report.message;
      double sum = 0;
      for (std::size_t e = 0; e < angles.size(); ++e)
        if (!angles[e].is_full()) sum -= report.edge_lengths[e] / 2;
      return sum;
    };
    double integral = 0;
    const double half = (to - from) / 2, middle = (to + from) / 2;
    for (int i = 0; i < 6; ++i)
      integral += kWeights[i] * half *
                  (integrand(middle - half * kNodes[i]) + integrand(middle + half * kNodes[i]));
    EXPECT_NEAR(solved(m, angles_at(to)).volume - solved(m, angles_at(from)).volume, integral,
                1e-10);
  }
}

// Orders to infinity: the volume grows to that of the parabolic edge, the gap like 1 / n^2.
TEST(ConeAngles, OrdersToInfinityApproachTheParabolicEdge) {
  for (const char* isosig : {"cPcbbbihq", "cPcbbbiht"}) {
    const Triangulation m = decoded(isosig);
    std::vector<ConeAngle> angles(m.edge_count(), ConeAngle::rational(1, 1));
    angles[0] = ConeAngle::rational(0, 1);
    const Report limit = solved(m, angles);
    ASSERT_EQ(limit.outcome, Outcome::kGeometric) << limit.message;
    EXPECT_EQ(limit.edge_lengths[0], 0);
    double last = 0, scaled = 0;
    for (const int n : {4, 8, 16, 32, 64, 128}) {
      angles[0] = ConeAngle::rational(2, n);
      const double volume = solved(m, angles).volume;
      EXPECT_GT(volume, last);
      EXPECT_LT(volume, limit.volume);
      const double gap = (limit.volume - volume) * n * n;
      if (n >= 32) {
        EXPECT_NEAR(gap, scaled, 0.02 * gap);
      }
      scaled = gap;
      last = volume;
    }
  }
}

// Every verdict with cusps or labels has its exact proof, and a changed proof is not accepted.
TEST(ConeAngles, VerdictsHaveCertificates) {
  int strict = 0, refused = 0;
  std::mt19937_64 random(8);
  std::vector<std::string> all = testing::data_lines("triangulations-cusped.txt");
  for (const char* more : {"cPcbbbiht", "cPcbbbihq", "bkaaid", "cPcbbbadh"}) all.push_back(more);
  for (const std::string& isosig : all) {
    const Triangulation m = decoded(isosig);
    for (int n = 0; n < 3; ++n) {
      std::vector<ConeAngle> angles(m.edge_count());
      for (std::size_t e = 0; n > 0 && e < angles.size(); ++e)
        if (random() % 3 == 0)
          angles[e] = ConeAngle::rational(2, 2 + static_cast<int>(random() % 4));
      SCOPED_TRACE(isosig + " " + std::to_string(n));
      const Existence found = existence(m, angles);
      const Report report = solved(m, angles);
      if (const auto* structure = std::get_if<StrictAngles>(&found)) {
        ++strict;
        EXPECT_TRUE(check(m, *structure)) << check(m, *structure).reason;
        EXPECT_NE(report.outcome, Outcome::kInfeasible);
        StrictAngles changed = *structure;
        changed.numerator[0][0] += 1;
        EXPECT_FALSE(check(m, changed));
      } else {
        ++refused;
        auto certificate = std::get<Certificate>(found);
        EXPECT_TRUE(check(m, certificate)) << check(m, certificate).reason;
        EXPECT_NE(report.outcome, Outcome::kGeometric);
        EXPECT_EQ(parse_certificate(to_json(certificate)), certificate);
        certificate.edge[0] += 1000000;
        EXPECT_FALSE(check(m, certificate));
      }
    }
  }
  EXPECT_GT(strict, 20);
  EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace tripus::structure
