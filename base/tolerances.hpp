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

/// Where no lengths in double precision bring max|K| below its tolerance, a tetrahedron with an
/// angle within this of pi is tried as a flat one: such angles are off by the square root of
/// rounding, 1e-8, times the condition of the problem.
inline constexpr double kNearlyFlat = 1e-3;

/// Bound on the estimated distance of the lengths from those of the metric, relative to 1 or the
/// shortest edge (docs/theory.md (49)). At a metric found to max|K| = 1e-12 the estimate is some
/// 1e-11; where lengths run off to infinity it is of order 1 however small max|K| becomes.
inline constexpr double kMaxDistanceToMetric = 1e-2;

/// Where there are cusps, a tetrahedron with an angle below this (radians) may be on its way to
/// infinity, with curvatures that vanish faster than its angles: below kMaxCurvature at angles of
/// 1e-7. An exact decision then says whether there is a minimum.
inline constexpr double kThinAngle = 1e-4;

/// Where a vertex is finite, edges longer than this are not believed: at a vertex that runs off to
/// infinity angles are those of an ideal one to within e^(-2l), 4e-11 at this length, so that
/// max|K| comes below its tolerance without a metric a little farther out.
inline constexpr double kLongestFiniteEdge = 12;

/// An angle structure whose margin (radians) is below this is not used as a starting point: the
/// linear programme is solved in floating point with feasibility tolerances of 1e-7.
inline constexpr double kAngleMargin = 1e-6;

/// A sum of two tilts below this, relative to 1 or the larger of the two, may be 0: it is taken
/// again in 50 digits. Rounding leaves some 1e-13; the smallest sum that is not 0 among the
/// triangulations with up to 4 tetrahedra is some thousand times this bound.
inline constexpr double kTiltDoubt = 1e-6;

/// A sum of two tilts that were computed in 50 digits is 0 if it is below this: what is 0 comes out
/// as 1e-45 and less. Between this and kTiltDoubt nothing was ever seen.
inline constexpr double kPreciseTiltZero = 1e-36;

/// Two triangulations of one manifold give its volume to within this, relatively: the curvatures of
/// 1e-12 that are left change it by less than 1e-11 (docs/canonical.md (T6)).
inline constexpr double kVolumeAgreement = 1e-9;

/// A determinant of coordinate differences has the sign of its floating-point value if that is
/// beyond this times the sum of the sizes of its terms: each term has at most 8 roundings of 2^-53;
/// twice that leaves room for the roundings of the bound. Below it, signs are computed exactly.
inline constexpr double kOrientationRounding = 0x1p-49;

/// Triangles of a tube's surface that come closer than this, relative to their size, count as
/// meeting while one of them is moved: rounding in the test itself is some 1e-15, and triangles
/// that keep this distance do not meet whatever the last bits do.
inline constexpr double kSweepClearance = 1e-9;

/// Points on open edges that lie closer together than this, relative to the size of the surface or
/// of its coordinates, may become one if that closes it: text with six digits is off by 5e-6,
/// single precision by 6e-8. The least distance that does is taken, from the first of these on.
inline constexpr double kLeastWelding = 1e-12;
inline constexpr double kMostWelding = 1e-5;
/// But no more than this part of the size, however far away the origin is.
inline constexpr double kMostWeldingOfSize = 1e-4;

/// A face whose corners are this close to a plane, relative to their coordinates, is called planar:
/// single precision rounds these by 6e-8.
inline constexpr double kPlanarFace = 1e-6;

/// New points that a mesher puts on a surface lie this far from its triangles at most, in parts of
/// the largest coordinate: they are rounded, some after a few operations. What is narrower than
/// that is not told apart by the doubles that describe it.
inline constexpr double kOnSurface = 1e-12;

/// Boxes that a ray misses by less than this part of its length are looked into all the same. Each
/// coordinate of the ray spans at least a third of the others, so its parameter has an error of
/// some ten roundings of 2^-53.
inline constexpr double kRayMargin = 1e-12;

/// A point in a hole is looked for down to this part of the size of its triangles away from them;
/// nearer, doubles are too coarse.
inline constexpr double kThinnestHole = 1e-9;

/// Lengths with an edge curvature above this are not placed in hyperbolic space: the misfit is
/// multiplied by e^r at distance r, and pictures of radius 10 are to close up to some 1e-4. Solved
/// metrics have 1e-12 and less.
inline constexpr double kEmbeddedCurvature = 1e-8;

/// Relators of a holonomy that miss the identity of SL(2,C) by more than this are reported as not
/// holding in double precision: all triangulations with up to 4 tetrahedra keep some 1e-11.
inline constexpr double kRelator = 1e-9;

/// The foot of an orthogonal arc that lies within this of a line lies on it (distances in the
/// projective disc): feet are known to some 1e-14, and the windows between lines are as wide as
/// e^-L, 3e-7 for arcs of length 15. What is on a line goes to one side by a rule, so a foot that
/// is wrongly called so is still counted once.
inline constexpr double kFootOnLine = 1e-12;

/// Bundles of rays are dropped if they cannot reach within a length by this, relatively: a few
/// hundred roundings stay far below.
inline constexpr double kArcReach = 1e-9;

/// Arcs whose lengths differ by less than this have one length: the same length comes out of
/// different unfoldings to within 1e-12. Ten thousand different lengths up to 10 are some 1e-3 apart
/// in the mean, so that two of them rarely look like one.
inline constexpr double kSameArcLength = 1e-9;

/// Arc lengths of two triangulations that differ by more than this are of different manifolds:
/// metrics with max|K| = 1e-12 give the shortest arcs to some 1e-10.
inline constexpr double kDifferentArcLength = 1e-7;

/// Feet of different arcs are this far apart at the least in the coordinates of a tile.
inline constexpr double kDistinctFeet = 1e-10;

}  // namespace tripus::tolerance
