#pragma once

#include <array>
#include <span>
#include <string>

#include "viewer/scene_words.hpp"
#include "viewer/window/view_state.hpp"

namespace tripus::viewer {

/// What is written over a frame, beside what the view asks for.
struct Overlay {
  std::string status;                       ///< at the top
  std::string said;                         ///< at the bottom; may be empty
  std::span<const SceneLabel> labels = {};  ///< on cells and edges
  std::array<int, 2> picture = {};          ///< width and height, pixels
  std::array<int, 2> window = {};           ///< the same in the window's units
};

/// Draws texts, the slider of cells, the legend of discs and the help over the picture in the bound
/// framebuffer.
void draw_overlay(const Scene& scene, const ViewState& state, const Overlay& overlay);

}  // namespace tripus::viewer
