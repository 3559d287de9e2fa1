#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace tripus::canonical::detail {

/// Vertices of one tetrahedron: the diagonal of its Gram matrix, 1 (hyperideal) or 0 (ideal).
using Diagonal = std::array<int, 4>;

/// -G_ij of an edge of length l, in any real type: docs/theory.md (77).
template <class Real>
Real minus_gram(const Real& l, int d_i, int d_j) {
  using std::cosh, std::exp;
  if (d_i != 0 && d_j != 0) return cosh(l);
  return d_i == d_j ? Real(2 * exp(l)) : Real(exp(l));
}

/// The square of the slope s_ij: G_ij^2 - G_ii G_jj.
template <class Real>
Real squared_slope(const Real& a, int d_i, int d_j) {
  return d_i != 0 && d_j != 0 ? Real((a - 1) * (a + 1)) : Real(a * a);
}

/// The cofactors of the Gram matrix of one tetrahedron: docs/theory.md (7), (48).
template <class Real>
struct Cofactors {
  std::array<std::array<Real, 4>, 4> c;  ///< off the diagonal c_kl, on it p_k = -c_kk
  Real D;                                ///< -det G
};

/// `a` [6] holds -G_ij in the order 01 02 03 12 13 23. Only two terms are subtracted anywhere.
template <class Real>
Cofactors<Real> cofactors(const std::array<Real, 6>& a, const Diagonal& d) {
  constexpr std::size_t kEdge[4][4] = {{9, 0, 1, 2}, {0, 9, 3, 4}, {1, 3, 9, 5}, {2, 4, 5, 9}};
  Cofactors<Real> result;
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t l = k + 1; l < 4; ++l) {
      const std::size_t i = k == 0 ? (l == 1 ? 2 : 1) : 0;
      const std::size_t j = 6 - i - k - l;
      const Real &ij = a[kEdge[i][j]], &kl = a[kEdge[k][l]];
      const Real &ik = a[kEdge[i][k]], &il = a[kEdge[i][l]];
      const Real &jk = a[kEdge[j][k]], &jl = a[kEdge[j][l]];
      const Real c = d[j] * (ik * il) + d[i] * (jk * jl) + ij * (ik * jl + il * jk) -
                     kl * squared_slope(ij, d[i], d[j]);
      result.c[k][l] = result.c[l][k] = c;
    }
    const std::size_t x = k == 0 ? 1 : 0, y = k <= 1 ? 2 : 1, z = 6 - x - y - k;
    const Real &xy = a[kEdge[x][y]], &xz = a[kEdge[x][z]], &yz = a[kEdge[y][z]];
    result.c[k][k] = d[z] * (xy * xy) + (d[y] * (xz * xz) + d[x] * squared_slope(yz, d[y], d[z])) +
                     2 * (xy * xz * yz);
  }
  // -det G expanded along its first row.
  result.D =
      d[0] * result.c[0][0] + a[0] * result.c[0][1] + a[1] * result.c[0][2] + a[2] * result.c[0][3];
  return result;
}

/// The tilt of a face where the horospheres shrink: geodesic + cusp / lambda, with the vectors of
/// ideal vertices lambda times those that belong to the lengths, and lambda -> infinity.
template <class Real>
struct TiltTerms {
  Real geodesic;  ///< from hyperideal vertices; 0 without any
  Real cusp;      ///< from ideal vertices; 0 without any
};

/// The terms for the four faces. Source: docs/canonical.md (T3), (T7).
template <class Real>
std::array<TiltTerms<Real>, 4> tetrahedron_tilts(const Cofactors<Real>& g, const Diagonal& d) {
  using std::sqrt;
  std::array<TiltTerms<Real>, 4> tilt;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Real, 2> row{Real(0), Real(0)};  // of ideal, of hyperideal vertices
    row[static_cast<std::size_t>(d[i])] = g.c[i][i];
    for (std::size_t j = 0; j < 4; ++j)
      if (j != i) row[static_cast<std::size_t>(d[j])] -= g.c[i][j];
    const Real norm = sqrt(g.c[i][i] * g.D);
    tilt[i] = {row[1] / norm, row[0] / norm};
  }
  return tilt;
}

}  // namespace tripus::canonical::detail
