#pragma once

/// Every tolerance of the library, by name and with its reason. Nothing else in the code
/// compares a floating-point number with a bare constant of this kind.
namespace tripus::tolerance {

/// Default bound on max|K|, the largest edge curvature, of a "geometric" answer. Curvatures are
/// sums of about 6 to 100 angles of size 1, so rounding alone leaves some 1e-15 to 1e-14.
inline constexpr double kMaxCurvature = 1e-12;

/// What a computed edge curvature of exactly 0 may really be: 2 pi itself is rounded by up to half
/// an ulp, 4.4e-16, and so is a sum of angles near it.
inline constexpr double kCurvatureRounding = 1e-15;

/// A tetrahedron with an angle within this of pi is not called a true one: the angle is then
/// pi - O(sqrt(-det G)), and rounding alone moves det G across 0.
inline constexpr double kFlatAngleMargin = 1e-6;

/// Bound on the estimated distance of the lengths from those of the metric, relative to 1 or the
/// shortest edge (docs/theory.md (49)). At a metric found to max|K| = 1e-12 the estimate is some
/// 1e-11; where lengths run off to infinity it is of order 1 however small max|K| becomes.
inline constexpr double kMaxDistanceToMetric = 1e-2;

/// An angle structure whose margin (radians) is below this is not used as a starting point: the
/// linear programme is solved in floating point with feasibility tolerances of 1e-7.
inline constexpr double kAngleMargin = 1e-6;

/// Relative difference of the volumes of one manifold on two triangulations. At max|K| = 1e-12 each
/// is accurate to some 1e-12; two manifolds that share a homology seldom are as close as this.
inline constexpr double kSameVolume = 1e-9;

}  // namespace tripus::tolerance
