#pragma once

#include <string_view>

#include "meshing/tube/spatial_graph.hpp"

namespace tripus::meshing {

/// Geomview's VECT (also 4VECT), as KnotPlot and others write it; a negative number of points makes
/// a polyline closed. Colours are skipped. Throws InvalidInput with the line.
SpatialGraph read_vect(std::string_view text);

}  // namespace tripus::meshing
