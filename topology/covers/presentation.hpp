#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {

/// A generator g = 0, 1, ... as g + 1, its inverse as -(g + 1).
using Letter = std::int32_t;
/// A product of generators, read from left to right.
using Word = std::vector<Letter>;

inline std::size_t generator_of(Letter letter) {
  return static_cast<std::size_t>(letter > 0 ? letter : -letter) - 1;
}

/// Generators and relators of a group.
struct Presentation {
  std::size_t generator_count = 0;
  std::vector<Word> relators;
};

/// The fundamental group of the manifold, which is that of the space without its vertices.
struct FundamentalGroup {
  /// Generators are the glued face pairs outside a spanning tree of the dual graph, relators the
  /// edge classes, freely and cyclically reduced.
  Presentation presentation;
  /// [T x 4] what crossing face f of tetrahedron t counts: a letter, or 0 in the tree. A path
  /// through tetrahedra is the product of its letters in their order.
  std::vector<Letter> face_letters;
};

/// Finite vertices add nothing: their links are simply connected. O(T).
/// Throws InvalidInput if the triangulation is not connected.
FundamentalGroup fundamental_group(const Triangulation& triangulation);

/// n where the cone angle is 2 pi / n with n >= 1 whole, so that the edge is the axis of a rotation
/// of order n; else 0.
std::int64_t rotation_order(const ConeAngle& cone_angle);

/// The same for an orbifold with cone angles [E] (empty: 2 pi everywhere): the way around an edge
/// has the power n as relator where the cone angle is 2 pi / n, and none where it is not: then this
/// is the group of the manifold without that edge.
FundamentalGroup orbifold_group(const Triangulation& triangulation,
                                std::span<const ConeAngle> cone_angles);

/// A presentation of the same group with fewer generators (Tietze moves).
struct ReducedPresentation {
  struct Definition {
    std::size_t generator;  ///< old number
    Word word;              ///< in the old generators that were still there
  };
  Presentation presentation;       ///< in the generators kept, numbered anew
  std::vector<std::size_t> kept;   ///< [generators] their old numbers, ascending
  std::vector<Definition> solved;  ///< the others, in the order in which they went
};

/// Solves relators, shortest first, for a generator that occurs in them once, while the relators
/// do not grow in all to more than a few times their length. Near linear in that length.
ReducedPresentation reduced(const Presentation& presentation);

}  // namespace tripus::topology
