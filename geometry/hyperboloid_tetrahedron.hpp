#pragma once

#include <array>
#include <span>

#include "geometry/hyperbolic_space.hpp"

namespace tripus::geometry {

/// A truncated tetrahedron in hyperbolic space: the points x with <x, v_i> <= 0 and <x, n_i> <= 0
/// for its eight planes.
struct HyperboloidTetrahedron {
  /// Unit spacelike, the poles of the truncating planes: <v_i, v_j> = -cosh l_ij.
  std::array<Vector4, 4> vertices;
  /// Unit spacelike, outward normals of the faces: <n_i, v_j> = 0 for j != i.
  std::array<Vector4, 4> faces;
};

/// Edges longer than this are refused: coordinates are of size e^{l/2} and their products of size
/// e^l, which must not overflow.
inline constexpr double kLongestEmbeddedEdge = 300;

/// The tetrahedron with lengths l [6], order 01 02 03 12 13 23, in its own frame:
///   - the origin is a point in its interior, the *centre*: the point where the weighted sum of
///     sinh^2 of the distances to the truncating planes is least. The weights depend on the lengths
///     alone, so the centre does not depend on the labels (docs/theory.md (58));
///   - v_3 points up (z > 0, x = y = 0) and v_0 lies over the positive x axis (y = 0);
///   - det(v_0, v_1, v_2, v_3) has the sign of `orientation`, 1 or -1: the mirror image in the
///   plane
///     y = 0 of the one is the other.
/// Accuracy: <v_i, v_j> is -cosh l_ij to a few ulp of |v_i| |v_j|, which the frame keeps as near to
/// cosh l_ij as the shape allows.
/// Throws InvalidInput where the lengths are not those of a truncated tetrahedron, or where it is
/// so nearly flat that rounding decides, and Unsupported for a length above kLongestEmbeddedEdge.
/// Source: docs/theory.md (56) to (59).
HyperboloidTetrahedron hyperboloid_tetrahedron(std::span<const double, 6> l, int orientation = 1);

/// The corner where edge ij meets the truncation of vertex i: a point of the hyperboloid.
Vector4 corner(const HyperboloidTetrahedron& tetrahedron, int i, int j);

}  // namespace tripus::geometry
