#include "viewer/opencsg/half_space_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

namespace tripus::viewer {
namespace {

/// The cap of a sphere of this radius in the local frame, or of a larger one, is a graph over its
/// disk of radius kPrimitiveReach, and not steep.
constexpr double kSmallestCapRadius = 1.5;

constexpr int kMostRings = 96;      // of a cap
constexpr int kMostDivisions = 64;  // of an icosahedron's edge

std::array<float, 3> as_floats(const Vector3& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

/// The corners and the faces of an icosahedron inscribed in the unit sphere.
struct Icosahedron {
  std::array<Vector3, 12> corners;
  std::array<std::array<int, 3>, 20> faces;
};

Icosahedron icosahedron() {
  Icosahedron result;
  const double height = 1 / std::sqrt(5.0), radius = 2 / std::sqrt(5.0);
  result.corners[0] = {0, 0, 1};
  result.corners[11] = {0, 0, -1};
  for (int i = 0; i < 5; ++i) {
    const double upper = 2 * std::numbers::pi * i / 5, lower = upper + std::numbers::pi / 5;
    const auto n = static_cast<std::size_t>(i);
    result.corners[1 + n] = {radius * std::cos(upper), radius * std::sin(upper), height};
    result.corners[6 + n] = {radius * std::cos(lower), radius * std::sin(lower), -height};
    const int next = (i + 1) % 5;
    result.faces[4 * n] = {0, 1 + i, 1 + next};
    result.faces[4 * n + 1] = {1 + i, 6 + i, 1 + next};
    result.faces[4 * n + 2] = {1 + next, 6 + i, 6 + next};
    result.faces[4 * n + 3] = {11, 6 + next, 6 + i};
  }
  return result;
}

/// A sphere with its icosahedron's edges cut into `divisions` parts.
ConvexMesh sphere(const Vector3& centre, double radius, int divisions) {
  static const Icosahedron kIcosahedron = icosahedron();
  ConvexMesh mesh;
  // Points are shared by their place on the icosahedron: by corners with whole weights.
  std::map<std::array<std::pair<int, int>, 3>, std::uint32_t> known;
  const auto point = [&](const std::array<int, 3>& face, int i, int j) {
    std::array<std::pair<int, int>, 3> key;
    const std::array<int, 3> weights{divisions - i - j, i, j};
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      key[k] = weights[k] == 0 ? std::pair(-1, 0) : std::pair(face[k], weights[k]);
      sum += weights[k] * kIcosahedron.corners[static_cast<std::size_t>(face[k])];
    }
    std::ranges::sort(key);
    const auto [place, added] =
        known.try_emplace(key, static_cast<std::uint32_t>(mesh.points.size()));
    if (added) mesh.points.push_back(as_floats(centre + radius * sum.normalized()));
    return place->second;
  };
  for (const auto& face : kIcosahedron.faces) {
    for (int i = 0; i < divisions; ++i) {
      for (int j = 0; i + j < divisions; ++j) {
        const std::uint32_t a = point(face, i, j), b = point(face, i + 1, j),
                            c = point(face, i, j + 1);
        mesh.triangles.push_back({a, b, c});
        if (i + j + 1 < divisions) mesh.triangles.push_back({b, point(face, i + 1, j + 1), c});
      }
    }
  }
  return mesh;
}

/// A body of revolution: a dome of rings of 6, 12, 18, ... points around its pole, and a flat base.
class Dome {
 public:
  /// `axis` (unit) points to the pole, which is at axis * pole.
  Dome(const Vector3& axis, double pole, int rings)
      : axis_(axis), u_(axis.unitOrthogonal()), v_(axis.cross(u_)), rings_(rings) {
    mesh_.points.push_back(as_floats(pole * axis));
  }

  /// The next ring outwards.
  void add_ring(double radius, double height) {
    ++ring_;
    add_points(6 * ring_, radius, height);
    for (int side = 0; side < 6; ++side) {
      for (int k = 0; k < ring_; ++k) {
        const int outer = side * ring_ + k, inner = side * (ring_ - 1) + k;
        mesh_.triangles.push_back({at(ring_, outer), at(ring_, outer + 1), at(ring_ - 1, inner)});
        if (k + 1 < ring_)
          mesh_.triangles.push_back(
              {at(ring_ - 1, inner), at(ring_, outer + 1), at(ring_ - 1, inner + 1)});
      }
    }
  }

