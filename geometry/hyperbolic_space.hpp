#pragma once

#include <array>
#include <string_view>

#include <Eigen/Core>

/// Hyperbolic space as the hyperboloid <x, x> = -1, x_4 > 0, and its models.
///
/// Coordinates are (x, y, z, time); isometries are the 4x4 matrices of O+(3,1), acting on columns.
/// Points are timelike vectors, planes are unit spacelike vectors n: the plane {<x, n> = 0}, whose
/// inner side is <x, n> < 0.
namespace tripus::geometry {

using Vector3 = Eigen::Vector3d;
using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;

/// x1 y1 + x2 y2 + x3 y3 - x4 y4.
inline double lorentz_product(const Vector4& x, const Vector4& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] - x[3] * y[3];
}

/// The point (0, 0, 0, 1), the middle of both balls.
inline Vector4 origin() { return Vector4::UnitW(); }

/// The inverse of an isometry, J A^T J: exact, no division.
Matrix4 lorentz_inverse(const Matrix4& isometry);

/// max |A^T J A - J|, 0 for an exact isometry.
double orthogonality_defect(const Matrix4& matrix);

/// The isometry nearest to a matrix that rounding has moved off O+(3,1).
///
/// It goes through SL(2,C), where every matrix gives an isometry and only its size must be set,
/// which the image of the origin does. Gram-Schmidt on the columns of A would subtract numbers of
/// size e^{2r} (r: how far A moves the origin) to find numbers of order 1, and spoil digits that A
/// has (docs/theory.md (62)).
Matrix4 reorthogonalised(const Matrix4& matrix);

/// The point of the hyperboloid with the spatial part of x; takes off what rounding put on.
Vector4 on_hyperboloid(const Vector4& x);

/// Hyperbolic distance of two points of the hyperboloid; keeps its digits for near points.
double hyperbolic_distance(const Vector4& x, const Vector4& y);

/// Pictures of hyperbolic space in R^3. In the Klein ball planes are flat; in the other two they
/// are spheres and planes orthogonal to the boundary.
enum class Model {
  kUpperHalfSpace,  ///< z > 0; the origin of the hyperboloid is (0, 0, 1)
  kPoincareBall,
  kKleinBall,
};
inline constexpr std::array<Model, 3> kModels{Model::kUpperHalfSpace, Model::kPoincareBall,
                                              Model::kKleinBall};

/// "upper", "ball", "klein".
std::string_view to_string(Model model);

/// Where a point of the hyperboloid lies in a model.
Vector3 to_model(Model model, const Vector4& point);

/// The point of the hyperboloid at a place of a model; inside the ball, or above the plane z = 0
/// (not checked).
Vector4 from_model(Model model, const Vector3& place);

}  // namespace tripus::geometry
