#pragma once

#include <string_view>

namespace tripus::viewer {

/// The most half-spaces of a product: 14 walls, the side of the model and the cut-away.
inline constexpr int kMostHalfSpaces = 16;

/// Shades a primitive of a cell where it is visible. Positions are in the cell's local frame.
extern const std::string_view kWallVertexShader;
extern const std::string_view kWallFragmentShader;

}  // namespace tripus::viewer
