#pragma once

#include "geometry/hyperbolic_space.hpp"

namespace tripus::geometry {

/// The boost, an isometry without rotation, that takes the origin to the point with these spatial
/// coordinates.
Matrix4 boost(const Vector3& x);

}  // namespace tripus::geometry
