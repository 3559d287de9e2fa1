#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

/// The Gram matrix g of the face normals, from the dihedral angles: g_ii = 1, g_kl = -cos theta_ij.
namespace tripus::geometry {

/// The Heron term 2pq + 2pr + 2qr - p^2 - q^2 - r^2, by its stable order.
template <class Real>
Real heron(Real p, Real q, Real r) {
  if (p < q) std::swap(p, q);
  if (p < r) std::swap(p, r);
  return 4 * q * r - (p - q - r) * (p - q - r);
}

/// Sum over the pairs of opposite edges of x_ij x_kl (x_ij + x_kl - the other four), plus the
/// products around the four triples `faces`.
template <class Real>
Real cayley_menger_half(const Real (&x)[6]) {
  const Real total = x[0] + x[1] + x[2] + x[3] + x[4] + x[5];
  Real sum = 0;
  for (int e = 0; e < 3; ++e) {
    const Real pair = x[e] + x[5 - e];
    sum += x[e] * x[5 - e] * (2 * pair - total);
  }
  return sum + x[0] * x[1] * x[3] + x[0] * x[2] * x[4] + x[1] * x[2] * x[5] + x[3] * x[4] * x[5];
}

/// -det g, with a small relative error also where the tetrahedron is nearly flat.
///
/// No obtuse angle: the terms of the expansion have one sign, but for the Heron term, and no small
/// result. Otherwise let the largest angle lie at the edge ij: near the flat tetrahedron with angle
/// pi at ij and kl, g is a matrix of signs, of rank one. Changing the signs of two faces makes it
/// g' = 1 1^T - F, where F has the small entries 2 cos^2(theta/2) at ij and kl and
/// 2 sin^2(theta/2) at the other edges, and -det g' = 1^T adj(F) 1 - det F is a sum of their
/// products of degree three (a Cayley-Menger determinant) and four (a Heron term).
template <class Real = double>
Real angle_gram_minus_det(std::span<const double, 6> theta) {
  const auto largest = std::max_element(theta.begin(), theta.end());
  if (*largest <= std::numbers::pi / 2) {
    Real x[6], squares = 0;
    for (std::size_t e = 0; e < 6; ++e) {
      x[e] = std::cos(Real(theta[e]));
      squares += x[e] * x[e];
    }
    // The faces of g meet along the edges of the tetrahedron's vertices.
    const Real triples =
        x[0] * x[1] * x[2] + x[0] * x[3] * x[4] + x[1] * x[3] * x[5] + x[2] * x[4] * x[5];
    return (squares - 1) + 2 * triples + heron(x[0] * x[5], x[1] * x[4], x[2] * x[3]);
  }
  const auto straight = static_cast<std::size_t>(largest - theta.begin());
  Real f[6];  // by the faces' pair: the entry of g between faces k and l is that of the edge ij
  for (std::size_t e = 0; e < 6; ++e) {
    const bool near_pi = e == straight || e == 5 - straight;
    const Real half = near_pi ? std::cos(Real(theta[e]) / 2) : std::sin(Real(theta[e]) / 2);
    f[5 - e] = 2 * half * half;
  }
  return 2 * cayley_menger_half(f) + heron(f[0] * f[5], f[1] * f[4], f[2] * f[3]);
}

/// -c_vv of the angle Gram matrix at the vertex with these edges, 4 cos h cos(h-a) cos(h-b)
/// cos(h-c) with h half the sum of the angles a, b, c; 0 where they are not positive or sum to pi
/// or more. Written with pi - a for the largest angle a, it keeps its digits where a is near pi.
template <class Real = double>
Real angle_vertex_minor(std::span<const double, 6> theta, const std::array<int, 3>& edges) {
  Real a = theta[static_cast<std::size_t>(edges[0])];
  Real b = theta[static_cast<std::size_t>(edges[1])];
  Real c = theta[static_cast<std::size_t>(edges[2])];
  if (!(a > 0 && b > 0 && c > 0)) return 0;
  if (a < b) std::swap(a, b);
  if (a < c) std::swap(a, c);
  constexpr double kPiLow = 0x1.1a62633145c07p-53;
  const Real gap = (Real(std::numbers::pi) - a) + Real(kPiLow);
  if (!(gap > b + c)) return 0;
  return 4 * std::sin((gap - b - c) / 2) * std::sin((gap + b + c) / 2) *
         std::sin((gap + b - c) / 2) * std::sin((gap + c - b) / 2);
}

}  // namespace tripus::geometry
