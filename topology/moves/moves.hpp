#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "topology/gluings.hpp"
#include "topology/moves/small_list.hpp"
#include "topology/triangulation.hpp"

// Local moves: each replaces a ball made of a few tetrahedra by another with the same boundary, or
// flattens one, and so leaves the manifold as it is. They edit a mutable gluing table in time
// O(1), or O(valence) where an edge must be walked around, and never look at the rest of it.
//
// The table must be one that the constructor of Triangulation accepts, up to open faces: a move
// whose tetrahedra have an open face is refused. Moves at boundary faces (open book, close book,
// shelling) are left out, because the gluings of this project are closed up.

namespace tripus::topology {

namespace detail {
struct MoveBall;
}

enum class MoveKind : std::uint8_t {
  kTwoThree,
  kThreeTwo,
  kFourFour,
  kTwoZeroEdge,
  kZeroTwoEdge,
  kTwoZeroVertex,
  kZeroTwoFace,
  kTwoOne,
  kOneTwo,
  kOneFour,
  kFourOne,
};

/// A move and where to make it. Which numbers matter is a matter of the kind (see MoveInfo); the
/// others are 0.
struct Move {
  MoveKind kind = MoveKind::kTwoThree;
  TetrahedronIndex tetrahedron = 0;
  std::uint8_t place = 0;   ///< face 0..3, edge 0..5 or vertex 0..3 of the tetrahedron
  std::uint8_t choice = 0;  ///< 0 or 1: axis of a 4-4, end of a 2-1, side of a 0-2 at an edge
  std::uint32_t steps = 0;  ///< corners to walk on around the edge

  friend bool operator==(const Move&, const Move&) = default;
};

/// What the number Move::place counts.
enum class MovePlace : std::uint8_t { kTetrahedron, kFace, kEdge, kVertex };

/// Why a move cannot be made.
enum class MoveRefusal : std::uint8_t {
  kNone,               ///< it can
  kNoSuchPlace,        ///< the tetrahedron, place, choice or steps do not exist
  kOpenFace,           ///< a tetrahedron of the ball has an open face
  kWrongValence,       ///< not the number of tetrahedra around the edge or vertex that it needs
  kNotDistinct,        ///< one tetrahedron would take part twice
  kSameOppositeEdges,  ///< two edges to be merged are one already: flattening would pinch
  kSealedFace,         ///< two faces to be merged are glued to each other: nothing would be left
  kNotFolded,          ///< no edge of valence 1 beside the edge, or the face is the fold itself
};
std::string_view to_string(MoveRefusal refusal);

/// What a move did to the numbers of the tetrahedra. Freed numbers are used again for new
/// tetrahedra, holes are filled with the last tetrahedra; all else keeps number and labels.
struct MoveChange {
  struct Renumbered {
    TetrahedronIndex from;
    TetrahedronIndex to;
  };
  SmallList<TetrahedronIndex, 4> removed;  ///< numbers before the move, ascending
  SmallList<TetrahedronIndex, 4> added;    ///< numbers after the move
  SmallList<Renumbered, 4> renumbered;     ///< old tetrahedra with a new number
  std::optional<Move> inverse = {};        ///< a move that undoes it; none after a 2-0 or a 2-1
};

/// A line of the table of moves.
struct MoveInfo {
  MoveKind kind;
  std::string_view name;         ///< "2-0 edge", for options and tables
  std::string_view arrow;        ///< "2-0", for reports
  std::string_view description;  ///< one sentence
  MovePlace place;
  std::string_view choice_name;  ///< "axis", "end", "side"; empty: there is none
  bool has_steps;
  int tetrahedra;       ///< change of T
  int finite_vertices;  ///< change of the number of sphere links; every other link stays
  MoveKind inverse;
  MoveRefusal (*refusal)(const Gluings&, const Move&);
  MoveChange (*apply)(Gluings&, const Move&);  ///< legal moves only
  /// What is replaced by what; null for 0-2, 2-1 and 1-2, which are not made that way.
  detail::MoveBall (*ball)(const Gluings&, const Move&);
  void (*candidates)(const Triangulation&, std::vector<Move>&);  ///< places, once each, to be tried
};

/// Every kind of move, in the order of MoveKind.
std::span<const MoveInfo> move_table();
const MoveInfo& info(MoveKind kind);
/// By MoveInfo::name; nullopt if there is none.
std::optional<MoveKind> find_move_kind(std::string_view name);

/// Why the move cannot be made here; kNone if it can. The conditions of each kind, with their
/// reasons, are at the top of its file. Never throws.
MoveRefusal refusal(const Gluings& gluings, const Move& move);
inline bool can_apply(const Gluings& gluings, const Move& move) {
  return refusal(gluings, move) == MoveRefusal::kNone;
}

/// Makes the move. Oriented tables (every gluing odd) stay oriented.
/// Throws InvalidInput with the move and the reason if it is refused; the table is then unchanged.
MoveChange apply(Gluings& gluings, const Move& move);

/// Every legal move of the given kinds, each place once: by kind, then in the order of the faces,
/// edge classes, vertex classes or tetrahedra. A 0-2 at an edge of valence n has n (n + 1) / 2
/// places and more.
std::vector<Move> all_moves(const Triangulation& triangulation, std::span<const MoveKind> kinds);

/// "2-3 at face 2 of tetrahedron 5", "4-4 at edge 03 of tetrahedron 5, axis 1".
std::string to_string(const Move& move);
/// Reads what to_string writes. Throws InvalidInput with the text and what was expected.
Move parse_move(std::string_view text);

/// The kinds that keep ideal triangulations ideal (no finite vertices) and do not only grow them.
inline constexpr std::array<MoveKind, 4> kUsualMoves{MoveKind::kTwoThree, MoveKind::kThreeTwo,
                                                     MoveKind::kFourFour, MoveKind::kTwoZeroEdge};

struct RandomMovesOptions {
  std::size_t count = 0;   ///< moves to make
  std::uint64_t seed = 0;  ///< the same moves for the same seed on every platform
  std::span<const MoveKind> kinds = kUsualMoves;
  std::size_t max_tetrahedra = 1000;  ///< no move beyond
};

/// Makes random moves: a kind is drawn, then a place, and the move is made if it is legal. Returns
/// the moves made, fewer than `count` only if nothing seems to be legal (5000 (T + 1) refusals in a
/// row).
/// Cost: O(valence) an attempt.
std::vector<Move> randomize(Gluings& gluings, const RandomMovesOptions& options);

}  // namespace tripus::topology
