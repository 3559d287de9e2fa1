#pragma once

#include <span>

#include "energies/co_volume.hpp"
#include "solver/method.hpp"
#include "structure/report.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure {

/// Judges lengths x [E] by the geometry they give and by nothing else: fills everything of the
/// report but the run's own account (method, counts, seconds), which comes from `summary`.
///
/// A critical point needs max|K| <= tolerance and the distance estimate of docs/theory.md (49),
/// because max|K| is also small where lengths run off to infinity. Then the outcome is
///   geometric    if every length is positive and every tetrahedron a true truncated one, with a
///                margin above rounding;
///   degenerate   if some tetrahedra are flat: the minimiser of the boundary case;
/// and otherwise unresolved.
Report assess(const topology::Triangulation& triangulation, const energies::CoVolume& energy,
              std::span<const double> x, double tolerance, const solver::Summary& summary);

/// The numbers at lengths x [E] that are no metric's and have not been looked for: everything of
/// the report but outcome and message. Only without finite vertices.
Report report_at(const topology::Triangulation& triangulation, const energies::CoVolume& energy,
                 std::span<const double> x);

}  // namespace tripus::structure
