#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "topology/gluings.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::topology {

/// One step of a simplification: an edge collapse, or a move of MoveKind.
struct SimplificationStep {
  bool is_collapse = false;
  Move move;  ///< a collapse: at edge `place` of `tetrahedron`; `kind` and `choice` mean nothing
};

/// What `simplify_recording` did, step by step: five bytes a step. With the table that it began
/// with, that is enough to make every step again, and to take them back one after another.
class SimplificationRecord {
 public:
  std::size_t size() const { return places_.size(); }
  SimplificationStep step(std::size_t n) const;
  void push_collapse(TetrahedronIndex t, int edge);
  /// The kinds that MutableTriangulation makes by replacing a ball: all but 0-2, 1-2 and 2-1.
  void push_move(const Move& move);
  /// Forgets the last steps, of a trial that was undone.
  void truncate(std::size_t size);
  /// From here on tetrahedra have the numbers of the table without empty slots.
  void compact() { segments_.push_back(size()); }
  /// [segments + 1] where the runs of steps between two renumberings begin, and the end.
  std::vector<std::size_t> segments() const;
  std::size_t memory_bytes() const {
    return places_.capacity() * sizeof(TetrahedronIndex) + codes_.capacity();
  }

 private:
  std::vector<TetrahedronIndex> places_;
  std::vector<std::uint8_t> codes_;  // kind * 16 + place * 2 + choice; kind 15 is a collapse
  std::vector<std::size_t> segments_;
};

/// Where the way back stands: one step, and the tables on both sides of it. Tetrahedra have the
/// numbers of their slots, which are the same in both tables; empty slots have open faces.
struct StepBack {
  SimplificationStep step;
  const Gluings& before;  ///< the larger one, where the step was made
  const Gluings& after;
  /// Tetrahedra that the step made, in the order of MoveBall::fresh; they are empty slots in
  /// `before`.
  std::span<const TetrahedronIndex> made;
};

/// What is told of the way back.
class WayBack {
 public:
  virtual ~WayBack() = default;
  /// Before the steps of a run are taken back: the table after them, in slots. `number` [slots] is
  /// the number of each tetrahedron in the table without empty slots, kNoTetrahedron for those.
  virtual void renumbered(const Gluings& slots, std::span<const TetrahedronIndex> number) = 0;
  virtual void step(const StepBack& step) = 0;
};

/// Makes the steps of a record again: the table that `simplify` gave, bit by bit.
/// Throws InvalidInput if the record is not of this table.
Gluings replayed(const Gluings& start, const SimplificationRecord& record);

/// The same, and then takes the steps back, the last one first, down to the table at the start,
/// telling of each. O(T + what the steps changed) time and memory; nothing is kept.
void replay_backwards(const Gluings& start, const SimplificationRecord& record, WayBack& way);

}  // namespace tripus::topology
