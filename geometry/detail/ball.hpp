#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "geometry/detail/pack.hpp"

/// Numbers that enclose: a midpoint and a radius, with every rounding accounted for.
///
/// A Ball stands for all real numbers x with |x - m| <= r, and each operation gives a ball that
/// contains every result on members of its operands (docs/theory.md, section 9.1). Three facts make
/// that so, whatever the rounding mode and whether or not products and sums are fused:
///   - a result m of one IEEE operation is off by at most 2^-52 |m|, or 2^-1074 where it underflows
///     (2^-53 to nearest): kUnit |m| + kTiny;
///   - a radius is computed by at most ten operations on numbers >= 0, so it is too small by a
///     factor of at most (1 + 2^-52)^10 < kUp;
///   - a radius that is infinite or NaN makes every comparison that proves something fail: these
///     are written so that NaN fails them.
/// Numbers must stay below overflow, where a rounding mode might give the largest double instead of
/// infinity: callers limit the lengths (kEnclosureLimit).
namespace tripus::geometry {
namespace {

inline constexpr double kUnit = 0x1p-52;
inline constexpr double kUp = 1 + 0x1p-48;
inline constexpr double kTiny = 0x1p-1000;

template <class Real>
struct Ball {
  Real m;
  Real r;
};

/// The exact number m.
template <class Real>
inline Ball<Real> exactly(Real m) {
  return {m, Real{} + 0.0};
}
/// A constant that m is within r of.
template <class Real>
inline Ball<Real> constant(double m, double r) {
  return {broadcast<Real>(m), broadcast<Real>(r)};
}
/// 1 / n as the compiler rounds it.
template <class Real>
inline Ball<Real> reciprocal_of(double n) {
  return constant<Real>(1 / n, kUnit * (1 / n));
}

template <class Real>
inline Ball<Real> rounded(Real m, Real r) {
  return {m, (r + (magnitude(m) * kUnit + kTiny)) * kUp};
}

template <class Real>
inline Ball<Real> operator+(const Ball<Real>& a, const Ball<Real>& b) {
  return rounded<Real>(a.m + b.m, a.r + b.r);
}
template <class Real>
inline Ball<Real> operator-(const Ball<Real>& a, const Ball<Real>& b) {
  return rounded<Real>(a.m - b.m, a.r + b.r);
}
template <class Real>
inline Ball<Real> operator-(const Ball<Real>& a) {
  return {-a.m, a.r};
}
template <class Real>
inline Ball<Real> operator*(const Ball<Real>& a, const Ball<Real>& b) {
  return rounded<Real>(a.m * b.m, magnitude(a.m) * b.r + (magnitude(b.m) + b.r) * a.r);
}
/// |a/b - a.m/b.m| <= (a.r + |a.m/b.m| b.r) / (|b.m| - b.r); infinite where b may be 0.
template <class Real>
inline Ball<Real> operator/(const Ball<Real>& a, const Ball<Real>& b) {
  const Real m = a.m / b.m;
  const Real least = magnitude(b.m) * (2 - kUp) - b.r;
  const Real infinite = broadcast<Real>(std::numeric_limits<double>::infinity());
  const Real r = (a.r + (magnitude(m) * kUp + kTiny) * b.r) / least;
  return rounded<Real>(m, least > broadcast<Real>(0.0) ? r : infinite);
}
/// By a power of two or another exact double.
template <class Real>
inline Ball<Real> operator*(double factor, const Ball<Real>& b) {
  return rounded<Real>(factor * b.m, std::fabs(factor) * b.r);
}
/// |sqrt x - sqrt m| <= |x - m| / sqrt m for all x >= 0; infinite where the midpoint is not > 0.
template <class Real>
inline Ball<Real> square_root(const Ball<Real>& a) {
  const Real zero = broadcast<Real>(0.0);
  const Real infinite = broadcast<Real>(std::numeric_limits<double>::infinity());
  const Real m = square_root(a.m > zero ? a.m : zero);
  return rounded<Real>(m, a.m > zero ? a.r / (m * (2 - kUp)) : infinite);
}
/// The square: narrower than the product.
template <class Real>
inline Ball<Real> square(const Ball<Real>& a) {
  return rounded<Real>(a.m * a.m, (2 * magnitude(a.m) + a.r) * a.r);
}

/// Whether the midpoint of a is the larger: only ever chooses between forms that are equal.
template <class Real>
inline auto larger(const Ball<Real>& a, const Ball<Real>& b) {
  return a.m > b.m;
}
template <class Mask, class Real>
inline Ball<Real> select(const Mask& mask, const Ball<Real>& a, const Ball<Real>& b) {
  return {mask ? a.m : b.m, mask ? a.r : b.r};
}

/// Lower bound of every member, and upper bound of the absolute values.
template <class Real>
inline Real lower(const Ball<Real>& a) {
  return (a.m - a.r) - (magnitude(a.m) + a.r) * 0x1p-50 - kTiny;
}
template <class Real>
inline Real magnitude_bound(const Ball<Real>& a) {
  return (magnitude(a.m) + a.r) * kUp;
}

}  // namespace
}  // namespace tripus::geometry
