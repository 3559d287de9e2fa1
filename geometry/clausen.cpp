// Cl2 from two expansions whose logarithmic part is explicit, so that what remains is an even
// entire-like function given by a short polynomial:
//   Cl2(x)      = x (1 - ln x) + x^3 A(x^2)         on [0, 2 pi/3],
//   Cl2(pi - y) = y (ln 2 - y^2 B(y^2))             on [0, pi/3].
// A and B are the series with coefficients |B_2n| / (2n (2n+1)!) and (2^2n - 1) times that,
// replaced by their Chebyshev interpolants of degree 9 (errors 3.4e-18 and 3.7e-18).
#include "geometry/clausen.hpp"

#include <cmath>

namespace tripus::geometry {
namespace {

constexpr double kPi = 0x1.921fb54442d18p+1;
constexpr double kPiLow = 0x1.1a62633145c07p-53;
constexpr double kLn2 = 0x1.62e42fefa39efp-1;

constexpr double kNearZero[] = {0x1.c71c71c71c71cp-7,  0x1.23456789abe0bp-14, 0x1.a6b4d4f3a34dfp-21,
                                0x1.8a86a4d27a2f7p-27, 0x1.a1597762ef30ep-33, 0x1.dcbc597f259eep-39,
                                0x1.1ebef3a598376p-44, 0x1.6c3d73fbe5342p-50, 0x1.932d251dc8042p-56,
                                0x1.ee115622b1cb0p-61};
constexpr double kNearPi[] = {0x1.5555555555555p-5,  0x1.111111111123dp-10, 0x1.a01a019fd3a75p-15,
                              0x1.88fc1e2ddacc4p-19, 0x1.a0f1210063ec2p-23, 0x1.dc9e8df8ce8d6p-27,
                              0x1.1eba77a854609p-30, 0x1.6c3c0cbb76b69p-34, 0x1.932cb20a57c52p-38,
                              0x1.ee1140ac205afp-41};

double polynomial(const double (&coefficient)[10], double u) {
  double sum = coefficient[9];
  for (int n = 8; n >= 0; --n) sum = sum * u + coefficient[n];
  return sum;
}

}  // namespace

double clausen2(double x) {
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
