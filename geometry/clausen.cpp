#include "geometry/clausen.hpp"

#include <cmath>

#include "geometry/detail/clausen_coefficients.hpp"

namespace tripus::geometry {
namespace {

double polynomial(const double (&coefficient)[10], double u) {
  double sum = coefficient[9];
  for (int n = 8; n >= 0; --n) sum = sum * u + coefficient[n];
  return sum;
}

}  // namespace

double clausen2(double x) {
  using namespace clausen;
  // Into [-pi, pi], with the low part of 2 pi.
  const double turns = std::nearbyint(x / (2 * kPi));
  double reduced = (x - turns * (2 * kPi)) - turns * (2 * kPiLow);
  const double sign = reduced < 0 ? -1.0 : 1.0;
  reduced = std::fabs(reduced);
  if (reduced <= 2 * kPi / 3) {
    if (reduced == 0) return 0;
    const double u = reduced * reduced;
    return sign * (reduced * (1 - std::log(reduced)) + reduced * u * polynomial(kNearZero, u));
  }
  const double y = (kPi - reduced) + kPiLow;
  const double u = y * y;
  return sign * y * (kLn2 - u * polynomial(kNearPi, u));
}

}  // namespace tripus::geometry
