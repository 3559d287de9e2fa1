#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "topology/gluings.hpp"

namespace tripus::topology {

/// The edges of a tetrahedron in their fixed order 01 02 03 12 13 23: ends of edge e.
inline constexpr std::array<std::array<int, 2>, 6> kEdgeEnds{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// kEdgeNumber[i][j] = number of the edge with ends i != j (the diagonal holds -1).
inline constexpr std::array<std::array<int, 4>, 4> kEdgeNumber{
    {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}}};

/// One corner of an edge class: a tetrahedron, one of its edges, and the direction in which the
/// class runs along it. Packed into 32 bits, which bounds T by 2^28.
class EdgeCorner {
 public:
  EdgeCorner() = default;
  EdgeCorner(std::size_t tetrahedron, int edge, bool reversed)
      : code_(static_cast<std::uint32_t>(16 * tetrahedron) +
              static_cast<std::uint32_t>(2 * edge + reversed)) {}
  std::size_t tetrahedron() const { return code_ >> 4; }
  int edge() const { return static_cast<int>(code_ >> 1 & 7); }
  /// False: the class runs from kEdgeEnds[edge][0] to kEdgeEnds[edge][1].
  bool reversed() const { return code_ & 1; }

 private:
  std::uint32_t code_ = 0;
};

/// The link of a vertex class.
struct VertexLink {
  std::int32_t euler_characteristic = 0;
  bool orientable = true;
  std::uint32_t triangle_count = 0;  ///< tetrahedron vertices in the class
  /// Genus, defined for orientable links: (2 - euler_characteristic) / 2.
  int genus() const { return (2 - euler_characteristic) / 2; }
};

/// An ideal triangulation with its skeleton; immutable. Compact arrays, no object a tetrahedron:
/// about 110 bytes a tetrahedron in all.
///
/// Edge and vertex classes are numbered in the order in which they first appear when the
/// tetrahedra are run through in order and their edges as 01 02 03 12 13 23 (Regina's numbering).
class Triangulation {
 public:
  /// Builds the skeleton, in O(T).
  /// Throws InvalidInput, naming the tetrahedron and the face or edge, for: no tetrahedra, an open
  /// face, a gluing to a tetrahedron that does not exist, a gluing that is not undone from the
  /// other side, a face glued to itself, an edge identified with its own reverse.
  /// Connectedness, orientability and the kinds of vertex links are not restricted here:
  /// see require_solvable in topology/requirements.hpp.
  explicit Triangulation(Gluings gluings);

  const Gluings& gluings() const { return gluings_; }
  std::size_t tetrahedron_count() const { return gluings_.tetrahedron_count(); }
  std::size_t edge_count() const { return edge_start_.size() - 1; }
  std::size_t vertex_count() const { return links_.size(); }
  std::size_t component_count() const { return component_count_; }

  /// [T x 6] edge class of each edge of each tetrahedron.
  std::span<const std::uint32_t> edge_classes() const { return edge_class_; }
  std::uint32_t edge_class(std::size_t t, int e) const {
    return edge_class_[6 * t + static_cast<std::size_t>(e)];
  }
  /// [T x 4] vertex class of each vertex of each tetrahedron.
  std::span<const std::uint32_t> vertex_classes() const { return vertex_class_; }
  std::uint32_t vertex_class(std::size_t t, int v) const {
    return vertex_class_[4 * t + static_cast<std::size_t>(v)];
  }

  /// The corners of edge class e in cyclic order around it; their number is the valence.
  std::span<const EdgeCorner> corners(std::size_t e) const {
    return std::span(corners_).subspan(edge_start_[e], edge_start_[e + 1] - edge_start_[e]);
  }
  std::size_t valence(std::size_t e) const { return edge_start_[e + 1] - edge_start_[e]; }

  const VertexLink& link(std::size_t v) const { return links_[v]; }

  bool is_connected() const { return component_count_ <= 1; }
  bool is_orientable() const { return orientable_; }

  /// Bytes held, for the memory law of topology/README.md.
  std::size_t memory_bytes() const;

 private:
  void walk_edges();
  void walk_vertex_links();
  void walk_components();

  Gluings gluings_;
  std::vector<std::uint32_t> edge_class_;    // [T x 6]
  std::vector<std::uint32_t> vertex_class_;  // [T x 4]
  std::vector<std::uint32_t> edge_start_;    // [E + 1] into corners_
  std::vector<EdgeCorner> corners_;          // [6 T]
  std::vector<VertexLink> links_;            // [V]
  std::size_t component_count_ = 0;
  bool orientable_ = true;
};

}  // namespace tripus::topology
