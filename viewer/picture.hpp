#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "viewer/camera.hpp"
#include "viewer/scene.hpp"

namespace tripus::viewer {

/// How the surfaces of cells are found.
enum class Drawing {
  kSolid,   ///< image-based CSG: solid cells, also where they are cut
  kHollow,  ///< each wall without its pixels outside of the others: faster, and hollow where cut
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
  Drawing drawing = Drawing::kSolid;
  bool occlusion = true;  ///< whether nooks are darkened; costs some
  int samples = 0;        ///< a pixel, in each direction, up to 4; 0: what its size allows
  /// Ends the drawing between two cells when it becomes true; null: nothing does.
  const std::atomic<bool>* stop_requested = nullptr;
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
inline constexpr std::size_t kMostCells = 20000;

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
