#pragma once

#include <cstdint>
#include <vector>

#include "meshing/tube/spatial_graph.hpp"

namespace tripus::meshing::detail {

/// Polylines as a file gives them, each at least two points.
struct Polyline {
  std::vector<Point> points;
  bool is_closed = false;  ///< from the last point to the first
};

/// The graph that polylines make where they share points: its vertices are the points where three
/// or more pieces meet, its edges run between these, or close up.
SpatialGraph graph_of(const std::vector<Polyline>& polylines);

}  // namespace tripus::meshing::detail
