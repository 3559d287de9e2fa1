#pragma once

#include <array>
#include <optional>
#include <vector>

#include "structure/certificate.hpp"
#include "structure/detail/angle_programme.hpp"
#include "structure/existence.hpp"
#include "topology/triangulation.hpp"

// Two ways from an optimum of the angle programme to exact numbers. Both return only what has been
// checked exactly, as `existence` states it, or nothing.

namespace tripus::structure::detail {

/// A certificate from vertex multipliers w [T x 4] alone, >= 0 but at ideal vertices: given w, the
/// largest u_e that (43) allows is the minimum of w_v + w_v' over the corners of e, and it makes R
/// smallest. Common factors of w are taken out. Nothing if that R is not <= 0, or w = 0.
/// The constraints must be exact. The cone angles of the result are left empty.
std::optional<Certificate> certificate_from(const topology::Triangulation& triangulation,
                                            const AngleConstraints& constraints,
                                            std::vector<std::array<Integer, 4>> w);

/// Exactly: angles >= 0, vertex sums <= 1 or = 1, edge sums = cone angle; strict or not.
bool is_angle_structure(const topology::Triangulation& triangulation,
                        const AngleConstraints& constraints, const StrictAngles& angles);

/// Rounds the floating-point optimum to a common denominator, the smallest of a few that does.
std::optional<Existence> by_rounding(const topology::Triangulation& triangulation,
                                     const AngleProgramme& programme);

/// Solves the linear systems of the final basis over the rationals. Always succeeds if the basis is
/// optimal.
std::optional<Existence> by_exact_basis(const topology::Triangulation& triangulation,
                                        const AngleProgramme& programme);

}  // namespace tripus::structure::detail
