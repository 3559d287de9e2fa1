#pragma once

#include <memory>

#include "viewer/inside/inside_options.hpp"
#include "viewer/picture.hpp"

namespace tripus::viewer {

/// What each pixel of a picture tells.
enum class Pixels {
  kColours,
  /// The number of the cell, from 1, in red and green, the lower byte first, and of its wall, from
  /// 1, in blue (9: the cut); 0 where there is none. One sample a pixel. Where a disc of
  /// Scene::discs is seen, 16 times its number in its tile, from 1 and at most 15, is added to
  /// blue.
  kIdentities,
};

/// Draws without a display, through EGL: by the driver in software if there is no other. One at a
/// time, each on one thread.
class OffscreenRenderer {
 public:
  /// Throws NoOpenGl where OpenGL is missing.
  OffscreenRenderer();
  ~OffscreenRenderer();
  OffscreenRenderer(const OffscreenRenderer&) = delete;
  OffscreenRenderer& operator=(const OffscreenRenderer&) = delete;

  /// The picture of a scene; alpha is 255. What is kept from the last scene makes the next picture
  /// of it faster. When options.stop ends it early, Image::cells_left cells are not
  /// drawn. Throws InvalidInput for what cannot be drawn (require_drawable).
  Image draw(const Scene& scene, const PictureOptions& options, int width, int height,
             Pixels pixels = Pixels::kColours);

  /// What one sees who stands in a manifold. Of the options those count that say so in
  /// InsideOptions. Identities: InsideRenderer::draw.
  /// Throws InvalidInput for a size out of range or a walker beyond a wall.
  Image draw_inside(const std::shared_ptr<const InsideManifold>& manifold,
                    const InsideOptions& inside, const PictureOptions& options, int width,
                    int height, Pixels pixels = Pixels::kColours);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// One picture from inside.
Image render_inside(const std::shared_ptr<const InsideManifold>& manifold,
                    const InsideOptions& inside, const PictureOptions& options, int width,
                    int height);

/// One picture.
Image render_picture(const Scene& scene, const PictureOptions& options, int width, int height,
                     Pixels pixels = Pixels::kColours);

}  // namespace tripus::viewer
