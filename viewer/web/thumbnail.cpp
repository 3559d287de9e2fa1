#include "viewer/web/thumbnail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "embedding/colour.hpp"

namespace tripus::viewer {
namespace {

using geometry::lorentz_product;
using geometry::Vector3;
using geometry::Vector4;

/// Where a geodesic leaves the half-space <n, x> <= 0: tanh of the distance; 1 if it never does.
double exit_of(const Vector4& n, const Vector4& x, const Vector4& u) {
  const double towards = lorentz_product(n, u);
  if (towards <= 0) return 1;
  return std::clamp(-lorentz_product(n, x) / towards, 0.0, 1.0);
}

/// The same of <v, x> <= -1, for a null vector v: where <v, x> + <v, u> t = -sqrt(1 - t^2).
double exit_at_horosphere(const Vector4& v, const Vector4& x, const Vector4& u) {
  const double a = lorentz_product(v, x), b = lorentz_product(v, u);
  const double discriminant = 1 + b * b - a * a;
  if (b <= 0 || discriminant <= 0) return 1;
  return std::clamp((a * a - 1) / (std::sqrt(discriminant) - a * b), 0.0, 1.0);
}

void advance(Vector4& x, Vector4& u, double tanh_distance) {
  const double c = 1 / std::sqrt(1 - tanh_distance * tanh_distance);
  const double s = tanh_distance * c;
  const Vector4 next = c * x + s * u;
  u = s * x + c * u;
  x = next;
}

void normalise(Vector4& x, Vector4& u) {
  x /= std::sqrt(-lorentz_product(x, x));
  u += lorentz_product(u, x) * x;
  u /= std::sqrt(lorentz_product(u, u));
}

constexpr int kWallColours = 8;
constexpr std::array<double, 3> kPale{0.92, 0.90, 0.84};
constexpr std::array<double, 3> kFog{0.60, 0.68, 0.76};
constexpr double kTint = 0.12;
constexpr double kLineWidth = 0.02;

/// How far a point of a wall is from the sides of it: of vertex 0..3, or 4 + a parabolic edge.
double distance_from_sides(const embedding::HyperboloidTetrahedron& shape, std::size_t wall,
                           const Vector4& x) {
  double side = std::numeric_limits<double>::infinity();
  const auto plane = [&](const Vector4& n) {
    side = std::min(side, std::asinh(-lorentz_product(n, x)));
  };
  if (wall >= 4) {  // of a parabolic edge: two faces, two truncations
    for (const int f : topology::kEdgeEnds[5 - (wall - 4)])
      plane(shape.faces[static_cast<std::size_t>(f)]);
    for (const int v : topology::kEdgeEnds[wall - 4])
      plane(shape.vertices[static_cast<std::size_t>(v)]);
    return side;
  }
  for (std::size_t f = 0; f < 4; ++f)
    if (f != wall) plane(shape.faces[f]);
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [v, w] = topology::kEdgeEnds[e];
    if (!shape.is_parabolic(e) ||
        (static_cast<std::size_t>(v) != wall && static_cast<std::size_t>(w) != wall))
      continue;
    side = std::min(side, std::log(-lorentz_product(shape.parabolic_point(e), x)));
  }
  return side;
}

/// Linear light of what is seen.
Vector3 colour_of(const Sight& sight) {
  const Vector3 fog(kFog[0], kFog[1], kFog[2]);
  if (!sight.wall) return fog;
  const auto own = embedding::tetrahedron_colour(
      static_cast<std::uint32_t>((4 * sight.tetrahedron + sight.vertex) % kWallColours));
  Vector3 base;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    base[i] = (1 - kTint) * std::pow(own[k] / 255.0, 2.2) + kTint * kPale[k];
  }
  if (sight.side < kLineWidth) base *= 0.35;
  const double clear = std::exp(-std::pow(sight.distance / 4.5, 3.0));
  return clear * (0.38 + 0.62 * sight.facing) * base + (1 - clear) * fog;
}

