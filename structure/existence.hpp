#pragma once

#include <optional>
#include <span>
#include <variant>

#include "structure/certificate.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure {

/// Whether a triangulation has a strict angle structure with given cone angles, with the exact
/// proof: the structure itself, or a certificate that there is none.
using Existence = std::variant<StrictAngles, Certificate>;

/// Decides exactly. The three answers exclude each other:
///   StrictAngles               a strict angle structure exists: H is coercive, a minimiser exists
///   Certificate, kind semi     angle structures exist (this too has been proved), none is strict
///   Certificate, kind none     there is no angle structure
///   cone_angles [E], each a rational multiple of pi (see ConeAngle); empty for 2 pi
/// Works for every triangulation, also those that topology::require_solvable refuses. A finite
/// vertex is treated like a hyperideal one: then the answer is never StrictAngles, since vertex
/// sums are < pi, and it says nothing about metrics. Time: about the simplex method's. Exact
/// arithmetic is used for the checks, and for more only where rounding the floating-point optimum
/// does not already give a proof. Throws InvalidInput where a cone angle is not known to be
/// rational, and InternalError rather than return what does not pass `check`. Source:
/// docs/theory.md (50)-(52).
Existence existence(const topology::Triangulation& triangulation,
                    std::span<const topology::ConeAngle> cone_angles = {});

/// The same, or nothing if the simplex method takes longer than so many seconds.
std::optional<Existence> existence_within(double seconds,
                                          const topology::Triangulation& triangulation,
                                          std::span<const topology::ConeAngle> cone_angles = {});

}  // namespace tripus::structure
