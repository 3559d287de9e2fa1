#pragma once

#include <span>
#include <vector>

#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure {

/// Dihedral angles with given edge sums, as deep inside the polytope of angle structures as a
/// linear programme puts them.
struct AngleStructure {
  /// Largest m with all angles >= m and all vertex sums <= pi - m; radians. Negative where no angle
  /// structure exists; about 0 where there are only semi-angle structures.
  double margin = 0;
  std::vector<double> angles;  ///< [T x 6] radians; an optimum of the programme
};

/// Solves  max m:  angle_c >= m,  vertex sums <= pi - m (= pi at ideal vertices),  edge sums = cone
/// angle. Floating point: a margin within about 1e-9 of 0 decides nothing.
///   cone_angles [E]; empty for 2 pi
/// Throws InternalError if the simplex method fails.
/// Source: docs/theory.md section 5.
AngleStructure deepest_angle_structure(const topology::Triangulation& triangulation,
                                       std::span<const topology::ConeAngle> cone_angles = {});

}  // namespace tripus::structure
