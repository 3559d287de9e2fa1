#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "viewer/camera.hpp"
#include "viewer/scene.hpp"

namespace tripus::viewer {

/// What cells are made of.
enum class Material {
  kSolid,   ///< solid cells, also where they are cut
  kHollow,  ///< walls alone, seen from both sides: hollow where cut
};

/// What finds the pixels of cells.
enum class RendererKind {
  kFaces,    ///< each visible wall once, met by the rays of its pixels
  kOpenCsg,  ///< image-based CSG of whole cells, as in the founding paper; slow in software
};

/// What a picture of a scene looks like.
struct PictureOptions {
  Model model = Model::kUpperHalfSpace;
  ColourBy colour_by = ColourBy::kTetrahedron;
  bool faces = true;        ///< without them, the truncations alone are drawn, and not solid
  bool truncations = true;  ///< without them, the faces alone are drawn, and not solid
  bool discs = true;        ///< those of the scene, where it has some
  /// Cells are cut at the plane x = cut_away of the model, and what lies beyond is not drawn.
  std::optional<double> cut_away;
  Camera camera;
  Material drawing = Material::kSolid;
  RendererKind renderer = RendererKind::kFaces;
  bool occlusion = true;  ///< whether nooks are darkened; costs some
  bool lines = true;      ///< along edges and borders of walls; by OpenCSG always
  bool tubes = true;      ///< around edges, where they are wide enough, if there are lines
  bool dark = false;      ///< the background
  bool labels = false;    ///< names of tetrahedra and edges; of pictures and windows
  /// One can look through the cells of this tetrahedron; hollow cells are left out instead. Not by
  /// OpenCSG.
  std::optional<std::uint32_t> transparent;
  int samples = 0;  ///< a pixel, in each direction, up to 4; 0: what its size allows
  /// Ends the drawing between two cells when it becomes true; null: nothing does.
  Stop stop{};
};

/// An image: rows from the top, red, green, blue and alpha of each pixel.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< [height x width x 4]
  /// Cells of the scene that are not in the picture because a stop was requested: those farthest
  /// from the eye, as the nearest are drawn first.
  std::size_t cells_left = 0;
};

/// Sides of pictures may be as long as this.
inline constexpr int kLargestSide = 4096;
/// Cells in a scene that is drawn may be as many as this.
inline constexpr std::size_t kMostDrawnCells = 20000;

/// Whether cells are solid: without some of their walls they are not.
inline bool is_solid(const PictureOptions& options) {
  return options.drawing == Material::kSolid && options.faces && options.truncations;
}

/// Whether the drawing is to end.
inline bool is_stopped(const PictureOptions& options) { return options.stop.requested(); }

/// Throws InvalidInput for a picture without pixels or with sides beyond kLargestSide.
void require_size(int width, int height);

/// Throws InvalidInput, naming the option, for a size, a camera or a number of cells out of range.
void require_drawable(const Scene& scene, const PictureOptions& options, int width, int height);

/// OpenGL, or a display, is missing here. The message says what to do about it.
class NoOpenGl : public Unsupported {
 public:
  using Unsupported::Unsupported;
};

/// Writes a PNG file. Throws InvalidInput if it cannot be written, with the system's reason.
void write_png(const Image& image, const std::string& path);

}  // namespace tripus::viewer
