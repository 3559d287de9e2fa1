#include "studies/detail/thresholds.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "geometry/paper_formulae.hpp"

// Where the paper's formulae break down for equal lengths L, with p bits of significand.
//
// The hexagon law gives cosh y = (c^2 + c) / s^2, c = cosh L and s = sinh L, exactly
// 1 + 1/(c - 1). That is above 1 by less than half a unit in the last place, 2^-p, from
// 2 e^-L = 2^-p on, L = (p + 1) ln 2. The sum c^2 + c is still rounded up for a while: c is more
// than half a unit of c^2 as long as c < 2^p sqrt(2). From there on, L = (p + 3/2) ln 2, the sum is
// c^2, the quotient 1, y = 0, and the triangle law divides 0 by 0. In double precision this is
// 37.776.
//
// For short edges cosh y is about 2/L^2, and the triangle law's cosine 1 - 1/(1 + cosh y) rounds to
// 1, the angle to 0, where L^2 / 2 < 2^-p / 2: at some L = 2^(-p/2) up to the rounding of the
// other operations.

namespace tripus::studies::detail {
namespace {

template <class Real>
Real paper_angle(double length) {
  Real l[6], theta[6];
  for (Real& value : l) value = Real(length);
  return geometry::paper_dihedral_angles(l, theta) ? theta[0]
                                                   : std::numeric_limits<Real>::quiet_NaN();
}

template <class Real>
std::vector<Threshold> thresholds_of(const std::string& precision) {
  const int p = std::numeric_limits<Real>::digits;
  const double ln2 = std::numbers::ln2;
  const double far = 4 * p;
  const auto exact_above_one = [](double length) {
    return Real(1) + 1 / (std::cosh(Real(length)) - 1) != Real(1);
  };
  const auto sum_grows = [](double length) {
    const Real c = std::cosh(Real(length));
    const volatile Real square = c * c, sum = square + c;
    return sum != square;
  };
  const auto side_positive = [](double length) {
    const Real c = std::cosh(Real(length)), s = std::sinh(Real(length));
    return std::acosh((c * c + c) / (s * s)) > 0;
  };
  const auto angle_sound = [](double length) { return !std::isnan(paper_angle<Real>(length)); };
  const auto angle_zero = [](double length) { return paper_angle<Real>(length) == 0; };
  return {
      {precision, p, "exact side rounds to zero", bisect(1, far, exact_above_one), (p + 1) * ln2,
       "1 + 1/(cosh L - 1), the exact cosh y, is nearest to 1"},
      {precision, p, "sum absorbed", bisect(1, far, sum_grows), (p + 1.5) * ln2,
       "cosh^2 L + cosh L rounds to cosh^2 L"},
      {precision, p, "side zero", bisect(1, far, side_positive), (p + 1.5) * ln2,
       "the quotient of the hexagon law is 1 and y = acosh 1 = 0"},
      {precision, p, "angle not a number", bisect(1, far, angle_sound), (p + 1.5) * ln2,
       "the triangle law divides 0 by 0"},
      {precision, p, "angle zero", bisect(std::exp2(-p), 1, angle_zero), std::exp2(-p / 2.0),
       "short edges: the cosine of the triangle law rounds to 1, the angle to 0"},
  };
}

}  // namespace

double bisect(double lower, double upper, const std::function<bool(double)>& holds) {
  for (;;) {
    const double middle = lower + (upper - lower) / 2;
    if (!(middle > lower && middle < upper)) return upper;
    (holds(middle) ? lower : upper) = middle;
  }
}

std::vector<Threshold> thresholds(const std::string& precision) {
  if (precision == "float") return thresholds_of<float>(precision);
  if (precision == "double") return thresholds_of<double>(precision);
  if (precision == "long double") return thresholds_of<long double>(precision);
  throw InternalError("no precision " + precision);
}

long double paper_regular_angle(const std::string& precision, double length) {
  if (precision == "float") return paper_angle<float>(length);
  if (precision == "double") return paper_angle<double>(length);
  return paper_angle<long double>(length);
}

long double exact_regular_angle(long double length) {
  // cos theta = c / (2 c - 1), so sin^2(theta/2) = (c - 1) / (2 (2 c - 1)) = q / (1 + 4 q) with
  // q = sinh^2(L/2).
  const long double s = std::sinh(length / 2);
  const long double ratio = s > 1 ? 1 / (4 + 1 / (s * s)) : s * s / (1 + 4 * s * s);
  return 2 * std::asin(std::sqrt(ratio));
}

}  // namespace tripus::studies::detail
