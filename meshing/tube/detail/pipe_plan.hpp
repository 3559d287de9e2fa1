#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meshing/tube/detail/strands.hpp"
#include "meshing/tube/detail/vector3.hpp"

namespace tripus::meshing::tube {

/// A hierarchy of boxes around straight pieces, for the nearest one to something.
class SegmentTree {
 public:
  struct Piece {
    Point a, b;
  };

  explicit SegmentTree(std::vector<Piece> pieces);

  struct Nearest {
    double distance = HUGE_VAL;
    std::uint32_t piece = 0xffffffff;
  };

  /// The piece with the least distance_to(piece) among those that are not skip(piece); `bounds`
  /// encloses what the distance is taken from.
  template <class Skip, class Distance>
  Nearest nearest(const Bounds& bounds, const Skip& skip, const Distance& distance_to) const {
    Nearest best;
    if (cells_.empty()) return best;
    std::vector<std::uint32_t> todo{0};
    while (!todo.empty()) {
      const Cell& cell = cells_[todo.back()];
      const auto here = todo.back();
      todo.pop_back();
      if (gap(cell.bounds, bounds) >= best.distance) continue;
      if (cell.right != 0) {
        const bool left_first =
            gap(cells_[here + 1].bounds, bounds) < gap(cells_[cell.right].bounds, bounds);
        todo.push_back(left_first ? cell.right : here + 1);
        todo.push_back(left_first ? here + 1 : cell.right);
        continue;
      }
      for (std::uint32_t i = cell.first; i < cell.last; ++i)
        if (!skip(order_[i]))
          if (const double d = distance_to(order_[i]); d < best.distance) best = {d, order_[i]};
    }
    return best;
  }

  const Piece& piece(std::uint32_t i) const { return pieces_[i]; }

 private:
  struct Cell {
    Bounds bounds;
    std::uint32_t first = 0, last = 0;  ///< of order_, if a leaf
    std::uint32_t right = 0;            ///< the other child; the left one follows its parent
  };

  void build(std::uint32_t first, std::uint32_t last);
  static double gap(const Bounds& a, const Bounds& b);

  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> order_;
  std::vector<Cell> cells_;
};

/// Where pipes meet, or where one opens to the outer surface.
struct Joint {
  Point point;
  bool opening = false;
  Point normal{};                      ///< of the outer surface, at an opening
  double radius = 0;                   ///< of the ball in which the pipes meet; 0 at an opening
  std::vector<std::uint32_t> pipes{};  ///< those that end here
};

/// A straight pipe from joint a to joint b that may be thicker at one end.
struct Pipe {
  std::uint32_t a, b;
  double radius_a = 0, radius_b = 0;
  std::uint32_t segment;  ///< of the strands: where a message should point
};

/// How thick each part of a tube may be by what is near to it, and by nothing else.
///
/// The ball of a joint and the pipes keep to these rules, each with a tenth to spare, and so meet
/// nothing but what they end at (law 6 of the README):
///   balls          less than half of the way to any other pipe, joint, or the outer surface
///   pipes          less than half of the way to any pipe or joint that they do not end at
///   pipes that end at one joint   each in a cone from there, the cones apart
/// At an opening the strand turns to the outer surface's normal shortly before it.
struct PipePlan {
  std::vector<Joint> joints;
  std::vector<Pipe> pipes;
  OuterSurface outer;
};

PipePlan plan_pipes(const TubeStrands& strands);

}  // namespace tripus::meshing::tube
