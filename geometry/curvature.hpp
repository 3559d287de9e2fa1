#pragma once

#include <span>

namespace tripus::geometry {

/// Edge curvature K(e) = 2 pi - (sum of the dihedral angles around e); radians.
/// Source: docs/theory.md (32).
double edge_curvature(std::span<const double> angles_around_edge);

/// Area of the hyperbolic triangle that truncates a hyperideal vertex, pi - (sum of the dihedral
/// angles of the three edges there).
double truncation_area(double a, double b, double c);

/// Solid angle of a tetrahedron at a finite vertex, (sum of the three dihedral angles) - pi.
double solid_angle(double a, double b, double c);

/// Vertex curvature K(v) = 4 pi - (sum of the solid angles at v); finite vertices.
double vertex_curvature(std::span<const double> solid_angles);

}  // namespace tripus::geometry
