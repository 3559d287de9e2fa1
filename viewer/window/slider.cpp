#include "viewer/window/slider.hpp"

#include <algorithm>
#include <cmath>

namespace tripus::viewer {
namespace {

struct Track {
  double left, right, middle;
};

Track track_of(int width, int height) {
  const double length = std::min(200.0, 0.4 * width);
  return {width - 20 - length, width - 20.0, height - 20.0};
}

const double kMost = std::log(static_cast<double>(kMostCells));

}  // namespace

bool is_on_slider(double x, double y, int width, int height) {
  const Track track = track_of(width, height);
  return x > track.left - 10 && x < track.right + 10 && std::abs(y - track.middle) < 10;
}

std::size_t slider_value(double x, int width, int height) {
  const Track track = track_of(width, height);
  const double share = std::clamp((x - track.left) / (track.right - track.left), 0.0, 1.0);
  return static_cast<std::size_t>(std::lround(std::exp(share * kMost)));
}

std::vector<LegendRectangle> slider(std::size_t cells, int width, int height, float scale) {
  const Track track = track_of(width, height);
  const double share = std::log(static_cast<double>(cells)) / kMost;
  const auto at = [&](double x) { return static_cast<float>(x) * scale; };
  const double handle = track.left + share * (track.right - track.left);
  return {{at(track.left - 10),
           at(track.middle - 10),
           at(track.right + 10),
           at(track.middle + 10),
           {255, 255, 255, 190}},
          {at(track.left),
           at(track.middle - 1),
           at(track.right),
           at(track.middle + 1),
           {120, 130, 140, 255}},
          {at(handle - 4),
           at(track.middle - 7),
           at(handle + 4),
           at(track.middle + 7),
           {33, 41, 51, 255}}};
}

}  // namespace tripus::viewer
