#include "viewer/scene.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "base/error.hpp"
#include "embedding/colour.hpp"

namespace tripus::viewer {
namespace {

/// Points bulge beyond the samples of a wall by at most this part of the ball's radius.
constexpr double kBulge = 1.02;

Colour mixed(const Colour& from, const Colour& to, float t) {
  Colour result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = (1 - t) * from[i] + t * to[i];
  return result;
}

void require_no_parabolic_edge(const geometry::HyperboloidTetrahedron& shape) {
  if (shape.parabolic_edges == 0) return;
  throw Unsupported(
      "parabolic edges (cone order 0) are not drawn; `tripus embed FILE -o cells.ply`, with a file "
      "of the labels, writes their cells for other programs");
}

}  // namespace

std::vector<std::size_t> corners_of_wall(std::size_t wall) {
  const auto corner = [](std::size_t v, std::size_t w) { return 3 * v + w - (w > v ? 1 : 0); };
  std::vector<std::size_t> around, result;
  for (std::size_t v = 0; v < 4; ++v)
    if (v != wall % 4) around.push_back(v);
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_truncation(wall)) {
      result.push_back(corner(wall - 4, around[i]));
      continue;
    }
    const std::size_t before = around[(i + 2) % 3], here = around[i], after = around[(i + 1) % 3];
    result.push_back(corner(here, before));
    result.push_back(corner(here, after));
  }
  return result;
}

HalfSpace half_space(Model model, const SceneCell& cell, std::size_t wall) {
  if (!has_wall(cell, wall)) return {0, {1e-6, 0, 0}, -1};
  return is_horosphere(cell, wall) ? horosphere(model, cell.walls[wall])
                                   : half_space(model, cell.walls[wall]);
}

Scene make_scene(std::string title, const embedding::Embedding& embedding,
                 std::span<const embedding::Cell> cells, const geometry::Matrix4& frame) {
  Scene scene;
  scene.title = std::move(title);
  scene.tetrahedron_count = embedding.tetrahedra.size();
  scene.cells.reserve(cells.size());
  for (const embedding::Cell& from : cells) {
    const geometry::HyperboloidTetrahedron& shape = embedding.tetrahedra[from.tetrahedron];
    const geometry::Matrix4 place = frame * from.isometry;
    SceneCell& cell = scene.cells.emplace_back();
    cell.tetrahedron = from.tetrahedron;
    cell.depth = from.depth;
    cell.place = place;
    cell.diagonal = shape.diagonal;
    cell.singular_edges = embedding.singular_edges.empty()
                              ? std::uint8_t{0}
                              : embedding.singular_edges[from.tetrahedron];
    require_no_parabolic_edge(shape);
    for (std::size_t i = 0; i < 4; ++i) {
      cell.walls[i] = place * shape.faces[i];
      cell.walls[4 + i] = place * shape.vertices[i];
    }
    std::size_t next = 0;
    for (int v = 0; v < 4; ++v)
      for (int w = 0; w < 4; ++w)
        if (w != v) cell.corners[next++] = place * geometry::corner(shape, v, w);
  }
  return scene;
}

Scene moved(Model model, const Scene& scene, const geometry::Matrix4& isometry) {
  Scene result = scene;
  if (isometry == geometry::Matrix4::Identity()) return result;
  result.focus = focus_of(model, scene);
  for (SceneCell& cell : result.cells) {
    for (Vector4& wall : cell.walls) wall = isometry * wall;
    for (Vector4& corner : cell.corners) corner = isometry * corner;
    cell.place = isometry * cell.place;
  }
  return result;
}

std::size_t edge_between(std::size_t vertex, std::size_t other) {
  const std::size_t low = std::min(vertex, other), high = std::max(vertex, other);
  return low == 0 ? high - 1 : low + high;
}

geometry::Matrix4 default_frame(Model model, const embedding::Embedding& embedding,
                                std::uint32_t root) {
  using geometry::lorentz_product;
  if (model != Model::kUpperHalfSpace) return geometry::Matrix4::Identity();
  // An orthonormal frame at the middle of edge 03, its third vector along the edge, its first
  // towards the middle of the cell; its inverse brings it to the axes.
  const geometry::HyperboloidTetrahedron& shape = embedding.tetrahedra[root];
  const Vector4 upper = geometry::corner(shape, 3, 0), lower = geometry::corner(shape, 0, 3);
  geometry::Matrix4 axes;
  const auto without = [&](Vector4 x, int column) {
    const Vector4 axis = axes.col(column);
    return Vector4(x - lorentz_product(x, axis) / lorentz_product(axis, axis) * axis);
  };
  const auto unit = [](const Vector4& x) {
    return Vector4(x / std::sqrt(std::abs(lorentz_product(x, x))));
  };
  axes.col(3) = unit(upper + lower);
  axes.col(2) = unit(without(upper, 3));
  axes.col(0) = unit(without(without(geometry::origin(), 3), 2));
  Vector4 last = Vector4::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vector4 candidate = without(without(without(Vector4::Unit(i), 3), 2), 0);
    if (candidate.norm() > last.norm()) last = candidate;
  }
  axes.col(1) = unit(last);
  if (axes.determinant() < 0) axes.col(1) = -axes.col(1);
  return geometry::lorentz_inverse(axes);
}

