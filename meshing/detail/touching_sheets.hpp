#pragma once

#include <cstddef>
#include <optional>

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing::detail {

/// A surface whose sheets touched in points and edges, and do no more.
struct SheetsApart {
  SurfaceMesh mesh;
  std::size_t moved = 0;  ///< points that were in one place with others
  double distance = 0;    ///< the farthest that one was moved
};

/// Boolean operations leave solids that touch themselves along an edge or in a point, and tell what
/// belongs to which sheet by points that are there several times. Such points are moved a little
/// towards their neighbours, which parts the sheets, however they are joined. Nothing if no points
/// are in one place, the triangles do not close up by the numbers of their corners, or no distance
/// that is tried gives a valid surface (require_valid). Points are all used, coordinates
/// in_exact_range.
std::optional<SheetsApart> sheets_apart(const SurfaceMesh& mesh);

}  // namespace tripus::meshing::detail
