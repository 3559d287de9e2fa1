#pragma once

#include "geometry/detail/ball_functions.hpp"

/// Balls whose midpoint is an unevaluated sum of two doubles: some 100 bits. For the angles, whose
/// sums around the edges must be known far better than to a rounding of each.
///
/// Sums and products of doubles are exact as a pair of doubles only if rounding is to nearest:
/// `rounds_to_nearest` must hold where these are used. What is left out of sums and products is of
/// second order, and bounded in docs/theory.md (90'). Quotients, roots and functions end in a small
/// correction that is an ordinary ball.
namespace tripus::geometry {
namespace {

/// Whether this thread rounds to nearest, as it does unless someone changed it.
inline bool rounds_to_nearest() {
  const volatile double one = 1, half_ulp = 0x1p-53, more = 0x1.8p-53;
  return one + half_ulp == 1 && -one - half_ulp == -1 && one + more == 1 + 0x1p-52;
}

/// Keeps the compiler from fusing the product x with what follows.
template <class Real>
inline Real unfused(Real x) {
#if defined(__x86_64__)
  asm("" : "+x"(x));
#elif defined(__aarch64__)
  asm("" : "+w"(x));
#endif
  return x;
}

template <class Real>
struct Pair {
  Real hi, lo;
};

/// hi + lo = a + b exactly, |lo| <= 2^-53 |hi|.
template <class Real>
inline Pair<Real> two_sum(Real a, Real b) {
  const Real s = a + b, part = s - a;
  return {s, (a - (s - part)) + (b - part)};
}
/// hi + lo = a b exactly, short of underflow (Dekker).
template <class Real>
inline Pair<Real> two_product(Real a, Real b) {
  constexpr double kSplit = 134217729.0;  // 2^27 + 1
  const Real ca = unfused<Real>(kSplit * a), cb = unfused<Real>(kSplit * b);
  const Real ah = ca - (ca - a), bh = cb - (cb - b);
  const Real al = a - ah, bl = b - bh;
  const Real p = unfused<Real>(a * b);
  return {p, ((ah * bh - p) + (ah * bl + al * bh)) + al * bl};
}

template <class Real>
struct DoubleBall {
  Real hi, lo, r;  // |lo| <= 2^-53 |hi|
};

template <class Real>
inline DoubleBall<Real> paired(Real hi, Real lo, Real r) {
  const Pair<Real> sum = two_sum(hi, lo);
  return {sum.hi, sum.lo, r * kUp};
}
template <class Real>
inline DoubleBall<Real> double_exactly(Real x) {
  return {x, Real{} + 0.0, Real{} + 0.0};
}
template <class Real>
inline DoubleBall<Real> double_constant(double hi, double lo, double r) {
  return {broadcast<Real>(hi), broadcast<Real>(lo), broadcast<Real>(r)};
}
template <class Real>
inline Ball<Real> to_ball(const DoubleBall<Real>& a) {
  return {a.hi, (magnitude(a.lo) + a.r) * kUp};
}

inline constexpr double kSecondOrder = 0x1p-102;

template <class Real>
inline DoubleBall<Real> operator+(const DoubleBall<Real>& a, const DoubleBall<Real>& b) {
  const Pair<Real> s = two_sum(a.hi, b.hi);
  return paired<Real>(s.hi, s.lo + (a.lo + b.lo),
                      a.r + b.r + ((magnitude(a.hi) + magnitude(b.hi)) * kSecondOrder + kTiny));
}
template <class Real>
inline DoubleBall<Real> operator-(const DoubleBall<Real>& a) {
  return {-a.hi, -a.lo, a.r};
}
template <class Real>
inline DoubleBall<Real> operator-(const DoubleBall<Real>& a, const DoubleBall<Real>& b) {
  return a + -b;
}
template <class Real>
inline DoubleBall<Real> operator*(const DoubleBall<Real>& a, const DoubleBall<Real>& b) {
  const Pair<Real> p = two_product(a.hi, b.hi);
  return paired<Real>(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi),
                      magnitude(a.hi) * b.r + (magnitude(b.hi) * kUp + b.r) * a.r +
                          (magnitude(p.hi) * kSecondOrder + kTiny));
}
/// By a power of two.
template <class Real>
inline DoubleBall<Real> operator*(double power, const DoubleBall<Real>& b) {
  return {power * b.hi, power * b.lo, power * b.r};
}
template <class Real>
inline DoubleBall<Real> square(const DoubleBall<Real>& a) {
  return a * a;
}
/// q + (a - q b)/b with q near a/b.
template <class Real>
inline DoubleBall<Real> operator/(const DoubleBall<Real>& a, const DoubleBall<Real>& b) {
  const Real q = a.hi / b.hi;
  const Ball<Real> rest = to_ball(a - double_exactly(q) * b) / to_ball(b);
  return paired<Real>(q, rest.m, rest.r);
}
/// s + (a - s^2)/(s + sqrt a) with s near sqrt a, and |sqrt a - s| <= |a - s^2|/s.
template <class Real>
inline DoubleBall<Real> square_root(const DoubleBall<Real>& a) {
  const Real zero = broadcast<Real>(0.0), infinite = broadcast<Real>(kInfinite);
  const Real s = square_root(a.hi > zero ? a.hi : zero);
  const Ball<Real> rest = to_ball(a - square(double_exactly(s)));
  const Ball<Real> sum{2 * s, magnitude_bound(rest) / (s * (2 - kUp)) * kUp};
  const Ball<Real> correction = rest / sum;
  return paired<Real>(s, correction.m, a.hi > zero ? correction.r : infinite);
}
template <class Real>
inline DoubleBall<Real> number_like(double value, const DoubleBall<Real>&) {
  return double_constant<Real>(value, 0, 0);
}
template <class Real>
inline auto larger(const DoubleBall<Real>& a, const DoubleBall<Real>& b) {
  return a.hi > b.hi;
}
template <class Mask, class Real>
inline DoubleBall<Real> select(const Mask& mask, const DoubleBall<Real>& a,
                               const DoubleBall<Real>& b) {
  return {mask ? a.hi : b.hi, mask ? a.lo : b.lo, mask ? a.r : b.r};
}

// 1/n! as two doubles; what is missing is below 2^-106 of it.
inline constexpr double kOverFactorial[9][2] = {{1, 0},
                                                {1, 0},
                                                {0.5, 0},
                                                {0x1.5555555555555p-3, 0x1.5555555555555p-57},
                                                {0x1.5555555555555p-5, 0x1.5555555555555p-59},
                                                {0x1.1111111111111p-7, 0x1.1111111111111p-63},
                                                {0x1.6c16c16c16c17p-10, -0x1.f49f49f49f49fp-65},
                                                {0x1.a01a01a01a01ap-13, 0x1.a01a01a01a01ap-73},
                                                {0x1.a01a01a01a01ap-16, 0x1.a01a01a01a01ap-76}};
template <class Real>
inline DoubleBall<Real> over_factorial(int n) {
  return double_constant<Real>(kOverFactorial[n][0], kOverFactorial[n][1],
                               kOverFactorial[n][0] * 0x1p-105);
}
inline constexpr double kFactorialBeyond[19] = {0,
                                                0,
                                                0,
                                                0,
                                                0,
                                                0,
                                                0,
                                                0,
                                                0,
                                                362880,
                                                3628800,
                                                39916800,
                                                479001600,
                                                6227020800,
                                                87178291200,
                                                1307674368000,
                                                20922789888000,
                                                355687428096000,
                                                6402373705728000};

/// x - k c for an integer |k| <= 64 and c = parts[0] + parts[1] + parts[2] to within 2^-143, where
/// k times the first two is exact.
template <class Real>
inline DoubleBall<Real> less_multiple(Real x, Real k, const double (&parts)[3]) {
  const Pair<Real> one = two_sum<Real>(x, -(k * parts[0]));
  const Pair<Real> two = two_sum<Real>(one.hi, -(k * parts[1]));
  const Real last = k * parts[2];
  return paired<Real>(two.hi, (one.lo + two.lo) - last,
                      (magnitude(one.lo) + magnitude(two.lo) + magnitude(last)) * 0x1p-51 +
                          (magnitude(k) * 0x1p-143 + kTiny));
}

/// sinh and cosh of the point x in [0, kEnclosureLimit]: expm1 of a sixteenth of x - k ln 2, which
/// is doubled four times.
template <class Real>
inline SinhCosh<DoubleBall<Real>> double_sinh_cosh(Real x) {
  using Bits = typename BitsOf<Real>::Type;
  using D = DoubleBall<Real>;
  constexpr double kLn2[3] = {0x1.62e42fefa3800p-1, 0x1.ef35793c76800p-45, -0x1.9ff0342542fc3p-90};
  const Real shifted = x * 0x1.71547652b82fep+0 + kRoundToInteger;
  const Real k = shifted - kRoundToInteger;
  const Real two_to_k = bits_as<Real>((bits_as<Bits>(shifted) + 1023) << 52);
  const D z = 0.0625 * less_multiple<Real>(x, k, kLn2);
  const Ball<Real> zb = to_ball(z);
  Ball<Real> far = reciprocal_of<Real>(kFactorialBeyond[13]);
  for (int n = 12; n >= 9; --n) far = far * zb + reciprocal_of<Real>(kFactorialBeyond[n]);
  D p{far.m, Real{} + 0.0, (far.r + tail_within(z.hi, 0.0223, 2e-19)) * kUp};
  for (int n = 8; n >= 1; --n) p = p * z + over_factorial<Real>(n);
  D m = p * z;
  for (int doubling = 0; doubling < 4; ++doubling) m = square(m) + 2.0 * m;
  const D one = double_constant<Real>(1, 0, 0), power = double_exactly(two_to_k);
  const D M = power * m + (power - one), e = M + one;
  const D inverse = one / e;
  return {0.5 * (M + M * inverse), 0.5 * (e + inverse)};
}

/// sin and 1 - cos of a sixteenth of y, doubled four times; |y| <= 0.79.
template <class Real>
inline Pair<DoubleBall<Real>> double_sine_versine(const DoubleBall<Real>& y) {
  using D = DoubleBall<Real>;
  const D z = 0.0625 * y, w = square(z);
  const Ball<Real> wb = to_ball(w);
  Ball<Real> odd = reciprocal_of<Real>(kFactorialBeyond[17]);
  Ball<Real> even = reciprocal_of<Real>(kFactorialBeyond[18]);
  for (int n = 15; n >= 9; n -= 2) {
    odd = reciprocal_of<Real>(kFactorialBeyond[n]) - odd * wb;
    even = reciprocal_of<Real>(kFactorialBeyond[n + 1]) - even * wb;
  }
  const Real zero = Real{} + 0.0;
  D s{odd.m, zero, (odd.r + tail_within(z.hi, 0.0494, 1e-29)) * kUp};
  D v{even.m, zero, (even.r + tail_within(z.hi, 0.0494, 1e-29)) * kUp};
  for (int n = 7; n >= 1; n -= 2) {
    s = over_factorial<Real>(n) - s * w;
    v = over_factorial<Real>(n + 1) - v * w;
  }
  s = s * z;
  v = v * w;
  for (int doubling = 0; doubling < 4; ++doubling) {
    const D sine = s;
    s = 2.0 * (sine - sine * v);
    v = 2.0 * square(sine);
  }
  return {s, v};
}

/// The angle of the point (x, y), y > 0, in (0, pi): a double t near it, and the angle that is left
/// after turning by -t.
template <class Real>
inline DoubleBall<Real> angle_of(const DoubleBall<Real>& y, const DoubleBall<Real>& x) {
  using D = DoubleBall<Real>;
  constexpr double kHalfPi[3] = {0x1.921fb54442d18p+0, 0x1.1a62633145c08p-54,
                                 -0x1.1f1976b7ed8fcp-106};
  const Real t = angle_of(exactly(y.hi), exactly(x.hi)).m;
  const Real j = (t * 0x1.45f306dc9c883p-1 + kRoundToInteger) - kRoundToInteger;
  const auto [s, v] = double_sine_versine(less_multiple<Real>(t, j, kHalfPi));
  const D c = double_constant<Real>(1, 0, 0) - v;
  const auto turned = j == broadcast<Real>(1.0);
  const auto opposite = j == broadcast<Real>(2.0);
  const D sine = select(turned, c, select(opposite, -s, s));
  const D cosine = select(turned, -s, select(opposite, -c, c));
  const Ball<Real> along = to_ball(x * cosine + y * sine);
  const Ball<Real> rest = to_ball(y * cosine - x * sine) / along;
  // |atan q - q| <= |q|^3, and q is about a rounding.
  const Real q = magnitude_bound(rest), infinite = broadcast<Real>(kInfinite);
  const auto small = (q < broadcast<Real>(0x1p-30)) & (lower(along) > broadcast<Real>(0.0));
  return paired<Real>(t, rest.m, small ? rest.r + q * q * q : infinite);
}

}  // namespace
}  // namespace tripus::geometry
