#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "geometry/batch.hpp"
#include "geometry/enclosure_formulae.hpp"

namespace tripus::geometry {

/// Lengths up to here are enclosed in doubles; beyond, products in the kernel come near overflow.
inline constexpr double kEnclosureLimit = 40.0;

/// What a block holds after `enclose`: quantity q of lane i at [q][i].
inline constexpr std::size_t kAngleMid = 0;     ///< [6] dihedral angles at the lengths given
inline constexpr std::size_t kAngleRadius = 6;  ///< [6] how far from the true ones they can be
inline constexpr std::size_t kWeight = 12;      ///< [6] of the corners
inline constexpr std::size_t kVolumeMid = 18;   ///< volume at the lengths given
inline constexpr std::size_t kVolumeRadius = 19;
inline constexpr std::size_t kAngleLow = 20;  ///< [6] to be added to the angles: below half an ulp
inline constexpr std::size_t kEnclosed = 26;

/// What a block holds after `mixed_angles`: the angles and the volume as above, and
inline constexpr std::size_t kSound = 12;  ///< 1 where they are proved, else 0
/// After `mixed_jacobian`: kSound, and
inline constexpr std::size_t kJacobianMid = 26;     ///< [21] packed as packed_index says
inline constexpr std::size_t kJacobianRadius = 47;  ///< [21]
inline constexpr std::size_t kMixedEnclosed = 68;

/// Enclosures of one truncated tetrahedron in doubles, every rounding accounted for; all
/// instruction sets give the same bits.
struct EnclosureKernels {
  std::string_view name;

  /// For every lane of `blocks` blocks of eight tetrahedra:
  ///   lengths  [blocks][6][8]          l, the middle of a box
  ///   radii    [blocks][6][8]          >= 0, half its sides
  ///   out      [blocks][kEnclosed][8]  angles and volume at l, and weights w [6] > 0 with
  ///       J(l') >= diag(w)  for every l' in the box,
  /// which the weights being > 0 says is proved, and with it that all l' are positive and those of
  /// true truncated tetrahedra. Weights are 0 where doubles do not prove it; the rest of the lane
  /// is then without meaning. That is everywhere unless the thread rounds to nearest. Volumes are
  /// only computed if `with_volume`. Source: docs/theory.md section 9.
  void (*enclose)(std::size_t blocks, const double* lengths, const double* radii, double* out,
                  bool with_volume);

  /// The same angles and volumes at the lengths of tetrahedra with hyperideal and ideal vertices,
  /// all with one `diagonal`. Lengths at ideal vertices may be negative, theory (77). The
  /// volume is sharp if the vertices are of one kind; elsewhere (24) is ill-conditioned.
  ///   out  [blocks][kMixedEnclosed][8]
  void (*mixed_angles)(std::size_t blocks, const double* lengths, const GramDiagonal& diagonal,
                       double* out, bool with_volume);
  /// Their Jacobian over the box: where it is sound, all members are of true tetrahedra.
  void (*mixed_jacobian)(std::size_t blocks, const double* lengths, const double* radii,
                         const GramDiagonal& diagonal, double* out);
};

/// The fastest kernels that this processor runs, and every set, "portable" first.
const EnclosureKernels& enclosure_kernels();
std::span<const EnclosureKernels> all_enclosure_kernels();

}  // namespace tripus::geometry
