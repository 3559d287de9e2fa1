#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/stop.hpp"
#include "embedding/universal_cover.hpp"
#include "geometry/hyperbolic_space.hpp"

/// Cells as surfaces to draw: four polygons on the faces, and one on the truncating plane or the
/// horosphere of each vertex that is not finite and of each parabolic edge.
namespace tripus::embedding {

using geometry::Model;
using geometry::Vector3;

/// No cell is divided more often than this.
inline constexpr int kMostSubdivisions = 7;

/// The closed surface of one tetrahedron in its own frame. Each polygon with more than three
/// corners is cut from its middle, so that there are 28 patches where all vertices are hyperideal
/// or ideal, fewer at finite vertices and more at parabolic edges. Each patch is cut n times into
/// four at the middles of its sides: hyperbolic ones, or those of the horosphere on which both ends
/// lie. Triangles are counter-clockwise seen from outside; points on common sides are shared.
struct CellShape {
  static constexpr std::int8_t kNoHorosphere = -1;

  std::vector<Vector4> points;  ///< on the hyperboloid
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// [triangles] 0..3 the face, 4..7 4 + the truncated vertex, 8..13 8 + the parabolic edge
  std::vector<std::uint8_t> sides;
  /// [points] on whose horosphere it lies: 0..3 the ideal vertex, 4..9 4 + the parabolic edge, or
  /// -1
  std::vector<std::int8_t> horospheres;

  /// The middle of some of the points: on the geodesic or the plane through them, or on the
  /// horosphere on which all of them lie.
  Vector4 middle(const HyperboloidTetrahedron& tetrahedron,
                 std::span<const std::uint32_t> numbers) const;
  /// The horosphere on which all of these points lie, or kNoHorosphere.
  std::int8_t common_horosphere(std::span<const std::uint32_t> numbers) const;
};

/// Throws InvalidInput unless subdivisions is from 0 to kMostSubdivisions.
CellShape cell_shape(const HyperboloidTetrahedron& tetrahedron, int subdivisions);

/// Number of triangles of a CellShape that is not subdivided.
std::size_t patch_count(const HyperboloidTetrahedron& tetrahedron);

/// Sizes of a CellShape with so many patches, which is a sphere.
inline std::size_t triangle_count(int subdivisions, std::size_t patches = 28) {
  return patches << (2 * subdivisions);
}
inline std::size_t point_count(int subdivisions, std::size_t patches = 28) {
  return triangle_count(subdivisions, patches) / 2 + 2;
}

/// What a tessellation is to be like.
struct TessellationOptions {
  Model model = Model::kPoincareBall;
  /// How far the flat triangles may lie from the surfaces and edges that they stand for, in the
  /// coordinates of the model; > 0. In the upper half-space, where cells can be large, it is
  /// multiplied by the diameter of a cell that is larger than 1.
  double error = 1e-2;
  /// Ends the work at a whole cell when it becomes true; null: nothing does.
  Stop stop{};
};

/// Cells cut into triangles, one cell at a time, so that not all must be in memory. In the Klein
/// model planes are flat and nothing but horospheres makes it subdivide.
class Tessellation {
 public:
  /// Finds the level of every cell: the least power of 2 that keeps the error. A stop leaves the
  /// cells found so far, one at least.
  /// Throws InvalidInput, naming the cell, where kFinestLevel is too coarse for the error, and for
  /// an error that is not positive. The arguments must outlive the tessellation.
  Tessellation(const Embedding& embedding, std::span<const Cell> cells,
               const TessellationOptions& options);

  std::span<const Cell> cells() const { return cells_; }
  /// Whether writers should end: a stop was requested since this was made.
  bool is_stopped() const { return options_.stop.requested(); }
  int subdivisions(std::size_t cell) const { return subdivisions_[cell]; }
  std::size_t point_count() const { return point_count_; }
  std::size_t triangle_count() const { return triangle_count_; }

  /// The points of a cell in the model.
  std::vector<Vector3> points(std::size_t cell) const;
  /// The triangles of a cell as numbers of its points, counter-clockwise seen from outside.
  std::vector<std::array<std::uint32_t, 3>> triangles(std::size_t cell) const;
  /// As CellShape::sides.
  const std::vector<std::uint8_t>& sides(std::size_t cell) const;

 private:
  const CellShape& shape(std::uint32_t tetrahedron, int subdivisions) const;
  double largest_deviation(const Cell& cell, int subdivisions) const;

  const Embedding& embedding_;
  std::span<const Cell> cells_;
  TessellationOptions options_;
  std::vector<std::uint8_t> subdivisions_;
  std::size_t point_count_ = 0, triangle_count_ = 0;
  /// Shapes by tetrahedron and subdivisions, made when first asked for.
  mutable std::vector<std::array<CellShape, kMostSubdivisions + 1>> shapes_;
};

/// The hyperbolic volume that a closed surface in the Klein ball encloses, by the divergence
/// theorem and the value at the middle of each triangle: the error falls with the square of their
/// size. Source: docs/theory.md (74).
double enclosed_volume(std::span<const Vector3> points,
                       std::span<const std::array<std::uint32_t, 3>> triangles);

/// Hyperbolic area of the triangle with three corners on the hyperboloid.
/// Source: docs/theory.md (75).
double triangle_area(const Vector4& a, const Vector4& b, const Vector4& c);

}  // namespace tripus::embedding
