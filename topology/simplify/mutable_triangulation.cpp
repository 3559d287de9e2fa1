#include "topology/simplify/mutable_triangulation.hpp"

#include <algorithm>
#include <array>

#include "topology/edge_walk.hpp"

// Bookkeeping: labels, the slots and labels that are free, and the record of a trial. The moves are
// in mutable_moves.cpp.
//
// Where two classes become one, the smaller is given the label of the larger; a class of n corners
// is so relabelled at most log2(n) times in a run of merges.

namespace tripus::topology {

MutableTriangulation::MutableTriangulation(const Triangulation& triangulation,
                                           std::span<const EdgePlace> kept)
    : gluings_(triangulation.gluings()),
      edges_(triangulation.edge_classes().begin(), triangulation.edge_classes().end()),
      vertices_(triangulation.vertex_classes().begin(), triangulation.vertex_classes().end()),
      valences_(triangulation.edge_count()),
      degrees_(triangulation.vertex_count()),
      finite_(triangulation.vertex_count()) {
  for (std::size_t e = 0; e < valences_.size(); ++e)
    valences_[e] = static_cast<std::uint32_t>(triangulation.valence(e));
  for (std::size_t v = 0; v < degrees_.size(); ++v) {
    degrees_[v] = triangulation.link(v).triangle_count;
    finite_[v] = triangulation.link(v).euler_characteristic == 2;
    finite_vertex_count_ += finite_[v];
  }
  if (kept.empty()) return;
  kept_.assign(valences_.size(), 0);
  kept_count_ = kept.size();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto [t, e] = kept[i];
    kept_[edge(t, e)] = static_cast<std::uint32_t>(i + 1);
    for (const int end : kEdgeEnds[static_cast<std::size_t>(e)]) {
      std::uint8_t& finite = finite_[vertex(t, end)];
      finite_vertex_count_ -= finite;
      finite = 0;
    }
  }
}

void MutableTriangulation::set_kept(Label edge, std::uint32_t number) {
  record(Field::kKept, edge, kept_[edge]);
  kept_[edge] = number;
}

void MutableTriangulation::set_side(TetrahedronIndex t, int f, TetrahedronIndex other, Perm4 p) {
  record(Field::kSide, 4 * t + static_cast<std::uint32_t>(f), gluings_.neighbour(t, f),
         gluings_.gluing(t, f));
  if (log_ != nullptr)
    log_->written.push_back(
        {4 * t + static_cast<std::uint32_t>(f), gluings_.neighbour(t, f), gluings_.gluing(t, f)});
  gluings_.set_one_side(t, f, other, p);
}

void MutableTriangulation::set_edge(TetrahedronIndex t, int e, Label label) {
  const std::uint32_t slot = 6 * t + static_cast<std::uint32_t>(e);
  record(Field::kEdge, slot, edges_[slot]);
  edges_[slot] = label;
}

void MutableTriangulation::set_vertex(TetrahedronIndex t, int v, Label label) {
  const std::uint32_t slot = 4 * t + static_cast<std::uint32_t>(v);
  record(Field::kVertex, slot, vertices_[slot]);
  vertices_[slot] = label;
}

void MutableTriangulation::set_valence(Label edge, std::uint32_t valence) {
  record(Field::kValence, edge, valences_[edge]);
  valences_[edge] = valence;
}

void MutableTriangulation::set_degree(Label vertex, std::uint32_t degree) {
  record(Field::kDegree, vertex, degrees_[vertex]);
  degrees_[vertex] = degree;
}

// New slots and labels are made free first: then an undone trial needs to know of taking alone.
TetrahedronIndex MutableTriangulation::take_tetrahedron() {
  if (free_tetrahedra_.empty()) {
    free_tetrahedra_.push_back(static_cast<TetrahedronIndex>(slot_count()));
    gluings_.resize(slot_count() + 1);
    edges_.resize(6 * slot_count());
    vertices_.resize(4 * slot_count());
  }
  const TetrahedronIndex t = free_tetrahedra_.back();
  free_tetrahedra_.pop_back();
  record(Field::kTakeTetrahedron, t, 0);
  if (log_ != nullptr) log_->taken.push_back(t);
  return t;
}

void MutableTriangulation::free_tetrahedron(TetrahedronIndex t) {
  for (int f = 0; f < 4; ++f) set_side(t, f, kNoTetrahedron, Perm4());
  free_tetrahedra_.push_back(t);
  record(Field::kFreeTetrahedron, t, 0);
}

MutableTriangulation::Label MutableTriangulation::take_edge() {
  if (free_edges_.empty()) {
    free_edges_.push_back(static_cast<Label>(valences_.size()));
    valences_.push_back(0);
    if (!kept_.empty()) kept_.push_back(0);
  }
  const Label label = free_edges_.back();
  free_edges_.pop_back();
  record(Field::kTakeEdge, label, 0);
  return label;
}

void MutableTriangulation::free_edge(Label label) {
  free_edges_.push_back(label);
  record(Field::kFreeEdge, label, 0);
}

MutableTriangulation::Label MutableTriangulation::take_vertex() {
  if (free_vertices_.empty()) {
    free_vertices_.push_back(static_cast<Label>(degrees_.size()));
    degrees_.push_back(0);
    finite_.push_back(0);
  }
  const Label label = free_vertices_.back();
  free_vertices_.pop_back();
  record(Field::kTakeVertex, label, 0);
  record(Field::kFinite, label, finite_[label]);
  finite_[label] = 1;
  ++finite_vertex_count_;
  return label;
}

