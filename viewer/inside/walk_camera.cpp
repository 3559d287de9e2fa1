#include "viewer/inside/walk_camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/LU>

#include "geometry/boost.hpp"
#include "viewer/scene.hpp"

namespace tripus::viewer {
namespace {

using geometry::lorentz_product;
using geometry::Matrix4;
using geometry::Vector3;
using geometry::Vector4;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vector4 unit_tangent(const Vector4& x) {
  return x / std::sqrt(std::max(lorentz_product(x, x), 1e-300));
}

/// Stands at p and looks at q, with `up` upwards as far as possible.
Matrix4 frame_from(const Vector4& p, const Vector4& q, const Vector4& up) {
  const auto tangent = [&](const Vector4& x) -> Vector4 { return x + lorentz_product(x, p) * p; };
  Matrix4 frame;
  frame.col(3) = p;
  frame.col(2) = unit_tangent(tangent(q));
  const Vector4 upwards = tangent(up);
  frame.col(1) = unit_tangent(upwards - lorentz_product(upwards, frame.col(2)) * frame.col(2));
  // What is left: of the axis that is farthest from the span of the others.
  double best = -1;
  for (int axis = 0; axis < 3; ++axis) {
    Vector4 a = tangent(Vector4::Unit(axis));
    for (const int other : {2, 1}) a -= lorentz_product(a, frame.col(other)) * frame.col(other);
    if (lorentz_product(a, a) <= best) continue;
    best = lorentz_product(a, a);
    frame.col(0) = unit_tangent(a);
  }
  // right x up = -forward, as the third axis points into the picture.
  if (frame.determinant() >= 0) frame.col(0) = -frame.col(0);
  return frame;
}

/// The rotation of the i-th towards the j-th axis.
Matrix4 rotation(int i, int j, double angle) {
  Matrix4 m = Matrix4::Identity();
  m(i, i) = m(j, j) = std::cos(angle);
  m(j, i) = std::sin(angle);
  m(i, j) = -std::sin(angle);
  return m;
}

/// The first s >= 0 with a cosh s + b sinh s = level, where b > 0; 0 if it is behind already.
double distance_to_level(double a, double b, double level) {
  if (a >= level) return 0;
  // (a + b) e^s / 2 + (a - b) e^-s / 2 = level
  const double p = (a + b) / 2, q = (a - b) / 2;
  const double root = std::sqrt(std::max(level * level - 4 * p * q, 0.0));
  double least = kInfinity;
  const auto take = [&](double power) {
    if (power >= 1) least = std::min(least, std::log(power));
  };
  if (std::abs(p) < 1e-15) {
    take(q / level);
  } else {
    take((level + root) / (2 * p));
    take((level - root) / (2 * p));
  }
  return least;
}

/// A wall of a tetrahedron: its vector, and whether it is a horosphere.
struct StandingWall {
  Vector4 vector;
  bool is_horosphere = false;
};

std::vector<StandingWall> walls_of(const embedding::HyperboloidTetrahedron& shape) {
  std::vector<StandingWall> walls;
  for (std::size_t v = 0; v < 4; ++v)
    if (!shape.is_finite(v)) walls.push_back({shape.vertices[v], shape.is_ideal(v)});
  for (std::size_t e = 0; e < 6; ++e)
    if (shape.is_parabolic(e)) walls.push_back({shape.parabolic_point(e), true});
  return walls;
}

/// Where walls are for one who walks: the product with their vector.
double wall_level(const StandingWall& wall) {
  return wall.is_horosphere ? -std::exp(kWallClearance) : -std::sinh(kWallClearance);
}

/// What is left of a step where a wall is near, and its normal.
struct Touch {
  double left = 0;
  Vector4 normal;
};

/// Goes straight until the distance is done, or a wall is near.
std::optional<Touch> step(Walker& walker, const InsideManifold& m, const Vector3& direction,
                          double distance) {
  constexpr int kMostFaces = 64;
  double left = distance;
  for (int crossing = 0; crossing < kMostFaces && left > 0; ++crossing) {
    const embedding::HyperboloidTetrahedron& shape = m.tetrahedra[walker.tetrahedron];
    const Vector4 p = walker.position();
    const Vector4 u = walker.frame.leftCols<3>() * direction;
    double reach = left;
    std::optional<std::size_t> face;
    std::optional<Vector4> wall;
    for (std::size_t f = 0; f < 4; ++f) {
      const double towards = lorentz_product(shape.faces[f], u);
      if (towards <= 0) continue;
      const double ratio = -lorentz_product(shape.faces[f], p) / towards;
      const double s = ratio >= 1 ? kInfinity : std::atanh(std::max(ratio, 0.0));
      if (s >= reach) continue;
      reach = s;
      face = f;
    }
    for (const StandingWall& one : walls_of(shape)) {
      const double towards = lorentz_product(one.vector, u);
      if (towards <= 0) continue;
      const double s = distance_to_level(lorentz_product(one.vector, p), towards, wall_level(one));
      if (s >= reach) continue;
      reach = s;
      face.reset();
      wall = one.vector;
    }
    walker.frame =
        geometry::reorthogonalised(walker.frame * geometry::boost(std::sinh(reach) * direction));
    left -= reach;
    if (wall) return Touch{left, *wall};
    if (!face) return std::nullopt;
    const std::uint32_t here = walker.tetrahedron;
    walker.frame = geometry::reorthogonalised(m.crossing[here][*face] * walker.frame);
    walker.tetrahedron = m.neighbour[here][*face];
  }
  return std::nullopt;
}

}  // namespace

void Walker::turn(double right, double up, double roll) {
  frame = geometry::reorthogonalised(frame * rotation(2, 0, right) * rotation(2, 1, up) *
                                     rotation(1, 0, roll));
}

bool Walker::walk(const InsideManifold& manifold, const Vector3& direction, double distance) {
  constexpr int kMostWalls = 4;
  bool touched = false;
  Vector3 way = direction.normalized();
  for (int part = 0; part < kMostWalls && distance > 1e-9; ++part) {
    const std::optional<Touch> touch = step(*this, manifold, way, distance);
    if (!touch) break;
    touched = true;
    // The direction without its component towards the wall.
    Vector3 normal;
    for (int i = 0; i < 3; ++i) normal[i] = lorentz_product(frame.col(i), touch->normal);
    const Vector3 along = way - way.dot(normal) / normal.squaredNorm() * normal;
    const double length = along.norm();
    distance = touch->left * length;
    if (length < 1e-6) break;
    way = along / length;
  }
  return touched;
}

Walker standing_at(const InsideManifold& manifold, StandingPlace place) {
  const embedding::HyperboloidTetrahedron& shape = manifold.tetrahedra[0];
  const auto middle = [](const Vector4& sum) -> Vector4 {
    return sum / std::sqrt(-lorentz_product(sum, sum));
  };
  const auto corner = [&](int i, int j) { return drawn_corner(shape, i, j); };
  const Vector4 centre = geometry::origin();
  Walker walker;
  if (place == StandingPlace::kWall) {
    const Vector4 floor = middle(corner(0, 1) + corner(0, 2) + corner(0, 3));
    walker.frame = frame_from(middle(3 * floor + centre), middle(corner(2, 0) + corner(3, 1)),
                              -shape.vertices[0]);
  } else if (place == StandingPlace::kEdge) {
    const Vector4 edge = middle(corner(0, 1) + corner(1, 0));
    walker.frame =
        frame_from(middle(2 * edge + centre), middle(corner(1, 0) + corner(1, 2) + corner(3, 2)),
                   shape.vertices[1]);
  } else {
    walker.frame =
        frame_from(centre, middle(corner(2, 3) + corner(3, 2) + corner(1, 0)), shape.vertices[1]);
  }
  if (!stands_inside(manifold, walker)) walker.frame = Matrix4::Identity();
  return walker;
}

bool stands_inside(const InsideManifold& manifold, const Walker& walker) {
  constexpr double kRounding = 1e-6;
  if (walker.tetrahedron >= manifold.tetrahedra.size()) return false;
  if (!walker.frame.allFinite() || !(geometry::orthogonality_defect(walker.frame) < kRounding))
    return false;
  const embedding::HyperboloidTetrahedron& shape = manifold.tetrahedra[walker.tetrahedron];
  const Vector4 p = walker.position();
  for (const Vector4& face : shape.faces)
    if (!(lorentz_product(face, p) <= kRounding)) return false;
  return std::ranges::all_of(walls_of(shape), [&](const StandingWall& wall) {
    return lorentz_product(wall.vector, p) <= (wall.is_horosphere ? -1 : 0) + kRounding;
  });
}

}  // namespace tripus::viewer
