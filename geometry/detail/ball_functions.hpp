#pragma once

#include "geometry/detail/ball.hpp"
#include "geometry/detail/elementary.hpp"

/// Elementary functions of balls: series with a bound for what is left out, evaluated in balls, so
/// that nothing has to be said about rounding. The bounds are proved in docs/theory.md,
/// section 9.2. Arguments outside of a series' range get an infinite radius.
namespace tripus::geometry {
namespace {

/// What enclosure_formulae.hpp calls.
template <class Real>
inline Ball<Real> number_like(double value, const Ball<Real>&) {
  return constant<Real>(value, 0);
}

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();
inline constexpr double kRoundToInteger =
    0x1.8p52;  // adding it rounds; the integer is in the low bits

/// `tail` where the bound of the argument holds, else infinity.
template <class Real>
inline Real tail_within(Real argument, double limit, double tail) {
  return magnitude(argument) <= broadcast<Real>(limit) ? broadcast<Real>(tail)
                                                       : broadcast<Real>(kInfinite);
}

template <class Real>
inline Ball<Real> ball_pi() {
  return constant<Real>(0x1.921fb54442d18p+1, 0x1.1a62633145c08p-53);
}
template <class Real>
inline Ball<Real> number_pi(const Ball<Real>&) {
  return ball_pi<Real>();
}
template <class Real>
inline Ball<Real> ball_ln2() {
  return constant<Real>(0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56 + 0x1p-100);
}

/// sinh and cosh over |d| <= radius about a point where they are known:
/// |sinh(x + d) - sinh x| and the same for cosh are at most |d| cosh x e^|d|, e^|d| <= 1 + 2 |d|.
template <class Real>
inline SinhCosh<Ball<Real>> widened(SinhCosh<Ball<Real>> at, Real radius) {
  const Real spread =
      (magnitude_bound(at.cosh) * radius * (1.0 + 2 * radius)) * kUp + tail_within(radius, 1, 0);
  at.sinh.r = (at.sinh.r + spread) * kUp;
  at.cosh.r = (at.cosh.r + spread) * kUp;
  return at;
}

/// sinh and cosh of the point x in [0, kEnclosureLimit].
/// x = k ln 2 + r; expm1 r by Taylor's series up to r^20; then as elementary.hpp does.
template <class Real>
inline SinhCosh<Ball<Real>> ball_sinh_cosh(Real x) {
  using Bits = typename BitsOf<Real>::Type;
  constexpr double kLog2E = 0x1.71547652b82fep+0;
  const Real shifted = (x * kLog2E - 0.5) + kRoundToInteger;
  const Real k = shifted - kRoundToInteger;
  const Real two_to_k = bits_as<Real>((bits_as<Bits>(shifted) + 1023) << 52);
  // k times the high part is exact: it ends in ten zero bits.
  const Ball<Real> high = exactly<Real>(k * 0x1.62e42fefa3800p-1);
  const Ball<Real> low = constant<Real>(0x1.ef35793c76730p-45, 0x1p-97);
  const Ball<Real> r = (exactly(x) - high) - exactly(k) * low;

  constexpr double kFactorial[21] = {1,
                                     1,
                                     2,
                                     6,
                                     24,
                                     120,
                                     720,
                                     5040,
                                     40320,
                                     362880,
                                     3628800,
                                     39916800,
                                     479001600,
                                     6227020800,
                                     87178291200,
                                     1307674368000,
                                     20922789888000,
                                     355687428096000,
                                     6402373705728000,
                                     121645100408832000,
                                     2432902008176640000};
  Ball<Real> p = reciprocal_of<Real>(kFactorial[20]);
  for (int n = 19; n >= 2; --n) p = p * r + reciprocal_of<Real>(kFactorial[n]);
  p.r = (p.r + tail_within(r.m, 1.05, 1e-19)) * kUp;
  const Ball<Real> expm1_r = r + square(r) * p;
  const Ball<Real> power = exactly(two_to_k), one = constant<Real>(1, 0);
  const Ball<Real> m = power * expm1_r + (power - one);
  const Ball<Real> e = m + one;
  return {0.5 * (m + m / e), 0.5 * (e + one / e)};
}

/// The angle in (-pi, pi] of the point of midpoints, and modulo turns of all members: a disc about
/// the point that does not contain 0 is seen from there at angles that vary by what is added.
template <class Real>
inline Ball<Real> angle_of(const Ball<Real>& y, const Ball<Real>& x) {
  const Real zero = broadcast<Real>(0.0), one = broadcast<Real>(1.0);
  const Real ax = magnitude(x.m), ay = magnitude(y.m);
  const Real big = maximum(ax, ay), small = minimum(ax, ay);
  const auto fold = small > big * 0x1.a827999fcef32p-2;
  const Ball<Real> numerator = select(fold, exactly(big) - exactly(small), exactly(small));
  const Ball<Real> denominator = select(fold, exactly(small) + exactly(big), exactly(big));
  const Ball<Real> t = numerator / denominator;
  const Ball<Real> u = square(t);
  Ball<Real> p = reciprocal_of<Real>(45);
  for (int n = 21; n >= 1; --n) p = reciprocal_of<Real>(2 * n + 1) - p * u;
  p.r = (p.r + tail_within(t.m, 0.42, 7e-19)) * kUp;
  const Ball<Real> at = t - t * (u * p);

  const Ball<Real> pi = ball_pi<Real>();
  const Ball<Real> first = select(fold, 0.25 * pi - at, at);
  const Ball<Real> second = select(ay > ax, 0.5 * pi - first, first);
  Ball<Real> angle = select(x.m < zero, pi - second, second);
  angle.m = y.m < zero ? -angle.m : angle.m;

  const Real both = (x.r + y.r) * kUp;
  const Real least = (ax * ax + ay * ay) * (2 - kUp) - (2 * both * (ax + ay) + kTiny) * kUp;
  const Real change = ((ay + y.r) * x.r + (ax + x.r) * y.r) * kUp / (least * (2 - kUp));
  angle.r = (angle.r + (least > zero ? change : one * kInfinite)) * kUp;
  return angle;
}

/// ln of all members, which must be > 0. x = 2^e m with m near 1, ln m = 2 artanh((m-1)/(m+1)).
template <class Real>
inline Ball<Real> ball_log(const Ball<Real>& x) {
  using Bits = typename BitsOf<Real>::Type;
  const Bits bits = bits_as<Bits>(x.m);
  const Real exponent =
      bits_as<Real>((bits >> 52) + 0x4330000000000000) - (4503599627370496.0 + 1023.0);
  const Real mantissa = bits_as<Real>((bits & 0x000fffffffffffff) | 0x3ff0000000000000);
  const auto high = mantissa > broadcast<Real>(0x1.6a09e667f3bcdp+0);
  const Ball<Real> m = exactly<Real>(high ? mantissa * 0.5 : mantissa);
  const Ball<Real> e = exactly<Real>(high ? exponent + 1.0 : exponent);
  const Ball<Real> one = constant<Real>(1, 0);
  const Ball<Real> s = (m - one) / (m + one);
  const Ball<Real> u = square(s);
  Ball<Real> p = reciprocal_of<Real>(25);
  for (int n = 11; n >= 1; --n) p = p * u + reciprocal_of<Real>(2 * n + 1);
  p.r = (p.r + tail_within(s.m, 0.172, 2e-20)) * kUp;
  Ball<Real> result = 2.0 * (s + s * (u * p)) + e * ball_ln2<Real>();
  const Real least = lower(x);
  const Real change = x.r * kUp / least;
  const Real infinite = broadcast<Real>(kInfinite);
  result.r = (result.r + (least > broadcast<Real>(0.0) ? change : infinite)) * kUp;
  return result;
}

// |B_2n| / (2n (2n+1)!), n = 1..16, and (4^n - 1) times that, rounded to nearest.
inline constexpr double kClausenNearZero[16] = {
    0x1.c71c71c71c71cp-7,  0x1.23456789abcdfp-14, 0x1.a6b4d4f3e9a84p-21, 0x1.8a86a49f629d1p-27,
    0x1.a1598a2de5251p-33, 0x1.dcb864bec8df1p-39, 0x1.1eff7ef77d015p-44, 0x1.6731c59dbd7dep-50,
    0x1.cf1d1c3362ad7p-56, 0x1.31aba277df942p-61, 0x1.9b500f3769b41p-67, 0x1.192a4b43f4a8cp-72,
    0x1.859450efd56d4p-78, 0x1.1100be03bf87dp-83, 0x1.826bbe4408f9cp-89, 0x1.13d916dfdf3ecp-94};
inline constexpr double kClausenNearPi[16] = {
    0x1.5555555555555p-5,  0x1.1111111111111p-10, 0x1.a01a01a01a01ap-15, 0x1.88fc1dfac33a7p-19,
    0x1.a0f133cb59abcp-23, 0x1.dc9a99387cf28p-27, 0x1.1efb02f981235p-30, 0x1.67305e6bf7e03p-34,
    0x1.cf1ca86c1ba09p-38, 0x1.31ab8f5d256cap-41, 0x1.9b5008ca29773p-45, 0x1.192a4a2aca5d8p-48,
    0x1.8594508e70590p-52, 0x1.1100bdf2af7bfp-55, 0x1.826bbe3dff4adp-59, 0x1.13d916decb65ap-62};

template <class Real>
inline Ball<Real> clausen_series(const double (&coefficient)[16], const Ball<Real>& u) {
  const auto term = [&](int n) { return constant<Real>(coefficient[n], coefficient[n] * kUnit); };
  Ball<Real> p = term(15);
  for (int n = 14; n >= 0; --n) p = p * u + term(n);
  return p;
}

/// Clausen's function of all members; |x| up to a few hundred.
///   Cl2(a) = a (1 - ln a) + a^3 A(a^2),      Cl2(pi - y) = y (ln 2 - y^2 B(y^2))
template <class Real>
inline Ball<Real> clausen(const Ball<Real>& x) {
  const Real zero = broadcast<Real>(0.0), infinite = broadcast<Real>(kInfinite);
  const Ball<Real> pi = ball_pi<Real>();
  const Real turns = (x.m * 0x1.45f306dc9c883p-3 + kRoundToInteger) - kRoundToInteger;
  // 2 pi as a sum of two doubles and a rest below 2^-105.
  const Ball<Real> rest = constant<Real>(0x1.1a62633145c07p-52, 0x1p-105);
  const Ball<Real> turned = exactly(turns) * constant<Real>(0x1.921fb54442d18p+2, 0);
  Ball<Real> reduced = (x - turned) - exactly(turns) * rest;
  // Directed rounding may leave up to a whole turn.
  const Ball<Real> size{magnitude(reduced.m), reduced.r};
  const auto past = size.m > broadcast<Real>(0x1.921fb54442d18p+1);
  const Ball<Real> folded = select(past, 2.0 * pi - size, size);
  const auto negative = past ? (reduced.m > zero) : (reduced.m < zero);

  // At the midpoint a of what is left; the radius comes after.
  const Ball<Real> a = exactly(maximum(folded.m, broadcast<Real>(0x1p-900)));
  const Ball<Real> log_a = ball_log(a);
  const Ball<Real> y = pi - a;
  const Ball<Real> a2 = square(a), y2 = square(y);
  Ball<Real> near_zero = clausen_series(kClausenNearZero, a2);
  near_zero.r = (near_zero.r + tail_within(a.m, 2.15, 2e-19)) * kUp;
  Ball<Real> near_pi = clausen_series(kClausenNearPi, y2);
  near_pi.r = (near_pi.r + tail_within(y.m, 1.1, 6e-19)) * kUp;
  const Ball<Real> one = constant<Real>(1, 0);
  const Ball<Real> by_zero = a * (one - log_a) + (a * a2) * near_zero;
  const Ball<Real> by_pi = y * (ball_ln2<Real>() - y2 * near_pi);
  Ball<Real> value = select(a.m < broadcast<Real>(2.1), by_zero, by_pi);
  value.m = negative ? -value.m : value.m;

  // |Cl2'| <= max(ln 2, ln(pi / a)) within a / 2 of a; next to 0 the values themselves are small.
  const Real rho = (folded.r + magnitude(a.m - folded.m) + kTiny) * kUp;
  const Real slope = maximum(broadcast<Real>(0.694), (1.15 - (log_a.m - log_a.r)) * kUp);
  const Real least = maximum(rho, broadcast<Real>(0x1p-58));
  const Real close = least < broadcast<Real>(0.1) ? 300 * least : infinite;
  const Real change = a.m * (2 - kUp) > 2 * rho ? slope * rho : close;
  value.r = (value.r + change) * kUp;
  return value;
}

}  // namespace
}  // namespace tripus::geometry
