#pragma once

#include <cstddef>
#include <vector>

#include "parameterise/solid.hpp"

namespace tripus::parameterise {

/// So many tetrahedra take some five gigabytes.
inline constexpr int kMostRefined = 10'000'000;
/// Throws InvalidInput for more.
void require_refinable(std::size_t tetrahedra);

/// Refines the mesh where a map stretches it: bisects the edge whose image is longest, with all
/// tetrahedra around it, until there are `tetrahedra` of them or a few more. The solid stays the
/// same set, and its marking the same connection: the parts of a tetrahedron keep its frame. New
/// points of the boundary lie on its planes. An edge whose bisection would turn a tetrahedron over
/// by rounding stays.
///   points [V]  the map, in the frames of the points; afterwards also at the new points, halfway
///               between the ends of their edges, and these are the solid's `start`
/// Throws InvalidInput for more than kMostRefined.
void refine(MarkedSolid& solid, std::vector<Vector4>& points, std::size_t tetrahedra);

}  // namespace tripus::parameterise
