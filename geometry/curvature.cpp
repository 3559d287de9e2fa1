#include "geometry/curvature.hpp"

#include <numbers>
#include <numeric>

namespace tripus::geometry {

double edge_curvature(std::span<const double> angles_around_edge) {
  return 2 * std::numbers::pi -
         std::accumulate(angles_around_edge.begin(), angles_around_edge.end(), 0.0);
}

double truncation_area(double a, double b, double c) { return std::numbers::pi - (a + b + c); }

double solid_angle(double a, double b, double c) { return (a + b + c) - std::numbers::pi; }

double vertex_curvature(std::span<const double> solid_angles) {
  return 4 * std::numbers::pi - std::accumulate(solid_angles.begin(), solid_angles.end(), 0.0);
}

}  // namespace tripus::geometry
