#include "topology/moves/moves.hpp"

#include <array>

#include "base/error.hpp"
#include "topology/moves/detail/surgery.hpp"

namespace tripus::topology {
namespace {

const auto& table() {
  static const std::array kTable{
      detail::two_three_info(),     detail::three_two_info(),     detail::four_four_info(),
      detail::two_zero_edge_info(), detail::zero_two_edge_info(), detail::two_zero_vertex_info(),
      detail::zero_two_face_info(), detail::two_one_info(),       detail::one_two_info(),
      detail::one_four_info(),      detail::four_one_info(),
  };
  return kTable;
}

}  // namespace

std::span<const MoveInfo> move_table() { return table(); }

const MoveInfo& info(MoveKind kind) { return table().at(static_cast<std::size_t>(kind)); }

std::optional<MoveKind> find_move_kind(std::string_view name) {
  for (const MoveInfo& line : table())
    if (line.name == name) return line.kind;
  return std::nullopt;
}

std::string_view to_string(MoveRefusal refusal) {
  switch (refusal) {
    case MoveRefusal::kNone:
      return "it can be made";
    case MoveRefusal::kNoSuchPlace:
      return "there is no such place";
    case MoveRefusal::kOpenFace:
      return "a face of its tetrahedra is open";
    case MoveRefusal::kWrongValence:
      return "the valence is another, or the tetrahedra meet in another way";
    case MoveRefusal::kNotDistinct:
      return "one tetrahedron would take part twice";
    case MoveRefusal::kSameOppositeEdges:
      return "the two edges to be merged are one edge already";
    case MoveRefusal::kSealedFace:
      return "the faces to be merged are glued to each other";
    case MoveRefusal::kNotFolded:
      return "there is no fold beside the edge, or the face is the fold itself";
  }
  throw InternalError("unknown MoveRefusal");
}

MoveRefusal refusal(const Gluings& gluings, const Move& move) {
  const MoveInfo& line = info(move.kind);
  const int places = line.place == MovePlace::kTetrahedron ? 1
                     : line.place == MovePlace::kEdge      ? 6
                                                           : 4;
  if (move.tetrahedron >= gluings.tetrahedron_count() || move.place >= places ||
      move.choice >= (line.choice_name.empty() ? 1 : 2) || (move.steps > 0 && !line.has_steps))
    return MoveRefusal::kNoSuchPlace;
  return line.refusal(gluings, move);
}

MoveChange apply(Gluings& gluings, const Move& move) {
  const MoveRefusal reason = refusal(gluings, move);
  if (reason != MoveRefusal::kNone)
    throw InvalidInput("no " + to_string(move) + ": " + std::string(to_string(reason)));
  return info(move.kind).apply(gluings, move);
}

std::vector<Move> all_moves(const Triangulation& triangulation, std::span<const MoveKind> kinds) {
  std::vector<Move> moves;
  for (const MoveKind kind : kinds) info(kind).candidates(triangulation, moves);
  std::erase_if(moves, [&](const Move& move) { return !can_apply(triangulation.gluings(), move); });
  return moves;
}

}  // namespace tripus::topology
