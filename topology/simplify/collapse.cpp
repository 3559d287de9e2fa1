#include "topology/simplify/collapse.hpp"

#include <array>
#include <string>
#include <utility>

#include "base/error.hpp"

// The collapse of an edge e between vertex classes u and w is a map q from the triangulated space
// M to another, M'. Every tetrahedron abcd at e = ab is mapped linearly to a triangle, a and b to
// one point; the triangles at e become edges and e a point. All else stays, but is glued to what it
// is glued to in the image. The claim: M' is homeomorphic to M, sphere links filled in and other
// vertices taken out, if
//
//  1. u is not w, and at least one of them, say u, is finite;
//  2. no tetrahedron has e as another of its edges;
//  3. the graph with the edge classes as nodes and an arc ac-bc for every triangle abc at e has no
//     cycle;
//  4. the graph with the triangle classes as nodes and an arc acd-bcd for every tetrahedron abcd at
//     e has no cycle.
//
// By 2 every other simplex is mapped injectively in its inside, and every face or edge that is
// merged lies opposite or beside e as named: no node is e itself or contains it, so that q is well
// defined and the image is a triangulation again. What is the preimage of a point of M'? For a
// point inside an edge it consists of one point in each edge class merged into it, joined by one
// arc across each triangle that merges them: a copy of a component of the graph in 3, hence a tree.
// For a point inside a triangle it is likewise a component of the graph in 4, a tree. For the point
// q(e) it is e, an arc by 1; and all others are points. So all preimages are contractible (cell-
// like) polyhedra. If both ends are finite, M and M' are thereby closed manifolds near q(e) and q
// is a cell-like map of 3-manifolds, which is a limit of homeomorphisms (Armentrout 1971,
// Siebenmann 1972; for these trees one can shrink arc after arc by hand). M' is a manifold there,
// because shrinking the arcs one after another, each in a ball of its own, gives M'.
// If w is not finite, take it out of M, and q(e) out of M'. M without w and e is M without w alone,
// because e without w is an unknotted ray in the cone over the link of w, lengthened by a collar
// into the ball around u: pushing it out to w is a homeomorphism. The other preimages are as
// before. Two non-finite ends must not be merged: their boundary components would become one.
//
// A cycle changes the manifold in general. In 3, by 1, it has two arcs at least: two triangles abc
// and abd with ac = ad and bc = bd are a sphere, which would be flattened to an arc; the manifold
// falls apart there, or loses a summand. In 4 it is a ring of tetrahedra without an outside, and
// they are a component that would vanish.
//
// Loops in M, and edges of which the two ends of a merged edge coincide, do no harm: the proof does
// not look at ends. The graph in 4 has degree 2 at most, because a triangle has two sides: it is a
// union of paths and cycles, and is followed as such. Edges that are their own reverse do not
// occur (Triangulation refuses them) and cannot arise: M' is a manifold off its vertices.

