#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "topology/cone_angle.hpp"
#include "topology/moves/moves.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {

/// Marks an edge class that a move has removed.
inline constexpr std::uint32_t kNoEdge = std::numeric_limits<std::uint32_t>::max();

/// Where the edge classes of a triangulation go in a move: [E before] classes of `after`, kNoEdge
/// for those that are gone. Moves that flatten tetrahedra merge classes: then two have one image.
///   change  what `apply` returned for the move on the gluings of `before`
///   after   of the gluings that it left
/// In O(T), for every kind of move but 0-2 and 1-2 at places where all corners of an edge are in
/// removed tetrahedra: it then counts as gone.
std::vector<std::uint32_t> edge_images(const Triangulation& before, const Move& move,
                                       const MoveChange& change, const Triangulation& after);

/// The edge that a 2-3 or a 4-4 makes, as a diagonal: it is the edge `edge` of tetrahedron
/// `tetrahedron` after the move, and the dihedral angle there at the opposite edge is made up of
/// those of `corners` before the move (a tetrahedron and one of its edges each).
struct NewDiagonal {
  std::size_t tetrahedron = 0;
  int edge = 0;
  std::vector<std::pair<std::size_t, int>> corners;
};
/// Nothing for moves that make no edge, and for other kinds.
std::optional<NewDiagonal> new_diagonal(const Triangulation& before, const Move& move,
                                        const MoveChange& change);

/// Labels [E before] on the other side of a move: [E after], 2 pi on new edges; empty if `labels`
/// is. Nothing where the move would remove a labelled edge, or merge two.
std::optional<std::vector<ConeAngle>> carried_labels(std::span<const ConeAngle> labels,
                                                     std::span<const std::uint32_t> images,
                                                     std::size_t edge_count);

}  // namespace tripus::topology
