#pragma once

#include <span>
#include <string>

#include "viewer/legend.hpp"

namespace tripus::viewer {

/// Draws text over the picture in the bound framebuffer.
///   x, y   of its top left corner, pixels from that of the framebuffer
///   scale  of the letters, 1: about 10 pixels high
void draw_text(const std::string& text, float x, float y, int scale, int width, int height);

/// Draws a legend over it.
void draw_legend(std::span<const LegendRectangle> rectangles, int width, int height);

}  // namespace tripus::viewer
