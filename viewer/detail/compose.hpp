#pragma once

#include <array>

#include "viewer/detail/gl.hpp"
#include "viewer/picture.hpp"

namespace tripus::viewer {

/// One frame to draw.
struct Frame {
  int width = 0;
  int height = 0;
  int samples = 1;  ///< in the place of options.samples
  /// Instead of colours: the number of the cell, from 1, in red and green, the lower byte first,
  /// and the number of its wall, from 1, in blue (9: the cut-away); 0 where there is none. Where
  /// a disc is seen, 16 times its number in its tile, from 1 and at most 15, is added to blue.
  bool identities = false;
};

/// Every renderer draws colours and depths of cells between begin() and finish(), which puts the
/// picture together: background, darkened nooks, samples.
class Composer {
 public:
  /// Binds cleared textures to draw into, of frame.samples times the frame's sides.
  void begin(const Frame& frame);

  /// Draws the picture into the framebuffer that was bound at begin().
  ///   scene  the ball that the view looks at
  void finish(const PictureOptions& options, const Frame& frame, const View& view,
              const Ball& scene);

 private:
  void make_programs(int samples, const PictureOptions& options);
  void find_openness(double reach, const View& view, int samples);

  RenderTarget target_;
  RenderTarget openness_;
  GLint picture_ = 0;
  GlProgram program_;
  GlProgram openness_program_;
  std::array<int, 4> made_{};  // what the programs were made for
};

/// Throws NoOpenGl if OpenGL reports an error.
void require_no_error();

/// The uniforms of a program, by name.
struct Uniform {
  GLuint program;
  GLint at(const char* name) const { return glGetUniformLocation(program, name); }
};

}  // namespace tripus::viewer
