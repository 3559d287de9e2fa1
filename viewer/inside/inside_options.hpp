#pragma once

#include "viewer/inside/walk_camera.hpp"

namespace tripus::viewer {

/// What the picture from inside looks like; light and dark, lines and discs are those of
/// PictureOptions.
struct InsideOptions {
  Walker walker;
  double tube = 0.03;  ///< radius of the edges, hyperbolic
  double sight = 3.4;  ///< distance at which things fade
};

}  // namespace tripus::viewer
