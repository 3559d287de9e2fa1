#include "geometry/hyperbolic_space.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/moebius.hpp"

namespace tripus::geometry {

Matrix4 lorentz_inverse(const Matrix4& isometry) {
  Matrix4 inverse = isometry.transpose();
  inverse.row(3) *= -1;
  inverse.col(3) *= -1;
  return inverse;
}

double orthogonality_defect(const Matrix4& matrix) {
  return (lorentz_inverse(matrix) * matrix - Matrix4::Identity()).cwiseAbs().maxCoeff();
}

Matrix4 reorthogonalised(const Matrix4& matrix) { return to_matrix(to_moebius(matrix)); }

Vector4 on_hyperboloid(const Vector4& x) {
  Vector4 point = x;
  point[3] = std::sqrt(1 + x.head<3>().squaredNorm());
  return point;
}

double hyperbolic_distance(const Vector4& x, const Vector4& y) {
  // <x - y, x - y> = 4 sinh^2(d / 2).
  const Vector4 step = x - y;
  return 2 * std::asinh(std::sqrt(std::max(lorentz_product(step, step), 0.0)) / 2);
}

std::string_view to_string(Model model) {
  switch (model) {
    case Model::kUpperHalfSpace:
      return "upper";
    case Model::kPoincareBall:
      return "ball";
    case Model::kKleinBall:
      break;
  }
  return "klein";
}

Vector3 to_model(Model model, const Vector4& point) {
  const double x = point[0], y = point[1], z = point[2], time = point[3];
  if (model == Model::kKleinBall) return point.head<3>() / time;
  if (model == Model::kPoincareBall) return point.head<3>() / (1 + time);
  // time - z, without the subtraction of two nearly equal numbers.
  const double depth = z > 0 ? (1 + x * x + y * y) / (time + z) : time - z;
  return Vector3(x, y, 1) / depth;
}

Vector4 from_model(Model model, const Vector3& place) {
  const double square = place.squaredNorm();
  Vector4 point;
  switch (model) {
    case Model::kKleinBall:
      point << place, 1;
      return point / std::sqrt(1 - square);
    case Model::kPoincareBall:
      point << 2 * place, 1 + square;
      return point / (1 - square);
    case Model::kUpperHalfSpace:
      break;
  }
  point << 2 * place[0], 2 * place[1], square - 1, square + 1;
  return point / (2 * place[2]);
}

}  // namespace tripus::geometry
