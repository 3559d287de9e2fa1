#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace tripus::geometry {

/// Tetrahedra in blocks of kLanes: quantity q of lane i of block b lies at [b][q][i]. A block
/// holds lengths [6][8], angles [6][8], Jacobians [21][8] (packed upper triangle, row-major).
inline constexpr std::size_t kLanes = 8;
inline constexpr std::size_t kPackedJacobian = 21;

/// Blocks that hold `count` tetrahedra.
constexpr std::size_t block_count(std::size_t count) { return (count + kLanes - 1) / kLanes; }

/// The kernels for one instruction set. All of them give the same bits.
struct BatchKernels {
  std::string_view name;  ///< "portable", "avx2" or "avx512"

  /// Extended dihedral angles and Jacobians of `blocks` blocks, all lanes.
  ///   lengths   [blocks][6][8]   finite; <= 0 counts as 0
  ///   theta     [blocks][6][8]   as extended_dihedral_angles
  ///   jacobian  [blocks][21][8]  or null
  /// Returns the number of flat lanes.
  std::size_t (*angles)(std::size_t blocks, const double* lengths, double* theta, double* jacobian);

  /// The same with ideal vertices.
  ///   lengths   [blocks][6][8]  finite; <= 0 counts as 0 between hyperideal vertices
  ///   diagonal  [blocks][4][8]  G_vv: 1 at hyperideal vertices, 0 at ideal ones
  std::size_t (*mixed_angles)(std::size_t blocks, const double* lengths, const double* diagonal,
                              double* theta, double* jacobian);

  /// The same where all vertices are ideal: the angles of `mixed_angles` with the diagonal 0, up to
  /// rounding. lengths [blocks][6][8] finite
  std::size_t (*ideal_angles)(std::size_t blocks, const double* lengths, double* theta,
                              double* jacobian);

  /// y = J x for the 8 tetrahedra of one block: jacobian [21][8], x [6][8], y [6][8].
  void (*jacobian_times)(const double* jacobian, const double* x, double* y);

  /// Volumes, docs/theory.md section 3: they differ from `volume` by some 1e-15, and where edges
  /// are long by what the rounding of the angles is worth, half the length times that.
  ///   lengths  [blocks][6][8]
  ///   theta    [blocks][6][8]  what `angles` finds there
  ///   volumes  [blocks][8]
  void (*volumes)(std::size_t blocks, const double* lengths, const double* theta, double* volumes);
};

/// Those of TRIPUS_SIMD (kernel_choice.hpp), or the fastest that this processor runs; chosen once.
const BatchKernels& batch_kernels();

/// Every set of kernels that this processor runs, "portable" first: for tests and benchmarks.
std::span<const BatchKernels> all_batch_kernels();

}  // namespace tripus::geometry
