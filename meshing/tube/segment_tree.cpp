#include "meshing/tube/detail/segment_tree.hpp"

#include <algorithm>
#include <numeric>

namespace tripus::meshing::tube {
namespace {

constexpr std::uint32_t kPiecesInLeaf = 4;

}  // namespace

SegmentTree::SegmentTree(std::vector<Piece> pieces)
    : pieces_(std::move(pieces)), order_(pieces_.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  if (!pieces_.empty()) build(0, std::uint32_t(pieces_.size()));
}

void SegmentTree::build(std::uint32_t first, std::uint32_t last) {
  const std::size_t cell = cells_.size();
  cells_.emplace_back();
  Bounds bounds, middles;
  const auto middle = [&](std::uint32_t i) { return 0.5 * (pieces_[i].a + pieces_[i].b); };
  for (std::uint32_t i = first; i < last; ++i) {
    bounds.add(pieces_[order_[i]].a);
    bounds.add(pieces_[order_[i]].b);
    middles.add(middle(order_[i]));
  }
  cells_[cell].bounds = bounds;
  if (last - first <= kPiecesInLeaf) {
    cells_[cell].first = first;
    cells_[cell].last = last;
    return;
  }
  const Point size = middles.high - middles.low;
  const auto axis = std::size_t(std::max_element(size.begin(), size.end()) - size.begin());
  const std::uint32_t half = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                   [&](std::uint32_t i, std::uint32_t j) {
                     const double x = middle(i)[axis], y = middle(j)[axis];
                     return x < y || (x == y && i < j);
                   });
  build(first, half);
  cells_[cell].right = std::uint32_t(cells_.size());
  build(half, last);
}

double SegmentTree::gap(const Bounds& a, const Bounds& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double d = std::max({a.low[k] - b.high[k], b.low[k] - a.high[k], 0.0});
    sum += d * d;
  }
  return std::sqrt(sum);
}

}  // namespace tripus::meshing::tube
