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
/// Polygons smaller than this, in square pixels, are rectangles: corners cost more than pixels.
constexpr double kSmallPolygon = 120;

constexpr double kDiagonal = std::numbers::sqrt2 / 2;
/// Eight directions of the picture, counter-clockwise.
constexpr std::array<std::array<double, 2>, 8> kDirections{{{1, 0},
                                                            {kDiagonal, kDiagonal},
                                                            {0, 1},
                                                            {-kDiagonal, kDiagonal},
                                                            {-1, 0},
                                                            {-kDiagonal, -kDiagonal},
                                                            {0, -1},
                                                            {kDiagonal, -kDiagonal}}};

}  // namespace

Projector::Projector(const View& view, int width, int height)
    : eye_(view.eye), width_(width), height_(height), focal_(height / view.height_at_one) {
  Eigen::Matrix<double, 3, 4> rows;
  const Eigen::Matrix4d all = view.projection * view.model_view;
  rows << all.row(0) * (width_ / 2), all.row(1) * (height_ / 2), all.row(3);
  to_picture_ = rows.cast<float>();
}

double Projector::pixels(const Ball& ball) const {
  const double distance = (ball.centre - eye_).norm();
  if (distance <= ball.radius) return std::numeric_limits<double>::infinity();
  return ball.radius / distance * focal_;
}

void Projector::add(std::span<const Eigen::Vector3f> points, double margin, float record,
                    ProxyMesh& mesh) const {
  float nearest = std::numeric_limits<float>::infinity();
  std::array<float, 4> low, high;
  low.fill(std::numeric_limits<float>::infinity());
  high.fill(-std::numeric_limits<float>::infinity());
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3f q = to_picture_.leftCols<3>() * p + to_picture_.col(3);
    nearest = std::min(nearest, q[2]);
    const float x = q[0] / q[2], y = q[1] / q[2];
    const std::array<float, 4> along{x, x + y, y, y - x};
    for (std::size_t k = 0; k < 4; ++k) {
      low[k] = std::min(low[k], along[k]);
      high[k] = std::max(high[k], along[k]);
    }
  }
  std::array<double, 8> reach{};
  if (nearest <= margin) {  // it may surround the eye
    reach.fill(width_ + height_);
  } else {
    // Away from the middle of the picture lengths look longer.
    const double tilt = std::hypot(1, std::hypot(width_, height_) / 2 / focal_);
    const double more = margin / (nearest - margin) * focal_ * tilt * tilt + kRounding;
    for (std::size_t k = 0; k < 4; ++k) {
      const double length = k % 2 == 0 ? 1 : kDiagonal;
      reach[k] = length * high[k] + more;
      reach[k + 4] = -length * low[k] + more;
    }
  }
  add_polygon(reach, record, mesh);
}

void Projector::add(const Ball& ball, float record, ProxyMesh& mesh) const {
  const Eigen::Vector3f middle = ball.centre.cast<float>();
  add(std::span(&middle, 1), ball.radius, record, mesh);
}

void Projector::add_polygon(std::span<const double, 8> reach, float record, ProxyMesh& mesh) const {
  if (reach[0] < -width_ / 2 || reach[4] < -width_ / 2 || reach[2] < -height_ / 2 ||
      reach[6] < -height_ / 2)
    return;
  const double straight = (reach[0] + reach[4]) * (reach[2] + reach[6]);
  const double slanting = (reach[1] + reach[5]) * (reach[3] + reach[7]);
  const std::size_t step = std::min(straight, slanting) < kSmallPolygon ? 2 : 1;
  const std::size_t start = step == 2 && slanting < straight ? 1 : 0;
  const auto first = static_cast<std::uint32_t>(mesh.corners.size());
  for (std::size_t k = start; k < 8 + start; k += step) {
    // Where the lines of two directions next to each other meet.
    const auto &d = kDirections[k % 8], &e = kDirections[(k + step) % 8];
    const double h = reach[k % 8], g = reach[(k + step) % 8];
    const double turn = d[0] * e[1] - d[1] * e[0];
    const double x = (h * e[1] - g * d[1]) / turn, y = (g * d[0] - h * e[0]) / turn;
    mesh.corners.emplace_back(static_cast<float>(2 * x / width_),
                              static_cast<float>(2 * y / height_), record);
  }
  const auto corners = static_cast<std::uint32_t>(8 / step);
  for (std::uint32_t i = 1; i + 1 < corners; ++i)
    mesh.triangles.insert(mesh.triangles.end(), {first, first + i, first + i + 1});
}

bool may_face(const HalfSpace& wall, std::span<const Eigen::Vector3f> points, double margin,
              const Vector3& eye) {
  // On the wall gradient(p).(p - eye) is linear in p.
  const Vector3 slope = -wall.b - 2 * wall.a * eye;
  const double constant = -2 * wall.c - wall.b.dot(eye);
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3f& p : points) least = std::min(least, slope.dot(p.cast<double>()));
  constexpr double kFloats = 1e-6;  // of the points
  return least + constant <= (margin + kFloats) * slope.norm();
}

}  // namespace tripus::viewer
