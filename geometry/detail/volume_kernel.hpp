#pragma once

#include "geometry/detail/clausen_coefficients.hpp"
#include "geometry/detail/gram_kernel.hpp"
#include "geometry/volume.hpp"

/// The volume of a truncated tetrahedron, docs/theory.md section 3, written once for all widths.
/// Sines and cosines of the dihedral angles come from the lengths, without trigonometry.
namespace tripus::geometry {
namespace {

/// clausen2 without branches, |x| <= 100.
template <class Real>
inline Real clausen_kernel(Real x) {
  using namespace clausen;
  constexpr double kRound = 0x1.8p52;
  const Real zero = broadcast<Real>(0.0);
  const Real turns = (x * (1 / (2 * kPi)) + kRound) - kRound;
  const Real reduced = (x - turns * (2 * kPi)) - turns * (2 * kPiLow);
  const Real size = magnitude(reduced);
  const auto near_zero = size <= 2 * kPi / 3;
  const Real y = near_zero ? size : (kPi - size) + kPiLow;
  const Real u = y * y;
  const auto coefficient = [&](int n) {
    return near_zero ? broadcast<Real>(kNearZero[n]) : broadcast<Real>(-kNearPi[n]);
  };
  Real p = coefficient(9);
  for (int n = 8; n >= 0; --n) p = p * u + coefficient(n);
  const Real logarithm = natural_log(maximum(y, broadcast<Real>(1e-300)));
  const Real result = y * ((near_zero ? 1.0 - logarithm : broadcast<Real>(kLn2)) + u * p);
  return reduced < zero ? -result : result;
}

template <class Real>
struct Complex {
  Real re, im;
};
template <class Real>
inline Complex<Real> operator*(const Complex<Real>& a, const Complex<Real>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <class Real>
inline Complex<Real> operator+(const Complex<Real>& a, const Complex<Real>& b) {
  return {a.re + b.re, a.im + b.im};
}

/// The volume from cosh c [6] and sinh s [6] of the lengths and the angles theta [6] that
/// gram_kernel finds from them; 0 for flat tetrahedra.
template <class Real>
inline Real volume_kernel(const Real* c, const Real* s, const Real* theta) {
  const Real zero = broadcast<Real>(0.0);
  const UnitDiagonal d;
  const OppositeProducts<Real> products = opposite_products(c, s);
  const Real det = minus_determinant(c, s, d, products);
  const Real root = square_root(maximum(det, zero));
  const Real minor[4] = {minus_face_minor<0>(c, s, d), minus_face_minor<1>(c, s, d),
                         minus_face_minor<2>(c, s, d), minus_face_minor<3>(c, s, d)};
  Complex<Real> unit[6];  // exp(i theta)
  [&]<int... E>(std::integer_sequence<int, E...>) {
    ((unit[E] = [&]() -> Complex<Real> {
       const Real scale = 1.0 / square_root(minor[kEdgeFrames[E].k] * minor[kEdgeFrames[E].l]);
       return {edge_cofactor<E>(c, s, d, products) * scale, root * s[E] * scale};
     }()),
     ...);
  }
  (std::make_integer_sequence<int, 6>{});

  // Ushijima's names: A, B, C at the edges 01, 02, 03 of one vertex, D, E, F opposite to them.
  const Complex<Real>&A = unit[0], &B = unit[1], &C = unit[2];
  const Complex<Real>&D = unit[5], &E = unit[4], &F = unit[3];
  const Complex<Real> AD = A * D, BE = B * E, CF = C * F;
  const Complex<Real> denominator = ((AD + BE) + (CF + A * (B * F))) +
                                    ((A * (C * E) + B * (C * D)) + (D * (E * F) + AD * (BE * CF)));
  const Real numerator = A.im * D.im + B.im * E.im + C.im * F.im;
  // -det of the Gram matrix of the angles is D^3 over the product of the minors.
  const Real minus_det = det * (det / (minor[0] * minor[1])) * (det / (minor[2] * minor[3]));
  const Real spread = upper_atan2(square_root(maximum(minus_det, zero)), numerator);
  const Real argument = upper_atan2(magnitude(denominator.im), denominator.re);
  const Real centre = clausen::kPi - (denominator.im < zero ? -argument : argument);

  const Real a = theta[0], b = theta[1], ab = a + b, ef = theta[4] + theta[3];
  const Real shifts[8] = {zero,
                          ab + (theta[5] + theta[4]),
                          (a + theta[2]) + (theta[5] + theta[3]),
                          (b + theta[2]) + ef,
                          ab + theta[2] + clausen::kPi,
                          a + ef + clausen::kPi,
                          b + (theta[5] + theta[3]) + clausen::kPi,
                          theta[2] + (theta[5] + theta[4]) + clausen::kPi};
  Real sum = zero;
  for (int n = 0; n < 8; ++n) {
    const Real middle = centre + shifts[n];
    const Real difference = clausen_kernel(middle - spread) - clausen_kernel(middle + spread);
    sum = n < 4 ? sum + difference : sum - difference;
  }
  const Real volume = minimum(maximum(0.25 * sum, zero), broadcast<Real>(kOctahedronVolume));
  return det > zero ? volume : zero;
}

}  // namespace
}  // namespace tripus::geometry
