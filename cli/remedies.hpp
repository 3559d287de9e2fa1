#pragma once

#include <span>
#include <string>

#include "structure/report.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::cli {

/// topology::require_geodesic_boundary, with the command that helps where there is one.
void require_boundary_with_remedy(const topology::Triangulation& triangulation);
void require_boundary_beside_cusps_with_remedy(const topology::Triangulation& triangulation);
/// The same with topology::require_solvable.
void require_with_remedy(const topology::Triangulation& triangulation,
                         std::span<const topology::ConeAngle> cone_angles);
/// The same with canonical::require_canonizable.
void require_canonizable_with_remedy(const topology::Triangulation& triangulation,
                                     std::span<const topology::ConeAngle> cone_angles);

/// What to do, by the options of this program; empty for Advice::kNone.
std::string advice_text(structure::Advice advice);

}  // namespace tripus::cli
