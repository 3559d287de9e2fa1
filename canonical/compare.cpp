#include "canonical/compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/context.hpp"
#include "base/error.hpp"
#include "base/tolerances.hpp"
#include "orthospectrum/spectrum.hpp"
#include "topology/homology.hpp"
#include "topology/moves/common_triangulation.hpp"
#include "topology/simplify/small_triangulations.hpp"

namespace tripus::canonical {
namespace {

using topology::Triangulation;

/// The boundary components: orientable ones by genus, others by Euler characteristic.
std::vector<std::string> boundary_components(const Triangulation& triangulation) {
  std::vector<std::string> result;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v) {
    const topology::VertexLink& link = triangulation.link(v);
    if (link.euler_characteristic == 2) continue;  // filled in
    result.push_back(
        link.orientable
            ? fmt::format("genus {}{}", link.genus(), link.genus() == 1 ? " (a cusp)" : "")
        : link.euler_characteristic == 0
            ? "a Klein bottle (a cusp)"
            : fmt::format("non-orientable of Euler characteristic {}", link.euler_characteristic));
  }
  std::ranges::sort(result);
  return result;
}

std::string boundary_text(const std::vector<std::string>& components) {
  return components.empty() ? "none" : fmt::format("{}", fmt::join(components, " + "));
}

Comparison different(std::string by, std::string message) {
  Comparison result;
  result.verdict = Verdict::kDifferent;
  result.decided_by = std::move(by);
  result.message = "Not homeomorphic: " + std::move(message);
  return result;
}

/// By what needs no geometry.
std::optional<Comparison> compare_topology(const Triangulation& a, const Triangulation& b,
                                           const Stop& stop) {
  if (a.component_count() != b.component_count()) {
    return different("components", fmt::format("they have {} and {} components.",
                                               a.component_count(), b.component_count()));
  }
  if (const auto x = boundary_components(a), y = boundary_components(b); x != y) {
    return different("boundary", fmt::format("the boundary of one is {}, that of the other {}.",
                                             boundary_text(x), boundary_text(y)));
  }
  if (a.is_orientable() != b.is_orientable())
    return different("orientability", "one is orientable, the other is not.");
  const std::string x = to_string(topology::first_homology(a, stop));
  const std::string y = to_string(topology::first_homology(b, stop));
  if (x != y) return different("homology", fmt::format("the first homology is {} and {}.", x, y));
  return std::nullopt;
}

void set_orientations(Comparison& result, bool keeps, bool reverses, bool amphicheiral) {
  result.keeps_orientation = keeps || amphicheiral;
  result.reverses_orientation = reverses || amphicheiral;
  if (amphicheiral) result.orientations_known = true;
  if (result.orientations_known) return;
  result.keeps_orientation = result.reverses_orientation = false;
}

std::string_view how_oriented(const Comparison& result, bool is_orientable) {
  if (!is_orientable) return "";
  if (!result.orientations_known)
    return " (orientation not known: a signature without + or - at its end does not tell)";
  if (result.keeps_orientation && result.reverses_orientation) return ", with either orientation";
  return result.keeps_orientation ? ", keeping the given orientations" : ", as mirror images";
}

/// Whether the boundary is geodesic, without cusps: then there are arcs to be compared.
bool is_geodesic(const Triangulation& triangulation) {
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (!triangulation.link(v).orientable || triangulation.link(v).euler_characteristic >= 0)
      return false;
  return true;
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
    context.stop = options.stop;
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

bool have_equal_codes(const CanonicalManifold& a, const CanonicalManifold& b) {
  return a.order.code == b.order.code && a.order.cone_angles == b.order.cone_angles;
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
  if (!have_equal_codes(a, b)) {
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
  if (a.decomposition.is_orientable()) {
    const bool keeps = a.decomposition.is_negative(a.order.flags[0]) ==
                       b.decomposition.is_negative(b.order.flags[0]);
    set_orientations(result, keeps, !keeps, a.isometries.is_amphicheiral);
  }
  result.message = fmt::format(
      "Homeomorphic{}: an isometry carries the {} of the canonical decompositions to each other.",
      how_oriented(result, a.decomposition.is_orientable()), a.cells);
}

/// Up to so many tetrahedra a common triangulation is searched for.
constexpr std::size_t kMostSearched = 40;

/// By moves that lead from both triangulations to a third, where geometry did not decide.
void compare_triangulations(Comparison& result, const Triangulation& a, const Triangulation& b,
                            const CanonizeOptions& options) {
  topology::CommonTriangulationOptions search;
  search.stop = options.solve.stop;
  // Every step looks at all neighbours of a triangulation: too much for large ones.
  if (std::max(a.tetrahedron_count(), b.tetrahedron_count()) > kMostSearched) search.budget = 0;
  const auto start = [&](const Triangulation& m) {
    auto small = topology::small_triangulations(m.gluings(), 1, search.stop);
    return small.empty() ? m.gluings() : std::move(small.front());
  };
  const auto common = topology::common_triangulation(start(a), start(b), search);
  if (!common) return;
  result.verdict = Verdict::kHomeomorphic;
  result.decided_by = "triangulation";
  const bool both = common->keeps_orientation && common->reverses_orientation;
  set_orientations(result, common->keeps_orientation, common->reverses_orientation, both);
  result.message = fmt::format("Homeomorphic{}: moves lead from both to the triangulation {}.",
                               how_oriented(result, a.is_orientable()), common->isosig);
}

}  // namespace

std::vector<Isometry> isometries(const CanonicalManifold& from, const CanonicalManifold& to) {
  std::vector<Isometry> all;
  if (!have_equal_codes(from, to)) return all;
  const Decomposition &a = from.decomposition, &b = to.decomposition;
  for (const std::vector<FlagIndex>& images : all_isomorphisms(from.order, b, to.order)) {
    Isometry isometry{as_cell_map(a, b, images), {}, a.is_negative(0) == b.is_negative(images[0])};
    isometry.boundary_images.resize(from.triangulation.vertex_count());
    for (FlagIndex flag = 0; flag < a.flag_count(); ++flag)
      isometry.boundary_images[a.boundary_component(flag)] = b.boundary_component(images[flag]);
    all.push_back(std::move(isometry));
  }
  return all;
}

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
                   const CanonizeOptions& options, Orientations orientations) {
  return compare({first, {}}, {second, {}}, options, orientations);
}

Comparison compare(const Labelled& one, const Labelled& other, const CanonizeOptions& options,
                   Orientations orientations) {
  const Triangulation &first = one.triangulation, &second = other.triangulation;
  const bool plain = topology::all_full(one.cone_angles) && topology::all_full(other.cone_angles);
  if (auto decided = compare_topology(first, second, options.solve.stop)) return *decided;
  try {
    require_canonizable(first, one.cone_angles);
    require_canonizable(second, other.cone_angles);
  } catch (const InvalidInput&) {
    Comparison result;
    result.orientations_known = orientations == Orientations::kKnown;
    if (plain) compare_triangulations(result, first, second, options);
    if (result.verdict == Verdict::kHomeomorphic) return result;
    throw;
  }
  const bool has_arcs = plain && is_geodesic(first) && is_geodesic(second);
  if (has_arcs && std::max(first.tetrahedron_count(), second.tetrahedron_count()) > kSlowToCanonize)
    if (auto decided = compare_arcs(first, second, options.solve)) return *decided;
  Comparison result;
  result.orientations_known =
      orientations == Orientations::kKnown || !first.is_orientable() || !second.is_orientable();
  CanonizeOptions of_one = options;
  of_one.solve.evidence = false;
  CanonizeOptions of_other = of_one;
  of_one.solve.cone_angles = one.cone_angles;
  of_other.solve.cone_angles = other.cone_angles;
  CanonizeAnswer a = canonize(first, of_one), b = canonize(second, of_other);
  result.first = std::move(a.manifold);
  result.second = std::move(b.manifold);
  if (result.first && result.second) {
    compare_manifolds(result);
    return result;
  }
  if (plain) compare_triangulations(result, first, second, options);
  if (result.verdict == Verdict::kHomeomorphic) return result;
  if (has_arcs)
    if (auto decided = compare_arcs(first, second, options.solve)) return *decided;
  result.message = fmt::format("Unresolved: no canonical decomposition of the {}. {}",
                               result.first    ? "second"
                               : result.second ? "first"
                                               : "two",
                               result.first ? b.message : a.message);
  result.advice = result.first ? b.advice : a.advice;
  return result;
}

}  // namespace tripus::canonical
