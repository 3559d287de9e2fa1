#pragma once

#include <array>
#include <span>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace tripus::testing {

/// 160 decimal digits: enough for lengths from 1e-300 to 1e6 by the definitions, without any care.
using Digits = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<160>,
                                             boost::multiprecision::et_off>;

/// Dihedral angles straight from the definition, docs/theory.md (6) and (9), in many digits: the
/// determinant and the cofactors by expansion along permutations.
struct ReferenceAngles {
  std::array<Digits, 6> theta;
  Digits minus_determinant;
};

inline Digits minor3(const std::array<std::array<Digits, 4>, 4>& g, int row, int column) {
  int r[3], c[3];
  for (int i = 0, a = 0, b = 0; i < 4; ++i) {
    if (i != row) r[a++] = i;
    if (i != column) c[b++] = i;
  }
  const auto at = [&](int i, int j) { return g[std::size_t(r[i])][std::size_t(c[j])]; };
  return at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) -
         at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
         at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
}

inline ReferenceAngles reference_angles(std::span<const double, 6> l) {
  static constexpr int kEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  std::array<std::array<Digits, 4>, 4> g;
  for (std::size_t i = 0; i < 4; ++i) g[i][i] = 1;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto i = std::size_t(kEnds[e][0]), j = std::size_t(kEnds[e][1]);
    g[i][j] = g[j][i] = -cosh(Digits(l[e]));
  }
  Digits det = 0;
  for (int j = 0; j < 4; ++j) det += (j % 2 == 0 ? 1 : -1) * g[0][std::size_t(j)] * minor3(g, 0, j);
  ReferenceAngles result;
  result.minus_determinant = -det;
  const Digits root = det < 0 ? Digits(sqrt(Digits(-det))) : Digits(0);
  for (std::size_t e = 0; e < 6; ++e) {
    const int k = kEnds[5 - e][0], m = kEnds[5 - e][1];
    const Digits cofactor = ((k + m) % 2 == 0 ? 1 : -1) * minor3(g, k, m);
    result.theta[e] = atan2(Digits(root * sinh(Digits(l[e]))), cofactor);
  }
  return result;
}

}  // namespace tripus::testing
