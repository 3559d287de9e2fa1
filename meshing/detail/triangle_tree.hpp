#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing::detail {

struct Box {
  Point low;
  Point high;

  bool meets(const Box& other) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
    return true;
  }
  void include(const Point& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  void include(const Box& other) {
    include(other.low);
    include(other.high);
  }
};

Box empty_box();
Box box_of(const SurfaceMesh& mesh, std::size_t triangle);
Box box_of(std::span<const Point> points);

/// A hierarchy of boxes over the triangles of a surface: halves by the middle of the widest axis of
/// the centres, so that its depth is logarithmic whatever the input. 64 bytes a node, built in
/// O(T log T).
class TriangleTree {
 public:
  explicit TriangleTree(const SurfaceMesh& mesh);

  /// Calls visit(triangle) for every triangle whose box passes `wanted(box)`; a box that contains
  /// it must pass as well. Stops when visit returns false.
  template <class Wanted, class Visit>
  void for_each(Wanted wanted, Visit visit) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, 64> stack;
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (!wanted(node.box)) continue;
      if (node.count == 0) {
        stack[depth++] = node.first + 1;
        stack[depth++] = node.first;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        if (wanted(boxes_[i]) && !visit(order_[i])) return;
    }
  }

  const Box& box() const { return nodes_.front().box; }

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< left child, the right one follows; or first triangle of a leaf
    std::uint32_t count = 0;  ///< triangles of a leaf
  };

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;  // triangles, leaf by leaf
  std::vector<Box> boxes_;            // [T] in that order
};

}  // namespace tripus::meshing::detail
