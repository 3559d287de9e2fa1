#pragma once

#include <memory>

#include "viewer/detail/compose.hpp"
#include "viewer/picture.hpp"

namespace tripus::viewer {

class FacesRenderer;
class OpenCsgRenderer;

/// Draws a scene by the renderer that options.renderer names, in the OpenGL context that is current
/// at every call and when it ends. One at a time, on one thread.
class Renderer {
 public:
  /// Throws NoOpenGl.
  Renderer();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Takes the scene to draw from now on, in a model; it is copied.
  void set_scene(const Scene& scene, Model model);

  /// Draws into the framebuffer that is bound. `options.model` is that of the scene.
  /// Returns the number of cells left out because a stop was requested.
  /// Throws NoOpenGl if OpenGL is missing, cannot do what the renderer needs, or reports an error.
  std::size_t draw(const PictureOptions& options, const Frame& frame);

  /// The ball around the scene that the camera looks at.
  const Ball& scene_ball() const { return ball_; }

 private:
  /// Makes the renderer, and tells it of the scene, if it does not know it.
  void take_scene(RendererKind kind);

  Composer composer_;
  Scene scene_;
  Model model_ = Model::kUpperHalfSpace;
  Ball ball_;
  double reach_ = 0;  // of cells around its middle, where they were moved; else 0
  std::unique_ptr<FacesRenderer> faces_;
  std::unique_ptr<OpenCsgRenderer> opencsg_;
  bool known_ = false;       // whether there is a scene
  bool faces_know_ = false;  // it
  bool opencsg_knows_ = false;
};

}  // namespace tripus::viewer
