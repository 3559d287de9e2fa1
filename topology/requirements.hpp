#pragma once

#include <span>

#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {

/// Checks that the triangulation with these cone angles [E] (empty: 2 pi everywhere) is one that
/// `structure::solve` can look for a metric on: connected, every vertex link a closed surface,
/// orientable or not, that can be the link of a hyperideal, an ideal or a finite vertex
/// (docs/theory.md (76)).
/// Throws InvalidInput for: not connected; a projective plane, or a bad orbifold such as a sphere
/// with one cone point, as link of a finite vertex; a parabolic edge that ends at a cusp or at a
/// finite vertex; what `completed` refuses. The message names the vertex class, one tetrahedron and
/// vertex of it, and what to do.
void require_solvable(const Triangulation& triangulation,
                      std::span<const ConeAngle> cone_angles = {});

/// Checks that the triangulation is one of a manifold with geodesic boundary and nothing else:
/// connected, every link an orientable surface of genus 2 or more. What does not know cusps, cone
/// points and finite vertices so far asks for this. The manifold itself may be non-orientable.
/// Throws InvalidInput for: not connected; a sphere link; a projective plane, Klein bottle or
/// other non-orientable link. Throws Unsupported for a torus link (a cusp), and for a closed
/// manifold: no link but spheres. The message names the place as above.
void require_geodesic_boundary(const Triangulation& triangulation);

/// The same with cusps beside the geodesic boundary: links that are tori or Klein bottles are
/// welcome, but not alone. Throws as above; Unsupported where there is no link of genus 2 or more.
void require_boundary_beside_cusps(const Triangulation& triangulation);

}  // namespace tripus::topology
