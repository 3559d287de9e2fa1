#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/batch.hpp"
#include "geometry/detail/gram_kernel.hpp"

/// Gram matrices scaled so that no entry overflows (docs/theory.md (12)), for lengths of any size.
namespace tripus::geometry {
namespace {

/// Row and column scaling of a Gram matrix: s_i = e^{-u_i}.
using Exponents = std::array<double, 4>;

inline double length_of(const double* l, int i, int j) { return l[kEdgeBetween[i][j]]; }

/// Exponents from the dominant pair of opposite edges ij, kl: u_i + u_j = l_ij, u_k + u_l = l_kl,
/// and the two remaining freedoms p, q lie in the middle of what the other entries allow
/// (Fourier-Motzkin elimination of q, then of p).
inline Exponents exponents_from_pair(const double* l, const EdgeFrame& f) {
  const double a = length_of(l, f.i, f.j) / 2, b = length_of(l, f.k, f.l) / 2;
  const double ik = length_of(l, f.i, f.k), il = length_of(l, f.i, f.l);
  const double jk = length_of(l, f.j, f.k), jl = length_of(l, f.j, f.l);
  const double half = a + b;
  const double p_low = std::max({-a, il - half - b, ik - half - b, (ik + il) / 2 - half});
  const double p_high = std::min({a, half + b - jl, half + b - jk, half - (jk + jl) / 2});
  const double p = (p_low + p_high) / 2;
  const double q_low = std::max({-b, ik - half - p, p - half + jk});
  const double q_high = std::min({b, half - jl - p, p - il + half});
  const double q = (q_low + q_high) / 2;
  Exponents u{};
  u[static_cast<std::size_t>(f.i)] = a + p;
  u[static_cast<std::size_t>(f.j)] = a - p;
  u[static_cast<std::size_t>(f.k)] = b + q;
  u[static_cast<std::size_t>(f.l)] = b - q;
  return u;
}

/// Exponents from the dominant face ijk, whose three entries become 1/2; the fourth vertex is not
/// scaled.
inline Exponents exponents_from_face(const double* l, int apex) {
  const int i = apex == 0 ? 1 : 0, j = apex <= 1 ? 2 : 1, k = apex <= 2 ? 3 : 2;
  const double ij = length_of(l, i, j), ik = length_of(l, i, k), jk = length_of(l, j, k);
  Exponents u{};
  u[static_cast<std::size_t>(i)] = (ij + ik - jk) / 2;
  u[static_cast<std::size_t>(j)] = (ij + jk - ik) / 2;
  u[static_cast<std::size_t>(k)] = (ik + jk - ij) / 2;
  return u;
}

/// The exponents u >= 0 of least sum with u_i + u_j >= l_ij: they bring every entry of the Gram
/// matrix to at most 1 and a dominant term of its determinant to order 1. By linear-programming
/// duality the sum is the largest weight of a pair of opposite edges, or half that of a face.
inline Exponents scaling_exponents(const double* l) {
  double best = -1;
  int best_pair = 0, best_apex = -1;
  for (int e = 0; e < 3; ++e) {
    if (l[e] + l[5 - e] > best) {
      best = l[e] + l[5 - e];
      best_pair = e;
    }
  }
  constexpr int kFaceEdges[4][3] = {{3, 4, 5}, {1, 2, 5}, {0, 2, 4}, {0, 1, 3}};
  for (int apex = 0; apex < 4; ++apex) {
    const int* edge = kFaceEdges[apex];
    const double weight = (l[edge[0]] + l[edge[1]] + l[edge[2]]) / 2;
    if (weight > best) {
      best = weight;
      best_apex = apex;
    }
  }
  return best_apex < 0 ? exponents_from_pair(l, kEdgeFrames[best_pair])
                       : exponents_from_face(l, best_apex);
}

/// A scaled Gram matrix: cosh, sinh and diagonal, and the products of opposite entries, which are
/// taken from sums of lengths so that equal pairs have equal products.
struct ScaledGram {
  double c[6], s[6], d[4];
  OppositeProducts<double> products;
};

/// Where all terms underflow but for two equal products of opposite edges, the tetrahedron is long
/// and thin, between two ways to be flat: in the limit these four edges have angle pi/2. Returns
/// false if that is not so.
inline bool ridge_angles(const OppositeProducts<double>& products, double* theta) {
  for (int e = 0; e < 3; ++e) {
    const int one = (e + 1) % 3, two = (e + 2) % 3;
    if (products.c[one] != products.c[two] || !(products.c[e] < products.c[one])) continue;
    theta[e] = theta[5 - e] = 0;
    theta[one] = theta[5 - one] = theta[two] = theta[5 - two] = std::numbers::pi / 2;
    return true;
  }
  return false;
}

/// One tetrahedron by its scaled Gram matrix. Returns -det G, scaled, or the least positive number
/// where it underflows. packed [21], the Jacobian, is always written; an edge of length 0 has s =
/// 0.
inline double scaled_gram_kernel(const ScaledGram& g, double* theta, double* packed) {
  double det = gram_kernel(g.c, g.s, g.d, g.products, theta, packed);
  // Scaled minors can underflow, but only where a change of the lengths far below an ulp makes the
  // tetrahedron flat: it is called flat then.
  const bool sound = det > 0 && std::all_of(packed, packed + kPackedJacobian,
                                            [](double x) { return std::isfinite(x); });
  if (!sound) {
    std::fill(packed, packed + kPackedJacobian, 0.0);
    if (det >= 0 && ridge_angles(g.products, theta)) {
      det = std::numeric_limits<double>::min();
    } else {
      for (int e = 0; e < 6; ++e) theta[e] = theta[e] > std::numbers::pi / 2 ? std::numbers::pi : 0;
      det = 0;
    }
  }
  return det;
}

}  // namespace
}  // namespace tripus::geometry
