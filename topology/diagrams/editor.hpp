#pragma once

#include <cstdint>
#include <vector>

#include "topology/diagrams/diagram.hpp"

namespace tripus::topology {

/// A diagram that changes: nodes come and go, arcs are cut and joined. Darts keep their numbers as
/// long as they live. Nothing is checked but that the result is drawn in the plane (`finished`).
class DiagramEditor {
 public:
  explicit DiagramEditor(const Diagram& diagram);

  /// Darts of all times; some are gone.
  std::size_t dart_count() const { return mates_.size(); }
  std::size_t node_count() const { return darts_.size(); }
  bool is_live(std::size_t node) const { return !darts_[node].empty(); }
  NodeKind kind(std::size_t node) const { return kinds_[node]; }
  bool is_crossing(std::size_t node) const { return kinds_[node] == NodeKind::kCrossing; }
  const std::vector<Dart>& darts(std::size_t node) const { return darts_[node]; }
  std::uint32_t node(Dart d) const { return node_of_[d]; }
  Dart mate(Dart d) const { return mates_[d]; }
  std::int64_t arc(Dart d) const { return names_[d]; }
  std::size_t slot(Dart d) const;
  Dart next(Dart d) const { return turned(d, 1); }
  Dart previous(Dart d) const { return turned(d, darts_[node_of_[d]].size() - 1); }
  Dart across(Dart d) const { return turned(d, 2); }
  Dart along_region(Dart d) const { return previous(mates_[d]); }
  bool is_under(Dart d) const { return slot(d) % 2 == 0; }

  /// A node with free darts, whose numbers are darts(node).
  std::uint32_t add_node(NodeKind kind, std::size_t degree);
  /// Joins two darts to an arc of that name.
  void join(Dart one, Dart two, std::int64_t name);
  /// Takes a node away; its darts must not be wanted any more.
  void remove_node(std::uint32_t node) { darts_[node].clear(); }
  /// Gives a node these darts, counterclockwise.
  void set_darts(std::uint32_t node, const std::vector<Dart>& darts);
  /// Takes a crossing away and lets its two strands pass straight on. A strand that has no other
  /// node becomes a circle with a vertex of degree 2.
  void dissolve(std::uint32_t crossing);

  Diagram finished() const;

 private:
  Dart turned(Dart d, std::size_t places) const {
    const std::vector<Dart>& all = darts_[node_of_[d]];
    return all[(slot(d) + places) % all.size()];
  }

  std::vector<NodeKind> kinds_;
  std::vector<std::vector<Dart>> darts_;  // of each node, counterclockwise
  std::vector<std::uint32_t> node_of_;
  std::vector<Dart> mates_;
  std::vector<std::int64_t> names_;
};

}  // namespace tripus::topology
