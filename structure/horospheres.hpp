#pragma once

#include <span>
#include <vector>

#include "energies/co_volume.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure {

/// The area of the horospheres from which lengths at cusps are reported: sqrt(3)/2. The lattice of
/// such a horosphere has a translation of length at most 1, so that in a manifold the horoballs are
/// embedded and disjoint, from each other and from the geodesic boundary (docs/theory.md 9.3).
inline constexpr double kHorosphereArea = 0.86602540378443864676;

/// Areas [V] of the horospheres to which the lengths belong, 0 at vertices that are not
/// ideal.
std::vector<double> horosphere_areas(const topology::Triangulation& triangulation,
                                     const energies::CoVolumeAt& at);

/// Moves every horosphere to the area kHorosphereArea: adds a constant to x_e for each end of e at
/// an ideal vertex, which changes no angle. Where the areas are no positive numbers (flat
/// tetrahedra only), x stays.
///   at  the functional at x
void set_horospheres(const topology::Triangulation& triangulation, const energies::CoVolumeAt& at,
                     std::span<double> x);

/// Takes out of g [E] what lies along the directions in which a horosphere moves. Of a curvature
/// that is rounding only.
void remove_horosphere_shifts(const topology::Triangulation& triangulation,
                              const energies::CoVolume& energy, std::span<double> g);

}  // namespace tripus::structure
