#pragma once

#include <array>
#include <span>

namespace tripus::geometry {

/// What six lengths are. A flat tetrahedron has angle pi at one pair of opposite edges and 0 at
/// the other four; the name says which pair.
enum class TetrahedronKind { kTruncated, kFlat01_23, kFlat02_13, kFlat03_12 };

/// Dihedral angles of one truncated tetrahedron.
///   l         [6]   hyperbolic lengths, finite, > 0, order 01 02 03 12 13 23
///   theta     [6]   radians in [0, pi]; exactly 0 or pi where it is flat
///   jacobian  [36]  d theta_i / d l_j, row-major, symmetric, positive definite where the
///                   tetrahedron is not flat; zero where it is, or so nearly that an entry would
///                   exceed 1e8 (sums of such entries have no digits left); empty to skip
/// Returns the kind of l: a flat tetrahedron is an answer, not an error.
/// Accuracy: the angles are those of lengths changed by a few ulp, for every positive length a
/// double can hold (the Gram matrix is scaled where its entries would overflow).
/// Throws InvalidInput if a length is not finite or not positive.
/// Source: docs/theory.md section 2.
TetrahedronKind dihedral_angles(std::span<const double, 6> l, std::span<double, 6> theta,
                                std::span<double> jacobian = {});

/// The same map extended continuously to all of R^6: a length <= 0 counts as 0, its angle is 0 and
/// so are its row and column of the Jacobian. Entries must be finite (not checked).
/// This is the gradient of the extended co-volume, convex and C1 (docs/theory.md section 4).
TetrahedronKind extended_dihedral_angles(std::span<const double, 6> l, std::span<double, 6> theta,
                                         std::span<double> jacobian = {});

/// Edge lengths of the truncated tetrahedron with given dihedral angles; inverse of
/// `dihedral_angles` on its open domain: theta > 0 and the three angles at every vertex sum to
/// less than pi. Outside of it returns false and leaves l unchanged.
/// Source: docs/theory.md section 2.
bool lengths_from_angles(std::span<const double, 6> theta, std::span<double, 6> l);

/// The three edges at each vertex.
inline constexpr std::array<std::array<int, 3>, 4> kEdgesAtVertex{
    {{0, 1, 2}, {0, 3, 4}, {1, 3, 5}, {2, 4, 5}}};

}  // namespace tripus::geometry
