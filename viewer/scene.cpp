#include "viewer/scene.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "base/error.hpp"
#include "embedding/colour.hpp"
#include "topology/triangulation.hpp"

namespace tripus::viewer {
namespace {

/// Points bulge beyond the samples of a wall by at most this part of the ball's radius.
constexpr double kBulge = 1.02;

Colour mixed(const Colour& from, const Colour& to, float t) {
  Colour result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = (1 - t) * from[i] + t * to[i];
  return result;
}

/// Where edge vw meets truncation v in a face that has it: if the edge is parabolic, where its wall
/// does.
const Vector4& corner_in_face(const SceneCell& cell, std::size_t v, std::size_t w,
                              std::size_t face) {
  const std::size_t edge = edge_between(v, w);
  const ParabolicEdge* const parabolic = parabolic_edge(cell, edge);
  if (parabolic == nullptr) return cell.corners[3 * v + w - (w > v ? 1 : 0)];
  const bool first_face = face == faces_at_edge(edge)[0];
  return parabolic->corners[v < w ? (first_face ? 0 : 3) : (first_face ? 1 : 2)];
}

/// The parabolic edges of a tetrahedron, where they are in a scene.
std::vector<ParabolicEdge> parabolic_edges_of(const geometry::HyperboloidTetrahedron& shape,
                                              const geometry::Matrix4& place) {
  std::vector<ParabolicEdge> result;
  for (std::size_t e = 0; e < 6; ++e) {
    if (!shape.is_parabolic(e)) continue;
    const auto [v, w] = topology::kEdgeEnds[e];
    const auto [k, l] = topology::kEdgeEnds[5 - e];
    ParabolicEdge& edge = result.emplace_back();
    edge.edge = static_cast<std::uint8_t>(e);
    edge.wall = place * shape.parabolic_point(e);
    edge.corners = {place * geometry::parabolic_corner(shape, v, w, k),
                    place * geometry::parabolic_corner(shape, w, v, k),
                    place * geometry::parabolic_corner(shape, w, v, l),
                    place * geometry::parabolic_corner(shape, v, w, l)};
  }
  return result;
}

}  // namespace

Vector4 drawn_corner(const geometry::HyperboloidTetrahedron& shape, int v, int w) {
  const std::size_t edge = edge_between(static_cast<std::size_t>(v), static_cast<std::size_t>(w));
  if (!shape.is_parabolic(edge)) return geometry::corner(shape, v, w);
  const auto [k, l] = topology::kEdgeEnds[5 - edge];
  return geometry::on_horosphere(
      (geometry::parabolic_corner(shape, v, w, k) + geometry::parabolic_corner(shape, v, w, l)) / 2,
      shape.parabolic_point(edge));
}

const ParabolicEdge* parabolic_edge(const SceneCell& cell, std::size_t edge) {
  for (const ParabolicEdge& one : cell.parabolic_edges)
    if (one.edge == edge) return &one;
  return nullptr;
}

const Vector4& wall_vector(const SceneCell& cell, std::size_t wall) {
  return is_edge_wall(wall) ? parabolic_edge(cell, wall - kPlainWallCount)->wall : cell.walls[wall];
}

bool have_same_walls(const SceneCell& a, const SceneCell& b) {
  return a.walls == b.walls && a.diagonal == b.diagonal &&
         std::ranges::equal(a.parabolic_edges, b.parabolic_edges,
                            [](const ParabolicEdge& one, const ParabolicEdge& other) {
                              return one.edge == other.edge && one.wall == other.wall;
                            });
}

std::vector<Vector4> corners_of_wall(const SceneCell& cell, std::size_t wall) {
  std::vector<Vector4> result;
  if (is_edge_wall(wall)) {
    const ParabolicEdge& edge = *parabolic_edge(cell, wall - kPlainWallCount);
    result.assign(edge.corners.begin(), edge.corners.end());
    return result;
  }
  std::array<std::size_t, 3> around{};
  for (std::size_t v = 0, found = 0; v < 4; ++v)
    if (v != wall % 4) around.at(found++) = v;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t before = around[(i + 2) % 3], here = around[i], after = around[(i + 1) % 3];
    if (is_face(wall)) {
      result.push_back(corner_in_face(cell, here, before, wall));
      result.push_back(corner_in_face(cell, here, after, wall));
      continue;
    }
    const std::size_t v = wall - 4;  // face `after` comes from `before`, and face `before` follows
    result.push_back(corner_in_face(cell, v, here, after));
    if (parabolic_edge(cell, edge_between(v, here)) != nullptr)
      result.push_back(corner_in_face(cell, v, here, before));
  }
  return result;
}

