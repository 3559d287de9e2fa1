#pragma once

#include <array>
#include <cmath>
#include <random>

namespace tripus::testing {

using Lengths = std::array<double, 6>;

/// Six independent log-uniform lengths in [low, high].
inline Lengths log_uniform_lengths(std::mt19937_64& random, double low, double high) {
  std::uniform_real_distribution<double> exponent(std::log(low), std::log(high));
  Lengths l;
  for (double& x : l) x = std::exp(exponent(random));
  return l;
}

/// Lengths that truncated tetrahedra of any size have: l_ij = u_i + u_j + noise, with u_i up to
/// `scale` and the noise in [0.1, 1.5].
inline Lengths balanced_lengths(std::mt19937_64& random, double scale) {
  std::uniform_real_distribution<double> height(0, scale), noise(0.1, 1.5);
  double u[4];
  for (double& x : u) x = height(random);
  constexpr int kEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  Lengths l;
  for (std::size_t e = 0; e < 6; ++e) l[e] = u[kEnds[e][0]] + u[kEnds[e][1]] + noise(random);
  return l;
}

}  // namespace tripus::testing
