#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "structure/existence.hpp"
#include "structure/retriangulate.hpp"
#include "structure/solve.hpp"
#include "tests/support/triangulations.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"
#include "topology/orientation.hpp"

// The claims of docs/verdicts.md as trials with counts. The tests run samples of them, the program
// tests/full/verdicts.cpp all.

namespace tripus::testing {

inline bool is_finite(const structure::Report& report) {
  bool finite = std::isfinite(report.volume) && std::isfinite(report.max_curvature);
  for (const double l : report.edge_lengths) finite = finite && std::isfinite(l);
  for (const auto& angles : report.dihedral_angles)
    for (const double theta : angles)
      finite = finite && theta >= 0 && theta <= std::numbers::pi + 1e-15;
  return finite;
}

/// A minimiser with flat tetrahedra, computed again from its lengths alone and by other formulae:
/// Gram matrices, their cofactors as 3 x 3 determinants, angles by acos, in long double. The flat
/// tetrahedra count with their pattern: pi at one opposite pair of edges, 0 at the others.
struct FlatEvidence {
  long double max_curvature = 0;
  /// |c_kl| / sqrt(c_kk c_ll) at the edges with angle pi is the cosine's absolute value, above 1
  /// where det G > 0, 1 where the four vertices are coplanar. Its least excess over 1 in the flat
  /// tetrahedra, and its greatest shortfall of 1 at any edge of the others, at least.
  long double excess = 1e9L, shortfall = 1e9L;
  /// Edge classes all of whose corners have angle pi in flat tetrahedra.
  std::vector<std::size_t> free_edges;
  double longest = 0;
};

/// Cosines [6] of the dihedral angles before clipping.
inline std::array<long double, 6> unclipped_cosines(const std::array<long double, 6>& lengths) {
  long double g[4][4];
  for (int i = 0; i < 4; ++i) g[i][i] = 1;
  for (std::size_t e = 0; e < 6; ++e) {
    const int i = topology::kEdgeEnds[e][0], j = topology::kEdgeEnds[e][1];
    g[i][j] = g[j][i] = -std::cosh(lengths[e]);
  }
  const auto cofactor = [&](int row, int column) {
    int r[3], c[3];
    for (int k = 0, a = 0, b = 0; k < 4; ++k) {
      if (k != row) r[a++] = k;
      if (k != column) c[b++] = k;
    }
    const auto minor = [&](int p, int q) {
      return g[r[1]][c[p]] * g[r[2]][c[q]] - g[r[1]][c[q]] * g[r[2]][c[p]];
    };
    const long double det =
        g[r[0]][c[0]] * minor(1, 2) - g[r[0]][c[1]] * minor(0, 2) + g[r[0]][c[2]] * minor(0, 1);
    return (row + column) % 2 == 0 ? det : -det;
  };
  std::array<long double, 6> cosines;
  for (std::size_t e = 0; e < 6; ++e) {
    const int k = topology::kEdgeEnds[5 - e][0], l = topology::kEdgeEnds[5 - e][1];
    cosines[e] = cofactor(k, l) / std::sqrt(cofactor(k, k) * cofactor(l, l));
  }
  return cosines;
}

/// `pi_edges[t]` is the edge 0, 1 or 2 with angle pi, together with its opposite one; -1 if
/// tetrahedron t is not flat.
inline FlatEvidence flat_evidence(const topology::Triangulation& triangulation,
                                  const std::vector<double>& lengths,
                                  const std::vector<int>& pi_edges) {
  constexpr long double kPi = std::numbers::pi_v<long double>;
  FlatEvidence evidence;
  std::vector<long double> sums(triangulation.edge_count());
  std::vector<std::size_t> flat_corners(triangulation.edge_count());
  for (const double l : lengths) evidence.longest = std::max(evidence.longest, l);
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    std::array<long double, 6> l;
    for (std::size_t e = 0; e < 6; ++e)
      l[e] = lengths[triangulation.edge_class(t, static_cast<int>(e))];
    const auto cosines = unclipped_cosines(l);
    for (std::size_t e = 0; e < 6; ++e) {
      const std::size_t edge = triangulation.edge_class(t, static_cast<int>(e));
      const bool straight = static_cast<int>(std::min(e, 5 - e)) == pi_edges[t];
      if (pi_edges[t] < 0) {
        evidence.shortfall = std::min(evidence.shortfall, 1 - std::fabs(cosines[e]));
        sums[edge] += std::acos(std::clamp(cosines[e], -1.0L, 1.0L));
      } else if (straight) {
        evidence.excess = std::min(evidence.excess, -cosines[e] - 1);
        sums[edge] += kPi;
        ++flat_corners[edge];
      }
    }
  }
  for (std::size_t e = 0; e < sums.size(); ++e) {
    evidence.max_curvature = std::max(evidence.max_curvature, std::fabs(sums[e] - 2 * kPi));
    if (flat_corners[e] == triangulation.valence(e)) evidence.free_edges.push_back(e);
  }
  return evidence;
}

