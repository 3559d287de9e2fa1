#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing {

/// Corners of a tetrahedron, as indices into the points.
using Tetrahedron = std::array<std::uint32_t, 4>;

/// A solid cut into tetrahedra. Nothing is promised but what require_valid checks; a valid one that
/// was oriented (meshing/validate_tetrahedra.hpp) has the determinant of (b-a, c-a, d-a) positive
/// for each tetrahedron a b c d.
struct TetrahedralMesh {
  std::vector<Point> points;
  std::vector<Tetrahedron> tetrahedra;

  friend bool operator==(const TetrahedralMesh&, const TetrahedralMesh&) = default;
};

}  // namespace tripus::meshing
