#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "viewer/detail/compose.hpp"
#include "viewer/detail/drawn_discs.hpp"
#include "viewer/detail/gl.hpp"
#include "viewer/faces/detail/mesh_drawing.hpp"
#include "viewer/faces/detail/tubes_renderer.hpp"
#include "viewer/faces/face_set.hpp"
#include "viewer/faces/proxies.hpp"
#include "viewer/picture.hpp"

namespace tripus::viewer {

/// Draws each visible face once, where the rays of its pixels meet it, in the OpenGL context that
/// is current when it is made, and must be at every call and when it ends.
class FacesRenderer {
 public:
  /// Throws NoOpenGl.
  FacesRenderer();

  /// Takes the scene to draw from now on, in a model; it is copied.
  ///   scene_radius  of the ball around it
  void set_scene(const Scene& scene, Model model, double scene_radius);

  /// Draws colours and depths of cells into what Composer has bound. `options.model` is that of
  /// the scene. Returns the number of cells left out because a stop was requested.
  std::size_t draw(const PictureOptions& options, const Frame& frame, const View& view);

 private:
  /// Faces of a kind: programs, and what is drawn in this frame.
  struct Kind {
    std::map<std::string, GlProgram> programs = {};  ///< by what is defined in front of them
    ProxyMesh mesh = {};
  };

  /// The cut through a cell.
  struct Cut {
    float first_texel = -1;  ///< of its record; negative: it has none
    BoundingBall ball = {};
  };

  void write_records(const PictureOptions& options);
  void write_cuts();
  void write_places();
  void add_cell(std::size_t cell, const PictureOptions& options, const View& view,
                const Projector& projector, int samples);
  void draw_meshes(const PictureOptions& options, const Frame& frame, const View& view,
                   double alpha);
  bool is_transparent(const PictureOptions& options, std::size_t cell) const;
  GLuint program_of(RecordKind kind, const PictureOptions& options);

  std::array<Kind, kRecordKinds> kinds_;  ///< by RecordKind
  MeshBuffers buffers_;
  GlTexture records_, places_;

  Scene scene_;
  FaceSet set_;
  TubesRenderer tubes_;
  DrawnDiscs discs_;
  std::vector<float> texels_;        // four numbers each: the records of faces, then of cuts
  std::size_t fixed_texels_ = 0;     // numbers of faces in it
  std::vector<float> first_texel_;   // [faces]
  std::vector<Cut> cuts_;            // [cells], or none
  std::optional<ColourBy> colours_;  // of the records; nothing: there are none yet
  std::optional<double> cut_;
  bool places_written_ = false;
};

}  // namespace tripus::viewer
