#include "viewer/faces/face_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "embedding/colour.hpp"
#include "viewer/faces/wall_outline.hpp"

namespace tripus::viewer {
namespace {

/// Length that nobody sees, in radii of the scene: some tenth of a pixel.
constexpr double kDetail = 5e-4;
/// Two faces are one if their middles are nearer than this, in radii of the face.
constexpr double kSamePlace = 1e-6;

}  // namespace

FaceSet::FaceSet(Model model, const Scene& scene, double scene_radius)
    : model_(model), walls_per_cell_(has_parabolic_edges(scene) ? kWallCount : kPlainWallCount) {
  const std::size_t count = walls_per_cell_ * scene.cells.size();
  faces_.reserve(count);
  half_spaces_.reserve(count);
  balls_.reserve(scene.cells.size());
  for (std::size_t number = 0; number < scene.cells.size(); ++number) {
    const SceneCell& cell = scene.cells[number];
    balls_.push_back(bounding_ball(model, cell));
    for (std::size_t wall = 0; wall < walls_per_cell_; ++wall) {
      const WallOutline outline = wall_outline(model, cell, wall, kDetail * scene_radius);
      SceneFace& face = faces_.emplace_back();
      face.cell = static_cast<std::uint32_t>(number);
      face.wall = static_cast<std::uint8_t>(wall);
      face.first_point = static_cast<std::uint32_t>(points_.size());
      face.point_count = static_cast<std::uint32_t>(outline.points.size());
      face.margin = static_cast<float>(outline.margin);
      face.ball = {outline.middle, outline.radius};
      for (const Vector3& p : outline.points) points_.emplace_back(p.cast<float>());
      half_spaces_.push_back(half_space(model, cell, wall));
      is_bent_ = is_bent_ || !half_spaces_.back().is_sphere();
    }
  }
  find_shared();
}

void FaceSet::find_shared() {
  // Along a line that no symmetry knows, the two sides of a face are neighbours.
  const Vector3 line(1, 0.6180339887, 0.3247179572);
  std::vector<std::pair<double, std::size_t>> order;
  double largest = 0;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (!is_face(faces_[i].wall)) continue;
    order.emplace_back(faces_[i].ball.centre.dot(line), i);
    largest = std::max(largest, faces_[i].ball.radius);
  }
  std::ranges::sort(order);
  for (std::size_t i = 0; i < order.size(); ++i) {
    SceneFace& face = faces_[order[i].second];
    const double reach = 2 * kSamePlace * face.ball.radius;
    for (std::size_t j = i + 1; j < order.size() && order[j].first - order[i].first <= reach; ++j) {
      SceneFace& other = faces_[order[j].second];
      if ((face.ball.centre - other.ball.centre).norm() > kSamePlace * face.ball.radius) continue;
      face.partner = other.cell;
      other.partner = face.cell;
      break;
    }
  }
}

std::vector<std::size_t> bounds_of_wall(std::size_t wall, bool with_edge_walls) {
  std::vector<std::size_t> bounds;
  const RecordKind kind = record_kind(wall);
  if (kind == RecordKind::kCut) {
    bounds.resize(bound_count(kind, with_edge_walls));
    std::iota(bounds.begin(), bounds.end(), std::size_t{0});
    return bounds;
  }
  if (kind == RecordKind::kEdgeWall) {
    const std::size_t edge = wall - kPlainWallCount;
    for (const std::size_t face : faces_at_edge(edge)) bounds.push_back(face);
    for (const std::size_t vertex : faces_at_edge(5 - edge)) bounds.push_back(4 + vertex);
    return bounds;
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (i != wall % 4) bounds.push_back(i);
  if (is_face(wall))
    for (std::size_t i = 0; i < 3; ++i) bounds.push_back(4 + bounds[i]);
  if (!with_edge_walls) return bounds;
  for (std::size_t i = 0; i < 3; ++i) {
    // Of a face: the edge that it has in common with the other one; of a truncation: the edge from
    // there to the vertex.
    const std::size_t edge = edge_between(wall % 4, bounds[i]);
    bounds.push_back(kPlainWallCount + (is_face(wall) ? 5 - edge : edge));
  }
  return bounds;
}

float edge_colours(const SceneCell& cell, std::size_t face) {
  const std::vector<std::size_t> bounds = bounds_of_wall(face);
  std::uint32_t packed = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<std::size_t, 2> ends{};  // the vertices on neither face
    std::size_t found = 0;
    for (std::size_t v = 0; v < 4; ++v)
      if (v != face && v != bounds[i]) ends.at(found++) = v;
    packed |= cell.edge_class[edge_between(ends[0], ends[1])] % embedding::kColourCount << 6 * i;
  }
  return static_cast<float>(packed);
}

void append_record(std::vector<float>& texels, const BoundingBall& cell_ball, const HalfSpace& own,
                   const std::vector<HalfSpace>& bounds, const FaceLook& look, bool is_bent) {
  const auto append = [&](double x) { texels.push_back(static_cast<float>(x)); };
  const auto append_slope = [&](const HalfSpace& local) {
    for (int k = 0; k < 3; ++k) append(local.b[k]);
    append(local.a);
  };
  const auto local = [&](const HalfSpace& h) {
    return in_local_frame(h, cell_ball.centre, cell_ball.radius);
  };
  append_slope(local(own));
  append(local(own).c);
  append(look.wall);
  append(look.shared ? 1 : 0);
  append(look.first_disc);
  for (int k = 0; k < 3; ++k) append(cell_ball.centre[k]);
  append(cell_ball.radius);
  for (const float part : look.colour) append(part);
  append(look.cell);
  for (const HalfSpace& h : bounds) append_slope(local(h));
  for (const HalfSpace& h : bounds) append(local(h).c);
  if (bounds.size() % 4 != 0) append(look.edge_colours);
  while (texels.size() % 4 != 0) append(0);
  if (!is_bent) return;
  const auto append_bend = [&](const HalfSpace& h) {
    for (int k = 0; k < 3; ++k) append(local(h).d[k]);
    append(0);
  };
  const RecordKind kind = record_kind(look.wall);
  if (kind == RecordKind::kTruncation || kind == RecordKind::kEdgeWall) append_bend(own);
  std::for_each(bounds.begin() + static_cast<std::ptrdiff_t>(flat_bounds(kind)), bounds.end(),
                append_bend);
}

}  // namespace tripus::viewer
