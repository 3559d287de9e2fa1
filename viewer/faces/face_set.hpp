#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "viewer/scene.hpp"

namespace tripus::viewer {

/// The number of no cell.
inline constexpr std::uint32_t kNoCell = ~std::uint32_t{0};

/// One wall of one cell, as the faces renderer draws it.
struct SceneFace {
  std::uint32_t cell = 0;
  std::uint8_t wall = 0;
  /// The cell of the scene that has this face too, on its other side: between solid cells it is
  /// never seen.
  std::uint32_t partner = kNoCell;
  bool is_shared() const { return partner != kNoCell; }
  std::uint32_t first_point = 0, point_count = 0;  ///< of its outline
  float margin = 0;                                ///< it lies within this of the points' hull
  BoundingBall ball;
};

/// The walls of all cells of a scene in a model.
class FaceSet {
 public:
  FaceSet() = default;
  ///   scene_radius  of the ball around the scene
  FaceSet(Model model, const Scene& scene, double scene_radius);

  Model model() const { return model_; }
  const std::vector<SceneFace>& faces() const { return faces_; }  ///< [8 cells], cell by cell
  const std::vector<BoundingBall>& cell_balls() const { return balls_; }
  /// Of the faces' walls, in the model.
  const std::vector<HalfSpace>& half_spaces() const { return half_spaces_; }
  const std::vector<Eigen::Vector3f>& points() const { return points_; }
  /// Whether some half-spaces have d: horospheres of the Klein ball.
  bool is_bent() const { return is_bent_; }

 private:
  void find_shared();

  Model model_ = Model::kUpperHalfSpace;
  bool is_bent_ = false;
  std::vector<SceneFace> faces_;
  std::vector<HalfSpace> half_spaces_;
  std::vector<BoundingBall> balls_;
  std::vector<Eigen::Vector3f> points_;
};

/// The walls that bound a wall: of a face the other faces, then the truncations at its corners; of
/// a truncation the faces that it cuts.
std::vector<std::size_t> bounds_of_wall(std::size_t wall);

/// Half-spaces that bound a cut: all walls of the cell.
inline constexpr std::size_t kCutBounds = 8;

/// Of how many half-spaces the record of a face with so many bounds has d, if the set is bent: its
/// own if it is a truncation, else those of the truncations that bound it.
constexpr std::size_t bends_of_record(std::size_t bounds) {
  return bounds == 3 ? 1 : bounds - (bounds == kCutBounds ? 4 : 3);
}

/// Texels of four numbers in the record of a face with so many bounds.
constexpr std::size_t record_texels(std::size_t bounds, bool is_bent) {
  return 4 + bounds + (bounds + 3) / 4 + (is_bent ? bends_of_record(bounds) : 0);
}

/// What a record says beside the geometry.
struct FaceLook {
  std::uint32_t cell = 0;
  std::uint8_t wall = 0;  ///< kWallCount: a cut
  bool shared = false;
  float first_disc = -1;  ///< texel; negative: none
  Colour colour{};
  /// Of a face: numbers of the colours of its edges in its first three bounds, of 48, so many times
  /// 1, 64 and 4096.
  float edge_colours = 0;
};

/// FaceLook::edge_colours of a face of a cell.
float edge_colours(const SceneCell& cell, std::size_t face);

/// Appends the record of a face, as faces.vert.glsl reads it: all half-spaces in units of the
/// cell's ball, where floats suffice for any cell.
///   is_bent  whether the record has d of half-spaces
void append_record(std::vector<float>& texels, const BoundingBall& cell_ball, const HalfSpace& own,
                   const std::vector<HalfSpace>& bounds, const FaceLook& look, bool is_bent);

}  // namespace tripus::viewer
