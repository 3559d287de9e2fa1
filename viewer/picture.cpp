#include "viewer/picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/error.hpp"

namespace tripus::viewer {
namespace {

void require(bool holds, const std::string& message) {
  if (!holds) throw InvalidInput(message);
}

std::string in_words(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

/// Whether the ball around the cells reaches into the picture.
bool is_in_picture(const Scene& scene, const PictureOptions& options, int width, int height) {
  const Camera& camera = options.camera;
  const BoundingBall focus = focus_of(options.model, scene);
  const double away = camera.distance * focus.radius;
  const double around = std::max(focus.radius, reach_of(options.model, scene, focus));
  if (away <= around) return true;
  const View view = view_of(camera, options.model, scene, width, height);
  // In halves of the picture's height.
  const double radius =
      2 * around / std::sqrt((away - around) * (away + around)) / view.height_at_one;
  const double aside = std::abs(camera.shift.x()) - static_cast<double>(width) / height;
  const double above = std::abs(camera.shift.y()) - 1;
  return std::hypot(std::max(aside, 0.0), std::max(above, 0.0)) < radius;
}

}  // namespace

void require_size(int width, int height) {
  require(width >= 1 && height >= 1 && width <= kLargestSide && height <= kLargestSide,
          "a picture of " + std::to_string(width) + "x" + std::to_string(height) +
              " pixels: sides go from 1 to " + std::to_string(kLargestSide));
}

void require_drawable(const Scene& scene, const PictureOptions& options, int width, int height) {
  require_size(width, height);
  require(!scene.cells.empty() && scene.cells.size() <= kMostDrawnCells,
          std::to_string(scene.cells.size()) + " cells: draw from 1 to " +
              std::to_string(kMostDrawnCells));
  const Camera& camera = options.camera;
  require(std::isfinite(camera.azimuth), "the camera's azimuth is no number");
  require(std::abs(camera.elevation) <= 89, "the camera's elevation is " +
                                                in_words(camera.elevation) +
                                                ": it goes from -89 to 89 degrees");
  require(camera.distance >= kClosestDistance && camera.distance <= kFarthestDistance,
          "the camera's distance is " + in_words(camera.distance) + ": it goes from " +
              in_words(kClosestDistance) + " to " + in_words(kFarthestDistance) +
              " radii of the scene");
  require(camera.zoom >= kLeastZoom && camera.zoom <= kMostZoom,
          "the camera's zoom is " + in_words(camera.zoom) + ": it goes from " +
              in_words(kLeastZoom) + " to " + in_words(kMostZoom));
  require(camera.shift.allFinite() && is_in_picture(scene, options, width, height),
          "the camera's shift leaves no cell in the picture: it is in halves of the picture's "
          "height");
  require(!options.cut_away || std::isfinite(*options.cut_away), "the cut-away is no number");
  require(
      options.renderer == RendererKind::kFaces ||
          (!options.transparent && options.colour_by != ColourBy::kEdge && options.lines &&
           !scene.focus),
      "the renderer opencsg knows no transparent tetrahedra, no colours of edges, no cells without "
      "lines and no Moebius moves; the renderer faces does");
  require(options.renderer == RendererKind::kFaces || options.model != Model::kKleinBall ||
              std::ranges::none_of(scene.cells,
                                   [](const SceneCell& cell) {
                                     return !cell.parabolic_edges.empty() ||
                                            std::ranges::find(cell.diagonal, 0.0) !=
                                                cell.diagonal.end();
                                   }),
          "the renderer opencsg draws spheres and planes, and horospheres of the Klein ball are "
          "neither; the renderer faces draws them, and opencsg does in the other models");
  require(!options.transparent || *options.transparent < scene.tetrahedron_count,
          "there is no tetrahedron " + std::to_string(options.transparent.value_or(0)) +
              " to be transparent: they go from 0 to " +
              std::to_string(scene.tetrahedron_count - 1));
  require(options.samples >= 0 && options.samples <= 4,
          std::to_string(options.samples) + " samples a pixel: ask for up to 4");
  require(options.faces || options.truncations,
          "without faces and without truncations there is nothing to draw");
}

}  // namespace tripus::viewer
