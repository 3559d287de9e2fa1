#pragma once

#include <memory>

#include "viewer/detail/compose.hpp"
#include "viewer/picture.hpp"

namespace tripus::viewer {

/// Draws a scene as the founding paper does, by image-based CSG, in the OpenGL context that is
/// current when it is made, and must be at every call and when it ends. One thread, one of them at
/// a time: OpenCSG keeps its state in globals.
class OpenCsgRenderer {
 public:
  /// Throws NoOpenGl.
  OpenCsgRenderer();
  ~OpenCsgRenderer();
  OpenCsgRenderer(const OpenCsgRenderer&) = delete;
  OpenCsgRenderer& operator=(const OpenCsgRenderer&) = delete;

  /// Takes the scene to draw from now on, in a model; it is copied.
  void set_scene(const Scene& scene, Model model);

  /// Draws colours and depths of cells into what Composer has bound. `options.model` is that of
  /// the scene. Returns the number of cells left out because a stop was requested.
  std::size_t draw(const PictureOptions& options, const Frame& frame, const View& view);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace tripus::viewer