namespace tripus::topology {
namespace {

int edge_number(int a, int b) {
  return kEdgeNumber[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
}

}  // namespace

std::string_view to_string(CollapseRefusal refusal) {
  switch (refusal) {
    case CollapseRefusal::kNone:
      return "it can be made";
    case CollapseRefusal::kNoSuchPlace:
      return "there is no such edge";
    case CollapseRefusal::kSameEnds:
      return "both ends of the edge are one vertex";
    case CollapseRefusal::kNoFiniteEnd:
      return "neither end of the edge has a sphere as its link";
    case CollapseRefusal::kMeetsItself:
      return "a tetrahedron around the edge has it twice";
    case CollapseRefusal::kEdgeCycle:
      return "edges to be merged form a cycle";
    case CollapseRefusal::kFaceCycle:
      return "faces to be merged form a cycle";
  }
  throw InternalError("unknown CollapseRefusal");
}

CollapseRefusal EdgeCollapse::refusal(TetrahedronIndex t, int edge) {
  const MutableTriangulation& m = *m_;
  if (t >= m.slot_count() || !m.is_live(t) || edge < 0 || edge > 5)
    return CollapseRefusal::kNoSuchPlace;
  const auto start = EdgeWalk::start(t, edge);
  const Label one = m.vertex(t, start.a);
  const Label two = m.vertex(t, start.b);
  if (one == two) return CollapseRefusal::kSameEnds;
  if (!m.is_finite(one) && !m.is_finite(two)) return CollapseRefusal::kNoFiniteEnd;

  const Label collapsed = m.edge(t, edge);
  if (m.kept(collapsed) != 0) return CollapseRefusal::kNoFiniteEnd;
  corners_.clear();
  EdgeWalk walk = start;
  for (std::uint32_t i = m.valence(collapsed); i > 0; --i) {
    for (int other = 0; other < 6; ++other)
      if (other != walk.edge() && m.edge(walk.t, other) == collapsed)
        return CollapseRefusal::kMeetsItself;
    corners_.push_back(walk);
    walk.step(m.gluings());
  }
  if (has_edge_cycle() || merges_kept()) return CollapseRefusal::kEdgeCycle;
  if (has_face_cycle()) return CollapseRefusal::kFaceCycle;
  return CollapseRefusal::kNone;
}

std::uint32_t EdgeCollapse::node(TetrahedronIndex t, int e) {
  const Label label = m_->edge(t, e);
  std::uint32_t& known = node_of_edge_[label];
  if (known == 0) {
    nodes_.push_back({t, e, label});
    known = edge_sets_.add() + 1;
  }
  return known - 1;
}

bool EdgeCollapse::has_edge_cycle() {
  if (node_of_edge_.size() < m_->edge_labels()) node_of_edge_.resize(m_->edge_labels(), 0);
  edge_sets_.clear();
  nodes_.clear();
  bool cycle = false;
  for (const auto& at : corners_) {
    const auto t = static_cast<TetrahedronIndex>(at.t);
    const std::uint32_t one = node(t, edge_number(at.a, at.d));
    const std::uint32_t two = node(t, edge_number(at.b, at.d));
    cycle = !edge_sets_.join(one, two);
    if (cycle) break;
  }
  for (const Node& met : nodes_) node_of_edge_[met.label] = 0;
  return cycle;
}

/// Whether two kept edges would become one.
bool EdgeCollapse::merges_kept() {
  bool found = false;
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
    if (m_->kept(nodes_[i].label) != 0)
      for (std::uint32_t j = 0; j < i; ++j)
        found =
            found || (m_->kept(nodes_[j].label) != 0 && edge_sets_.root(i) == edge_sets_.root(j));
  return found;
}

// With tetrahedra as nodes and their common faces as arcs: the same cycles.
bool EdgeCollapse::has_face_cycle() {
  if (corner_of_.size() < m_->slot_count()) corner_of_.resize(m_->slot_count(), 0);
  tetrahedron_sets_.clear();
  for (const auto& at : corners_) corner_of_[at.t] = tetrahedron_sets_.add() + 1;
  bool cycle = false;
  for (std::uint32_t i = 0; i < corners_.size() && !cycle; ++i) {
    const auto& at = corners_[i];
    for (const int f : {at.a, at.b}) {
      const TetrahedronIndex other = m_->gluings().neighbour(at.t, f);
      const std::uint32_t j = corner_of_[other];
      if (j == 0) continue;
      // Each common face once, from its first side.
      const int g = m_->gluings().gluing(at.t, f)(f);
      if (std::pair(other, g) < std::pair(static_cast<TetrahedronIndex>(at.t), f)) continue;
      if (!tetrahedron_sets_.join(i, j - 1)) cycle = true;
    }
  }
  for (const auto& at : corners_) corner_of_[at.t] = 0;
  return cycle;
}

void EdgeCollapse::merge_labels() {
  MutableTriangulation& m = *m_;
  largest_.resize(nodes_.size());
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) largest_[i] = i;
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    std::uint32_t& largest = largest_[edge_sets_.root(i)];
    if (m.valence(nodes_[i].label) > m.valence(nodes_[largest].label)) largest = i;
  }
  // The classes are still circles of their own: each is relabelled by itself.
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    const std::uint32_t largest = largest_[edge_sets_.root(i)];
    if (i != largest) m.relabel_edge(nodes_[i].t, nodes_[i].e, nodes_[largest].label);
  }
  const auto& at = corners_.front();
  const auto t = static_cast<TetrahedronIndex>(at.t);
  const Label one = m.vertex(t, at.a);
  const Label two = m.vertex(t, at.b);
  const bool keep_one = !m.is_finite(one) || (m.is_finite(two) && m.degree(one) >= m.degree(two));
  if (keep_one)
    m.relabel_vertex(t, at.b, one);
  else
    m.relabel_vertex(t, at.a, two);
}

