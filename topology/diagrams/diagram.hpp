#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tripus::topology {

/// An arc end at a node: darts of a node are consecutive, counterclockwise.
using Dart = std::uint32_t;
inline constexpr Dart kNoDart = 0xffffffffu;

enum class NodeKind : std::uint8_t { kVertex, kCrossing };

/// A node as people write it: V[1,2,3] or X[4,2,5,1].
struct DiagramNode {
  NodeKind kind = NodeKind::kCrossing;
  std::vector<std::int64_t> arcs =
      {};                  ///< names, counterclockwise; slots 0 and 2 of an X are under
  std::string place = {};  ///< for messages; empty: "V[1,2,3]"

  friend bool operator==(const DiagramNode&, const DiagramNode&) = default;
};

/// A planar diagram of a knotted graph: nodes on the sphere, each a vertex of the graph (any degree
/// of 1 or more) or a crossing, joined by arcs. Several pieces, loops and double arcs are welcome;
/// a circle without a node is V[1,1]. Flat arrays, 13 bytes a dart.
///
/// Dart d = first_dart(n) + k is slot k of node n. The region to the left of a dart, seen from its
/// node, lies between it and next(d).
class Diagram {
 public:
  Diagram() = default;
  /// Throws InvalidInput, naming the node or the arc and the remedy, for: no nodes, a vertex
  /// without arcs, a crossing with other than four, an arc named once or three times, and arcs that
  /// cannot be drawn in the plane in the order given. O(arcs log arcs).
  explicit Diagram(const std::vector<DiagramNode>& nodes);

  std::size_t node_count() const { return kinds_.size(); }
  std::size_t crossing_count() const { return crossing_count_; }
  std::size_t dart_count() const { return mates_.size(); }
  std::size_t arc_count() const { return mates_.size() / 2; }

  NodeKind kind(std::size_t node) const { return kinds_[node]; }
  bool is_crossing(std::size_t node) const { return kinds_[node] == NodeKind::kCrossing; }
  Dart first_dart(std::size_t node) const { return first_[node]; }
  std::uint32_t degree(std::size_t node) const { return first_[node + 1] - first_[node]; }

  std::uint32_t node(Dart d) const { return node_of_[d]; }
  std::uint32_t slot(Dart d) const { return d - first_[node_of_[d]]; }
  /// The other end of the arc.
  Dart mate(Dart d) const { return mates_[d]; }
  /// The next dart of its node, counterclockwise, and clockwise.
  Dart next(Dart d) const { return d + 1 == first_[node_of_[d] + 1] ? first_[node_of_[d]] : d + 1; }
  Dart previous(Dart d) const {
    return d == first_[node_of_[d]] ? first_[node_of_[d] + 1] - 1 : d - 1;
  }
  /// The next dart of which the region lies to the left.
  Dart along_region(Dart d) const { return previous(mates_[d]); }
  bool is_at_crossing(Dart d) const { return is_crossing(node_of_[d]); }
  /// At a crossing: whether the strand passes below, and the dart where it goes on.
  bool is_under(Dart d) const { return slot(d) % 2 == 0; }
  Dart across(Dart d) const { return first_[node_of_[d]] + (slot(d) + 2) % 4; }
  /// The name of the arc. After changes several arcs of one strand may share a name.
  std::int64_t arc(Dart d) const { return names_[d]; }

  /// The nodes as they are written.
  std::vector<DiagramNode> nodes() const;

  /// The same graph seen in a mirror: all orders reversed, crossings with them.
  Diagram mirror_image() const;

  friend bool operator==(const Diagram&, const Diagram&) = default;

 private:
  friend class DiagramEditor;

  void start(const std::vector<NodeKind>& kinds, const std::vector<std::uint32_t>& degrees);
  void require_planar() const;

  std::vector<NodeKind> kinds_;         // [N]
  std::vector<std::uint32_t> first_;    // [N + 1]
  std::vector<std::uint32_t> node_of_;  // [D]
  std::vector<Dart> mates_;             // [D]
  std::vector<std::int64_t> names_;     // [D]
  std::size_t crossing_count_ = 0;
};

/// The regions of the diagram on the sphere.
struct DiagramRegions {
  std::vector<std::uint32_t> of_dart;  ///< [D] the region to its left
  std::vector<Dart> start;             ///< [regions] one of its darts
  std::size_t count() const { return start.size(); }
};
/// Of a diagram in pieces: those of each piece on a sphere of its own.
DiagramRegions regions(const Diagram& diagram);

/// The pieces into which the diagram falls: arcs and nodes that hang together.
struct DiagramPieces {
  std::vector<std::uint32_t> of_node;  ///< [N]
  std::size_t count = 0;
};
DiagramPieces pieces(const Diagram& diagram);

/// A strand: what runs from vertex to vertex through crossings, or closes up without meeting one.
struct Strand {
  std::vector<Dart> darts;  ///< the first dart of each of its arcs, in its direction
  bool closed = false;
};
struct Strands {
  std::vector<Strand> all;
  std::vector<std::uint32_t> of_dart;  ///< [D]
};
/// Numbered by first appearance; a strand runs away from its first dart, a closed one as its
/// crossings say: from the incoming under-strand X[in,..] where it passes below first.
Strands strands(const Diagram& diagram);

/// "V[1,2,3] X[4,2,5,1]": what the reader reads.
std::string to_text(const Diagram& diagram);
std::string to_text(const DiagramNode& node);

}  // namespace tripus::topology
