#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace tripus::topology {

/// Disjoint sets of 0, 1, ..., n - 1, which are joined: what hangs together in a graph.
class DisjointSets {
 public:
  /// Each number for itself.
  explicit DisjointSets(std::size_t count = 0) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::size_t size() const { return parent_.size(); }
  void clear() { parent_.clear(); }
  /// One number more, by itself.
  std::uint32_t add() {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    return parent_.back();
  }
  /// The number that stands for the set of i, until that is joined to another.
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// The root of j stands for both then. False if they are in one set already.
  bool join(std::uint32_t i, std::uint32_t j) {
    i = root(i);
    j = root(j);
    parent_[i] = j;
    return i != j;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace tripus::topology
