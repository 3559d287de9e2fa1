#include "viewer/window/detail/overlay.hpp"

#include <algorithm>

#include "viewer/keys.hpp"
#include "viewer/legend.hpp"
#include "viewer/window/detail/text.hpp"
#include "viewer/window/slider.hpp"

namespace tripus::viewer {
namespace {

/// A line and a letter of the font, about, at the scale 1.
constexpr int kLine = 12;
constexpr double kLetter = 6.2;
/// The help's texts begin so far to the right of its keys.
constexpr int kHelpColumn = 130;

std::size_t whole(double count) { return static_cast<std::size_t>(std::max(count, 0.0)); }

}  // namespace

void draw_overlay(const Scene& scene, const ViewState& state, const Overlay& overlay) {
  const auto [width, height] = overlay.picture;
  const int scale = std::max(1, std::min(width, height) / 500);
  const int across = width / scale, up = height / scale;
  const auto at = [&](int pixels) { return static_cast<float>(pixels * scale); };
  draw_text(overlay.status, at(10), at(10), scale, width, height);
  // In small windows the help takes its place.
  if (!overlay.said.empty() && (!state.help || up > 450)) {
    // Beside the slider or, where that leaves too little, above it.
    const bool beside = across > 560;
    const std::string lines = broken_at_blanks(
        overlay.said, whole((across - (beside ? 250 : 20)) / kLetter), whole(0.5 * up / kLine));
    const auto count = 1 + static_cast<int>(std::ranges::count(lines, '\n'));
    draw_text(lines, at(10), at(up - kLine * count - (beside ? 6 : 36)), scale, width, height);
  }
  draw_legend(slider(state.cells, overlay.window[0], overlay.window[1],
                     static_cast<float>(height) / static_cast<float>(overlay.window[1])),
              width, height);
  if (!overlay.labels.empty()) draw_legend(rectangles_of(overlay.labels, scale), width, height);
  if (scene.discs != nullptr && state.shown.discs)
    draw_legend(legend_of(*scene.discs, width, height), width, height);
  if (!state.help) return;
  const auto columns =
      window_help(whole((across - kHelpColumn - 20) / kLetter), whole((up - 40.0) / kLine));
  draw_text(columns[0], at(10), at(28), scale, width, height);
  draw_text(columns[1], at(10 + kHelpColumn), at(28), scale, width, height);
}

}  // namespace tripus::viewer
