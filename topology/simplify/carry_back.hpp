#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "topology/gluings.hpp"
#include "topology/simplify/record.hpp"

namespace tripus::topology {

/// A group whose elements are known by number, the same element always by the same one; 0 is the
/// identity.
class NumberedGroup {
 public:
  virtual ~NumberedGroup() = default;
  virtual std::uint32_t product(std::uint32_t first, std::uint32_t second) = 0;
  virtual std::uint32_t inverse(std::uint32_t element) = 0;
  /// How far an element is from the identity, >= 0: frames are chosen so that this stays small.
  virtual double size(std::uint32_t element) const { return element == 0 ? 0 : 1; }
  /// Whether the product of two elements is sure to be one that the group can hold.
  virtual bool can_hold_product(std::uint32_t /*first*/, std::uint32_t /*second*/) const {
    return true;
  }
  /// from^-1 element to. The three together may be what the group can hold where two are not.
  virtual std::uint32_t conjugate(std::uint32_t from, std::uint32_t element, std::uint32_t to) {
    return product(inverse(from), product(element, to));
  }

  /// A frame `element` times that of `from` is that of `to`.
  struct Link {
    std::uint32_t from, to, element;
  };
  /// For each of so many frames the element that takes it to a better one (links [L], those from
  /// one frame together): such that
  /// conjugate(change[from], element, change[to]) is small for all links. Empty: none are better.
  virtual std::vector<std::uint32_t> better_frames(std::span<const Link> /*links*/,
                                                   std::size_t /*frames*/) {
    return {};
  }
};

/// Where a list by tetrahedron and face has face f of tetrahedron t.
inline std::size_t slot_of(std::size_t t, int f) { return 4 * t + static_cast<std::size_t>(f); }

/// A flat connection on the dual graph of a triangulation: every tetrahedron has a frame, and
/// across face f of tetrahedron t the frame of the neighbour is `values[4 t + f]` times that of t,
/// so that the value on the other side is the inverse, a path through tetrahedra has the product of
/// its values from left to right, and the way around an edge has the identity.
struct FlatConnection {
  std::vector<std::uint32_t> values;  ///< [T x 4]
  /// [T] whose frame it is, but for what NumberedGroup::better_frames changed: a tetrahedron of the
  /// small triangulation, whose frame was copied from one to the next. So it is a map of the
  /// tetrahedra. Empty to begin with for each its own.
  std::vector<TetrahedronIndex> origins = {};
};

/// A flat connection on what `simplify` made of a table, on that table: the two are equal outside
/// the ball in which a step happens, for every step of the record. Frames are copied; a tetrahedron
/// that a step brings back takes the frame of a neighbour where that makes the values around it
/// smaller, and where values grow large the group may choose all frames anew.
/// Source: docs/parameterise.md, "The connection".
FlatConnection carried_back(const Gluings& start, const SimplificationRecord& record,
                            FlatConnection connection, NumberedGroup& group);

/// Edge corners (a tetrahedron and an edge) around which a connection has another product than the
/// identity, one for each such edge class; empty if it is flat. Open faces end an edge.
std::vector<std::pair<TetrahedronIndex, int>> curved_edges(const Gluings& gluings,
                                                           std::span<const std::uint32_t> values,
                                                           NumberedGroup& group);

}  // namespace tripus::topology
