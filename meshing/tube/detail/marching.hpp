#pragma once

#include <cstddef>

#include "meshing/surface_mesh.hpp"
#include "meshing/tube/detail/pulse.hpp"
#include "meshing/tube/detail/region.hpp"

namespace tripus::meshing::tube {

/// The boundary of the region {value < 0}, sampled on a body-centred cubic lattice of cell side
/// `cell`: triangles face outwards. Closed, manifold and free of self-intersections for every
/// function, because each crossing stays strictly inside its own lattice edge and each triangle
/// inside its own tetrahedron (see marching.cpp).
/// The region must be less than 2^18 cells large. Throws InvalidInput if the surface has more than
/// `most_triangles`, and Stopped.
SurfaceMesh march(const TubeRegion& region, double cell, std::size_t most_triangles,
                  const Pulse& pulse);

}  // namespace tripus::meshing::tube
