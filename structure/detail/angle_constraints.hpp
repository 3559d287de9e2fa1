#pragma once

#include <span>
#include <vector>

#include "structure/detail/rational_system.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure::detail {

/// What an angle structure is, in units of pi (docs/theory.md (41), (81)): the corners of each edge
/// class sum to its cone angle, the three at a tetrahedron vertex to at most 1, or to exactly 1
/// where the vertex is ideal. Corners on parabolic edges are 0 and take no part.
struct AngleConstraints {
  explicit AngleConstraints(const topology::Triangulation& triangulation,
                            std::span<const topology::ConeAngle> cone_angles = {});

  std::vector<double> edge_sum;     ///< [E]
  std::vector<Rational> exact_sum;  ///< [E]; empty where some angle is not a rational number of pi
  std::vector<bool> parabolic;      ///< [E]
  std::vector<bool> ideal;          ///< [4 T]
  std::vector<int> corners;         ///< [4 T] how many of the three corners take part
  bool plain = true;                ///< all cone angles 2 pi, no ideal vertex
};

}  // namespace tripus::structure::detail
