#pragma once

#include <optional>

#include "structure/report.hpp"
#include "structure/solve.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure::detail {

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

}  // namespace tripus::structure::detail
