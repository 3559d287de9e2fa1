#pragma once

#include <array>
#include <cstddef>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "geometry/moebius.hpp"

/// Moebius maps in a hundred digits.
namespace tripus::embedding::detail {

using WideNumber = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                                 boost::multiprecision::et_off>;

/// What std::complex promises for the types of the language only.
struct WideComplex {
  WideNumber re, im;

  static WideComplex of(const geometry::Complex& w) {
    return {WideNumber(w.real()), WideNumber(w.imag())};
  }
  geometry::Complex rounded() const { return {static_cast<double>(re), static_cast<double>(im)}; }
  WideNumber square() const { return re * re + im * im; }
};

inline WideComplex operator+(const WideComplex& p, const WideComplex& q) {
  return {p.re + q.re, p.im + q.im};
}
inline WideComplex operator-(const WideComplex& p, const WideComplex& q) {
  return {p.re - q.re, p.im - q.im};
}
inline WideComplex operator*(const WideComplex& p, const WideComplex& q) {
  return {p.re * q.re - p.im * q.im, p.re * q.im + p.im * q.re};
}
inline WideComplex operator*(const WideComplex& p, const WideNumber& factor) {
  return {p.re * factor, p.im * factor};
}
inline WideComplex conj(const WideComplex& w) { return {w.re, -w.im}; }

/// Coefficients a, b, c, d, and whether the map is of the conjugate.
struct WideMap {
  std::array<WideComplex, 4> m;
  bool reverses = false;
};

/// The map of the doubles, taken `on_group`.
WideMap widened(const geometry::MoebiusMap& map);
/// The nearest map with a d - b c = 1, from one that is near to it.
WideMap on_group(const WideMap& map);
WideMap product(const WideMap& p, const WideMap& q);
/// For a d - b c = 1.
WideMap inverse(const WideMap& map);
geometry::MoebiusMap rounded(const WideMap& map);
/// On the hyperboloid, rounded at the end, to double or long double.
template <class Scalar>
Eigen::Matrix<Scalar, 4, 4> to_matrix(const WideMap& map);

}  // namespace tripus::embedding::detail
