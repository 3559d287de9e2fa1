#include "meshing/detail/triangle_tree.hpp"

#include <limits>
#include <numeric>

namespace tripus::meshing::detail {
namespace {

constexpr std::uint32_t kLeafSize = 4;

}  // namespace

Box empty_box() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
}

Box box_of(const SurfaceMesh& mesh, std::size_t triangle) {
  Box box = empty_box();
  for (const std::uint32_t corner : mesh.triangles[triangle]) box.include(mesh.points[corner]);
  return box;
}

Box box_of(std::span<const Point> points) {
  Box box = empty_box();
  for (const Point& point : points) box.include(point);
  return box;
}

TriangleTree::TriangleTree(const SurfaceMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  if (count == 0) return;
  std::vector<Box> boxes(count);
  std::vector<Point> centres(count);
  for (std::size_t t = 0; t < count; ++t) {
    boxes[t] = box_of(mesh, t);
    for (std::size_t k = 0; k < 3; ++k) centres[t][k] = boxes[t].low[k] / 2 + boxes[t].high[k] / 2;
  }
  order_.resize(count);
  std::iota(order_.begin(), order_.end(), 0u);
  struct Range {
    std::uint32_t node, first, last;
  };
  std::vector<Range> todo{{0, 0, static_cast<std::uint32_t>(count)}};
  nodes_.emplace_back();
  while (!todo.empty()) {
    const Range range = todo.back();
    todo.pop_back();
    Box box = empty_box(), spread = empty_box();
    for (std::uint32_t i = range.first; i < range.last; ++i) {
      box.include(boxes[order_[i]]);
      spread.include(centres[order_[i]]);
    }
    nodes_[range.node].box = box;
    if (range.last - range.first <= kLeafSize) {
      nodes_[range.node].first = range.first;
      nodes_[range.node].count = range.last - range.first;
      continue;
    }
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (spread.high[k] - spread.low[k] > spread.high[axis] - spread.low[axis]) axis = k;
    const std::uint32_t middle = range.first + (range.last - range.first) / 2;
    std::nth_element(
        order_.begin() + range.first, order_.begin() + middle, order_.begin() + range.last,
        [&](std::uint32_t s, std::uint32_t t) { return centres[s][axis] < centres[t][axis]; });
    const auto left = static_cast<std::uint32_t>(nodes_.size());
    nodes_[range.node].first = left;
    nodes_.resize(nodes_.size() + 2);
    todo.push_back({left, range.first, middle});
    todo.push_back({left + 1, middle, range.last});
  }
  boxes_.resize(count);
  for (std::size_t i = 0; i < count; ++i) boxes_[i] = boxes[order_[i]];
}

}  // namespace tripus::meshing::detail
