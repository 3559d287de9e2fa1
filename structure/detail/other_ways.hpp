#pragma once

#include <optional>
#include <vector>

#include "energies/co_volume.hpp"
#include "solver/method.hpp"
#include "structure/report.hpp"
#include "structure/solve.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure::detail {

/// Solves K = 0 where some vertex is finite, by Gauss and Newton's method with steps of least
/// length (a finite vertex that is no cone point moves freely) and backtracking on |K|: from the
/// lengths that the options give, else from equal lengths, then from random ones.
/// docs/theory.md 9.6. Writes the lengths with the least max|K| met into x [E].
solver::Summary gauss_newton(const topology::Triangulation& triangulation,
                             const energies::CoVolume& energy, const SolveOptions& options,
                             std::vector<double>& x);

/// Looks for the minimiser of the co-volume where a run came to rest without reaching the
/// tolerance, because some tetrahedra are flat there or nearly so: the angles of such a tetrahedron
/// go like the square root of a change of the lengths, and no double may be near enough. Also where
/// the minimum may not be attained.
///   report    of that run
/// Returns the degenerate outcome, or nothing where the minimiser is not seen to have flat
/// tetrahedra. Source: docs/theory.md (54').
std::optional<Report> flat_minimiser(const topology::Triangulation& triangulation,
                                     const SolveOptions& options, const Report& report);

/// Looks for the minimiser of the co-volume in Arb, 192 bits and more, where doubles came to rest
/// without telling flat tetrahedra from nearly flat ones: edges of length 25 make Gram entries of
/// 1e11, whose rounding is as large as an angle of 1e-3. Only for triangulations with a strict
/// angle structure, where the minimum is attained, with geodesic boundary and no labels, and no
/// more than kMostEdgesForDigits edge classes.
///   report    of the run in doubles
/// Returns the geometric or degenerate outcome, with angles, curvature and volume as they were
/// found and the lengths rounded to doubles; nothing where it was stopped or did not converge.
std::optional<Report> precise_minimiser(const topology::Triangulation& triangulation,
                                        const SolveOptions& options, const Report& report);

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
