#include <algorithm>
#include <numbers>
#include <variant>

#include "base/tolerances.hpp"
#include "structure/detail/angle_programme.hpp"
#include "structure/detail/other_ways.hpp"
#include "structure/existence.hpp"

namespace tripus::structure::detail {
namespace {

bool has_cusp_or_parabolic_edge(const SolveOptions& options, const Report& report) {
  return std::ranges::any_of(report.vertices,
                             [](const VertexReport& vertex) {
                               return vertex.kind == topology::VertexKind::kIdeal;
                             }) ||
         std::ranges::any_of(options.cone_angles, &topology::ConeAngle::is_parabolic);
}

/// Flat ones apart, whose angles are 0 and pi.
bool has_thin_one(const Report& report) {
  std::size_t flat = 0;
  for (std::size_t t = 0; t < report.dihedral_angles.size(); ++t) {
    if (flat < report.flat_tetrahedra.size() && report.flat_tetrahedra[flat] == t) {
      ++flat;
      continue;
    }
    if (std::ranges::min(report.dihedral_angles[t]) < tolerance::kThinAngle) return true;
  }
  return false;
}

}  // namespace

Report settled_if_thin(const topology::Triangulation& triangulation, const SolveOptions& options,
                       Report report, double seconds) {
  const bool claims =
      report.outcome == Outcome::kGeometric || report.outcome == Outcome::kDegenerate;
  if (!claims || !has_cusp_or_parabolic_edge(options, report) || !has_thin_one(report))
    return report;
  const bool decidable =
      triangulation.tetrahedron_count() <= most_tetrahedra_decided() &&
      std::ranges::all_of(options.cone_angles, &topology::ConeAngle::is_rational);
  std::optional<Existence> found;
  if (decidable) found = existence_within(seconds, triangulation, options.cone_angles);
  if (found && std::holds_alternative<StrictAngles>(*found)) return report;
  report.outcome = Outcome::kUnresolved;
  report.message =
      "No metric was found on this triangulation: the curvature is small but some tetrahedra are "
      "thin, as when lengths run off to infinity. Nothing follows about the manifold.";
  return report;
}

}  // namespace tripus::structure::detail
