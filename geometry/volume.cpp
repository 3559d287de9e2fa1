#include "geometry/volume.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "geometry/clausen.hpp"
#include "geometry/detail/angle_gram.hpp"

namespace tripus::geometry {
namespace {

/// The difference S(z-) - S(z+) of docs/theory.md for the two roots z = exp(i phi).
double clausen_sum(double phi, const double (&faces)[3], const double (&vertices)[4]) {
  double sum = clausen2(phi);
  for (const double x : faces) sum += clausen2(phi + x);
  for (const double x : vertices) sum -= clausen2(phi + std::numbers::pi + x);
  return sum;
}

}  // namespace

double volume(std::span<const double, 6> theta) {
  // Ushijima's names: A, B, C at the edges 01, 02, 03 of one vertex, D, E, F opposite to them.
  const double A = theta[0], B = theta[1], C = theta[2];
  const double D = theta[5], E = theta[4], F = theta[3];
  const double sine[6] = {std::sin(A), std::sin(B), std::sin(C),
                          std::sin(D), std::sin(E), std::sin(F)};
  const double minus_det = angle_gram_minus_det(theta);
  if (!(minus_det > 0)) return 0;  // flat

  const double numerator = sine[0] * sine[3] + sine[1] * sine[4] + sine[2] * sine[5];
  const auto unit = [](double angle) { return std::polar(1.0, angle); };
  const std::complex<double> denominator = unit(A + D) + unit(B + E) + unit(C + F) +
                                           unit(A + B + F) + unit(A + C + E) + unit(B + C + D) +
                                           unit(D + E + F) + unit(A + B + C + D + E + F);
  const double centre = std::numbers::pi - std::arg(denominator);
  const double spread = std::atan2(std::sqrt(minus_det), numerator);
  const double face_sums[3] = {A + B + D + E, A + C + D + F, B + C + E + F};
  const double vertex_sums[4] = {A + B + C, A + E + F, B + D + F, C + D + E};
  const double v = (clausen_sum(centre - spread, face_sums, vertex_sums) -
                    clausen_sum(centre + spread, face_sums, vertex_sums)) /
                   4;
  return std::clamp(v, 0.0, kOctahedronVolume);
}

}  // namespace tripus::geometry
