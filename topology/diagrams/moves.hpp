#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "topology/diagrams/editor.hpp"

namespace tripus::topology {

/// Puts a kink (a Reidemeister I move) into the arc of dart d: the strand crosses itself once, and
/// the small loop lies to the left of d. `over`: the strand, on its way from d, passes above first.
void add_kink(DiagramEditor& editor, Dart d, bool over);

/// Pushes the arc of dart `over` across that of dart `under` (Reidemeister II), where both have the
/// same region to their left, or lie in different pieces, whose regions then become one. The arcs
/// must differ.
void push_across(DiagramEditor& editor, Dart over, Dart under);

/// Moves of diagrams, after Reidemeister, and of graphs, after Kauffman and Ishii. All but the last
/// are isotopies of the graph; none changes the exterior.
enum class DiagramMove : std::uint8_t {
  kKink,      ///< I: a strand crosses itself once
  kUnkink,    ///< its inverse, at a crossing with a loop
  kPush,      ///< II: a strand is pushed across another one
  kPull,      ///< its inverse, at a region of two corners
  kSlide,     ///< III: at a region of three corners
  kSurround,  ///< IV: a strand is pushed across a vertex, and passes all its arcs
  kRelease,   ///< its inverse
  kTwist,     ///< V: two neighbouring arcs of a vertex change places and cross
  kUntwist,   ///< its inverse
  kIh,        ///< IH: two vertices of degree 3 exchange neighbours: the handlebody stays
};
inline constexpr std::array kDiagramMoves{
    DiagramMove::kKink,    DiagramMove::kUnkink,   DiagramMove::kPush,    DiagramMove::kPull,
    DiagramMove::kSlide,   DiagramMove::kSurround, DiagramMove::kRelease, DiagramMove::kTwist,
    DiagramMove::kUntwist, DiagramMove::kIh};
std::string_view to_string(DiagramMove move);

/// Makes the move at a place, or returns false and changes nothing where it cannot be made. Never
/// throws for darts that live.
///   at     kKink, kPush: the strand that moves, with the region into which it moves to its left;
///          kUnkink, kPull, kSlide: a dart with the loop or region to its left;
///          kSurround: the strand, with the vertex in the region to its left;
///          kRelease, kTwist: a dart of the vertex; kUntwist: a dart of the vertex, the crossing
///          between it and the next one; kIh: the arc between the vertices
///   other  kPush: the other strand, with the same region to its left; kSurround: the dart of the
///          vertex with the region to its left
///   over   kKink, kPush, kSurround, kTwist: whether what moves passes above
bool try_move(DiagramEditor& editor, DiagramMove move, Dart at, Dart other, bool over);

struct RandomDiagramMoves {
  std::size_t count = 100;
  std::uint64_t seed = 0;
  std::size_t max_crossings = 30;  ///< moves that add crossings stop here
  bool ih = true;                  ///< whether IH-moves are among them
};
struct MovedDiagram {
  Diagram diagram;
  std::array<std::size_t, kDiagramMoves.size()> made{};  ///< how many of each
};
/// Random legal moves; the same for the same seed on every platform. Fewer than `count` where
/// hardly any is legal.
MovedDiagram random_moves(const Diagram& diagram, const RandomDiagramMoves& options);

}  // namespace tripus::topology
