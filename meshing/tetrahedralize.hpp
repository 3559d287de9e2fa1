#pragma once

#include <cstddef>
#include <cstdint>

#include "base/stop.hpp"
#include "meshing/tetrahedral_mesh.hpp"
#include "meshing/validate.hpp"

namespace tripus::meshing {

struct TetrahedralizeOptions {
  double max_volume = 0;       ///< none is larger, up to rounding; 0: as few as it takes
  std::size_t tetrahedra = 0;  ///< about so many, more if the boundary forces it; 0: no aim
  double time_limit = 600;     ///< seconds
  std::uint64_t memory_limit = std::uint64_t{8} << 30;  ///< bytes
  Stop stop{};
};

/// Fills the region with tetrahedra, by TetGen in a process of its own (the program tripus-tetgen),
/// which is asked in several ways. Its points are the surface's, with their numbers, and new ones;
/// its boundary is the surface, or a subdivision of it if TetGen puts points there
/// (detail/mesh_boundary.cpp); every tetrahedron has positive volume and its corners in positive
/// order. All of that is checked. Tetrahedra that TetGen leaves too large, next to a coarse
/// boundary, are split at their centroids.
/// Where TetGen fails every time, the region is cut by the planes of its triangles in exact
/// arithmetic instead (detail/fill_by_planes.cpp). The mesh is then right by its gluings, but its
/// points are rounded, and no size is kept to.
/// Deterministic, but for what a time limit cuts short. Throws Unsupported if it runs out of the
/// limits, or the program tripus-tetgen is missing; Stopped when `stop` is set. No
/// process is left behind in any of these cases, nor when the calling process is killed.
TetrahedralMesh tetrahedralize(const Region& region, const TetrahedralizeOptions& options = {});

/// Volume of a region.
double volume(const Region& region);

}  // namespace tripus::meshing
