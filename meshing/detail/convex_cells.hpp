#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/bignum.hpp"
#include "meshing/surface_mesh.hpp"

namespace tripus::meshing::detail {

/// A point with rational coordinates, and the nearest doubles.
struct RationalPoint {
  std::array<Rational, 3> exact;
  Point near{};

  explicit RationalPoint(std::array<Rational, 3> coordinates);
  explicit RationalPoint(const Point& p);
};

/// The points where n . x + d is 0, with n . x + d > 0 on its positive side.
struct RationalPlane {
  std::array<Rational, 4> exact;
  std::array<double, 4> near{};

  RationalPlane(const Point& a, const Point& b, const Point& c);
  /// Sign of n . p + d, by doubles where these are sure.
  int side(const RationalPoint& p) const;
};

/// Where the segment from p to q, which are on different sides, crosses a plane.
RationalPoint crossing(const RationalPlane& plane, const RationalPoint& p, const RationalPoint& q);

/// A box that planes cut into convex polyhedra. Faces are polygons that two cells share as a whole,
/// edges are shared by all faces around them: a face may have corners in the middle of its sides.
/// Exact; the coordinates stay as short as those of the crossing of three planes are.
class ConvexCells {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  struct Face {
    std::vector<std::uint32_t> loop;
    std::array<std::uint32_t, 2> cells{kNone, kNone};
    std::uint32_t plane = kNone;  ///< kNone: a side of the box
  };
  struct Cell {
    std::vector<std::uint32_t> faces;
  };

  /// One cell.
  ConvexCells(const Point& low, const Point& high);

  /// Cuts a cell that the plane runs through. The cell keeps its negative side; returns the new one
  /// on the positive side.
  std::uint32_t cut(std::uint32_t cell, const RationalPlane& plane, std::uint32_t name);

  /// Of a cell, each once, in order.
  std::vector<std::uint32_t> corners(std::uint32_t cell) const;

  const std::vector<RationalPoint>& points() const { return points_; }
  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<Cell>& cells() const { return cells_; }

 private:
  std::uint32_t add_face(Face face);
  void split_edge(std::uint32_t a, std::uint32_t b, const RationalPlane& plane);
  void split_face(std::uint32_t face);
  std::vector<std::uint32_t> zero_loop(const Cell& cell) const;

  std::vector<RationalPoint> points_;
  std::vector<Face> faces_;
  std::vector<Cell> cells_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> faces_at_;  ///< of each edge
  std::vector<int> sides_;  ///< [points] of the plane at hand, where it matters
};

}  // namespace tripus::meshing::detail
