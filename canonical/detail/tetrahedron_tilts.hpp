#pragma once

#include <array>
#include <cstddef>

namespace tripus::canonical::detail {

/// The cofactors of the Gram matrix of one truncated tetrahedron: docs/theory.md (7).
template <class Real>
struct Cofactors {
  std::array<std::array<Real, 4>, 4> c;  ///< off the diagonal c_kl, on it p_k = -c_kk
  Real D;                                ///< -det G
};

/// `a` [6] holds cosh l in the order 01 02 03 12 13 23. Only two terms are subtracted anywhere.
template <class Real>
Cofactors<Real> cofactors(const std::array<Real, 6>& a) {
  constexpr std::size_t kEdge[4][4] = {{9, 0, 1, 2}, {0, 9, 3, 4}, {1, 3, 9, 5}, {2, 4, 5, 9}};
  Cofactors<Real> result;
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t l = k + 1; l < 4; ++l) {
      const std::size_t i = k == 0 ? (l == 1 ? 2 : 1) : 0;
      const std::size_t j = 6 - i - k - l;
      const Real &ij = a[kEdge[i][j]], &kl = a[kEdge[k][l]];
      const Real &ik = a[kEdge[i][k]], &il = a[kEdge[i][l]];
      const Real &jk = a[kEdge[j][k]], &jl = a[kEdge[j][l]];
      const Real c = ik * il + jk * jl + ij * (ik * jl + il * jk) - kl * ((ij - 1) * (ij + 1));
      result.c[k][l] = result.c[l][k] = c;
    }
    const std::size_t x = k == 0 ? 1 : 0, y = k <= 1 ? 2 : 1, z = 6 - x - y - k;
    const Real &xy = a[kEdge[x][y]], &xz = a[kEdge[x][z]], &yz = a[kEdge[y][z]];
    result.c[k][k] = xy * xy + (xz * xz + (yz * yz - 1)) + 2 * (xy * xz * yz);
  }
  // det G expanded along its first row, with G_00 = 1 and G_0j = -cosh l_0j.
  result.D = result.c[0][0] + a[0] * result.c[0][1] + a[1] * result.c[0][2] + a[2] * result.c[0][3];
  return result;
}

/// Tilts of the faces: t_i = (p_i - sum_j c_ij) / sqrt(p_i D). Source: docs/canonical.md (T3).
template <class Real>
std::array<Real, 4> tetrahedron_tilts(const Cofactors<Real>& g) {
  using std::sqrt;
  std::array<Real, 4> tilt;
  for (std::size_t i = 0; i < 4; ++i) {
    Real row = g.c[i][i];
    for (std::size_t j = 0; j < 4; ++j)
      if (j != i) row -= g.c[i][j];
    tilt[i] = row / sqrt(g.c[i][i] * g.D);
  }
  return tilt;
}

}  // namespace tripus::canonical::detail
