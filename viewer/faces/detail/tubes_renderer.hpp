#pragma once

#include <array>
#include <optional>

#include "viewer/faces/detail/mesh_drawing.hpp"
#include "viewer/faces/tubes.hpp"

namespace tripus::viewer {

/// Draws tubes around edges: over all else, as they are blended at their rims.
class TubesRenderer {
 public:
  ///   faces  of the scene in the model
  void set_scene(Model model, const Scene& scene, const FaceSet& faces);

  /// Draws those wide enough into the bound framebuffer. Blending leaves colours weighed by alpha.
  void draw(const Scene& scene, const PictureOptions& options, const Frame& frame,
            const View& view);

 private:
  void write_colours(const Scene& scene, ColourBy colour_by);
  void collect(const PictureOptions& options, const Frame& frame, const View& view);
  GLuint program_of(const PictureOptions& options);

  TubeSet set_;
  std::optional<ColourBy> colours_;  // of the records
  GlTexture records_;
  std::array<GlProgram, 6> programs_;
  ProxyMesh mesh_;
  MeshBuffers buffers_;
};

}  // namespace tripus::viewer
