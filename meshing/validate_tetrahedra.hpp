#pragma once

#include <vector>

#include "meshing/tetrahedral_mesh.hpp"
#include "topology/gluings.hpp"

namespace tripus::meshing {

/// A solid in tetrahedra that was checked.
struct Solid {
  TetrahedralMesh mesh;              ///< every tetrahedron in positive order
  topology::Gluings gluings;         ///< the same tetrahedra; open faces on the boundary, oriented
  std::vector<int> boundary_genera;  ///< of the components of the boundary, sorted
};

/// Checks that a tetrahedral mesh is a connected solid, and returns that. In this order: not empty,
/// corners different, coordinates finite and in_exact_range, no unused points, no equal points, no
/// flat tetrahedra, no tetrahedron twice, no face in more than two, neighbours on the two sides of
/// their face (exact), the boundary a closed surface with one fan of triangles at every point, one
/// ball or half-ball of tetrahedra around every point, connected. The order of the corners of a
/// tetrahedron is mended, nothing else; all keep their numbers. In O(T log T).
/// Throws InvalidInput naming what is wrong, where (with the line, where `lines` knows it), how
/// often, and what to do.
Solid require_valid(TetrahedralMesh mesh, const SourceLines& lines = {});

/// The gluings of tetrahedra in positive order that share faces; open faces where nothing is
/// shared. Throws InvalidInput for a face in more than two tetrahedra.
topology::Gluings gluings_of(const TetrahedralMesh& mesh, const SourceLines& lines = {});

/// The faces that only one tetrahedron has, facing outwards where that is in positive order, by the
/// number of the tetrahedron.
std::vector<Triangle> boundary_triangles(const TetrahedralMesh& mesh);

}  // namespace tripus::meshing
