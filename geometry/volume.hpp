#pragma once

#include <span>

namespace tripus::geometry {

/// Volume of the truncated tetrahedron with dihedral angles theta [6] (radians, order
/// 01 02 03 12 13 23). Domain: the closure of theta > 0, vertex sums < pi. Flat tetrahedra have
/// volume 0. Absolute error some 1e-15.
/// Source: docs/theory.md section 3 (Ushijima's formula in Clausen's function).
double volume(std::span<const double, 6> theta);

/// Volume of the regular ideal octahedron: the supremum of the volumes of truncated tetrahedra.
inline constexpr double kOctahedronVolume = 3.66386237670887606021841405972953644309659749712668;

}  // namespace tripus::geometry
