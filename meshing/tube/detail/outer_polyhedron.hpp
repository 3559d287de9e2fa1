#pragma once

#include <optional>
#include <vector>

#include "meshing/tube/detail/outer_surface.hpp"

namespace tripus::meshing::tube {

/// A triangle of points in the outer surface where a pipe comes out, counterclockwise from outside.
using Opening = Triangle;

/// The outer surface in few triangles: convex, with its corners on the sphere or the box, and with
/// all points that are there already, but for those of the openings, strictly inside. The triangles
/// of the openings are left out; the others face outwards and are added, as new points are.
/// Says no if an opening is too small, beside the whole, for what doubles resolve.
bool add_outer_polyhedron(SurfaceMesh& mesh, const OuterSurface& outer,
                          const std::vector<Opening>& openings);

}  // namespace tripus::meshing::tube