// What lies behind the two ends of every chain of merged faces is glued together.
void EdgeCollapse::close_gap() {
  MutableTriangulation& m = *m_;
  for (std::uint32_t i = 0; i < corners_.size(); ++i) corner_of_[corners_[i].t] = i + 1;
  for (const auto& at : corners_)
    for (const int f : {at.a, at.b}) {
      const TetrahedronIndex near = m.gluings_.neighbour(at.t, f);
      if (corner_of_[near] != 0) continue;
      const Perm4 out = m.gluings_.gluing(at.t, f);
      Perm4 map = out.inverse();
      auto t = static_cast<TetrahedronIndex>(at.t);
      do {
        const auto& here = corners_[corner_of_[t] - 1];
        map = Perm4::transposition(here.a, here.b) * map;
        const int leaving = map(out(f));
        const TetrahedronIndex next = m.gluings_.neighbour(t, leaving);
        map = m.gluings_.gluing(t, leaving) * map;
        t = next;
      } while (corner_of_[t] != 0);
      const int side = out(f);
      if (std::pair(t, map(side)) < std::pair(near, side)) continue;  // done from the other end
      m.glue(near, side, t, map);
      m.touched_.insert(m.touched_.end(), {near, t});
    }
  for (const auto& at : corners_) corner_of_[at.t] = 0;
}

void EdgeCollapse::collapse() {
  MutableTriangulation& m = *m_;
  if (m.steps_ != nullptr)
    m.steps_->push_collapse(static_cast<TetrahedronIndex>(corners_.front().t),
                            corners_.front().edge());
  merge_labels();
  m.touched_.clear();
  close_gap();
  const Label collapsed =
      m.edge(static_cast<TetrahedronIndex>(corners_.front().t), corners_.front().edge());
  for (const auto& at : corners_) m.uncount(static_cast<TetrahedronIndex>(at.t));
  m.free_edge(collapsed);
  for (const auto& at : corners_) m.free_tetrahedron(static_cast<TetrahedronIndex>(at.t));
}

void EdgeCollapse::apply(TetrahedronIndex t, int edge) {
  const CollapseRefusal reason = refusal(t, edge);
  if (reason == CollapseRefusal::kNone) return collapse();
  std::string place = "edge " + std::to_string(edge);
  if (edge >= 0 && edge < 6) {
    const auto [a, b] = kEdgeEnds[static_cast<std::size_t>(edge)];
    place = "edge " + std::to_string(a) + std::to_string(b);
  }
  throw InvalidInput("no collapse of " + place + " of tetrahedron " + std::to_string(t) + ": " +
                     std::string(to_string(reason)));
}

Gluings collapse_edge(const Gluings& gluings, TetrahedronIndex t, int edge) {
  MutableTriangulation triangulation{Triangulation(gluings)};
  EdgeCollapse(triangulation).apply(t, edge);
  return triangulation.compacted();
}

}  // namespace tripus::topology
