#pragma once

#include <optional>

#include "structure/detail/angle_programme.hpp"
#include "structure/existence.hpp"

// Two ways from an optimum of the angle programme to exact numbers. Both return only what has been
// checked exactly, as `existence` states it, or nothing.

namespace tripus::structure::detail {

/// Rounds the floating-point optimum to a common denominator, the smallest of a few that does.
std::optional<Existence> by_rounding(const topology::Triangulation& triangulation,
                                     const AngleProgramme& programme);

/// Solves the linear systems of the final basis over the rationals. Always succeeds if the basis is
/// optimal.
std::optional<Existence> by_exact_basis(const topology::Triangulation& triangulation,
                                        const AngleProgramme& programme);

}  // namespace tripus::structure::detail