inline FlatEvidence flat_evidence(const topology::Triangulation& triangulation,
                                  const structure::Report& report) {
  std::vector<int> pi_edges(triangulation.tetrahedron_count(), -1);
  for (const std::size_t t : report.flat_tetrahedra)
    for (std::size_t e = 0; e < 3; ++e)
      if (report.dihedral_angles[t][e] > 3) pi_edges[t] = static_cast<int>(e);
  FlatEvidence evidence = flat_evidence(triangulation, report.edge_lengths, pi_edges);
  // All angles at a free edge are pi, whatever its length beyond a least one: minimisers fill a ray
  // at least, and far out on it the flat tetrahedra are flat by a margin that anyone can see.
  if (!evidence.free_edges.empty()) {
    std::vector<double> longer = report.edge_lengths;
    for (const std::size_t e : evidence.free_edges) longer[e] += 1;
    evidence = flat_evidence(triangulation, longer, pi_edges);
  }
  return evidence;
}

/// The verdicts of a list.
struct VerdictCounts {
  int triangulations = 0;
  int geometric = 0, degenerate_strict = 0, degenerate_semi = 0;
  int infeasible_semi = 0, infeasible_none = 0, unresolved = 0;
  std::vector<std::string> wrong;  ///< without the evidence that goes with the verdict
};

/// What is wrong with a verdict, or nothing. With cone angles 2 pi and without limits.
inline std::string fault_of(const topology::Triangulation& triangulation,
                            const structure::Report& report) {
  using structure::Outcome;
  using Kind = structure::Certificate::Kind;
  if (!is_finite(report)) return "a number is not finite";
  if (report.certificate && !structure::check(triangulation, *report.certificate))
    return "the certificate is not valid";
  if (report.strict_angles && !structure::check(triangulation, *report.strict_angles))
    return "the angles are not strict";
  switch (report.outcome) {
    case Outcome::kGeometric:
      if (report.certificate || !report.flat_tetrahedra.empty()) return "geometric, and yet not";
      return report.max_curvature <= 1e-12 ? "" : "curvature";
    case Outcome::kDegenerate: {
      if (report.certificate.has_value() == report.strict_angles.has_value())
        return "neither strict nor semi";
      if (report.certificate && report.certificate->kind != Kind::kSemi)
        return "a minimiser of none";
      if (report.flat_tetrahedra.empty()) return "nothing is flat";
      const FlatEvidence evidence = flat_evidence(triangulation, report);
      if (!(evidence.max_curvature <= 1e-13L)) return "not a minimiser";
      if (!(evidence.shortfall > 1e-3L)) return "other tetrahedra are nearly flat";
      // Without free edges the vertices of a flat tetrahedron are coplanar: 0 but for rounding.
      const bool clear = evidence.free_edges.empty() ? std::fabs(evidence.excess) < 1e-13L
                                                     : evidence.excess > 1e-2L;
      return clear ? "" : "the flat tetrahedra are not";
    }
    case Outcome::kInfeasible:
      return report.certificate && !report.strict_angles ? "" : "infeasible without certificate";
    case Outcome::kUnresolved:
      return "unresolved";
  }
  return "no outcome";
}

/// "degenerate strict", "infeasible none", ...
inline std::string verdict_of(const structure::Report& report) {
  std::string name(structure::to_string(report.outcome));
  if (report.certificate) return name + " " + std::string(to_string(report.certificate->kind));
  return report.outcome == structure::Outcome::kDegenerate ? name + " strict" : name;
}

inline void count_verdict(const std::string& signature,
                          const topology::Triangulation& triangulation,
                          const structure::Report& report, VerdictCounts& counts) {
  ++counts.triangulations;
  const std::string verdict = verdict_of(report);
  counts.geometric += verdict == "geometric";
  counts.degenerate_strict += verdict == "degenerate strict";
  counts.degenerate_semi += verdict == "degenerate semi";
  counts.infeasible_semi += verdict == "infeasible semi";
  counts.infeasible_none += verdict == "infeasible none";
  counts.unresolved += report.outcome == structure::Outcome::kUnresolved;
  const std::string fault = fault_of(triangulation, report);
  if (!fault.empty()) counts.wrong.push_back(signature + ": " + fault);
}

/// Solving one metric again and again from elsewhere.
struct StartTrials {
  long solves = 0;
  int most_iterations = 0;
  double worst = 0;                 ///< largest difference of a length
  std::vector<std::string> failed;  ///< signatures, with the start
};

