#include "viewer/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace tripus::viewer {
namespace {

/// Of the shorter side of the picture, at zoom 1: that of a short telephoto lens.
constexpr double kFieldOfView = 30 * std::numbers::pi / 180;

/// Primitives of cells lie within so many radii of the scene: kFarthestPoint radii of a cell.
constexpr double kPrimitivesWithin = 2.1;
static_assert(kPrimitivesWithin < kClosestDistance);
/// Depths are told apart from this part of the way to the scene's middle on.
constexpr double kNearest = 0.02;

}  // namespace

View view_of(const Camera& camera, Model model, const Scene& scene, int width, int height) {
  const Ball focus = focus_of(model, scene);
  return view_of(camera, focus, width, height, reach_of(model, scene, focus));
}

double reach_of(Model model, const Scene& scene, const Ball& focus) {
  if (!scene.focus) return 0;
  const Ball around = bounding_ball(model, scene);
  return (around.centre - focus.centre).norm() + around.radius;
}

View view_of(const Camera& camera, const Ball& scene, int width, int height, double reach) {
  constexpr double kDegree = std::numbers::pi / 180;
  const double azimuth = camera.azimuth * kDegree, elevation = camera.elevation * kDegree;
  const Vector3 back(std::cos(elevation) * std::cos(azimuth),
                     std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  const Vector3 right(-std::sin(azimuth), std::cos(azimuth), 0);
  Eigen::Matrix3d rotation;
  rotation << right.transpose(), back.cross(right).transpose(), back.transpose();

  View view;
  view.eye = scene.centre + camera.distance * scene.radius * back;
  view.model_view.setIdentity();
  view.model_view.topLeftCorner<3, 3>() = rotation;
  view.model_view.topRightCorner<3, 1>() = -rotation * view.eye;

  const double shorter = 2 * std::tan(kFieldOfView / 2) / camera.zoom;
  view.height_at_one = width >= height ? shorter : shorter * height / width;
  const double aspect = static_cast<double>(width) / height;
  const double middle = camera.distance * scene.radius;
  // Primitives reach beyond their cells, and must not be clipped.
  const double within = std::max(kPrimitivesWithin * scene.radius, reach);
  view.near = std::max(middle - within, kNearest * middle);
  view.far = middle + within;
  const double depth = view.far - view.near;
  view.projection.setZero();
  view.projection(0, 0) = 2 / (view.height_at_one * aspect);
  view.projection(1, 1) = 2 / view.height_at_one;
  view.projection(0, 2) = -camera.shift.x() / aspect;
  view.projection(1, 2) = -camera.shift.y();
  view.projection(2, 2) = -(view.far + view.near) / depth;
  view.projection(2, 3) = -2 * view.far * view.near / depth;
  view.projection(3, 2) = -1;
  return view;
}

Vector3 key_light(const View& view) {
  const Vector3 in_eye_space(-0.45, 0.65, 0.75);
  return (view.model_view.topLeftCorner<3, 3>().transpose() * in_eye_space).normalized();
}

std::vector<std::size_t> nearest_first(std::span<const Ball> balls, const Vector3& eye) {
  std::vector<double> distance;
  for (const Ball& ball : balls) distance.push_back((ball.centre - eye).norm() - ball.radius);
  std::vector<std::size_t> order(balls.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return distance[i]; });
  return order;
}

Ray ray_through(const View& view, int width, int height, double x, double y) {
  const Vector4 clip(2 * x / width - 1, 1 - 2 * y / height, -1, 1);
  const Vector4 eye_space = view.projection.inverse() * clip;
  const Vector3 direction =
      view.model_view.topLeftCorner<3, 3>().transpose() * (eye_space.head<3>() / eye_space[3]);
  return {view.eye, direction.normalized()};
}

}  // namespace tripus::viewer
