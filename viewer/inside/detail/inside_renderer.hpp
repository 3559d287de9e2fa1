#pragma once

#include <memory>

#include "viewer/detail/compose.hpp"
#include "viewer/detail/drawn_discs.hpp"
#include "viewer/detail/gl.hpp"
#include "viewer/inside/inside_options.hpp"

namespace tripus::viewer {

/// Draws what one sees along geodesics who stands in a manifold: web/inside.frag.glsl, as in pages.
/// It needs the OpenGL context that is current at every call and when it ends.
class InsideRenderer {
 public:
  /// Throws NoOpenGl.
  InsideRenderer();

  /// Takes a manifold from now on. Throws NoOpenGl where the card cannot hold it.
  void set_manifold(std::shared_ptr<const InsideManifold> manifold);

  /// Draws into the framebuffer that is bound: with frame.samples, so many pictures in each
  /// direction whose rays go through the pixels at other places, and their mean. Identities, frame
  /// bytes: what is met (0 nothing, 1 a wall, 2 an edge); the lower byte of the tetrahedron's
  /// number; the number of the vertex or edge (4 + that of a parabolic edge), and 16 times that of
  /// the disc.
  void draw(const PictureOptions& options, const InsideOptions& inside, const Frame& frame);

 private:
  void draw_sample(const PictureOptions& options, const InsideOptions& inside, const Frame& frame,
                   double jitter_x, double jitter_y) const;

  std::shared_ptr<const InsideManifold> manifold_;
  int kinds_ = 0;  // InsideManifold::kinds() of the program
  GlProgram program_;
  GlTexture records_;
  DrawnDiscs discs_;
  // Sums of pictures need more than eight bits.
  GlTexture sum_;
  GlFramebuffer sum_buffer_;
  int sum_width_ = 0, sum_height_ = 0;
};

}  // namespace tripus::viewer
