#pragma once

#include "viewer/picture.hpp"

namespace tripus::viewer {

/// Draws a scene without a display, through EGL, by the driver in software if there is no other.
/// With `identities` the pixels are those of Renderer::Frame::identities and alpha is 255.
/// Throws InvalidInput for what cannot be drawn (require_drawable), and NoOpenGl, an Unsupported,
/// where OpenGL is missing.
Image render_picture(const Scene& scene, const PictureOptions& options, int width, int height,
                     bool identities = false);

}  // namespace tripus::viewer
