#pragma once

#include <array>
#include <optional>
#include <vector>

#include "studies/study.hpp"
#include "topology/triangulation.hpp"

// The metric without a flow, an energy or the kernels: the gluing equations as equations in the
// numbers c_e = cosh l_e, solved to 50 digits. Nothing here shares code with geometry/.
//
// With G_ii = 1, G_ij = -c_ij and its cofactors m_ij, the dihedral angle at edge ij is that of the
// complex number
//     z_ij = m_kl + i sqrt(-det G) sqrt(c_ij^2 - 1),      {i,j,k,l} = {0,1,2,3},
// of absolute value sqrt(m_kk m_ll). The gluing equation of an edge class is
//     Im( product of z / |z| around the edge ) = 0
// with real part 1 and with angles that add up to 2 pi and not to another multiple of it. Every
// step is algebraic in the c_e.

namespace tripus::studies::detail {

struct AlgebraicMetric {
  bool found = false;
  int newton_steps = 0;         ///< in multiprecision
  double residual = 0;          ///< largest |Im| of the gluing equations at the end
  double distance_bound = 0;    ///< |J^-1 residual|: how far from a solution, to first order
  std::vector<double> lengths;  ///< [E], rounded from 50 digits
  std::vector<double> angles;   ///< [T x 6] radians, the same
  double volume = 0;            ///< by Schlaefli's formula, integrated to some 20 digits
};

/// Dihedral angles [6] from lengths [6] by the same formulae in 60 digits, rounded; nothing where
/// this is not a truncated tetrahedron. Lengths of up to 1e8.
std::optional<std::array<double, 6>> dihedral_angles_in_60_digits(const std::array<double, 6>& l);

/// From equal lengths, by damped Newton steps in double precision and then in 60 digits. Not found
/// where the steps leave the truncated tetrahedra or do not settle.
///   stop  polled; once it is set the result is not found
AlgebraicMetric solve_algebraically(const topology::Triangulation& triangulation, const Stop& stop);

}  // namespace tripus::studies::detail
