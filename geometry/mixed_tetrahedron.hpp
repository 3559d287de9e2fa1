#pragma once

#include <span>

#include "geometry/truncated_tetrahedron.hpp"

/// One tetrahedron whose vertices may be hyperideal, ideal or finite. The kind of a vertex is given
/// by G_vv, the diagonal of the Gram matrix: +1, 0 or -1. Source: docs/theory.md section 10.
namespace tripus::geometry {

/// A Gram entry as a function of an edge's length.
struct GramEntry {
  double minus_gram = 0;  ///< -G_ij
  double slope = 0;       ///< s_ij = d(-G_ij)/dl, so that s_ij^2 = G_ij^2 - G_ii G_jj
};
/// For ends with the diagonal entries d_i, d_j. The length of an edge with an ideal end is measured
/// from a horosphere and may be any real number; between a finite and a hyperideal vertex likewise
/// (negative: beyond the plane). Source: docs/theory.md (77).
GramEntry gram_entry(double l, double d_i, double d_j);

/// As `extended_dihedral_angles`, for hyperideal (+1) and ideal (0) vertices: the continuous
/// extension to all of R^6, where a length <= 0 between hyperideal vertices counts as 0.
///   l         [6]   finite
///   diagonal  [4]   +1 or 0
///   theta     [6]   radians in [0, pi]; exactly 0 or pi where it is flat
///   jacobian  [36]  d theta_i / d l_j, symmetric and positive semidefinite; its null vectors move
///                   the horospheres. Zero where flat, or so nearly that an entry exceeds 1e8
/// Accuracy: that of lengths changed by a few ulp of the longest.
TetrahedronKind mixed_dihedral_angles(std::span<const double, 6> l,
                                      std::span<const double, 4> diagonal,
                                      std::span<double, 6> theta, std::span<double> jacobian = {});

/// The same for vertices of every kind, finite ones (-1) included, where the map is neither
/// monotone nor extended: returns false, with angles 0 and a zero Jacobian, if there is no such
/// tetrahedron. Lengths up to some 50; computed with the 64 bits of a long double.
bool general_dihedral_angles(std::span<const double, 6> l, std::span<const double, 4> diagonal,
                             std::span<double, 6> theta, std::span<double> jacobian = {});

}  // namespace tripus::geometry
