#pragma once

#include "topology/triangulation.hpp"

namespace tripus::topology {

/// Checks that the triangulation is one that Tripus can look for a metric on: connected, every
/// vertex link an orientable closed surface of genus >= 2. The manifold itself may be
/// non-orientable.
/// Throws InvalidInput for: not connected; a sphere link; a projective plane, Klein bottle or
/// other non-orientable link. Throws Unsupported for a torus link (a cusp), and for a closed
/// manifold: no link but spheres. The message names the vertex class, one tetrahedron and vertex of
/// it, and what to do.
void require_solvable(const Triangulation& triangulation);

}  // namespace tripus::topology