std::vector<Vector3> outline(Model model, const SceneCell& cell) {
  constexpr int kSteps = 4;
  std::vector<Vector3> points;
  const auto add = [&](const Vector4& x) {  // sums of points of the hyperboloid are timelike
    points.push_back(geometry::to_model(model, x / std::sqrt(-geometry::lorentz_product(x, x))));
  };
  // Where horospheres cut cells off, the cells lie in the hulls of their corners.
  for (std::size_t wall = 0; wall < kWallCount; ++wall) {
    if (!has_wall(cell, wall)) continue;
    const std::vector<std::size_t> around = corners_of_wall(wall);
    Vector4 middle = Vector4::Zero();
    for (const std::size_t corner : around) middle += cell.corners[corner];
    middle /= static_cast<double>(around.size());
    add(middle);
    for (std::size_t k = 0; k < around.size(); ++k) {
      const Vector4 &a = cell.corners[around[k]],
                    &b = cell.corners[around[(k + 1) % around.size()]];
      for (int i = 0; i < kSteps; ++i) {
        const Vector4 edge = a + (b - a) * i / kSteps;
        add(edge);
        add((edge + middle) / 2);
      }
    }
  }
  return points;
}

namespace {

/// Ritter's ball: never smaller than need be, and seldom a tenth larger.
BoundingBall ball_around(const std::vector<Vector3>& points) {
  const auto farthest = [&](const Vector3& from) {
    return *std::ranges::max_element(points, {},
                                     [&](const Vector3& p) { return (p - from).squaredNorm(); });
  };
  const Vector3 one = farthest(points.front()), other = farthest(one);
  BoundingBall ball{(one + other) / 2, (one - other).norm() / 2};
  for (const Vector3& p : points) {
    const double distance = (p - ball.centre).norm();
    if (distance <= ball.radius) continue;
    const double grown = (ball.radius + distance) / 2;
    ball.centre += (p - ball.centre) * ((grown - ball.radius) / distance);
    ball.radius = grown;
  }
  return ball;
}

}  // namespace

BoundingBall bounding_ball(Model model, const SceneCell& cell) {
  BoundingBall ball = ball_around(outline(model, cell));
  ball.radius *= kBulge;
  return ball;
}

BoundingBall bounding_ball(Model model, const Scene& scene) {
  if (scene.cells.empty()) throw InvalidInput("a scene without cells has no extent");
  std::vector<Vector3> points;
  for (const SceneCell& cell : scene.cells)
    for (const Vector4& corner : cell.corners) points.push_back(geometry::to_model(model, corner));
  for (const Vector3& p : outline(model, scene.cells.front())) points.push_back(p);
  BoundingBall ball = ball_around(points);
  ball.radius *= kBulge;
  return ball;
}

BoundingBall focus_of(Model model, const Scene& scene) {
  return scene.focus ? *scene.focus : bounding_ball(model, scene);
}

ToTetrahedron to_tetrahedron(Model model, const SceneCell& cell, const BoundingBall& ball) {
  // In every model the hyperboloid's point is linear in (p, |p|^2, 1), up to a factor.
  Eigen::Matrix<double, 4, 5> of_model = Eigen::Matrix<double, 4, 5>::Zero();
  switch (model) {
    case Model::kUpperHalfSpace:  // z times the point
      of_model(0, 0) = of_model(1, 1) = 1;
      of_model.col(3) << 0, 0, 0.5, 0.5;
      of_model.col(4) << 0, 0, -0.5, 0.5;
      break;
    case Model::kPoincareBall:  // (1 - |p|^2) / 2 times the point
      of_model.topLeftCorner<3, 3>().setIdentity();
      of_model.col(3) << 0, 0, 0, 0.5;
      of_model.col(4) << 0, 0, 0, 0.5;
      break;
    case Model::kKleinBall:  // sqrt(1 - |p|^2) times the point
      of_model.topLeftCorner<3, 3>().setIdentity();
      of_model.col(4) << 0, 0, 0, 1;
      break;
  }
  Eigen::Matrix<double, 5, 5> local = Eigen::Matrix<double, 5, 5>::Zero();
  local.topLeftCorner<3, 3>() = ball.radius * Eigen::Matrix3d::Identity();
  local.col(4) << ball.centre, ball.centre.squaredNorm(), 1;
  local.row(3).head<3>() = 2 * ball.radius * ball.centre;
  local(3, 3) = ball.radius * ball.radius;
  return geometry::lorentz_inverse(cell.place) * of_model * local / ball.radius;
}

Colour wall_colour(ColourBy colour_by, const SceneCell& cell, std::size_t wall) {
  // M. Okabe, K. Ito, "Color universal design": without black, in an order of our own.
  const auto palette = [](std::uint32_t i) {
    const auto bytes = embedding::tetrahedron_colour(i);
    Colour colour;
    for (std::size_t k = 0; k < 3; ++k) colour[k] = static_cast<float>(bytes[k]) / 255;
    return colour;
  };
  constexpr Colour kPaper{0.94F, 0.93F, 0.89F}, kIce{0.76F, 0.87F, 0.96F};
  constexpr float kTint = 0.62F;
  constexpr Colour kGrey{0.72F, 0.73F, 0.74F};
  const Colour paper = is_horosphere(cell, wall) ? kIce : kPaper;
  if (colour_by == ColourBy::kFace)
    return is_truncation(wall) ? paper : palette(cell.face_class[wall]);
  if (colour_by == ColourBy::kComponent)
    return is_truncation(wall) ? palette(cell.vertex_class[wall - 4]) : kGrey;
  if (colour_by == ColourBy::kEdge) return is_truncation(wall) ? paper : kGrey;
  Colour colour = palette(cell.tetrahedron);
  if (colour_by == ColourBy::kDepth) {
    constexpr float kFade = 6;  // gluings after which the ramp is nearly at its end
    const float t = 1 - std::exp(-static_cast<float>(cell.depth) / kFade);
    colour =
        t < 0.5F ? mixed(palette(5), palette(2), 2 * t) : mixed(palette(2), palette(4), 2 * t - 1);
  }
  return is_truncation(wall) ? mixed(colour, paper, kTint) : colour;
}

}  // namespace tripus::viewer
