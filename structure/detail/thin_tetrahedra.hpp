#pragma once

#include "structure/report.hpp"
#include "structure/solve.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure::detail {

/// Where cusps are, tetrahedra can become thin, with angles near 0, pi/2 and pi/2 or the like, as
/// lengths run off to infinity: curvatures then vanish, and look like those of a metric. With a
/// strict angle structure the minimum is attained, and they cannot. So a metric or a flat minimiser
/// with angles below tolerance::kThinAngle is believed only where there is one, by exact decision
/// (docs/theory.md 5).
///   report   of a run that ended at a critical point
///   seconds  that the decision may take
/// Returns the report, unresolved if there is none, or if that could not be decided: cone angles
/// that are not rational, the limit of time, too many tetrahedra.
Report settled_if_thin(const topology::Triangulation& triangulation, const SolveOptions& options,
                       Report report, double seconds);

}  // namespace tripus::structure::detail
