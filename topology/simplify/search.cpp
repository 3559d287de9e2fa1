#include "topology/simplify/search.hpp"

namespace tripus::topology {
namespace {

/// Tetrahedra without an edge of this valence or less are seldom worth a trial: one in so many.
constexpr std::uint32_t kLowValence = 5;
constexpr std::uint64_t kSeldom = 8;

}  // namespace

/// A tetrahedron with an edge of low valence, mostly; while finite vertices are to go, one with a
/// finite vertex.
TetrahedronIndex LocalSearch::draw_place() {
  while (true) {
    const auto t = static_cast<TetrahedronIndex>(draw(m_->slot_count()));
    if (!m_->is_live(t)) continue;
    if (draw(kSeldom) == 0) return t;
    if (has_finite_to_go()) {
      for (int v = 0; v < 4; ++v)
        if (m_->is_finite(m_->vertex(t, v))) return t;
      continue;
    }
    for (int e = 0; e < 6; ++e)
      if (m_->valence(m_->edge(t, e)) <= kLowValence) return t;
  }
}

// Only an edge of valence 3 or less can go, and 2-3 moves at the faces around an edge lower its
// valence. So every other move aims at the edge of the tetrahedron that has the lowest.
bool LocalSearch::random_move(TetrahedronIndex t) {
  if (has_finite_to_go() && draw(4) == 0)
    return m_->try_apply({.kind = MoveKind::kOneFour, .tetrahedron = t});
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

void LocalSearch::run_from_seeds() {
  for (const TetrahedronIndex t : seeds_) reducer_->push(t);
  reducer_->run();
}

void LocalSearch::trial(int depth) {
  const SearchSize before = size();
  m_->begin_trial();
  seeds_.clear();
  TetrahedronIndex t = draw_place();
  for (auto moves = 1 + draw(static_cast<std::uint64_t>(depth)); moves > 0; --moves) {
    if (!random_move(t)) continue;
    seeds_.insert(seeds_.end(), m_->touched().begin(), m_->touched().end());
    t = m_->touched()[draw(m_->touched().size())];
  }
  if (has_finite_to_go()) {  // collapse first: a 4-1 would only undo a 1-4
    reducer_->allow(Reducer::Moves::kCollapse);
    run_from_seeds();
    reducer_->allow(Reducer::Moves::kAll);
  }
  run_from_seeds();
  if (size() > before)
    m_->undo_trial();
  else
    m_->keep_trial();
}

}  // namespace tripus::topology
