#pragma once

#include <vector>

#include "structure/solve.hpp"

namespace tripus::structure {

/// Edge length of the regular truncated tetrahedron with dihedral angle 0 < theta < pi/3:
/// cosh l = cos theta / (2 cos theta - 1). Source: docs/theory.md section 3.
double regular_edge_length(double theta);

/// The starting lengths [E] that the options ask for.
/// Throws InvalidInput for a wrong number of lengths, or one that is not finite and positive.
std::vector<double> starting_lengths(const topology::Triangulation& triangulation,
                                     const SolveOptions& options);

}  // namespace tripus::structure
