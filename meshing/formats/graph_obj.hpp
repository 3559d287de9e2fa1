#pragma once

#include <string_view>

#include "meshing/tube/spatial_graph.hpp"

namespace tripus::meshing {

/// The lines (l) of a Wavefront OBJ, also cut into single pieces as Blender writes them.
/// Throws InvalidInput with the line; for a file that has faces or no lines.
SpatialGraph read_obj_lines(std::string_view text);

/// Whether a Wavefront OBJ has lines and no faces.
bool has_only_lines(std::string_view text);

}  // namespace tripus::meshing
