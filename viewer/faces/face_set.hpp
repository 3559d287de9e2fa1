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
  /// How many walls of each cell are in the lists: kPlainWallCount, or kWallCount where some cells
  /// have parabolic edges.
  std::size_t walls_per_cell() const { return walls_per_cell_; }
  bool has_edge_walls() const { return walls_per_cell_ > kPlainWallCount; }
  /// [walls_per_cell() cells], cell by cell; those that are not there have no points.
  const std::vector<SceneFace>& faces() const { return faces_; }
  const std::vector<BoundingBall>& cell_balls() const { return balls_; }
  /// Of the faces' walls, in the model.
  const std::vector<HalfSpace>& half_spaces() const { return half_spaces_; }
  const std::vector<Eigen::Vector3f>& points() const { return points_; }
  /// Whether some half-spaces have d: horospheres of the Klein ball.
  bool is_bent() const { return is_bent_; }

 private:
  void find_shared();

  Model model_ = Model::kUpperHalfSpace;
  std::size_t walls_per_cell_ = kPlainWallCount;
  bool is_bent_ = false;
  std::vector<SceneFace> faces_;
  std::vector<HalfSpace> half_spaces_;
  std::vector<BoundingBall> balls_;
  std::vector<Eigen::Vector3f> points_;
};

/// What a record is of; kKind of faces.glsl.
enum class RecordKind : std::uint8_t { kTruncation, kFace, kCut, kEdgeWall };
inline constexpr std::size_t kRecordKinds = 4;
constexpr RecordKind record_kind(std::size_t wall) {
  return is_face(wall)         ? RecordKind::kFace
         : is_truncation(wall) ? RecordKind::kTruncation
         : is_edge_wall(wall)  ? RecordKind::kEdgeWall
                               : RecordKind::kCut;
}

/// The walls that bound a wall: of a face the other faces, then the truncations at its corners; of
/// a truncation the faces that it cuts; of a cut (kWallCount) all; of an edge wall its two faces
/// and two truncations.
///   with_edge_walls  whether those of parabolic edges are among them: then they come last, of a
///                    face and a truncation as many as other faces and in the order of these
std::vector<std::size_t> bounds_of_wall(std::size_t wall, bool with_edge_walls = false);

/// How many of the walls that bound a wall are there.
constexpr std::size_t bound_count(RecordKind kind, bool with_edge_walls) {
  switch (kind) {
    case RecordKind::kTruncation:
      return with_edge_walls ? 6 : 3;
    case RecordKind::kFace:
      return with_edge_walls ? 9 : 6;
    case RecordKind::kCut:
      return with_edge_walls ? kWallCount : kPlainWallCount;
    case RecordKind::kEdgeWall:
      break;
  }
  return 4;
}

/// How many of them, the first ones, are planes: their half-spaces have no d.
constexpr std::size_t flat_bounds(RecordKind kind) {
  return kind == RecordKind::kTruncation || kind == RecordKind::kFace ? 3 : 4;
}

/// Of how many half-spaces a record with so many bounds has d, if the set is bent: its own if it is
/// a truncation or an edge wall, then of the bounds that may be horospheres.
constexpr std::size_t bends_of_record(RecordKind kind, std::size_t bounds) {
  const bool own = kind == RecordKind::kTruncation || kind == RecordKind::kEdgeWall;
  return (own ? 1 : 0) + bounds - flat_bounds(kind);
}

/// Texels of four numbers in a record with so many bounds.
constexpr std::size_t record_texels(RecordKind kind, std::size_t bounds, bool is_bent) {
  return 4 + bounds + (bounds + 3) / 4 + (is_bent ? bends_of_record(kind, bounds) : 0);
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
