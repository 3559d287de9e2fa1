#pragma once

#include <cstdint>
#include <optional>

#include "base/stop.hpp"
#include "meshing/tetrahedral_mesh.hpp"
#include "meshing/validate.hpp"

namespace tripus::meshing::detail {

/// Fills a region with tetrahedra without any mesher: a box around it is cut by the planes of its
/// triangles into convex cells, each plane where its triangles run, all of it in exact rational
/// arithmetic. Never fails but for want of time or memory (nothing is returned then); makes some
/// 50 tetrahedra a triangle. The points are rounded at the end, so that tetrahedra may be flat or
/// turned inside out by that; how they hang together is that of the exact ones, in positive order.
/// The points of the surface are the first ones.
/// Throws Stopped.
std::optional<TetrahedralMesh> fill_by_planes(const Region& region, std::uint64_t memory_limit,
                                              double deadline, const Stop& stop);

}  // namespace tripus::meshing::detail