void MutableTriangulation::free_vertex(Label label) {
  record(Field::kFinite, label, finite_[label]);
  finite_vertex_count_ -= finite_[label];
  finite_[label] = 0;
  free_vertices_.push_back(label);
  record(Field::kFreeVertex, label, 0);
}

void MutableTriangulation::uncount(TetrahedronIndex t) {
  for (int e = 0; e < 6; ++e) set_valence(edge(t, e), valence(edge(t, e)) - 1);
  for (int v = 0; v < 4; ++v) set_degree(vertex(t, v), degree(vertex(t, v)) - 1);
}

void MutableTriangulation::count(TetrahedronIndex t) {
  for (int e = 0; e < 6; ++e) set_valence(edge(t, e), valence(edge(t, e)) + 1);
  for (int v = 0; v < 4; ++v) set_degree(vertex(t, v), degree(vertex(t, v)) + 1);
}

void MutableTriangulation::relabel_edge(TetrahedronIndex t, int e, Label to) {
  const Label from = edge(t, e);
  auto walk = EdgeWalk::start(t, e);
  do {
    set_edge(static_cast<TetrahedronIndex>(walk.t), walk.edge(), to);
    walk.step(gluings_);
  } while (edge(walk.t, walk.edge()) == from);
  set_valence(to, valence(to) + valence(from));
  set_valence(from, 0);
  if (kept(from) != 0) {
    set_kept(to, kept(from));
    set_kept(from, 0);
  }
  free_edge(from);
}

void MutableTriangulation::relabel_vertex(TetrahedronIndex t, int v, Label to) {
  const Label from = vertex(t, v);
  set_vertex(t, v, to);
  stack_.assign(1, 4 * t + static_cast<std::uint32_t>(v));
  while (!stack_.empty()) {
    const std::uint32_t here = stack_.back();
    stack_.pop_back();
    for (int f = 0; f < 4; ++f) {
      if (f == static_cast<int>(here % 4)) continue;
      const TetrahedronIndex other = gluings_.neighbour(here / 4, f);
      const int w = gluings_.gluing(here / 4, f)(static_cast<int>(here % 4));
      if (vertex(other, w) != from) continue;
      set_vertex(other, w, to);
      stack_.push_back(4 * other + static_cast<std::uint32_t>(w));
    }
  }
  set_degree(to, degree(to) + degree(from));
  set_degree(from, 0);
  free_vertex(from);
}

void MutableTriangulation::begin_trial() {
  journal_.clear();
  recording_ = true;
  if (steps_ != nullptr) steps_before_trial_ = steps_->size();
}

void MutableTriangulation::keep_trial() { recording_ = false; }

void MutableTriangulation::undo_trial() {
  recording_ = false;
  if (steps_ != nullptr) steps_->truncate(steps_before_trial_);
  for (std::size_t i = journal_.size(); i-- > 0;) {
    const Written& written = journal_[i];
    switch (written.field) {
      case Field::kSide:
        gluings_.set_one_side(written.index / 4, static_cast<int>(written.index % 4), written.old,
                              written.perm);
        break;
      case Field::kEdge:
        edges_[written.index] = written.old;
        break;
      case Field::kVertex:
        vertices_[written.index] = written.old;
        break;
      case Field::kValence:
        valences_[written.index] = written.old;
        break;
      case Field::kDegree:
        degrees_[written.index] = written.old;
        break;
      case Field::kFinite:
        finite_vertex_count_ += written.old;
        finite_vertex_count_ -= finite_[written.index];
        finite_[written.index] = static_cast<std::uint8_t>(written.old);
        break;
      case Field::kKept:
        kept_[written.index] = written.old;
        break;
      case Field::kTakeTetrahedron:
        free_tetrahedra_.push_back(written.index);
        break;
      case Field::kFreeTetrahedron:
        free_tetrahedra_.pop_back();
        break;
      case Field::kTakeEdge:
        free_edges_.push_back(written.index);
        break;
      case Field::kFreeEdge:
        free_edges_.pop_back();
        break;
      case Field::kTakeVertex:
        free_vertices_.push_back(written.index);
        break;
      case Field::kFreeVertex:
        free_vertices_.pop_back();
        break;
    }
  }
  journal_.clear();
}

Gluings MutableTriangulation::compacted() const {
  std::vector<TetrahedronIndex> number(slot_count(), kNoTetrahedron);
  TetrahedronIndex next = 0;
  for (std::size_t t = 0; t < slot_count(); ++t)
    if (is_live(t)) number[t] = next++;
  Gluings result(next);
  for (std::size_t t = 0; t < slot_count(); ++t)
    for (int f = 0; f < 4 && is_live(t); ++f)
      result.set_one_side(number[t], f, number[gluings_.neighbour(t, f)], gluings_.gluing(t, f));
  return result;
}

std::vector<EdgePlace> MutableTriangulation::compacted_kept() const {
  std::vector<EdgePlace> places(kept_count_);
  TetrahedronIndex number = 0;
  for (TetrahedronIndex t = 0; t < slot_count(); ++t) {
    if (!is_live(t)) continue;
    for (int e = 0; e < 6; ++e)
      if (kept(edge(t, e)) != 0) places[kept(edge(t, e)) - 1] = {number, e};
    ++number;
  }
  return places;
}

}  // namespace tripus::topology
