#pragma once

#include <vector>

#include "viewer/detail/compose.hpp"
#include "viewer/detail/gl.hpp"
#include "viewer/faces/proxies.hpp"

namespace tripus::viewer {

/// A texture of so many numbers, four a texel, in the rows that the shaders know.
GlTexture number_texture(std::vector<float> numbers);

/// Where polygons go to be drawn.
class MeshBuffers {
 public:
  MeshBuffers();
  /// Draws with the program in use, whose attribute 0 are the corners.
  void draw(const ProxyMesh& mesh) const;

 private:
  GlBuffer corners_, triangles_;
};

/// Sets the camera of desktop.glsl and the light of desktop_light.glsl in the program in use.
void set_camera(const Uniform& uniform, const PictureOptions& options, const Frame& frame,
                const View& view);

}  // namespace tripus::viewer
