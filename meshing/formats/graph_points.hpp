#pragma once

#include <string_view>

#include "meshing/tube/spatial_graph.hpp"

namespace tripus::meshing {

/// Points as three numbers a line, with spaces, commas or semicolons between them; empty lines
/// between polylines. A polyline neither end of which is a point of another is closed.
/// Throws InvalidInput with the line.
SpatialGraph read_point_lists(std::string_view text);

}  // namespace tripus::meshing
