#pragma once

#include <array>
#include <span>

#include "geometry/hyperbolic_space.hpp"
#include "geometry/hyperboloid_tetrahedron.hpp"
#include "geometry/moebius.hpp"

/// One truncated tetrahedron in the upper half-space by the circles in which its planes meet the
/// plane at infinity: the route of the paper's section 3.3.
namespace tripus::geometry {

/// An oriented circle or line, the boundary of a hyperbolic plane. Straight lines are circles
/// through infinity and nothing special: these coordinates serve both.
struct Circle {
  /// 1 / radius; > 0 where the inner side is outside the disc, < 0 where it is inside; 0 for a
  /// line.
  double curvature = 0;
  /// curvature * centre; for a line the unit normal to its outer side.
  Complex weighted_centre{0, 0};
  /// curvature * (|centre|^2 - radius^2); for a line twice its distance from 0 along the normal.
  double co_curvature = 0;

  bool is_line() const { return curvature == 0; }
  Complex centre() const { return weighted_centre / curvature; }  ///< of a circle that is no line
  double radius() const { return 1 / std::abs(curvature); }
};

/// The plane over a circle, and the circle of a plane; the half-space is <x, n> <= 0.
/// Source: docs/theory.md (64).
Vector4 plane_of(const Circle& circle);
Circle circle_of(const Vector4& plane);

/// The circles of one truncated tetrahedron. The intersection of the eight half-spaces over them is
/// the truncated tetrahedron.
struct CirclePacking {
  std::array<Circle, 4> faces;     ///< face i, opposite vertex i: the paper's f_{i+1}
  std::array<Circle, 4> vertices;  ///< truncation of vertex i: the paper's v_{i+1}
};

/// The tetrahedron with dihedral angles theta [6] (radians, order 01 02 03 12 13 23), in the
/// paper's place: f1 is the line y = 0, f2 the line through 0 at the angle theta_23 with it, f3 has
/// radius 1. f4 is the smaller of the two circles that the angles allow, the root with "+": the
/// larger one is its mirror image. So det(v_0, v_1, v_2, v_3) > 0 always. Throws InvalidInput
/// unless theta > 0 and the angles at every vertex sum to less than pi. Source: docs/theory.md (65)
/// to (68), the paper's section 3.3.2.
CirclePacking circle_packing(std::span<const double, 6> theta);

/// The dihedral angle between the planes over two circles that meet, measured in the plane at
/// infinity from centres, radii and directions alone.
double intersection_angle(const Circle& first, const Circle& second);

/// The eight half-spaces of a packing as poles and outward normals: the same tetrahedron as
/// `hyperboloid_tetrahedron` finds from the lengths, in another place.
HyperboloidTetrahedron to_hyperboloid(const CirclePacking& packing);

/// The circles at infinity of a tetrahedron in any place.
CirclePacking circles_of(const HyperboloidTetrahedron& tetrahedron);

/// The isometry that carries one tetrahedron to another with the same lengths, from the frames that
/// their vertices are. It reverses orientation where their orientations differ.
Matrix4 isometry_between(const HyperboloidTetrahedron& from, const HyperboloidTetrahedron& to);

/// The mirror image in the line y = 0.
CirclePacking mirrored(const CirclePacking& packing);

/// The image of a circle under a Moebius map.
Circle apply(const MoebiusMap& map, const Circle& circle);

}  // namespace tripus::geometry
