#pragma once

#include <cstdint>
#include <vector>

#include "meshing/detail/places.hpp"

namespace tripus::meshing::detail {

/// Throws InvalidInput for a coordinate that is not finite or not in_exact_range.
void require_coordinates(const std::vector<Point>& points, const Places& places);

/// Throws InvalidInput for a point that is marked unused, and for two points that are equal.
void require_points_used(const std::vector<bool>& used, const Places& places);
void require_points_different(const std::vector<Point>& points, const Places& places);

}  // namespace tripus::meshing::detail
