#pragma once

#include <span>

#include "geometry/truncated_tetrahedron.hpp"

/// One tetrahedron whose vertices are all ideal. Source: docs/theory.md 10.2.
namespace tripus::geometry {

/// As `mixed_dihedral_angles` with the diagonal 0, by half the arithmetic: opposite angles are
/// equal, and they are those of a triangle with sides exp((l_ij + l_kl) / 2).
///   l         [6]   finite
///   theta     [6]   radians in [0, pi]; exactly 0 or pi where it is flat
///   jacobian  [36]  d theta_i / d l_j, symmetric and positive semidefinite; zero where flat, or so
///                   nearly that an entry exceeds 1e8; empty to skip
/// Accuracy: that of lengths changed by a few ulp of the longest.
TetrahedronKind ideal_dihedral_angles(std::span<const double, 6> l, std::span<double, 6> theta,
                                      std::span<double> jacobian = {});

/// `volume` where the sums of the angles are pi at all four vertices, so that opposite angles are
/// equal: half the sum of Cl2(2 theta) over the angles at one vertex. Absolute error some 1e-15.
/// Source: J. Milnor, Hyperbolic geometry: the first 150 years, Bull. AMS 6 (1982).
double ideal_volume(std::span<const double, 6> theta);

}  // namespace tripus::geometry
