#pragma once

#include <functional>
#include <string>
#include <vector>

namespace tripus::studies::detail {

/// A rounding in the paper's formulae for a regular tetrahedron of edge length L, and the length
/// from which (or up to which) it happens, found by bisection.
struct Threshold {
  std::string precision;  ///< float, double, long double
  int digits = 0;         ///< bits p of the significand
  std::string event;
  double length = 0;     ///< measured
  double predicted = 0;  ///< from p; NaN where there is no formula
  std::string meaning;
};

/// Every event in float, double and long double.
std::vector<Threshold> thresholds(const std::string& precision);

/// The dihedral angle of the regular tetrahedron by the paper's formulae in a precision, NaN where
/// they break down.
long double paper_regular_angle(const std::string& precision, double length);

/// Closed form of the same angle, docs/theory.md (26), in a shape that loses no digits.
long double exact_regular_angle(long double length);

/// Where `holds` changes between lower (true) and upper (false), to adjacent doubles.
double bisect(double lower, double upper, const std::function<bool(double)>& holds);

}  // namespace tripus::studies::detail
