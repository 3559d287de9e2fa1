#pragma once

#include <limits>
#include <string>

#include "meshing/tube/detail/strands.hpp"

namespace tripus::meshing::tube {

/// How thick a tube may be: for every radius below `room` the tube's shape is that of a regular
/// neighbourhood of the graph, and pipes and outer surface stay apart (see clearance.cpp).
struct Clearance {
  double room = std::numeric_limits<double>::infinity();
  std::string place;  ///< what limits it, for messages
};

/// Throws InvalidInput where strands touch, or fold back on themselves.
Clearance find_clearance(const TubeStrands& strands);

double segment_distance(const Point& a, const Point& b, const Point& c, const Point& d);
double point_segment_distance(const Point& p, const Point& a, const Point& b);

}  // namespace tripus::meshing::tube
