#pragma once

#include <cstddef>
#include <vector>

#include "viewer/legend.hpp"

namespace tripus::viewer {

/// The slider of the number of cells, in the lower right corner of a window; all places are pixels
/// of the window from its top left corner. A step to the right is so many times more cells.
bool is_on_slider(double x, double y, int width, int height);

/// The number of cells, 1 to kMostCells, at a place across; beyond the ends those of the ends.
std::size_t slider_value(double x, int width, int height);

/// Its rectangles for a window, of `scale` pixels of the picture for one of the window.
std::vector<LegendRectangle> slider(std::size_t cells, int width, int height, float scale);

}  // namespace tripus::viewer
