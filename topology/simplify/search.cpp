#include "topology/simplify/search.hpp"

#include <utility>

namespace tripus::topology {

// Only an edge of valence 3 or less can go, and 2-3 moves at the faces around an edge lower its
// valence. So every other move aims at the edge of the tetrahedron that has the lowest.
bool LocalSearch::random_move(TetrahedronIndex t) {
  int edge = static_cast<int>(draw(6));
  if (draw(2) == 0)
    for (int e = 0; e < 6; ++e)
      if (m_->valence(m_->edge(t, e)) < m_->valence(m_->edge(t, edge))) edge = e;
  if (m_->valence(m_->edge(t, edge)) == 4 &&
      m_->try_apply({.kind = MoveKind::kFourFour,
                     .tetrahedron = t,
                     .place = static_cast<std::uint8_t>(edge),
                     .choice = static_cast<std::uint8_t>(draw(2))}))
    return true;
  const auto& faces = kEdgeEnds[static_cast<std::size_t>(5 - edge)];  // those that hold the edge
  return m_->try_apply({.kind = MoveKind::kTwoThree,
                        .tetrahedron = t,
                        .place = static_cast<std::uint8_t>(faces[draw(2)])});
}

LocalSearch::Result LocalSearch::trial(TetrahedronIndex t, int depth) {
  const auto size = [&] { return std::pair(m_->finite_vertex_count(), m_->tetrahedron_count()); };
  const auto before = size();
  m_->begin_trial();
  for (auto moves = 1 + draw(static_cast<std::uint64_t>(depth)); moves > 0; --moves) {
    if (!random_move(t)) continue;
    reducer_->push_touched();
    t = m_->touched()[draw(m_->touched().size())];
  }
  reducer_->run();
  const auto after = size();
  if (after > before) {
    m_->undo_trial();
    return Result::kUndone;
  }
  m_->keep_trial();
  return after < before ? Result::kBetter : Result::kLevel;
}

}  // namespace tripus::topology