std::uint8_t display(double linear) {
  return static_cast<std::uint8_t>(
      std::lround(255 * std::pow(std::clamp(linear, 0.0, 1.0), 1 / 2.2)));
}

}  // namespace

Sight look(const embedding::Embedding& embedding, const topology::Triangulation& triangulation,
           std::size_t tetrahedron, const Vector4& point, const Vector4& direction,
           int most_crossings) {
  Sight sight;
  sight.tetrahedron = tetrahedron;
  Vector4 x = point, u = direction;
  int came_from = -1;
  for (int crossing = 0; crossing <= most_crossings; ++crossing) {
    const auto& here = embedding.tetrahedra[sight.tetrahedron];
    double reach = 1;
    int face = -1;
    for (int f = 0; f < 4; ++f) {
      if (f == came_from) continue;
      const double t = exit_of(here.faces[static_cast<std::size_t>(f)], x, u);
      if (t < reach) {
        reach = t;
        face = f;
      }
    }
    for (std::size_t v = 0; v < 4; ++v) {
      if (here.is_finite(v)) continue;
      const double t = here.is_ideal(v) ? exit_at_horosphere(here.vertices[v], x, u)
                                        : exit_of(here.vertices[v], x, u);
      if (t < reach) {
        reach = t;
        sight.wall = true;
        sight.vertex = v;
      }
    }
    for (std::size_t e = 0; e < 6; ++e) {
      if (!here.is_parabolic(e)) continue;
      const double t = exit_at_horosphere(here.parabolic_point(e), x, u);
      if (t < reach) {
        reach = t;
        sight.wall = true;
        sight.vertex = 4 + e;
      }
    }
    if (reach == 1) return sight;  // only by rounding
    sight.distance += std::atanh(reach);
    advance(x, u, reach);
    if (sight.wall) {
      const Vector4 wall =
          sight.vertex < 4 ? here.vertices[sight.vertex] : here.parabolic_point(sight.vertex - 4);
      sight.facing = std::abs(lorentz_product(wall, u));
      sight.side = distance_from_sides(here, sight.vertex, x);
      return sight;
    }
    const std::size_t other = triangulation.gluings().neighbour(sight.tetrahedron, face);
    came_from = triangulation.gluings().gluing(sight.tetrahedron, face)(face);
    const auto& crossing_map = embedding.face_pairings[other][static_cast<std::size_t>(came_from)];
    x = crossing_map * x;
    u = crossing_map * u;
    normalise(x, u);
    sight.tetrahedron = other;
  }
  return sight;
}

Image inside_picture(const embedding::Embedding& embedding,
                     const topology::Triangulation& triangulation, int width, int height) {
  Image image{width, height, {}};
  image.pixels.reserve(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  // Towards an edge, where the walls recede; vertex 3 is upwards in its own frame.
  const auto& vertices = embedding.tetrahedra[0].vertices;
  const Vector3 up = Vector3::UnitZ();
  Vector3 forward = (vertices[0] + vertices[1]).head<3>();
  forward -= 0.8 * forward.dot(up) * up;
  forward = forward.norm() > 1e-9 ? Vector3(forward.normalized()) : Vector3::UnitX();
  const Vector3 right = forward.cross(up).normalized();
  const Vector3 above = right.cross(forward);
  const double scale = 0.75 / std::min(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      Vector3 sum = Vector3::Zero();
      for (int sample = 0; sample < 4; ++sample) {
        const double across = 2 * (column + 0.25 + 0.5 * (sample & 1)) - width;
        const double upwards = height - 2 * (row + 0.25 + 0.5 * (sample >> 1));
        const Vector3 ray = (forward + scale * (across * right + upwards * above)).normalized();
        const Vector4 direction(ray[0], ray[1], ray[2], 0);
        sum += colour_of(look(embedding, triangulation, 0, geometry::origin(), direction));
      }
      for (int i = 0; i < 3; ++i) image.pixels.push_back(display(sum[i] / 4));
      image.pixels.push_back(255);
    }
  }
  return image;
}

}  // namespace tripus::viewer