inline void try_start(const std::string& signature, const topology::Triangulation& triangulation,
                      const structure::Report& metric, const structure::SolveOptions& options,
                      const std::string& name, StartTrials& trials) {
  const structure::Report report = structure::solve(triangulation, options);
  ++trials.solves;
  trials.most_iterations = std::max(trials.most_iterations, report.iterations);
  if (report.outcome != structure::Outcome::kGeometric) {
    trials.failed.push_back(signature + " from " + name);
    return;
  }
  for (std::size_t e = 0; e < metric.edge_lengths.size(); ++e) {
    trials.worst =
        std::max(trials.worst, std::fabs(report.edge_lengths[e] - metric.edge_lengths[e]));
  }
}

/// From one length on all edges, from `random_starts` log-uniform ones of 1e-6 to 1e4, edge by
/// edge. Nothing is done where the triangulation is not geometric.
inline void try_starts(const std::string& signature, const std::string& method, int random_starts,
                       StartTrials& trials) {
  const auto triangulation = decode(signature);
  const structure::Report metric = structure::solve(triangulation);
  if (metric.outcome != structure::Outcome::kGeometric) return;
  structure::SolveOptions options;
  options.method = method;
  for (const double length : {1e-8, 1e-3, 1.0, 10.0, 37.8, 100.0, 1e3, 1e5}) {
    options.initial_length = length;
    try_start(signature, triangulation, metric, options, std::to_string(length), trials);
  }
  options.initial_length = 0;
  std::seed_seq seed(signature.begin(), signature.end());
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> exponent(-6, 4);
  options.initial_lengths.resize(triangulation.edge_count());
  for (int start = 0; start < random_starts; ++start) {
    for (double& l : options.initial_lengths) l = std::pow(10, exponent(random));
    try_start(signature, triangulation, metric, options, "random start " + std::to_string(start),
              trials);
  }
}

/// Geometric triangulations disturbed by random 2-3 moves and found again.
struct MoveTrials {
  int trials = 0, recovered = 0, still_geometric = 0;
  long tried = 0;
  std::size_t most_tried = 0, most_moves = 0;
  double worst = 0;                 ///< largest relative difference of the volume
  std::vector<std::string> failed;  ///< what was not found again
  std::vector<std::string> wrong;   ///< what was found and is not the same manifold
};

/// Whether moves lead from the start, or from what its signature says is a simplification of it, to
/// what is reported.
inline bool path_leads_there(const topology::Gluings& start,
                             const structure::Retriangulation& found) {
  topology::Gluings gluings = found.path_start;
  const topology::Gluings expected = found.simplified.empty()
                                         ? topology::oriented(start)
                                         : topology::decode_isosig(found.simplified);
  if (gluings != expected) return false;
  for (const topology::Move& move : found.path) topology::apply(gluings, move);
  return topology::isosig(gluings) == topology::isosig(found.gluings);
}

inline void try_recovery(const std::string& signature, std::size_t moves, std::uint64_t seed,
                         MoveTrials& trials) {
  using topology::MoveKind;
  constexpr std::array<MoveKind, 1> kOnly{MoveKind::kTwoThree};
  const auto original = decode(signature);
  const structure::Report metric = structure::solve(original);
  topology::Gluings gluings = original.gluings();
  topology::randomize(gluings, {.count = moves, .seed = seed, .kinds = kOnly});
  const topology::Triangulation disturbed(std::move(gluings));
  const std::string name =
      signature + ", " + std::to_string(moves) + " moves, seed " + std::to_string(seed);
  ++trials.trials;
  structure::Report report = structure::solve(disturbed);
  topology::AbelianGroup homology = topology::first_homology(disturbed);
  if (report.outcome == structure::Outcome::kGeometric) {
    ++trials.still_geometric;
  } else {
    const auto found = structure::retriangulate(disturbed, std::move(report), {});
    report = found.report;
    homology = topology::first_homology(topology::Triangulation(found.gluings));
    trials.tried += static_cast<long>(found.tried);
    trials.most_tried = std::max(trials.most_tried, found.tried);
    trials.most_moves = std::max(trials.most_moves, found.path.size());
    if (!path_leads_there(disturbed.gluings(), found)) trials.wrong.push_back(name + ": path");
  }
  if (report.outcome != structure::Outcome::kGeometric) {
    trials.failed.push_back(name);
    return;
  }
  ++trials.recovered;
  const double difference = std::fabs(report.volume / metric.volume - 1);
  trials.worst = std::max(trials.worst, difference);
  if (!(difference <= 1e-10)) trials.wrong.push_back(name + ": volume");
  if (homology != topology::first_homology(original)) trials.wrong.push_back(name + ": H1");
}

}  // namespace tripus::testing