bool has_parabolic_edges(const Scene& scene) {
  return std::ranges::any_of(scene.cells,
                             [](const SceneCell& cell) { return !cell.parabolic_edges.empty(); });
}

HalfSpace half_space(Model model, const SceneCell& cell, std::size_t wall) {
  if (!has_wall(cell, wall)) return {0, {1e-6, 0, 0}, -1};
  return is_horosphere(cell, wall) ? horosphere(model, wall_vector(cell, wall))
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
    for (std::size_t i = 0; i < 4; ++i) {
      cell.walls[i] = place * shape.faces[i];
      cell.walls[4 + i] = place * shape.vertices[i];
    }
    std::size_t next = 0;
    for (int v = 0; v < 4; ++v)
      for (int w = 0; w < 4; ++w)
        if (w != v) cell.corners[next++] = place * drawn_corner(shape, v, w);
    if (shape.parabolic_edges != 0) cell.parabolic_edges = parabolic_edges_of(shape, place);
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
    for (ParabolicEdge& edge : cell.parabolic_edges) {
      edge.wall = isometry * edge.wall;
      for (Vector4& corner : edge.corners) corner = isometry * corner;
    }
    cell.place = isometry * cell.place;
  }
  return result;
}

std::size_t edge_between(std::size_t vertex, std::size_t other) {
  const std::size_t low = std::min(vertex, other), high = std::max(vertex, other);
  return low == 0 ? high - 1 : low + high;
}

std::array<std::size_t, 2> faces_at_edge(std::size_t edge) {
  const auto [k, l] = topology::kEdgeEnds[5 - edge];
  return {static_cast<std::size_t>(k), static_cast<std::size_t>(l)};
}

geometry::Matrix4 default_frame(Model model, const embedding::Embedding& embedding,
                                std::uint32_t root) {
  using geometry::lorentz_product;
  if (model != Model::kUpperHalfSpace) return geometry::Matrix4::Identity();
  // An orthonormal frame at the middle of the edge, its third vector along it, its first towards
  // the middle of the cell; its inverse brings it to the axes.
  const geometry::HyperboloidTetrahedron& shape = embedding.tetrahedra[root];
  constexpr std::array<std::size_t, 6> kInTurn{2, 0, 1, 3, 4, 5};
  const auto edge =
      std::ranges::find_if(kInTurn, [&](std::size_t e) { return !shape.is_parabolic(e); });
  if (edge == kInTurn.end()) return geometry::Matrix4::Identity();
  const auto [below, above] = topology::kEdgeEnds[*edge];
  const Vector4 upper = geometry::corner(shape, above, below),
                lower = geometry::corner(shape, below, above);
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
    const std::vector<Vector4> around = corners_of_wall(cell, wall);
    Vector4 middle = Vector4::Zero();
    for (const Vector4& corner : around) middle += corner;
    middle /= static_cast<double>(around.size());
    add(middle);
    for (std::size_t k = 0; k < around.size(); ++k) {
      const Vector4 &a = around[k], &b = around[(k + 1) % around.size()];
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
  for (const SceneCell& cell : scene.cells) {
    for (const Vector4& corner : cell.corners) points.push_back(geometry::to_model(model, corner));
    for (const ParabolicEdge& edge : cell.parabolic_edges)
      for (const Vector4& corner : edge.corners)
        points.push_back(geometry::to_model(model, corner));
  }
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
  if (colour_by == ColourBy::kFace) return is_face(wall) ? palette(cell.face_class[wall]) : paper;
  if (colour_by == ColourBy::kComponent) {
    // Colours of components are counted from the first on, those of annular cusps from the last.
    if (is_edge_wall(wall)) {
      const std::uint32_t edge = cell.edge_class[wall - kPlainWallCount];
      return palette(embedding::kColourCount - 1 - edge % embedding::kColourCount);
    }
    return is_truncation(wall) ? palette(cell.vertex_class[wall - 4]) : kGrey;
  }
  if (colour_by == ColourBy::kEdge) return is_face(wall) ? kGrey : paper;
  Colour colour = palette(cell.tetrahedron);
  if (colour_by == ColourBy::kDepth) {
    constexpr float kFade = 6;  // gluings after which the ramp is nearly at its end
    const float t = 1 - std::exp(-static_cast<float>(cell.depth) / kFade);
    colour =
        t < 0.5F ? mixed(palette(5), palette(2), 2 * t) : mixed(palette(2), palette(4), 2 * t - 1);
  }
  return is_face(wall) ? colour : mixed(colour, paper, kTint);
}

}  // namespace tripus::viewer
