#pragma once

/// Every tolerance of the library, by name and with its reason. Nothing else in the code
/// compares a floating-point number with a bare constant of this kind.
namespace tripus::tolerance {

/// Default bound on max|K|, the largest edge curvature, of a "geometric" answer. Curvatures are
/// sums of about 6 to 100 angles of size 1, so rounding alone leaves some 1e-15 to 1e-14.
inline constexpr double kMaxCurvature = 1e-12;

}  // namespace tripus::tolerance
