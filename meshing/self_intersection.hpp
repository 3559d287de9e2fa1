#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/stop.hpp"
#include "meshing/surface_mesh.hpp"

namespace tripus::meshing {

/// Whether two triangles of a surface meet in more than the points that they share by number: in
/// nothing, a shared corner, a shared edge. The triangles are not collinear and do not share all
/// three corners. Exact.
bool triangles_cross(const SurfaceMesh& mesh, std::size_t s, std::size_t t);

/// The first pair (s < t, smallest s, then t) of triangles that cross; nothing if the surface has
/// no self-intersection. Exact; near-linear in the number of triangles where their boxes overlap
/// few others. Indices must be valid, coordinates in_exact_range, triangles not collinear and all
/// different, as the checks before it in require_valid make sure.
/// Throws Stopped when `stop` is set.
std::optional<std::array<std::uint32_t, 2>> first_self_intersection(const SurfaceMesh& mesh,
                                                                    const Stop& stop = {});

}  // namespace tripus::meshing
