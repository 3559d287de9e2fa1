#pragma once

#include <vector>

#include "energies/co_volume.hpp"
#include "solver/method.hpp"
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

}  // namespace tripus::structure::detail
