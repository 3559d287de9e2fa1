#pragma once

#include <optional>

#include "structure/report.hpp"
#include "structure/solve.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure::detail {

/// Looks for the minimiser of the co-volume where a run came to rest without reaching the
/// tolerance, because some tetrahedra are flat there or nearly so: the angles of such a tetrahedron
/// go like the square root of a change of the lengths, and no double may be near enough. Also where
/// the minimum may not be attained.
///   report    of that run
/// Returns the degenerate outcome, or nothing where the minimiser is not seen to have flat
/// tetrahedra. Source: docs/theory.md (54').
std::optional<Report> flat_minimiser(const topology::Triangulation& triangulation,
                                     const SolveOptions& options, const Report& report);

}  // namespace tripus::structure::detail
