#pragma once

#include <cstdint>
#include <vector>

#include "topology/simplify/collapse.hpp"
#include "topology/simplify/mutable_triangulation.hpp"

namespace tripus::topology {

/// Moves that make a triangulation smaller, driven by a queue of the tetrahedra around which
/// something may be possible: edge collapse, 3-2, 2-0, 2-1 and 4-1. A move puts what it touched
/// into the queue, so the work is proportional to the moves made.
class Reducer {
 public:
  explicit Reducer(MutableTriangulation& triangulation) : m_(&triangulation), collapse_(*m_) {}

  enum class Moves : std::uint8_t { kCollapse, kAll };
  /// Which moves step() makes; all at first.
  void allow(Moves moves) { moves_ = moves; }

  void push(TetrahedronIndex t);
  void push_touched() {
    for (const TetrahedronIndex t : m_->touched()) push(t);
  }
  /// Puts everything into the queue, also edges whose turn would come later.
  void push_all();
  bool is_idle() const { return head_ == queue_.size(); }

  /// Makes moves at the next tetrahedron of the queue, if there is one.
  void step();
  /// Makes moves until the queue is empty.
  void run() {
    while (!is_idle()) step();
  }
  /// Forgets the queue.
  void clear();

 private:
  bool reduce_at_edges(TetrahedronIndex t);
  bool reduce_at_vertices(TetrahedronIndex t);
  bool collapse_at(TetrahedronIndex t);

  MutableTriangulation* m_;
  EdgeCollapse collapse_;
  Moves moves_ = Moves::kAll;
  std::vector<TetrahedronIndex> queue_;
  std::size_t head_ = 0;
  std::vector<std::uint8_t> queued_;
  std::vector<std::uint32_t> waits_;  // by edge label: visits until the next try to collapse it
};

}  // namespace tripus::topology
