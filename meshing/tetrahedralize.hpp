#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "meshing/tetrahedral_mesh.hpp"
#include "meshing/validate.hpp"

namespace tripus::meshing {

struct TetrahedralizeOptions {
  double max_volume = 0;       ///< none is larger, up to rounding; 0: as few as it takes
  std::size_t tetrahedra = 0;  ///< about so many, more if the boundary forces it; 0: no aim
  double time_limit = 600;     ///< seconds
  std::uint64_t memory_limit = std::uint64_t{8} << 30;  ///< bytes
  const std::atomic<bool>* stop_requested = nullptr;
};

/// Fills the region with tetrahedra, by TetGen in a process of its own (the program tripus-tetgen).
/// The boundary stays exactly as it is: its points are the first ones, with their numbers, its
/// triangles are the boundary faces, all of which is checked, as is that every tetrahedron has
/// positive volume and its corners in positive order (exact). Deterministic. Tetrahedra that TetGen
/// leaves too large, next to a coarse boundary, are split at their centroids.
/// Throws InvalidInput if TetGen refuses the surface; Unsupported if it or max_volume runs out of
/// the limits, crashes, or the program tripus-tetgen is missing; Stopped when `stop_requested` is
/// set. No process is left behind in any of these cases, nor when the calling process is killed.
TetrahedralMesh tetrahedralize(const Region& region, const TetrahedralizeOptions& options = {});

/// Volume of a region.
double volume(const Region& region);

}  // namespace tripus::meshing
