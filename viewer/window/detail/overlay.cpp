#include "viewer/window/detail/overlay.hpp"

#include <algorithm>

#include "viewer/keys.hpp"
#include "viewer/legend.hpp"
#include "viewer/window/detail/text.hpp"
#include "viewer/window/slider.hpp"

namespace tripus::viewer {
namespace {

/// Breaks a text at blanks, where it can.
std::string in_lines(std::string text, std::size_t letters) {
  for (std::size_t begin = 0; begin + letters < text.size();) {
    std::size_t blank = text.rfind(' ', begin + letters);
    if (blank == std::string::npos || blank <= begin) blank = text.find(' ', begin + letters);
    if (blank == std::string::npos) break;
    text[blank] = '\n';
    begin = blank + 1;
  }
  return text;
}

}  // namespace

void draw_overlay(const Scene& scene, const ViewState& state, const Overlay& overlay) {
  const auto [width, height] = overlay.picture;
  const int scale = std::max(1, height / 500);
  const float line = 18.0F * static_cast<float>(scale);
  draw_text(overlay.status, 10, 10, scale, width, height);
  if (!overlay.said.empty()) {
    // Letters are some 6 wide; the slider is beside them.
    const auto letters = static_cast<std::size_t>(std::max(20, (width / scale - 250) / 6));
    const std::string lines = in_lines(overlay.said, letters);
    const auto count = 1 + std::ranges::count(lines, '\n');
    draw_text(lines, 10, static_cast<float>(height) - static_cast<float>(count) * line, scale,
              width, height);
  }
  draw_legend(slider(state.cells, overlay.window[0], overlay.window[1],
                     static_cast<float>(height) / static_cast<float>(overlay.window[1])),
              width, height);
  if (!overlay.labels.empty()) draw_legend(rectangles_of(overlay.labels, scale), width, height);
  if (scene.discs != nullptr && state.shown.discs)
    draw_legend(legend_of(*scene.discs, width, height), width, height);
  if (!state.help) return;
  const auto columns = window_help();
  draw_text(columns[0], 10, 10 + line, scale, width, height);
  draw_text(columns[1], 10 + 130.0F * static_cast<float>(scale), 10 + line, scale, width, height);
}

}  // namespace tripus::viewer
