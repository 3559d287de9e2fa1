#pragma once

#include <cstddef>
#include <functional>

#include "meshing/surface_mesh.hpp"

/// Faces of more than three corners need not be planar, and were cut into triangles along diagonals
/// that looked best in each face by itself. Where one collides with the rest of the surface, the
/// other diagonal of its quadrilateral is as true to the file.
namespace tripus::meshing::detail {

/// Whether two triangles of the mesh are parts of one face of the file.
using SameFace = std::function<bool(std::size_t, std::size_t)>;

/// Turns diagonals that are edges of other triangles as well, where the other diagonal is no edge.
/// Returns how many. Triangles keep their places.
std::size_t uncrowd_diagonals(SurfaceMesh& mesh, const SameFace& same_face);

/// Turns diagonals of triangles that cross others, as long as that leaves fewer crossings; if some
/// are left in the end, those of quadrilaterals are chosen anew (quad_diagonals.hpp), and if that
/// has no solution, nothing is changed. The surface is closed, its triangles are proper and
/// different. Returns how many were turned. Quadratic at worst, in the number of crossings times
/// triangles.
std::size_t uncross_diagonals(SurfaceMesh& mesh, const SameFace& same_face);

}  // namespace tripus::meshing::detail
