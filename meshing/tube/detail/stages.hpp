#pragma once

#include <cstddef>
#include <optional>

#include "meshing/surface_mesh.hpp"
#include "meshing/tube/detail/guarded_surface.hpp"
#include "meshing/tube/detail/pipe_plan.hpp"
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

/// Evens the surface out: every vertex goes towards the middle of its neighbours and onto the
/// region's boundary, as far as that is an isotopy.
void relax(GuardedSurface& surface, const TubeRegion& region, int sweeps, const Pulse& pulse);

/// Collapses edges, shortest first, until at most `target` triangles are left or none can be
/// collapsed. Away from the tube longer edges count as short ones.
void coarsen(GuardedSurface& surface, const TubeRegion& region, std::size_t target,
             const Pulse& pulse);

/// The surface of straight three-sided pipes and of convex joints between them, within the outer
/// surface: as few triangles as there is reason for. Triangles face out of the piece of space that
/// they bound. Nothing where rounding does not leave the shape that the plan asks for, which takes
/// a drawing with parts some 1e7 times finer than the whole.
std::optional<SurfaceMesh> pipe_surface(const PipePlan& plan);

}  // namespace tripus::meshing::tube
