#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geometry/hyperbolic_space.hpp"

namespace tripus::geometry {

/// A tetrahedron in hyperbolic space, cut off at its hyperideal and ideal vertices and at its
/// parabolic edges: the points x with <x, n_i> <= 0 for its four faces, <x, v_i> <= 0 for
/// hyperideal vertices, <x, v_i> <= -1 for ideal ones, and <x, p_e> <= -1 for parabolic edges.
struct HyperboloidTetrahedron {
  /// By the kind of the vertex, v_i is
  ///   hyperideal  unit spacelike, the pole of the truncating plane;
  ///   ideal       null, its time > 0; its horosphere is {x : <x, v_i> = -1};
  ///   finite      a point of the hyperboloid.
  /// <v_i, v_j> is the Gram entry of the edge, docs/theory.md (77): -cosh l_ij between hyperideal
  /// ones.
  std::array<Vector4, 4> vertices;
  /// Unit spacelike, outward normals of the faces: <n_i, v_j> = 0 for j != i.
  std::array<Vector4, 4> faces;
  /// <v_i, v_i>: 1 hyperideal, 0 ideal, -1 finite.
  std::array<double, 4> diagonal{1, 1, 1, 1};
  /// Bit e is set where edge e = ij is parabolic: v_i and v_j, both hyperideal, have planes that
  /// touch at the ideal point of p_e = parabolic_scale (v_i + v_j), a null vector.
  std::uint8_t parabolic_edges = 0;
  double parabolic_scale = 1;

  bool is_hyperideal(std::size_t i) const { return diagonal[i] > 0; }
  bool is_ideal(std::size_t i) const { return diagonal[i] == 0; }
  bool is_finite(std::size_t i) const { return diagonal[i] < 0; }
  bool is_parabolic(std::size_t e) const { return (parabolic_edges >> e & 1) != 0; }
  /// p_e of a parabolic edge.
  Vector4 parabolic_point(std::size_t e) const;
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

/// The same with vertices of every kind.
///   diagonal  [4]  1 hyperideal, 0 ideal, -1 finite
/// Lengths at ideal vertices are those from the horospheres and may be negative; the shape and its
/// frame are then found as well, but a horoball reaches beyond another one or the plane. The centre
/// depends on the horospheres.
/// An edge of length 0 between hyperideal vertices is parabolic. Throws as above; Unsupported for
/// an edge of length 0 or less between a finite and a hyperideal vertex (the vertex lies beyond the
/// plane).
/// Source: docs/theory.md (56) to (58), (77), (113).
HyperboloidTetrahedron hyperboloid_tetrahedron(std::span<const double, 6> l,
                                               std::span<const double, 4> diagonal,
                                               int orientation);

/// The corner where edge ij meets the truncating plane or the horosphere of vertex i, or vertex i
/// itself if it is finite: a point of the hyperboloid. Not for a parabolic edge, whose corner is
/// ideal. Source: docs/theory.md (59), (113).
Vector4 corner(const HyperboloidTetrahedron& tetrahedron, int i, int j);

/// Where the horosphere of the parabolic edge ij meets the plane of vertex i in face f, which
/// contains the edge. Source: docs/theory.md (116).
Vector4 parabolic_corner(const HyperboloidTetrahedron& tetrahedron, int i, int j, int f);

/// The point of the horosphere {x : <x, v> = -1} that lies half-way, in its own Euclidean geometry,
/// between points of it whose mean is m: <m, v> = -1. Source: docs/theory.md (114).
Vector4 on_horosphere(const Vector4& m, const Vector4& v);

}  // namespace tripus::geometry