  /// A wall straight down from the last ring.
  void add_wall(double radius, double height) {
    const int rim = 6 * ring_;
    const auto below = static_cast<std::uint32_t>(mesh_.points.size());
    add_points(rim, radius, height);
    for (int i = 0; i < rim; ++i) {
      const std::uint32_t a = at(ring_, i), b = at(ring_, i + 1);
      const auto c = below + static_cast<std::uint32_t>(i),
                 d = below + static_cast<std::uint32_t>((i + 1) % rim);
      mesh_.triangles.push_back({a, c, b});
      mesh_.triangles.push_back({b, c, d});
    }
  }

  /// The base below the last points.
  ConvexMesh close(double height) {
    const int rim = 6 * ring_;
    const auto middle = static_cast<std::uint32_t>(mesh_.points.size());
    const std::uint32_t first = middle - static_cast<std::uint32_t>(rim);
    mesh_.points.push_back(as_floats(height * axis_));
    for (int i = 0; i < rim; ++i)
      mesh_.triangles.push_back({first + static_cast<std::uint32_t>(i), middle,
                                 first + static_cast<std::uint32_t>((i + 1) % rim)});
    return std::move(mesh_);
  }

  int rings() const { return rings_; }

 private:
  void add_points(int count, double radius, double height) {
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      mesh_.points.push_back(
          as_floats(height * axis_ + radius * (std::cos(angle) * u_ + std::sin(angle) * v_)));
    }
  }
  /// Point i of a ring, which come after those of the rings inside it.
  static std::uint32_t at(int ring, int i) {
    return static_cast<std::uint32_t>(ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + i % (6 * ring));
  }

  Vector3 axis_, u_, v_;
  int rings_;
  int ring_ = 0;
  ConvexMesh mesh_;
};

/// The part of a large ball under its cap over a disk of radius kPrimitiveReach.
///   pole  of the cap along the axis; curvature: 1 / radius, 0 for a plane
ConvexMesh capped_cylinder(Dome dome, double pole, double curvature) {
  double height = pole;
  for (int ring = 1; ring <= dome.rings(); ++ring) {
    const double radius = kPrimitiveReach * ring / dome.rings(), k = curvature * radius;
    height = pole - k * radius / (1 + std::sqrt(1 - k * k));
    dome.add_ring(radius, height);
  }
  const double base = std::min(-kPrimitiveReach, height - 0.1);
  dome.add_wall(kPrimitiveReach, base);
  return dome.close(base);
}

/// A ball without what lies below kPrimitiveReach on the other side.
ConvexMesh cut_ball(Dome dome, double pole, double radius) {
  const double centre = pole - radius;
  const double end = std::acos((-kPrimitiveReach - centre) / radius);
  double height = pole;
  for (int ring = 1; ring <= dome.rings(); ++ring) {
    const double angle = end * ring / dome.rings();
    height = centre + radius * std::cos(angle);
    dome.add_ring(radius * std::sin(angle), height);
  }
  return dome.close(height);
}

}  // namespace

HalfSpacePrimitive half_space_primitive(const HalfSpace& half_space, double error) {
  HalfSpacePrimitive primitive;
  HalfSpace ball = half_space;
  if (half_space.a < 0) {
    primitive.operation = Operation::kSubtract;
    ball = {-half_space.a, -half_space.b, -half_space.c};
  }
  const double curvature = 2 * ball.a;
  // The point of the wall nearest to the origin lies on the line through the centre:
  // a t^2 + |b| t + c = 0, the root near 0, with b^2 - 4 a c = 1.
  const double slope = ball.b.norm();
  const double pole = -2 * ball.c / (slope + 1);
  // A chord of length h leaves a sphere by curvature h^2 / 8.
  const double chord = std::sqrt(8 * error / std::max(curvature, 1e-9));
  const auto parts = [&](double length, int most) {
    return std::clamp(static_cast<int>(std::ceil(std::min(1.3 * length / chord, 1e3))), 2, most);
  };
  if (curvature * kSmallestCapRadius <= 1) {
    const Dome dome(ball.b / slope, pole, parts(kPrimitiveReach, kMostRings));
    primitive.mesh = capped_cylinder(dome, pole, curvature);
    return primitive;
  }
  const double radius = 1 / curvature;
  if (pole - 2 * radius > -kPrimitiveReach) {
    primitive.mesh = sphere(-ball.b / curvature, radius, parts(radius, kMostDivisions));
  } else {
    const Dome dome(ball.b / slope, pole, parts(2 * radius, kMostRings));
    primitive.mesh = cut_ball(dome, pole, radius);
  }
  return primitive;
}

ConvexMesh bounding_mesh() {
  // An icosahedron cut in 3 has its faces at 0.9406 and more of its corners' distance.
  return sphere(Vector3::Zero(), kBoundingReach, 3);
}

}  // namespace tripus::viewer
