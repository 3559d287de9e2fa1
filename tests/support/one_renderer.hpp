#pragma once

#include "viewer/egl/offscreen.hpp"

namespace tripus::viewer {

/// One renderer for all tests: a context costs more than a small picture, and OpenCSG knows one.
inline OffscreenRenderer& one_renderer() {
  static OffscreenRenderer renderer;
  return renderer;
}

}  // namespace tripus::viewer
