#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "viewer/picture.hpp"
#include "viewer/scene_words.hpp"

namespace tripus::viewer {

/// A rectangle of one colour in a picture, pixels from its top left corner.
struct LegendRectangle {
  float left = 0, top = 0, right = 0, bottom = 0;
  std::array<std::uint8_t, 4> colour{};  ///< red, green, blue, alpha
};

/// What the colours of discs mean, for the lower left corner of a picture: a bar with lengths under
/// it, one thing drawn over the other. Nothing where the picture is too small to read it.
std::vector<LegendRectangle> legend_of(const WallDiscs& discs, int width, int height);

/// Labels on paper, their middles at their places.
///   scale  of the letters, 1: about 10 pixels high
std::vector<LegendRectangle> rectangles_of(std::span<const SceneLabel> labels, int scale);

/// Paints rectangles over a picture, one after the other.
void paint(Image& image, std::span<const LegendRectangle> rectangles);

/// Paints names of tetrahedra and edges over a picture.
///   identities  the same, drawn by Pixels::kIdentities with one sample
void add_labels(const Scene& scene, const PictureOptions& options, const Image& identities,
                Image& image);

/// Paints the legend of the scene's discs over a picture of it, if it shows them.
void add_legend(const Scene& scene, const PictureOptions& options, Image& image);

}  // namespace tripus::viewer
