#include "geometry/truncated_tetrahedron.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "geometry/batch.hpp"
#include "geometry/detail/angle_gram.hpp"
#include "geometry/detail/gram_kernel.hpp"
#include "geometry/detail/scaled_kernel.hpp"

namespace tripus::geometry {
namespace {

constexpr double kPi = std::numbers::pi;

/// Row and column scaling of a Gram matrix: s_i = e^{-u_i}.
using Exponents = std::array<double, 4>;

double length_of(const double* l, int i, int j) { return l[kEdgeBetween[i][j]]; }

/// Exponents from the dominant pair of opposite edges ij, kl: u_i + u_j = l_ij, u_k + u_l = l_kl,
/// and the two remaining freedoms p, q lie in the middle of what the other entries allow
/// (Fourier-Motzkin elimination of q, then of p).
Exponents exponents_from_pair(const double* l, const EdgeFrame& f) {
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
Exponents exponents_from_face(const double* l, int apex) {
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
Exponents scaling_exponents(const double* l) {
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

ScaledGram scaled_gram(const double* l) {
  // A quarter of the lengths, so that sums of them cannot overflow.
  double quarter[6];
  std::transform(l, l + 6, quarter, [](double x) { return x / 4; });
  const Exponents u = scaling_exponents(quarter);
  ScaledGram g;
  for (std::size_t i = 0; i < 4; ++i) g.d[i] = std::exp(-8 * u[i]);
  for (int e = 0; e < 6; ++e) {
    const EdgeFrame& f = kEdgeFrames[e];
    const double u_i = u[static_cast<std::size_t>(f.i)], u_j = u[static_cast<std::size_t>(f.j)];
    if (l[e] <= 1) {
      const double factor = std::exp(-4 * (u_i + u_j));
      g.s[e] = std::sinh(l[e]) * factor;
      g.c[e] = std::cosh(l[e]) * factor;
    } else {
      const double leading = std::exp(4 * ((quarter[e] - u_i) - u_j)) / 2;
      g.s[e] = -leading * std::expm1(-2 * l[e]);
      g.c[e] = leading * (1 + std::exp(-2 * l[e]));
    }
  }
  const double total = u[0] + u[1] + u[2] + u[3];
  for (int e = 0; e < 3; ++e) {
    const double leading = std::exp(4 * ((quarter[e] + quarter[5 - e]) - total)) / 4;
    g.products.c[e] = leading * ((1 + std::exp(-2 * l[e])) * (1 + std::exp(-2 * l[5 - e])));
    g.products.s[e] = leading * (std::expm1(-2 * l[e]) * std::expm1(-2 * l[5 - e]));
  }
  return g;
}

/// Where all terms underflow but for two equal products of opposite edges, the tetrahedron is long
/// and thin, between two ways to be flat: in the limit these four edges have angle pi/2. Returns
/// false if that is not so.
bool ridge_angles(const OppositeProducts<double>& products, double* theta) {
  for (int e = 0; e < 3; ++e) {
    const int one = (e + 1) % 3, two = (e + 2) % 3;
    if (products.c[one] != products.c[two] || !(products.c[e] < products.c[one])) continue;
    theta[e] = theta[5 - e] = 0;
    theta[one] = theta[5 - one] = theta[two] = theta[5 - two] = kPi / 2;
    return true;
  }
  return false;
}

/// One tetrahedron by the scaled Gram matrix; l >= 0, any size. Returns -det G, scaled, or the
/// least positive number where it underflows.
double scaled_kernel(const double* l, double* theta, double* jacobian) {
  const ScaledGram g = scaled_gram(l);
  double packed[kPackedJacobian];
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
      for (int e = 0; e < 6; ++e) theta[e] = theta[e] > kPi / 2 ? kPi : 0;
      det = 0;
    }
  }
  for (int e = 0; e < 6; ++e)
    if (!(l[e] > 0)) packed[packed_index(e, e)] = 0;
  if (jacobian != nullptr) std::copy(packed, packed + kPackedJacobian, jacobian);
  return det;
}

/// The unscaled route, in the same operations as the batched kernels.
double unscaled_kernel(const double* l, double* theta, double* jacobian) {
  double c[6], s[6];
  for (int e = 0; e < 6; ++e) {
    const SinhCosh<double> h = sinh_cosh(l[e]);
    s[e] = h.sinh;
    c[e] = h.cosh;
  }
  const double det = gram_kernel(c, s, UnitDiagonal{}, opposite_products(c, s), theta, jacobian);
  if (jacobian != nullptr) {
    for (int e = 0; e < 6; ++e)
      if (!(s[e] > 0)) jacobian[packed_index(e, e)] = 0;
  }
  return det;
}

TetrahedronKind kind_of(double minus_det, const double* theta) {
  if (minus_det > 0) return TetrahedronKind::kTruncated;
  if (theta[0] > kPi / 2) return TetrahedronKind::kFlat01_23;
  return theta[1] > kPi / 2 ? TetrahedronKind::kFlat02_13 : TetrahedronKind::kFlat03_12;
}

}  // namespace

std::size_t scaled_angles_of_lane(const double* lengths, double* theta, double* jacobian) {
  double l[6], angle[6], packed[kPackedJacobian];
  for (std::size_t e = 0; e < 6; ++e) l[e] = std::max(lengths[kLanes * e], 0.0);
  const double det = scaled_kernel(l, angle, jacobian == nullptr ? nullptr : packed);
  for (std::size_t e = 0; e < 6; ++e) theta[kLanes * e] = angle[e];
  if (jacobian != nullptr)
    for (std::size_t q = 0; q < kPackedJacobian; ++q) jacobian[kLanes * q] = packed[q];
  return det > 0 ? 0 : 1;
}

TetrahedronKind extended_dihedral_angles(std::span<const double, 6> l, std::span<double, 6> theta,
                                         std::span<double> jacobian) {
  double clamped[6], packed[kPackedJacobian];
  std::transform(l.begin(), l.end(), clamped, [](double x) { return std::max(x, 0.0); });
  const bool huge = *std::max_element(clamped, clamped + 6) > kUnscaledLimit;
  double* wanted = jacobian.empty() ? nullptr : packed;
  const double det = huge ? scaled_kernel(clamped, theta.data(), wanted)
                          : unscaled_kernel(clamped, theta.data(), wanted);
  if (wanted != nullptr) {
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        jacobian[static_cast<std::size_t>(6 * i + j)] =
            packed[packed_index(std::min(i, j), std::max(i, j))];
  }
  return kind_of(det, theta.data());
}

TetrahedronKind dihedral_angles(std::span<const double, 6> l, std::span<double, 6> theta,
                                std::span<double> jacobian) {
  for (std::size_t e = 0; e < 6; ++e) {
    if (!std::isfinite(l[e]) || l[e] <= 0) {
      throw InvalidInput("edge length " + std::to_string(e) + " of the tetrahedron is " +
                         std::to_string(l[e]) + "; lengths are finite and greater than 0");
    }
  }
  return extended_dihedral_angles(l, theta, jacobian);
}

bool lengths_from_angles(std::span<const double, 6> theta, std::span<double, 6> l) {
  double minor[4];
  for (std::size_t v = 0; v < 4; ++v) {
    minor[v] = angle_vertex_minor(theta, kEdgesAtVertex[v]);
    if (!(minor[v] > 0)) return false;
  }
  const double det = angle_gram_minus_det(theta);
  if (!(det > 0)) return false;
  const double root = std::sqrt(det);
  for (int e = 0; e < 6; ++e) {
    const EdgeFrame& f = kEdgeFrames[e];
    l[static_cast<std::size_t>(e)] = std::asinh(
        root * std::sin(theta[static_cast<std::size_t>(e)]) / std::sqrt(minor[f.i] * minor[f.j]));
  }
  return true;
}

}  // namespace tripus::geometry
