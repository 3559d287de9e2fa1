#include "viewer/picture.hpp"

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

}  // namespace

void require_drawable(const Scene& scene, const PictureOptions& options, int width, int height) {
  require(width >= 1 && height >= 1 && width <= kLargestSide && height <= kLargestSide,
          "a picture of " + std::to_string(width) + "x" + std::to_string(height) +
              " pixels: sides go from 1 to " + std::to_string(kLargestSide));
  require(
      !scene.cells.empty() && scene.cells.size() <= kMostCells,
      std::to_string(scene.cells.size()) + " cells: draw from 1 to " + std::to_string(kMostCells));
  const Camera& camera = options.camera;
  require(std::isfinite(camera.azimuth), "the camera's azimuth is no number");
  require(std::abs(camera.elevation) <= 89, "the camera's elevation is " +
                                                in_words(camera.elevation) +
                                                ": it goes from -89 to 89 degrees");
  require(camera.distance >= kClosestDistance && camera.distance <= kFarthestDistance,
          "the camera's distance is " + in_words(camera.distance) + ": it goes from " +
              in_words(kClosestDistance) + " to " + in_words(kFarthestDistance) +
              " radii of the scene");
  require(std::isfinite(camera.zoom) && camera.zoom > 0 && camera.shift.allFinite(),
          "the camera's zoom is not positive, or its shift no number");
  require(!options.cut_away || std::isfinite(*options.cut_away), "the cut-away is no number");
  require(
      options.renderer == RendererKind::kFaces ||
          (!options.transparent && options.colour_by != ColourBy::kEdge && !scene.focus),
      "the renderer opencsg knows no transparent tetrahedra, no colours of edges and no Moebius "
      "moves; the renderer faces does");
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
