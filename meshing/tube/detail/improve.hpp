#pragma once

#include <cstddef>

#include "meshing/tube/detail/guarded_surface.hpp"
#include "meshing/tube/detail/pulse.hpp"
#include "meshing/tube/detail/region.hpp"

namespace tripus::meshing::tube {

/// Evens the surface out: every vertex goes towards the middle of its neighbours and onto the
/// region's boundary, as far as that is an isotopy.
void relax(GuardedSurface& surface, const TubeRegion& region, int sweeps, const Pulse& pulse);

/// Collapses edges, shortest first, until at most `target` triangles are left or none can be
/// collapsed. Away from the tube longer edges count as short ones.
void coarsen(GuardedSurface& surface, const TubeRegion& region, std::size_t target,
             const Pulse& pulse);

}  // namespace tripus::meshing::tube
