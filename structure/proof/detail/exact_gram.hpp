#pragma once

#include <array>

#include "geometry/edge_frames.hpp"
#include "structure/proof/detail/precise_tetrahedron.hpp"

namespace tripus::structure::detail {

/// What the Gram matrix of a tetrahedron gives by sums and products alone, for numbers that are
/// known exactly: theory (7), (9) and (77), each as a polynomial in a_ij = -G_ij.
template <class N>
struct ExactGram {
  std::array<N, 6> cofactor;  ///< c_kl at edge ij: its sign is that of the cosine there
  std::array<N, 4> minor;     ///< p_l = -c_ll
  N minus_det;                ///< D = -det G

  ExactGram(const std::array<N, 6>& a, const Diagonal& diagonal) {
    const auto at = [&](int i, int j) -> const N& {
      return a[static_cast<std::size_t>(geometry::kEdgeBetween[i][j])];
    };
    const auto d = [&](int i) { return N(diagonal[static_cast<std::size_t>(i)]); };
    for (int e = 0; e < 6; ++e) {
      const auto [i, j, k, l] = geometry::kEdgeFrames[e];
      cofactor[static_cast<std::size_t>(e)] =
          at(i, j) * (at(i, k) * at(j, l) + at(i, l) * at(j, k)) + d(j) * at(i, k) * at(i, l) +
          d(i) * at(j, k) * at(j, l) - at(k, l) * (at(i, j) * at(i, j) - d(i) * d(j));
    }
    for (int v = 0; v < 4; ++v) {
      const int i = v == 0 ? 1 : 0, j = v <= 1 ? 2 : 1, k = v <= 2 ? 3 : 2;
      minor[static_cast<std::size_t>(v)] =
          N(2) * at(i, j) * at(i, k) * at(j, k) + d(i) * at(j, k) * at(j, k) +
          d(j) * at(i, k) * at(i, k) + d(k) * (at(i, j) * at(i, j) - d(i) * d(j));
    }
    // Row 0 of G by its cofactors: det G = d_0 (-p_0) + sum_j (-a_0j) c_0j.
    minus_det = d(0) * minor[0];
    for (int j = 1; j < 4; ++j) minus_det = minus_det + at(0, j) * opposite(0, j);
  }

  /// c_ij.
  const N& opposite(int i, int j) const {
    return cofactor[static_cast<std::size_t>(5 - geometry::kEdgeBetween[i][j])];
  }
};

}  // namespace tripus::structure::detail
