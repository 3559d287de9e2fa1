#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "viewer/camera.hpp"
#include "viewer/picture.hpp"

/// Rays through the pixels of a scene, cut with the half-spaces of every cell, on the processor and
/// by formulae of their own: what the pictures of the desktop viewer must show.
namespace tripus::viewer {

struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  std::size_t cell = 0;  ///< from 1; 0: nothing
  std::size_t wall = 0;  ///< from 1
  auto operator<=>(const Hit&) const = default;
};

/// <normal, X(p)> times a positive factor: X(p) for points of the models, from their definitions.
inline double side(Model model, const Vector4& n, const Vector3& p) {
  const double square = p.squaredNorm();
  switch (model) {
    case Model::kUpperHalfSpace:
      return 2 * (n[0] * p[0] + n[1] * p[1]) + n[2] * (square - 1) - n[3] * (square + 1);
    case Model::kPoincareBall:
      return 2 * n.head<3>().dot(p) - n[3] * (1 + square);
    case Model::kKleinBall:
      return n.head<3>().dot(p) - n[3];
  }
  return 0;
}

/// What `side` multiplies <normal, X(p)> with.
inline double side_factor(Model model, const Vector3& p) {
  const double square = p.squaredNorm();
  if (model == Model::kUpperHalfSpace) return 2 * p[2];
  return model == Model::kPoincareBall ? 1 - square : std::sqrt(std::max(1 - square, 0.0));
}

/// The same of a wall of a cell, negative inside: of a horosphere <v, X(p)> + 1.
inline double side(Model model, const SceneCell& cell, std::size_t wall, const Vector3& p) {
  if (!has_wall(cell, wall)) return -1;
  const double plane = side(model, wall_vector(cell, wall), p);
  return is_horosphere(cell, wall) ? plane + side_factor(model, p) : plane;
}

/// Where a ray meets a wall: the zeros of a quadratic polynomial, here by its values at three
/// points. Of a horosphere of the Klein ball the polynomial is the product of <v, X> + 1 and
/// <v, X> - 1, times 1 - |p|^2.
inline std::vector<double> crossings(Model model, const SceneCell& cell, std::size_t wall,
                                     const Ray& ray, double length) {
  if (!has_wall(cell, wall)) return {};
  const auto value = [&](double t) {
    const Vector3 p = ray.origin + t * length * ray.direction;
    if (model != Model::kKleinBall || !is_horosphere(cell, wall)) return side(model, cell, wall, p);
    const double plane = side(model, wall_vector(cell, wall), p);
    return plane * plane - 1 + p.squaredNorm();
  };
  const double c = value(0), plus = value(1), minus = value(-1);
  const double a = (plus + minus) / 2 - c, b = (plus - minus) / 2;
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return {};
  const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
  std::vector<double> roots;
  // Of planes, where a is 0 but for rounding, there is no second one.
  if (std::abs(a) > 1e-12 * (std::abs(b) + std::abs(c))) roots.push_back(q / a * length);
  if (q != 0) roots.push_back(c / q * length);
  return roots;
}

inline bool in_model(Model model, const Vector3& p) {
  return model == Model::kUpperHalfSpace ? p.z() > 0 : p.squaredNorm() < 1;
}

/// The first wall that a ray meets, on the side x <= cut.
inline Hit first_hit(const Scene& scene, Model model, const Ray& ray, double length,
                     double cut = std::numeric_limits<double>::infinity()) {
  Hit best;
  for (std::size_t number = 0; number < scene.cells.size(); ++number) {
    const SceneCell& cell = scene.cells[number];
    std::vector<std::pair<double, std::size_t>> candidates;
    for (std::size_t wall = 0; wall < kWallCount; ++wall)
      for (const double t : crossings(model, cell, wall, ray, length))
        candidates.emplace_back(t, wall);
    if (std::isfinite(cut) && ray.direction.x() != 0)
      candidates.emplace_back((cut - ray.origin.x()) / ray.direction.x(), kWallCount);
    for (const auto& [t, wall] : candidates) {
      if (t <= 0 || t >= best.distance) continue;
      const Vector3 p = ray.origin + t * ray.direction;
      if (!in_model(model, p) || (wall != kWallCount && p.x() > cut)) continue;
      bool inside = true;
      for (std::size_t other = 0; other < kWallCount && inside; ++other)
        inside = other == wall || side(model, cell, other, p) <= 0;
      if (inside) best = {t, number + 1, wall + 1};
    }
  }
  return best;
}

inline Hit shown(const Image& image, int x, int y) {
  const std::uint8_t* pixel = image.pixels.data() + 4 * (static_cast<std::size_t>(y) *
                                                             static_cast<std::size_t>(image.width) +
                                                         static_cast<std::size_t>(x));
  return {0, pixel[0] + 256U * pixel[1], pixel[2] & 15U};
}

}  // namespace tripus::viewer
