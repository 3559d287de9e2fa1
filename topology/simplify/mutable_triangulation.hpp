#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "topology/moves/moves.hpp"
#include "topology/simplify/record.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {

/// An edge of a tetrahedron, for an edge class.
struct EdgePlace {
  TetrahedronIndex tetrahedron = 0;
  int edge = 0;
};

/// What moves wrote into a table: enough to take them back.
struct SideLog {
  struct Side {
    std::uint32_t slot;  ///< 4 t + f
    TetrahedronIndex neighbour;
    Perm4 gluing;
  };
  std::vector<Side> written;            ///< the old values, in the order of writing
  std::vector<TetrahedronIndex> taken;  ///< slots given to new tetrahedra
};

/// A closed-up triangulation that moves change in place and whose edge and vertex classes keep
/// their labels: every move updates labels, valences and degrees around it and nothing else, in
/// time O(1), or O(valence) where edges are merged. This is what makes long runs of moves linear.
///
/// Tetrahedra live in slots; a removed one leaves its slot empty for another, so numbers stay what
/// they are. About 70 bytes a slot.
///
/// Edges may be *kept*: no move or collapse takes them away or lays two of them upon each other,
/// and their ends count as vertices that are not finite. So a knotted graph of edges stays what it
/// is.
///
/// A *trial* keeps a record of what moves write, until it is kept or undone exactly.
class MutableTriangulation {
 public:
  using Label = std::uint32_t;

  explicit MutableTriangulation(const Triangulation& triangulation,
                                std::span<const EdgePlace> kept = {});

  /// Empty slots have four open faces.
  const Gluings& gluings() const { return gluings_; }
  std::size_t slot_count() const { return gluings_.tetrahedron_count(); }
  bool is_live(std::size_t t) const { return !gluings_.is_open(t, 0); }
  std::size_t tetrahedron_count() const { return slot_count() - free_tetrahedra_.size(); }

  /// Label of the edge class of edge e; equal for the same class, whatever its number.
  Label edge(std::size_t t, int e) const { return edges_[6 * t + static_cast<std::size_t>(e)]; }
  Label vertex(std::size_t t, int v) const {
    return vertices_[4 * t + static_cast<std::size_t>(v)];
  }
  /// Labels are below these; some are free.
  std::size_t edge_labels() const { return valences_.size(); }
  std::size_t vertex_labels() const { return degrees_.size(); }
  std::uint32_t valence(Label edge) const { return valences_[edge]; }
  /// Tetrahedron corners at the vertex: triangles of its link. 0 if the label is free.
  std::uint32_t degree(Label vertex) const { return degrees_[vertex]; }
  /// 0, or one more than the number of the kept edge in the list that was given.
  std::uint32_t kept(Label edge) const { return kept_.empty() ? 0 : kept_[edge]; }
  bool is_finite(Label vertex) const { return finite_[vertex] != 0; }
  std::size_t finite_vertex_count() const { return finite_vertex_count_; }
  std::size_t vertex_count() const { return vertex_labels() - free_vertices_.size(); }
  std::size_t edge_count() const { return edge_labels() - free_edges_.size(); }

  /// Why a move cannot be made: as topology::refusal says, but with O(1) look-ups for whether two
  /// edges are the same. 0-2 and 1-2 moves are not made here (kNoSuchPlace).
  MoveRefusal refusal(const Move& move) const;
  /// Makes a legal move; touched() then lists where something new may have become possible.
  void apply(const Move& move);
  bool try_apply(const Move& move) {
    if (refusal(move) != MoveRefusal::kNone) return false;
    apply(move);
    return true;
  }

  /// The live tetrahedra that the last move or collapse made, or, where it made none, those that it
  /// brought together.
  std::span<const TetrahedronIndex> touched() const { return touched_; }

  void begin_trial();
  void keep_trial();
  void undo_trial();

  /// From now on moves and collapses are recorded there, and those of undone trials forgotten;
  /// null: nothing is. Not with kept edges, which a replay does not know.
  void record_steps(SimplificationRecord* steps) { steps_ = steps; }
  /// From now on all that is written to sides is logged there, undone trials included.
  void log_sides(SideLog* log) { log_ = log; }

  /// The table without the empty slots, in the order of the slots.
  Gluings compacted() const;
  /// The kept edges in that table, in the order in which they were given.
  std::vector<EdgePlace> compacted_kept() const;

 private:
  friend class EdgeCollapse;

  enum class Field : std::uint8_t {
    kSide,
    kEdge,
    kVertex,
    kValence,
    kDegree,
    kFinite,
    kKept,
    kTakeTetrahedron,
    kFreeTetrahedron,
    kTakeEdge,
    kFreeEdge,
    kTakeVertex,
    kFreeVertex,
  };
  struct Written {
    Field field;
    Perm4 perm;
    std::uint32_t index;
    std::uint32_t old;
  };

  void record(Field field, std::uint32_t index, std::uint32_t old, Perm4 perm = {}) {
    if (recording_) journal_.push_back({field, perm, index, old});
  }
  void set_side(TetrahedronIndex t, int f, TetrahedronIndex other, Perm4 p);
  void glue(TetrahedronIndex t, int f, TetrahedronIndex other, Perm4 p) {
    set_side(t, f, other, p);
    set_side(other, p(f), t, p.inverse());
  }
  void set_edge(TetrahedronIndex t, int e, Label label);
  void set_vertex(TetrahedronIndex t, int v, Label label);
  void set_valence(Label edge, std::uint32_t valence);
  void set_degree(Label vertex, std::uint32_t degree);
  void set_kept(Label edge, std::uint32_t number);
  /// Whether a move that is legal otherwise would take a kept edge away, or merge two.
  bool hurts_kept(const Move& move) const;
  TetrahedronIndex take_tetrahedron();
  void free_tetrahedron(TetrahedronIndex t);
  Label take_edge();
  void free_edge(Label label);
  Label take_vertex();
  void free_vertex(Label label);

  /// Takes the corners of a tetrahedron out of (adds them to) valences and degrees.
  void uncount(TetrahedronIndex t);
  void count(TetrahedronIndex t);
  /// Gives every corner of the edge class at the given one another label, which gets its valence.
  void relabel_edge(TetrahedronIndex t, int e, Label to);
  void relabel_vertex(TetrahedronIndex t, int v, Label to);

  void merge_edges(const detail::MoveBall& ball);
  void replace_ball(const Move& move);
  void apply_two_one(const Move& move);

  Gluings gluings_;
  std::vector<Label> edges_;     // [T x 6]
  std::vector<Label> vertices_;  // [T x 4]
  std::vector<std::uint32_t> valences_;
  std::vector<std::uint32_t> degrees_;
  std::vector<std::uint8_t> finite_;
  std::vector<std::uint32_t> kept_;  // by edge label; empty if no edge is kept
  std::size_t kept_count_ = 0;
  std::vector<TetrahedronIndex> free_tetrahedra_;
  std::vector<Label> free_edges_;
  std::vector<Label> free_vertices_;
  std::size_t finite_vertex_count_ = 0;
  std::vector<TetrahedronIndex> touched_;
  std::vector<std::uint32_t> stack_;
  SimplificationRecord* steps_ = nullptr;
  std::size_t steps_before_trial_ = 0;
  SideLog* log_ = nullptr;
  bool recording_ = false;
  std::vector<Written> journal_;
};

}  // namespace tripus::topology
