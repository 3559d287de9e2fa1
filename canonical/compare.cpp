#include "canonical/compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/context.hpp"
#include "base/tolerances.hpp"
#include "orthospectrum/spectrum.hpp"
#include "topology/homology.hpp"
#include "topology/isomorphism.hpp"
#include "topology/requirements.hpp"

namespace tripus::canonical {
namespace {

using topology::Triangulation;

std::vector<int> genera(const Triangulation& triangulation) {
  std::vector<int> result;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    result.push_back(triangulation.link(v).genus());
  std::ranges::sort(result);
  return result;
}

Comparison different(std::string by, std::string message) {
  Comparison result;
  result.verdict = Verdict::kDifferent;
  result.decided_by = std::move(by);
  result.message = "Not homeomorphic: " + std::move(message);
  return result;
}

/// By what needs no geometry.
std::optional<Comparison> compare_topology(const Triangulation& a, const Triangulation& b) {
  if (const auto x = genera(a), y = genera(b); x != y) {
    return different("boundary", fmt::format("the boundary components have genera {} and {}.",
                                             fmt::join(x, ", "), fmt::join(y, ", ")));
  }
  if (a.is_orientable() != b.is_orientable())
    return different("orientability", "one is orientable, the other is not.");
  const std::string x = to_string(topology::first_homology(a));
  const std::string y = to_string(topology::first_homology(b));
  if (x != y) return different("homology", fmt::format("the first homology is {} and {}.", x, y));
  return std::nullopt;
}

/// Beyond so many tetrahedra a canonical decomposition takes longer than two metrics and their
/// shortest arcs, as each of its moves solves the whole triangulation again.
constexpr std::size_t kSlowToCanonize = 24;
constexpr std::size_t kFingerprintArcs = 60;

/// By the lengths of the shortest arcs, where both triangulations carry the metric. That they agree
/// proves nothing.
std::optional<Comparison> compare_arcs(const Triangulation& a, const Triangulation& b,
                                       const structure::SolveOptions& options) {
  structure::SolveOptions solve = options;
  solve.evidence = false;
  std::array<std::vector<double>, 2> lengths;
  std::size_t side = 0;
  for (const Triangulation* manifold : {&a, &b}) {
    const structure::Report report = structure::solve(*manifold, solve);
    if (report.outcome != structure::Outcome::kGeometric) return std::nullopt;
    Context context;
    context.stop_flag = options.stop_requested;
    lengths[side++] =
        orthospectrum::shortest_lengths(*manifold, report.edge_lengths, kFingerprintArcs, context);
  }
  const std::size_t count = std::min(lengths[0].size(), lengths[1].size());
  for (std::size_t n = 0; n < count; ++n) {
    if (std::fabs(lengths[0][n] - lengths[1][n]) <= tolerance::kDifferentArcLength) continue;
    return different("orthospectrum",
                     fmt::format("the {} shortest arcs between boundary components have lengths "
                                 "that differ: number {} has {:.12g} and {:.12g}.",
                                 count, n + 1, lengths[0][n], lengths[1][n]));
  }
  return std::nullopt;
}

void compare_manifolds(Comparison& result) {
  const CanonicalManifold &a = *result.first, &b = *result.second;
  const double difference = std::fabs(a.report.volume - b.report.volume);
  const double error = a.volume_error + b.volume_error;
  // A factor of safety over an error that is an estimate.
  if (difference > 1000 * error) {
    result.verdict = Verdict::kDifferent;
    result.decided_by = "volume";
    result.message =
        fmt::format("Not homeomorphic: the volumes are {:.15g} and {:.15g}, to within {:.1g}.",
                    a.report.volume, b.report.volume, error);
    return;
  }
  result.decided_by = "decomposition";
  if (a.order.code != b.order.code) {
    result.verdict = Verdict::kDifferent;
    result.message =
        a.cells == b.cells
            ? fmt::format(
                  "Not homeomorphic: the canonical decompositions, of {} both, are not "
                  "isomorphic.",
                  a.cells)
            : fmt::format("Not homeomorphic: the canonical decompositions have {} and {}.", a.cells,
                          b.cells);
    return;
  }
  result.verdict = Verdict::kHomeomorphic;
  result.isometry = as_cell_map(a.decomposition, b.decomposition, isomorphism(a.order, b.order));
  std::string_view how;
  if (a.decomposition.is_orientable()) {
    const bool keeps = a.decomposition.is_negative(a.order.flags[0]) ==
                       b.decomposition.is_negative(b.order.flags[0]);
    result.keeps_orientation = keeps || a.isometries.is_amphicheiral;
    result.reverses_orientation = !keeps || a.isometries.is_amphicheiral;
    how = result.keeps_orientation && result.reverses_orientation
              ? ", with either orientation"
              : (keeps ? ", keeping the given orientations" : ", as mirror images");
  }
  result.message = fmt::format(
      "Homeomorphic{}: an isometry carries the {} of the canonical decompositions to each other.",
      how, a.cells);
}

}  // namespace

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::kHomeomorphic:
      return "homeomorphic";
    case Verdict::kDifferent:
      return "different";
    case Verdict::kUnresolved:
      break;
  }
  return "unresolved";
}

Comparison compare(const Triangulation& first, const Triangulation& second,
                   const CanonizeOptions& options) {
  topology::require_solvable(first);
  topology::require_solvable(second);
  if (auto decided = compare_topology(first, second)) return *decided;
  if (std::max(first.tetrahedron_count(), second.tetrahedron_count()) > kSlowToCanonize)
    if (auto decided = compare_arcs(first, second, options.solve)) return *decided;
  Comparison result;
  CanonizeAnswer a = canonize(first, options), b = canonize(second, options);
  result.first = std::move(a.manifold);
  result.second = std::move(b.manifold);
  if (result.first && result.second) {
    compare_manifolds(result);
    return result;
  }
  if (topology::is_isomorphic(first.gluings(), second.gluings())) {
    result.verdict = Verdict::kHomeomorphic;
    result.decided_by = "triangulation";
    result.message = "Homeomorphic: the triangulations are the same but for their labels.";
    return result;
  }
  if (auto decided = compare_arcs(first, second, options.solve)) return *decided;
  result.message = fmt::format("Unresolved: no canonical decomposition of the {}. {}",
                               result.first    ? "second"
                               : result.second ? "first"
                                               : "two",
                               result.first ? b.message : a.message);
  return result;
}

}  // namespace tripus::canonical
