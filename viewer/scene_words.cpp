#include "viewer/scene_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

#include <fmt/format.h>

namespace tripus::viewer {
namespace {

/// One number for each pair of glued faces, in the order in which they first appear.
std::vector<std::array<std::uint32_t, 4>> number_faces(const topology::Triangulation& m) {
  constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::vector<std::array<std::uint32_t, 4>> number(m.tetrahedron_count(),
                                                   {kNone, kNone, kNone, kNone});
  std::uint32_t next = 0;
  for (std::size_t t = 0; t < number.size(); ++t) {
    for (std::size_t f = 0; f < 4; ++f) {
      if (number[t][f] != kNone) continue;
      const int face = static_cast<int>(f);
      const auto glued = static_cast<std::size_t>(m.gluings().gluing(t, face)(face));
      number[t][f] = next;
      number[m.gluings().neighbour(t, face)][glued] = next++;
    }
  }
  return number;
}

/// Degrees.
double dihedral_angle(const SceneCell& cell, std::size_t face, std::size_t other) {
  const double cosine = -geometry::lorentz_product(cell.walls[face], cell.walls[other]);
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

/// The edge where two faces meet: its vertices are the other two.
std::string describe_edge(const Scene& scene, const SceneCell& cell, std::size_t face,
                          std::size_t other) {
  std::array<std::size_t, 2> ends{};
  std::size_t found = 0;
  for (std::size_t v = 0; v < 4; ++v)
    if (v != face && v != other) ends.at(found++) = v;
  const std::size_t edge = edge_between(ends[0], ends[1]);
  const std::uint32_t number = cell.edge_class[edge];
  if (parabolic_edge(cell, edge) != nullptr)
    return fmt::format("{}{} of class {} (parabolic)", ends[0], ends[1], number);
  std::string length;
  if (number < scene.edge_lengths.size())
    length = fmt::format("length {:.8g}, ", scene.edge_lengths[number]);
  return fmt::format("{}{} of class {} ({}angle {:.8g} degrees)", ends[0], ends[1], number, length,
                     dihedral_angle(cell, face, other));
}

/// What is seen of a cell.
struct Seen {
  std::size_t pixels = 0;
  double x = 0, y = 0;  ///< sums
};

/// Which cell a picture of identities shows, from 1, or 0.
std::size_t cell_at(const Image& image, int x, int y) {
  const auto seen = seen_at(image, x, y);
  return seen ? seen->cell + 1 : 0;
}

bool is_near(const Image& image, int x, int y, std::size_t cell) {
  for (int j = -2; j <= 2; ++j)
    for (int i = -2; i <= 2; ++i)
      if (cell_at(image, x + i, y + j) == cell) return true;
  return false;
}

/// A point in the middle of edge vw; of a parabolic edge in the middle of its wall.
Vector4 middle_of_edge(const SceneCell& cell, std::size_t v, std::size_t w) {
  const auto corner = [&](std::size_t i, std::size_t j) -> const Vector4& {
    return cell.corners[3 * i + j - (j > i ? 1 : 0)];
  };
  const Vector4 sum = corner(v, w) + corner(w, v);
  if (const ParabolicEdge* const parabolic = parabolic_edge(cell, edge_between(v, w)))
    return geometry::on_horosphere(sum / 2, parabolic->wall);
  return sum / std::sqrt(-geometry::lorentz_product(sum, sum));
}

/// Whether an edge is on the side of its cell that turns to the eye, seen from a pixel at its
/// middle: one of its faces turns there, or, if it is parabolic, its wall is seen.
bool is_seen(const Image& image, int x, int y, const SceneCell& cell, std::size_t number,
             std::size_t edge, Model model, const Vector3& eye) {
  if (parabolic_edge(cell, edge) == nullptr)
    return std::ranges::any_of(faces_at_edge(edge), [&](std::size_t face) {
      return half_space(model, cell, face)(eye) > 0;
    });
  const auto seen = seen_at(image, x, y);
  return seen && seen->cell + 1 == number && seen->wall == kPlainWallCount + edge;
}

}  // namespace

void add_classes(Scene& scene, const topology::Triangulation& triangulation,
                 std::span<const double> edge_lengths) {
  const auto faces = number_faces(triangulation);
  for (SceneCell& cell : scene.cells) {
    const std::size_t t = cell.tetrahedron;
    cell.face_class = faces[t];
    for (std::size_t v = 0; v < 4; ++v)
      cell.vertex_class[v] = triangulation.vertex_classes()[4 * t + v];
    for (std::size_t e = 0; e < 6; ++e)
      cell.edge_class[e] = triangulation.edge_classes()[6 * t + e];
  }
  scene.edge_lengths.assign(edge_lengths.begin(), edge_lengths.end());
}

std::string describe(const Scene& scene, std::size_t cell_number, std::size_t wall) {
  const SceneCell& cell = scene.cells.at(cell_number);
  std::string text = fmt::format("tetrahedron {}", cell.tetrahedron);
  if (wall >= kWallCount) return text + ", cut";
  if (is_edge_wall(wall)) {
    const std::size_t edge = wall - kPlainWallCount;
    return text + fmt::format(", horosphere of the parabolic edge {}{} of class {}",
                              topology::kEdgeEnds[edge][0], topology::kEdgeEnds[edge][1],
                              cell.edge_class[edge]);
  }
  if (is_horosphere(cell, wall)) {
    return text + fmt::format(", horosphere {} of cusp {}", wall - 4, cell.vertex_class[wall - 4]);
  }
  if (is_truncation(wall)) {
    return text + fmt::format(", truncation {} of boundary component {}", wall - 4,
                              cell.vertex_class[wall - 4]);
  }
  text += fmt::format(", face {}; edges", wall);
  const char* before = " ";
  for (std::size_t other = 0; other < 4; ++other) {
    if (other == wall) continue;
    text += before + describe_edge(scene, cell, wall, other);
    before = ", ";
  }
  return text;
}

std::optional<SeenWall> seen_at(const Image& identities, int x, int y) {
  if (x < 0 || y < 0 || x >= identities.width || y >= identities.height) return std::nullopt;
  const std::uint8_t* const pixel =
      identities.pixels.data() +
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(identities.width) +
           static_cast<std::size_t>(x));
  const std::size_t cell = pixel[0] + 256U * pixel[1];
  if (cell == 0) return std::nullopt;
  return SeenWall{cell - 1, (pixel[2] & 15U) - 1};
}

std::vector<SceneLabel> labels_of(const Scene& scene, const PictureOptions& options,
                                  const Image& identities) {
  std::map<std::size_t, Seen> seen;
  for (int y = 0; y < identities.height; ++y) {
    for (int x = 0; x < identities.width; ++x) {
      const std::size_t cell = cell_at(identities, x, y);
      if (cell == 0 || cell > scene.cells.size()) continue;
      Seen& here = seen[cell];
      ++here.pixels;
      here.x += x;
      here.y += y;
    }
  }
  const View view =
      view_of(options.camera, options.model, scene, identities.width, identities.height);
  const Eigen::Matrix4d to_clip = view.projection * view.model_view;
  std::vector<SceneLabel> labels;
  const auto add = [&](double x, double y, std::string text) {
    for (const SceneLabel& label : labels)
      if (std::abs(label.x - x) < 22 && std::abs(label.y - y) < 12) return;
    labels.push_back({static_cast<float>(x), static_cast<float>(y), std::move(text)});
  };
  constexpr std::size_t kReadable = 500;  // pixels
  for (const auto& [number, here] : seen) {
    if (here.pixels < kReadable) continue;
    const SceneCell& cell = scene.cells[number - 1];
    const auto count = static_cast<double>(here.pixels);
    const double x = here.x / count, y = here.y / count;
    if (is_near(identities, static_cast<int>(x), static_cast<int>(y), number))
      add(x, y, fmt::format("{}", cell.tetrahedron));
    for (std::size_t v = 0; v < 4; ++v) {
      for (std::size_t w = v + 1; w < 4; ++w) {
        const std::size_t edge = edge_between(v, w);
        const Vector3 middle = geometry::to_model(options.model, middle_of_edge(cell, v, w));
        const Vector4 clip = to_clip * Vector4(middle.x(), middle.y(), middle.z(), 1);
        const double px = (clip[0] / clip[3] + 1) / 2 * identities.width;
        const double py = (1 - clip[1] / clip[3]) / 2 * identities.height;
        if (!(clip[3] > 0 && px >= 0 && py >= 0 && px < identities.width && py < identities.height))
          continue;
        // An edge is seen where its cell is seen around its middle, and one of its faces turns
        // towards the eye.
        if (!is_near(identities, static_cast<int>(px), static_cast<int>(py), number)) continue;
        if (is_seen(identities, static_cast<int>(px), static_cast<int>(py), cell, number, edge,
                    options.model, view.eye))
          add(px, py, fmt::format("e{}", cell.edge_class[edge]));
      }
    }
  }
  return labels;
}

}  // namespace tripus::viewer
