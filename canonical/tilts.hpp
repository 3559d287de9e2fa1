#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

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

/// The faces of a triangulation with its metric, by the signs of their tilt sums.
struct FaceKinds {
  std::vector<std::array<FaceKind, 4>> kind;  ///< [T x 4] the same from both sides
  std::vector<std::array<double, 4>> sum;     ///< [T x 4] tilt sums in double precision
  bool precise = false;  ///< whether some sums were near 0 and taken again in 50 digits
  /// Largest |sum| of a transparent face, after the second pass: what "0" was. 0 if there is none.
  double largest_zero = 0;
  /// Smallest |sum| of any other face: how far from 0 the nearest sign was.
  double margin = 0;

  bool has_concave() const;
};

/// Tilt sums and kinds of all faces.
///   lengths  [E]  those of the metric, as structure::solve finds them
/// Sums that double precision cannot tell from 0 are settled in 50 digits, from lengths that are
/// improved to 50 digits first; only if no face is concave beyond doubt (else there is something to
/// do anyway, and faces in doubt are called transparent for the time being).
/// Throws InternalError if the lengths are so poor that they cannot be improved.
FaceKinds face_kinds(const topology::Triangulation& triangulation, std::span<const double> lengths);

}  // namespace tripus::canonical
