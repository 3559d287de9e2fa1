#pragma once

#include <array>
#include <optional>

#include "structure/proof/detail/arb_number.hpp"

/// One tetrahedron for the checker of proofs, by the formulae as they stand in the theory and by no
/// code of the prover: determinants are expanded, angles are arc cosines, the Jacobian is that of
/// theory (16), and the volume is Ushijima's sum of dilogarithms.
namespace tripus::structure::detail {

inline constexpr int kCheckedEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

/// Gram matrix, cofactors and determinant of six lengths: theory (6) and (77).
///   kind  1 at a hyperideal vertex, 0 at an ideal, -1 at a finite one
struct CheckedGram {
  using Matrix4 = std::array<std::array<Arb, 4>, 4>;
  Matrix4 g, c;
  std::array<Arb, 6> slope;  ///< |d G_ij / dl|
  Arb det;

  CheckedGram(const std::array<Arb, 6>& l, const std::array<int, 4>& kind);
  /// Whether there is a true tetrahedron with it: det G < 0 and all c_kk < 0.
  bool is_true() const;
  /// cos theta_ij = c_kl / sqrt(c_kk c_ll), theory (10).
  Arb cosine(int e) const;
};

std::array<Arb, 6> checked_angles(const CheckedGram& gram);

/// d theta / dl by the general formula that follows theory (16); rows of edges with slope 0 are 0.
std::array<std::array<Arb, 6>, 6> checked_jacobian(const CheckedGram& gram);

/// Weights w > 0 with J >= diag(w) for every member of J; nothing if none was shown.
std::optional<std::array<double, 6>> checked_weights(const std::array<std::array<Arb, 6>, 6>& J);

/// Ushijima's formula, theory (24), as it stands.
Arb checked_volume(const CheckedGram& gram, const std::array<Arb, 6>& theta);

}  // namespace tripus::structure::detail
