#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::canonical {

/// What a face of a geometric triangulation is for the canonical decomposition.
enum class FaceKind : std::uint8_t {
  kTrue,         ///< tilt sum < 0: the decomposition bends there
  kTransparent,  ///< tilt sum = 0: the tetrahedra on both sides are of one cell
  kConcave,      ///< tilt sum > 0: the triangulation is to be changed there
};

/// Tilts of the faces of one truncated tetrahedron.
///   l  [6]  lengths, > 0, of a true truncated tetrahedron, order 01 02 03 12 13 23
/// Returns [4] the tilt of face i, which is opposite vertex i. Where the tetrahedron is flat the
/// values are not finite.
/// Source: docs/canonical.md (T3).
std::array<double, 4> tilts(std::span<const double, 6> l);

/// The tilt of a face as horospheres shrink: `geodesic` + `cusp` / lambda, lambda -> infinity. The
/// first comes from hyperideal vertices and is 0 where there are none, the second from ideal ones.
/// Sums across faces are compared in this order. Source: docs/canonical.md (T7).
struct Tilt {
  double geodesic = 0;
  double cusp = 0;
};

/// The same for vertices that are hyperideal or ideal.
///   l         [6]  of a true tetrahedron; at ideal vertices from horospheres
///   diagonal  [4]  1 at hyperideal, 0 at ideal vertices
std::array<Tilt, 4> mixed_tilts(std::span<const double, 6> l, std::span<const int, 4> diagonal);

/// The faces of a triangulation with its metric, by the signs of their tilt sums.
struct FaceKinds {
  std::vector<std::array<FaceKind, 4>> kind;  ///< [T x 4] the same from both sides
  /// [T x 4] tilt sums in double precision: of the geodesic terms, of those of cusps where the
  /// former vanish because no hyperideal vertex is near.
  std::vector<std::array<double, 4>> sum;
  bool precise = false;  ///< whether some sums were near 0 and taken again in 50 digits
  /// Largest |sum| of a transparent face, after the second pass: what "0" was. 0 if there is none.
  double largest_zero = 0;
  /// Smallest |sum| of any other face: how far from 0 the nearest sign was.
  double margin = 0;

  bool has_concave() const;
};

/// Tilt sums and kinds of all faces.
///   lengths      [E]  those of the metric, as structure::solve finds them: from horospheres of one
///                     area at all cusps
///   cone_angles  [E]  of the metric; empty for 2 pi everywhere
/// No vertex may be finite. Sums that double precision cannot tell from 0 are settled in 50 digits,
/// from lengths that are improved to 50 digits first; only if no face is concave beyond doubt (else
/// there is something to do anyway, and faces in doubt are called transparent for the time being).
/// Throws InternalError if the lengths are so poor that they cannot be improved.
FaceKinds face_kinds(const topology::Triangulation& triangulation, std::span<const double> lengths,
                     std::span<const topology::ConeAngle> cone_angles = {});

}  // namespace tripus::canonical
