#pragma once

#include "geometry/detail/pack.hpp"

/// Elementary functions without branches, on doubles and on packs, for the limited domains on
/// which the kernels call them. They exist because the kernels must give the same bits on every
/// machine and at every vector width, which neither libm nor libmvec promises. Errors measured
/// against the correctly rounded results are below 2.5 ulp (tests/unit/geometry_elementary.cpp).
namespace tripus::geometry {
namespace {

/// Hyperbolic sine and cosine of one argument.
template <class Real>
struct SinhCosh {
  Real sinh;
  Real cosh;
};

/// Domain 0 <= x <= 700. sinh keeps its relative accuracy down to the smallest double.
///
/// With x = k ln 2 + r, |r| <= ln(2)/2, expm1(x) = 2^k expm1(r) + (2^k - 1), and expm1(r) is its
/// Taylor polynomial of degree 13 (remainder below 2e-17). Then sinh x = (m + m / (m + 1)) / 2.
template <class Real>
inline SinhCosh<Real> sinh_cosh(Real x) {
  using Bits = typename BitsOf<Real>::Type;
  constexpr double kLog2E = 0x1.71547652b82fep+0;
  constexpr double kLn2High = 0x1.62e42fefa3800p-1;  // 10 trailing zero bits: k * kLn2High is exact
  constexpr double kLn2Low = 0x1.ef35793c76730p-45;
  constexpr double kRound = 0x1.8p52;  // adding it rounds to an integer, kept in the low bits

  const Real shifted = x * kLog2E + kRound;
  const Real k = shifted - kRound;
  const Real two_to_k = bits_as<Real>((bits_as<Bits>(shifted) + 1023) << 52);
  const Real r = (x - k * kLn2High) - k * kLn2Low;

  Real p = broadcast<Real>(1.0 / 6227020800.0);
  p = p * r + 1.0 / 479001600.0;
  p = p * r + 1.0 / 39916800.0;
  p = p * r + 1.0 / 3628800.0;
  p = p * r + 1.0 / 362880.0;
  p = p * r + 1.0 / 40320.0;
  p = p * r + 1.0 / 5040.0;
  p = p * r + 1.0 / 720.0;
  p = p * r + 1.0 / 120.0;
  p = p * r + 1.0 / 24.0;
  p = p * r + 1.0 / 6.0;
  p = p * r + 0.5;
  const Real expm1_r = r + r * r * p;
  const Real m = two_to_k * expm1_r + (two_to_k - 1.0);
  const Real e = m + 1.0;
  const Real reciprocal = 1.0 / e;
  return {0.5 * (m + m * reciprocal), 0.5 * (e + reciprocal)};
}

/// The angle in [0, pi] of the point (x, y), y >= 0; 0 at the origin. NaN if x or y is.
///
/// The argument is folded into [0, tan(pi/8)] by one division; there atan(t) = t + t u P(u),
/// u = t^2, with P the Chebyshev interpolant of degree 11 (error 3e-18).
template <class Real>
inline Real upper_atan2(Real y, Real x) {
  constexpr double kTanPi8 = 0x1.a827999fcef32p-2;
  constexpr double kPi4 = 0x1.921fb54442d18p-1;
  constexpr double kPi2 = 0x1.921fb54442d18p+0;
  constexpr double kPi2Low = 0x1.1a62633145c07p-54;

  const Real ax = magnitude(x);
  const Real big = maximum(ax, y);
  const Real small = minimum(ax, y);
  const auto fold = small > big * kTanPi8;
  const Real zero = broadcast<Real>(0.0);
  const Real one = broadcast<Real>(1.0);
  const Real numerator = fold ? small - big : small;
  const Real denominator = fold ? small + big : big;
  const Real t = numerator / (denominator == zero ? one : denominator);
  const Real u = t * t;

  Real p = broadcast<Real>(0x1.0acd9e91a5a35p-6);
  p = p * u - 0x1.1b311bb48c215p-5;
  p = p * u + 0x1.74dccfb93fff0p-5;
  p = p * u - 0x1.ac7a5a79b3f26p-5;
  p = p * u + 0x1.e19a0bfa3eef9p-5;
  p = p * u - 0x1.110e87b4357d2p-4;
  p = p * u + 0x1.3b1392d519db1p-4;
  p = p * u - 0x1.745d165dc9713p-4;
  p = p * u + 0x1.c71c71c303dbbp-4;
  p = p * u - 0x1.249249248d7dcp-3;
  p = p * u + 0x1.9999999999953p-3;
  p = p * u - 0x1.5555555555555p-2;
  const Real at_t = t + t * (u * p);
  // In each step the low part of the constant is added to the small term first.
  const Real first = fold ? kPi4 + (at_t + 0.5 * kPi2Low) : at_t;
  const Real second = y > ax ? kPi2 - (first - kPi2Low) : first;
  return x < zero ? 2 * kPi2 - (second - 2 * kPi2Low) : second;
}

/// Natural logarithm of a normal x > 0; absolute error below 1 ulp of max(1, |ln x|).
///
/// x = 2^k m with m in [sqrt(1/2), sqrt 2) and ln m = 2 artanh t, t = (m - 1) / (m + 1), by its
/// Taylor polynomial of degree 21 (|t| < 0.172: remainder below 3e-19).
template <class Real>
inline Real natural_log(Real x) {
  using Bits = typename BitsOf<Real>::Type;
  constexpr double kLn2High = 0x1.62e42fefa3800p-1;
  constexpr double kLn2Low = 0x1.ef35793c76730p-45;
  constexpr std::int64_t kRootHalf = 0x3fe6a09e667f3bcd;
  constexpr std::int64_t kOne = std::int64_t{1023} << 52;
  constexpr double kRound = 0x1.8p52;
  constexpr std::int64_t kRoundBits = 0x4338000000000000;

  const Bits bits = bits_as<Bits>(x);
  const Bits k = ((bits - kRootHalf + kOne) >> 52) - 1023;
  const Real exponent = bits_as<Real>(k + kRoundBits) - kRound;
  const Real f = bits_as<Real>(bits - (k << 52)) - 1.0;
  const Real t = f / (f + 2.0);
  const Real z = t * t;
  Real p = broadcast<Real>(1.0 / 21);
  p = p * z + 1.0 / 19;
  p = p * z + 1.0 / 17;
  p = p * z + 1.0 / 15;
  p = p * z + 1.0 / 13;
  p = p * z + 1.0 / 11;
  p = p * z + 1.0 / 9;
  p = p * z + 1.0 / 7;
  p = p * z + 1.0 / 5;
  p = p * z + 1.0 / 3;
  return exponent * kLn2High + (2.0 * t + (2.0 * t * (z * p) + exponent * kLn2Low));
}

}  // namespace
}  // namespace tripus::geometry
