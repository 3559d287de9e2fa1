#pragma once

#include <cstddef>
#include <functional>
#include <queue>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace tripus::topology {

/// The book of a best-first search over triangulations by moves: which are known, by signature, and
/// which is to be looked at next, the one with the fewest tetrahedra, of these the earliest.
template <class Node>
class BestFirst {
 public:
  /// Whether the signature is new; it is known from now on.
  bool learn(std::string signature) { return known_.insert(std::move(signature)).second; }

  /// Adds a node, to be looked at, and returns its number; nodes are numbered from 0.
  std::size_t add(std::size_t tetrahedra, Node node) {
    open_.emplace(tetrahedra, nodes_.size());
    nodes_.push_back(std::move(node));
    return nodes_.size() - 1;
  }

  bool has_open() const { return !open_.empty(); }
  /// The number of the node to look at; it is not open any more.
  std::size_t next() {
    const std::size_t number = open_.top().second;
    open_.pop();
    return number;
  }

  /// References end with the next `add`.
  Node& operator[](std::size_t number) { return nodes_[number]; }
  const Node& operator[](std::size_t number) const { return nodes_[number]; }
  std::size_t size() const { return nodes_.size(); }
  Node& front() { return nodes_.front(); }
  Node& back() { return nodes_.back(); }

 private:
  using Entry = std::pair<std::size_t, std::size_t>;  // tetrahedra, number
  std::vector<Node> nodes_;
  std::unordered_set<std::string> known_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace tripus::topology
