#pragma once

#include <memory>

#include "viewer/picture.hpp"

namespace tripus::viewer {

/// Draws a scene in the OpenGL context that is current when it is made, and must be at every call
/// and when it ends. One thread, one renderer at a time: OpenCSG keeps its state in globals.
class Renderer {
 public:
  /// Throws NoOpenGl.
  Renderer();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Takes the scene to draw from now on, in a model; it is copied.
  void set_scene(const Scene& scene, Model model);

  struct Frame {
    int width = 0;
    int height = 0;
    int samples = 1;  ///< in the place of options.samples
    /// Instead of colours: the number of the cell, from 1, in red and green, the lower byte first,
    /// and the number of its wall, from 1, in blue (9: the cut-away); 0 where there is none. Where
    /// a disc is seen, 16 times its number in its tile, from 1 and at most 15, is added to blue.
    bool identities = false;
  };

  /// Draws into the framebuffer that is bound. `options.model` is that of the scene.
  /// Returns the number of cells left out because a stop was requested.
  /// Throws NoOpenGl if OpenGL reports an error.
  std::size_t draw(const PictureOptions& options, const Frame& frame);

  /// The ball around the scene that the camera looks at.
  const Ball& scene_ball() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace tripus::viewer
