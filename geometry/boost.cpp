#include "geometry/boost.hpp"

#include <cmath>

namespace tripus::geometry {

Matrix4 boost(const Vector3& x) {
  const double time = std::sqrt(1 + x.squaredNorm());
  Matrix4 result = Matrix4::Identity();
  result.topLeftCorner<3, 3>() += x * x.transpose() / (1 + time);
  result.topRightCorner<3, 1>() = x;
  result.bottomLeftCorner<1, 3>() = x.transpose();
  result(3, 3) = time;
  return result;
}

}  // namespace tripus::geometry
