#include "structure/angle_structure.hpp"

#include <numbers>

#include "base/error.hpp"
#include "structure/detail/angle_programme.hpp"

namespace tripus::structure {

AngleStructure deepest_angle_structure(const topology::Triangulation& triangulation,
                                       std::span<const topology::ConeAngle> cone_angles) {
  constexpr double kPi = std::numbers::pi;
  detail::AngleProgramme programme(triangulation, cone_angles);
  if (!programme.solve())
    throw InternalError("the simplex method did not solve the angle-structure programme");
  AngleStructure found;
  found.margin = kPi * programme.margin();
  found.angles = programme.angles();
  for (double& angle : found.angles) angle *= kPi;
  return found;
}

}  // namespace tripus::structure
