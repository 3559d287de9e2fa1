#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "embedding/universal_cover.hpp"
#include "viewer/half_space.hpp"
#include "viewer/wall_discs.hpp"

namespace tripus::viewer {

/// The walls of a truncated tetrahedron: its faces 0..3 (hexagons), then its truncations 0..3
/// (triangles), wall 4 + v truncating vertex v: a plane, a horosphere if the vertex is ideal, and
/// nothing if it is finite; then its edge walls, wall 8 + e the horosphere that cuts off edge e if
/// that is parabolic (a rectangle), and nothing if it is not.
inline constexpr std::size_t kWallCount = 14;
/// Cells without parabolic edges have only the first of them.
inline constexpr std::size_t kPlainWallCount = 8;
constexpr bool is_face(std::size_t wall) { return wall < 4; }
constexpr bool is_truncation(std::size_t wall) { return wall >= 4 && wall < kPlainWallCount; }
constexpr bool is_edge_wall(std::size_t wall) {
  return wall >= kPlainWallCount && wall < kWallCount;
}

/// A ball in a model.
struct BoundingBall {
  Vector3 centre = Vector3::Zero();
  double radius = 0;
};

/// A parabolic edge of a cell, on the hyperboloid.
struct ParabolicEdge {
  std::uint8_t edge = 0;  ///< 0..5
  Vector4 wall;           ///< null vector: <wall, X> <= -1 inside
  /// Of its wall, in cyclic order: on the truncations of the edge's vertices v < w and in its faces
  /// k < l, those of v k, w k, w l, v l.
  std::array<Vector4, 4> corners;
};

/// One cell of the universal cover, ready to be drawn: an intersection of up to 14 half-spaces.
struct SceneCell {
  std::uint32_t tetrahedron = 0;
  std::uint32_t depth = 0;  ///< gluings away from the first cell
  /// [8] unit outward normals of faces and truncations, hyperboloid model, time last: <normal, X>
  /// <= 0 inside. Of an ideal vertex a null vector, <wall, X> <= -1 inside; of a finite one the
  /// vertex.
  std::array<Vector4, kPlainWallCount> walls;
  /// Of the vertices: 1 hyperideal, 0 ideal, -1 finite.
  std::array<double, 4> diagonal{1, 1, 1, 1};
  std::uint8_t singular_edges = 0;  ///< bit e: edge e is singular
  /// [12] corners on the hyperboloid: corner 3 v + k lies on truncation v and on the k-th edge of
  /// the tetrahedron at v, in the order of the other vertices. Of a parabolic edge it is the middle
  /// of the side where its wall meets truncation v.
  std::array<Vector4, 12> corners;
  std::vector<ParabolicEdge> parabolic_edges = {};  ///< in the order of edges
  geometry::Matrix4 place;  ///< the isometry from the frame of the tetrahedron
  /// What its parts are glued to, for colours and words: a number for each pair of glued faces,
  /// each boundary component and each edge class, edges in the order 01, 02, 03, 12, 13, 23.
  std::array<std::uint32_t, 4> face_class{0, 1, 2, 3}, vertex_class{0, 0, 0, 0};
  std::array<std::uint32_t, 6> edge_class{0, 1, 2, 3, 4, 5};
};

/// The parabolic edge with this number; null: that edge is not parabolic.
const ParabolicEdge* parabolic_edge(const SceneCell& cell, std::size_t edge);

/// Whether a wall of a cell is there.
inline bool has_wall(const SceneCell& cell, std::size_t wall) {
  if (is_edge_wall(wall)) return parabolic_edge(cell, wall - kPlainWallCount) != nullptr;
  return is_face(wall) || cell.diagonal[wall - 4] >= 0;
}
/// Whether it is a horosphere.
inline bool is_horosphere(const SceneCell& cell, std::size_t wall) {
  return is_truncation(wall) ? cell.diagonal[wall - 4] == 0 : is_edge_wall(wall);
}
/// The vector of a wall that is there.
const Vector4& wall_vector(const SceneCell& cell, std::size_t wall);

/// Whether the same half-spaces make two cells.
bool have_same_walls(const SceneCell& a, const SceneCell& b);

/// The corners of a wall that is there, in cyclic order: 6 of a face, 3 of a truncation and one
/// more for each parabolic edge at its vertex, 4 of an edge wall.
std::vector<Vector4> corners_of_wall(const SceneCell& cell, std::size_t wall);
/// The half-space of a wall; one that holds everything near the cells if it is not there.
HalfSpace half_space(Model model, const SceneCell& cell, std::size_t wall);

/// What is drawn, by every viewer.
struct Scene {
  std::string title;
  std::size_t tetrahedron_count = 0;  ///< of the triangulation
  std::vector<SceneCell> cells;
  /// On the truncations; null: none.
  std::shared_ptr<const WallDiscs> discs;
  std::vector<double> edge_lengths;  ///< of the edge classes; empty: not known
  /// The ball that the camera looks at; nothing: the one around all cells.
  std::optional<BoundingBall> focus;
};

/// SceneCell::corners in the frame of a tetrahedron: on truncation v and on edge vw.
Vector4 drawn_corner(const geometry::HyperboloidTetrahedron& shape, int v, int w);

/// Whether some cell has parabolic edges.
bool has_parabolic_edges(const Scene& scene);

/// Puts cells into a scene.
///   frame  moves all of them; default_frame(model) makes for good pictures
Scene make_scene(std::string title, const embedding::Embedding& embedding,
                 std::span<const embedding::Cell> cells, const geometry::Matrix4& frame);

/// The same cells elsewhere: all are moved by an isometry, while the camera looks where it looked.
Scene moved(Model model, const Scene& scene, const geometry::Matrix4& isometry);

/// An isometry that puts the first cell where its picture tells most: its middle at the middle of
/// the ball; in the upper half-space one of its edges on the vertical axis, as in the paper: edge
/// 03, or the first one that is not parabolic.
geometry::Matrix4 default_frame(Model model, const embedding::Embedding& embedding,
                                std::uint32_t root = 0);

/// Points of the cell's surface whose spread is that of the cell, its corners among them.
std::vector<Vector3> outline(Model model, const SceneCell& cell);

/// A ball that contains the cell, not much larger than need be.
BoundingBall bounding_ball(Model model, const SceneCell& cell);

/// A ball that contains all cells. Throws InvalidInput if there are none.
BoundingBall bounding_ball(Model model, const Scene& scene);

/// The ball that the camera looks at. Throws InvalidInput if there are no cells.
BoundingBall focus_of(Model model, const Scene& scene);

/// From points centre + radius q of a model to the hyperboloid in the frame of the cell's
/// tetrahedron: (q, |q|^2, 1) becomes the point times 1 / s, where q moves s of hyperbolic length
/// for one of its own (exactly so in the models that keep angles).
using ToTetrahedron = Eigen::Matrix<double, 4, 5>;
ToTetrahedron to_tetrahedron(Model model, const SceneCell& cell, const BoundingBall& ball);

/// What tells cells apart.
enum class ColourBy {
  kTetrahedron,  ///< the tetrahedron of the triangulation
  kFace,         ///< SceneCell::face_class: glued faces have one colour
  kDepth,        ///< gluings away from the first cell
  kComponent,    ///< the boundary component of a truncation, or the annular cusp of a parabolic
                 ///< edge, which has a colour of its own; faces are grey
  kEdge,         ///< the class of each edge, which is drawn wider; walls are grey
};
inline constexpr int kColourByCount = 5;

/// Red, green, blue in [0, 1], sRGB.
using Colour = std::array<float, 3>;

/// The colour of a wall of a cell: Okabe and Ito's palette, safe for colour-blind readers, and a
/// ramp of one hue to another for the depth. Truncations have a light tint of their cell's colour,
/// horospheres a bluish one.
Colour wall_colour(ColourBy colour_by, const SceneCell& cell, std::size_t wall);

/// The number of the edge of a tetrahedron between two of its vertices, 0..5: 01, 02, 03, 12,
/// 13, 23.
std::size_t edge_between(std::size_t vertex, std::size_t other);

/// The two faces at an edge 0..5, the one with the lower number first.
std::array<std::size_t, 2> faces_at_edge(std::size_t edge);

}  // namespace tripus::viewer
