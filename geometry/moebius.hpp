#pragma once

#include <array>
#include <complex>

#include "geometry/hyperbolic_space.hpp"

/// Isometries of the upper half-space as Moebius maps of its boundary, the plane with infinity.
namespace tripus::geometry {

using Complex = std::complex<double>;

/// w -> (a w + b) / (c w + d), or the same of the conjugate of w where `reverses` (it reverses
/// orientation). a d - b c = 1; (a, b, c, d) and its negative are one map: PSL(2,C) and its other
/// half.
struct MoebiusMap {
  Complex a{1}, b{0}, c{0}, d{1};
  bool reverses = false;
};

/// A point of the boundary: x : y, the number x / y; y = 0 is infinity.
struct BoundaryPoint {
  Complex x{0}, y{1};
};

/// The map "first `second`, then `first`", as for matrices.
MoebiusMap operator*(const MoebiusMap& first, const MoebiusMap& second);
MoebiusMap inverse(const MoebiusMap& map);
/// Scaled to a d - b c = 1.
MoebiusMap normalised(const MoebiusMap& map);

BoundaryPoint apply(const MoebiusMap& map, const BoundaryPoint& point);

/// The orientation-preserving map with three given values at three points, distinct in each triple:
/// phi2^-1 o phi1, where phi1 takes `from` and phi2 takes `to` to 0, 1, infinity. With `reverses`,
/// the orientation-reversing one.
/// Source: docs/theory.md (70), the paper's section 3.3.3.
MoebiusMap map_of_triples(const std::array<BoundaryPoint, 3>& from,
                          const std::array<BoundaryPoint, 3>& to, bool reverses = false);

/// The same isometry on the hyperboloid; docs/theory.md (61).
Matrix4 to_matrix(const MoebiusMap& map);

/// The Moebius map of an isometry in O+(3,1), up to sign. Also good for a matrix that rounding has
/// moved off the group.
MoebiusMap to_moebius(const Matrix4& isometry);
/// The same where it is known whether the isometry reverses orientation: far from the identity the
/// sign of a determinant is noise.
MoebiusMap to_moebius(const Matrix4& isometry, bool reverses);

/// Where the map takes the origin, on the hyperboloid.
Vector4 image_of_origin(const MoebiusMap& map);

/// The ideal point of a null vector with positive time.
BoundaryPoint to_boundary(const Vector4& null_vector);

/// How far two maps are apart: max |difference of coefficients|, by the better of the two signs,
/// and infinity if one reverses orientation and the other does not.
double difference(const MoebiusMap& first, const MoebiusMap& second);

}  // namespace tripus::geometry
