#pragma once

#include <cstddef>

#include "meshing/detail/diagonals.hpp"

namespace tripus::meshing::detail {

/// For every face that was cut into two triangles the diagonal with which no triangle crosses
/// another and no edge is in more than two, if there are such; triangles of other faces stay.
/// Exact: each pair of triangles that collide excludes a pair of diagonals, and such pairs alone
/// decide. The surface is closed, its triangles are proper and different, and keep their places.
/// Returns how many diagonals were turned: 0 if there is no way, or none was needed. Near-linear
/// where the boxes of triangles overlap few others.
std::size_t choose_diagonals(SurfaceMesh& mesh, const SameFace& same_face);

}  // namespace tripus::meshing::detail
