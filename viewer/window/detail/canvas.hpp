#pragma once

#include "viewer/detail/gl.hpp"
#include "viewer/detail/renderer.hpp"
#include "viewer/inside/detail/inside_renderer.hpp"

namespace tripus::viewer {

/// Draws scenes into a window's framebuffer; it needs the window's OpenGL.
class Canvas {
 public:
  /// Takes the scene to draw from now on, in a model; it is copied.
  void set_scene(const Scene& scene, Model model) { renderer_.set_scene(scene, model); }

  /// The ball around the scene that the camera looks at.
  const BoundingBall& scene_ball() const { return renderer_.scene_ball(); }

  /// Shows from now on what one sees who stands in a manifold, or the scene again.
  void look_from_inside(const std::shared_ptr<const InsideManifold>& manifold,
                        const InsideOptions& inside);
  void look_from_outside() { is_inside_ = false; }

  /// Draws a frame of width x height pixels.
  ///   quality  the share of the pixels across that are drawn, in (0, 1]
  ///   samples  a pixel, in each direction
  void draw(const PictureOptions& shown, int width, int height, double quality, int samples);

  /// Which cells and walls the pixels of the frame show, or what InsideRenderer says; what is in
  /// the window stays.
  Image identities(const PictureOptions& shown, int width, int height);

 private:
  void draw_frame(const PictureOptions& shown, const Frame& frame);

  Renderer renderer_;
  std::unique_ptr<InsideRenderer> inside_renderer_;
  InsideOptions inside_;
  bool is_inside_ = false;
  RenderTarget coarse_;  // what is drawn into where quality < 1
};

}  // namespace tripus::viewer
