#include "topology/simplify/reducer.hpp"

namespace tripus::topology {
namespace {

/// An edge of valence k that cannot be collapsed, which takes O(k) to find out, is tried again at
/// the (k / kPatience)-th visit of a tetrahedron around it. So a visit costs O(1) on average, even
/// where thousands of tetrahedra around one edge are visited again and again.
constexpr std::uint32_t kPatience = 16;

}  // namespace

void Reducer::push(TetrahedronIndex t) {
  if (queued_.size() < m_->slot_count()) queued_.resize(m_->slot_count(), 0);
  if (queued_[t] != 0 || !m_->is_live(t)) return;
  queued_[t] = 1;
  queue_.push_back(t);
}

void Reducer::push_all() {
  waits_.assign(m_->edge_labels(), 0);
  for (TetrahedronIndex t = 0; t < m_->slot_count(); ++t) push(t);
}

void Reducer::clear() {
  for (std::size_t i = head_; i < queue_.size(); ++i) queued_[queue_[i]] = 0;
  queue_.clear();
  head_ = 0;
}

void Reducer::step() {
  const TetrahedronIndex t = queue_[head_++];
  queued_[t] = 0;
  if (head_ == queue_.size()) {
    queue_.clear();
    head_ = 0;
  }
  if (!m_->is_live(t)) return;
  const bool all = moves_ == Moves::kAll;
  const bool finite = m_->finite_vertex_count() > 0;
  if ((all && reduce_at_edges(t)) || (all && finite && reduce_at_vertices(t)) ||
      (finite && collapse_at(t))) {
    push_touched();
    push(t);  // if it is still there
  }
}

bool Reducer::reduce_at_edges(TetrahedronIndex t) {
  for (int e = 0; e < 6; ++e) {
    Move move{.tetrahedron = t, .place = static_cast<std::uint8_t>(e)};
    switch (m_->valence(m_->edge(t, e))) {
      case 1:
        move.kind = MoveKind::kTwoOne;
        if (m_->try_apply(move)) return true;
        move.choice = 1;
        if (m_->try_apply(move)) return true;
        break;
      case 2:
        move.kind = MoveKind::kTwoZeroEdge;
        if (m_->try_apply(move)) return true;
        break;
      case 3:
        move.kind = MoveKind::kThreeTwo;
        if (m_->try_apply(move)) return true;
        break;
      default:
        break;
    }
  }
  return false;
}

bool Reducer::reduce_at_vertices(TetrahedronIndex t) {
  for (int v = 0; v < 4; ++v) {
    const auto degree = m_->degree(m_->vertex(t, v));
    if (degree != 2 && degree != 4) continue;
    if (m_->try_apply({.kind = degree == 2 ? MoveKind::kTwoZeroVertex : MoveKind::kFourOne,
                       .tetrahedron = t,
                       .place = static_cast<std::uint8_t>(v)}))
      return true;
  }
  return false;
}

bool Reducer::collapse_at(TetrahedronIndex t) {
  if (waits_.size() < m_->edge_labels()) waits_.resize(m_->edge_labels(), 0);
  for (int e = 0; e < 6; ++e) {
    const auto label = m_->edge(t, e);
    if (waits_[label] > 0) {
      --waits_[label];
      continue;
    }
    if (collapse_.try_apply(t, e) == CollapseRefusal::kNone) return true;
    waits_[label] = m_->valence(label) / kPatience;
  }
  return false;
}

}  // namespace tripus::topology
