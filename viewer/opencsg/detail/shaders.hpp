#pragma once

#include <string_view>

namespace tripus::viewer {

/// The most half-spaces of a product: 8 walls, the side of the model and the cut-away.
inline constexpr int kMostHalfSpaces = 10;

/// Of the texture that holds the discs, two texels each: centre; colour and extent, which is
/// negative behind the last disc of a tile.
inline constexpr int kDiscTexelsPerRow = 1024;

/// Shades a primitive of a cell where it is visible. Positions are in the cell's local frame.
extern const std::string_view kWallVertexShader;
extern const std::string_view kWallFragmentShader;

/// Puts a picture together from its colours and depths: background, darkened nooks, and as many
/// samples a pixel as the drawn textures are larger.
extern const std::string_view kComposeVertexShader;
extern const std::string_view kComposeFragmentShader;

}  // namespace tripus::viewer
