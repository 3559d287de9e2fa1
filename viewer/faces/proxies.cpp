#include "viewer/faces/proxies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace tripus::viewer {
namespace {

/// What rounding in the shaders may move a pixel by.
constexpr double kRounding = 0.06;
/// Polygons smaller than this, in square pixels, are rectangles, and larger than that have 16
/// sides: corners cost some pixels each.
constexpr double kSmallPolygon = 120, kLargePolygon = 2500;

constexpr std::size_t kMostSides = 16;

/// Directions of the picture, counter-clockwise.
const std::array<Eigen::Vector2f, kMostSides> kDirections = [] {
  std::array<Eigen::Vector2f, kMostSides> result;
  for (std::size_t k = 0; k < kMostSides; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kMostSides;
    result[k] = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
  }
  return result;
}();

}  // namespace

Projector::Projector(const View& view, int width, int height)
    : eye_(view.eye), width_(width), height_(height), focal_(height / view.height_at_one) {
  Eigen::Matrix<double, 3, 4> rows;
  const Eigen::Matrix4d all = view.projection * view.model_view;
  rows << all.row(0) * (width_ / 2), all.row(1) * (height_ / 2), all.row(3);
  to_picture_ = rows.cast<float>();
}

double Projector::pixels(const BoundingBall& ball) const {
  const double distance = (ball.centre - eye_).norm();
  if (distance <= ball.radius) return std::numeric_limits<double>::infinity();
  return ball.radius / distance * focal_;
}

void Projector::add(std::span<const Eigen::Vector3f> points, double margin, float record,
                    ProxyMesh& mesh) const {
  float nearest = std::numeric_limits<float>::infinity();
  // How far the polygon reaches in each direction, of which every other one is known at first.
  std::array<float, kMostSides> reach;
  reach.fill(-std::numeric_limits<float>::infinity());
  const auto place = [&](const Eigen::Vector3f& p) {
    const Eigen::Vector3f q = to_picture_.leftCols<3>() * p + to_picture_.col(3);
    nearest = std::min(nearest, q[2]);
    return Eigen::Vector2f(q[0] / q[2], q[1] / q[2]);
  };
  const auto extend = [&](std::size_t k, const Eigen::Vector2f& at) {
    const float along = kDirections[k].dot(at);
    reach[k] = std::max(reach[k], along);
    reach[k + kMostSides / 2] = std::max(reach[k + kMostSides / 2], -along);
  };
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector2f at = place(p);
    for (std::size_t k = 0; k < kMostSides / 2; k += 2) extend(k, at);
  }
  if (nearest <= margin) {  // it may surround the eye
    reach.fill(static_cast<float>(width_ + height_));
    add_polygon(reach, 2, record, mesh);
    return;
  }
  // Away from the middle of the picture lengths look longer.
  const double tilt = std::hypot(1, std::hypot(width_, height_) / 2 / focal_);
  const auto more =
      static_cast<float>(margin / (nearest - margin) * focal_ * tilt * tilt + kRounding);
  const float straight = (reach[0] + reach[8] + 2 * more) * (reach[4] + reach[12] + 2 * more);
  const float slanting = (reach[2] + reach[10] + 2 * more) * (reach[6] + reach[14] + 2 * more);
  const float area = std::min(straight, slanting);
  if (area > kLargePolygon) {
    for (const Eigen::Vector3f& p : points) {
      const Eigen::Vector2f at = place(p);
      for (std::size_t k = 1; k < kMostSides / 2; k += 2) extend(k, at);
    }
  }
  for (float& length : reach) length += more;
  if (area < kSmallPolygon) {
    // The smaller of the two rectangles.
    if (slanting < straight) std::rotate(reach.begin(), reach.begin() + 2, reach.end());
    add_polygon(reach, 4, record, mesh, slanting < straight ? 2 : 0);
    return;
  }
  add_polygon(reach, area > kLargePolygon ? 1 : 2, record, mesh);
}

void Projector::add(const BoundingBall& ball, float record, ProxyMesh& mesh) const {
  const Eigen::Vector3f middle = ball.centre.cast<float>();
  add(std::span(&middle, 1), ball.radius, record, mesh);
}

void Projector::add_polygon(std::span<const float> reach, std::size_t step, float record,
                            ProxyMesh& mesh, std::size_t turn) const {
  const auto first = static_cast<std::uint32_t>(mesh.corners.size());
  float left = 0, right = 0, low = 0, high = 0;  // of the picture's middle
  for (std::size_t k = 0; k < kMostSides; k += step) {
    // Where the lines of two directions next to each other meet.
    const Eigen::Vector2f &d = kDirections[(k + turn) % kMostSides],
                          &e = kDirections[(k + step + turn) % kMostSides];
    const float h = reach[k], g = reach[(k + step) % kMostSides];
    const float sine = d[0] * e[1] - d[1] * e[0];
    const float x = (h * e[1] - g * d[1]) / sine, y = (g * d[0] - h * e[0]) / sine;
    mesh.corners.emplace_back(2 * x / static_cast<float>(width_),
                              2 * y / static_cast<float>(height_), record);
    left = k == 0 ? x : std::min(left, x);
    right = k == 0 ? x : std::max(right, x);
    low = k == 0 ? y : std::min(low, y);
    high = k == 0 ? y : std::max(high, y);
  }
  const auto half_width = static_cast<float>(width_ / 2),
             half_height = static_cast<float>(height_ / 2);
  if (left > half_width || right < -half_width || low > half_height || high < -half_height) {
    mesh.corners.resize(first);
    return;
  }
  const auto corners = static_cast<std::uint32_t>(kMostSides / step);
  for (std::uint32_t i = 1; i + 1 < corners; ++i)
    mesh.triangles.insert(mesh.triangles.end(), {first, first + i, first + i + 1});
}

bool may_face(const HalfSpace& wall, std::span<const Eigen::Vector3f> points, double margin,
              const Vector3& eye) {
  // On the wall gradient(p).(p - eye) is linear in p.
  const Vector3 slope = -wall.gradient(eye);
  const double constant = -2 * wall.c - wall.b.dot(eye);
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3f& p : points) least = std::min(least, slope.dot(p.cast<double>()));
  constexpr double kFloats = 1e-6;  // of the points
  return least + constant <= (margin + kFloats) * slope.norm();
}

}  // namespace tripus::viewer
