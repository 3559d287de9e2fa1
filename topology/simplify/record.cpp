#include "topology/simplify/record.hpp"

#include <utility>

#include "base/error.hpp"
#include "topology/simplify/collapse.hpp"
#include "topology/simplify/mutable_triangulation.hpp"

namespace tripus::topology {
namespace {

constexpr unsigned kCollapse = 15;

void make_step(MutableTriangulation& m, EdgeCollapse& collapse, const SimplificationStep& step) {
  const auto [is_collapse, move] = step;
  const bool made = is_collapse
                        ? collapse.try_apply(move.tetrahedron, move.place) == CollapseRefusal::kNone
                        : m.try_apply(move);
  if (!made)
    throw InvalidInput("the record of a simplification does not belong to this table: no " +
                       (is_collapse ? "collapse of edge " + std::to_string(move.place) +
                                          " of tetrahedron " + std::to_string(move.tetrahedron)
                                    : to_string(move)));
}

/// Makes the steps first .. last - 1.
void make_steps(MutableTriangulation& m, const SimplificationRecord& record, std::size_t first,
                std::size_t last) {
  EdgeCollapse collapse(m);
  for (std::size_t n = first; n < last; ++n) make_step(m, collapse, record.step(n));
}

/// Makes the steps of a run and takes them back.
void walk_back(const Gluings& start, const SimplificationRecord& record, std::size_t first,
               std::size_t last, WayBack& way) {
  MutableTriangulation m{Triangulation(start)};
  SideLog log;
  m.log_sides(&log);
  EdgeCollapse collapse(m);
  struct Mark {
    std::size_t written, taken;  // sizes of the log
  };
  std::vector<Mark> marks;
  for (std::size_t n = first; n < last; ++n) {
    marks.push_back({log.written.size(), log.taken.size()});
    make_step(m, collapse, record.step(n));
  }
  Gluings after = m.gluings();
  std::vector<TetrahedronIndex> number(after.tetrahedron_count(), kNoTetrahedron);
  TetrahedronIndex next = 0;
  for (std::size_t t = 0; t < number.size(); ++t)
    if (m.is_live(t)) number[t] = next++;
  way.renumbered(after, number);
  Gluings before = after;
  for (std::size_t n = last; n-- > first;) {
    const Mark mark = marks[n - first];
    const auto undo = [&](Gluings& table) {
      for (std::size_t i = log.written.size(); i-- > mark.written;) {
        const SideLog::Side& side = log.written[i];
        table.set_one_side(side.slot / 4, static_cast<int>(side.slot % 4), side.neighbour,
                           side.gluing);
      }
    };
    undo(before);
    way.step({record.step(n), before, after, std::span(log.taken).subspan(mark.taken)});
    undo(after);
    log.written.resize(mark.written);
    log.taken.resize(mark.taken);
  }
}

}  // namespace

SimplificationStep SimplificationRecord::step(std::size_t n) const {
  const unsigned code = codes_[n];
  SimplificationStep step;
  step.is_collapse = code >> 4 == kCollapse;
  if (!step.is_collapse) step.move.kind = static_cast<MoveKind>(code >> 4);
  step.move.tetrahedron = places_[n];
  step.move.place = static_cast<std::uint8_t>(code >> 1 & 7);
  step.move.choice = static_cast<std::uint8_t>(code & 1);
  return step;
}

void SimplificationRecord::push_collapse(TetrahedronIndex t, int edge) {
  places_.push_back(t);
  codes_.push_back(static_cast<std::uint8_t>(kCollapse << 4 | static_cast<unsigned>(edge) << 1));
}

void SimplificationRecord::push_move(const Move& move) {
  places_.push_back(move.tetrahedron);
  codes_.push_back(static_cast<std::uint8_t>(static_cast<unsigned>(move.kind) << 4 |
                                             static_cast<unsigned>(move.place) << 1 | move.choice));
}

void SimplificationRecord::truncate(std::size_t size) {
  places_.resize(size);
  codes_.resize(size);
}

std::vector<std::size_t> SimplificationRecord::segments() const {
  std::vector<std::size_t> all{0};
  all.insert(all.end(), segments_.begin(), segments_.end());
  if (all.back() != size() || all.size() == 1) all.push_back(size());
  return all;
}

Gluings replayed(const Gluings& start, const SimplificationRecord& record) {
  Gluings table = start;
  const std::vector<std::size_t> segments = record.segments();
  for (std::size_t s = 0; s + 1 < segments.size(); ++s) {
    MutableTriangulation m{Triangulation(table)};
    make_steps(m, record, segments[s], segments[s + 1]);
    table = m.compacted();
  }
  return table;
}

void replay_backwards(const Gluings& start, const SimplificationRecord& record, WayBack& way) {
  const std::vector<std::size_t> segments = record.segments();
  std::vector<Gluings> starts{start};
  for (std::size_t s = 0; s + 2 < segments.size(); ++s) {
    MutableTriangulation m{Triangulation(starts.back())};
    make_steps(m, record, segments[s], segments[s + 1]);
    starts.push_back(m.compacted());
  }
  for (std::size_t s = segments.size() - 1; s-- > 0;)
    walk_back(starts[s], record, segments[s], segments[s + 1], way);
}

}  // namespace tripus::topology
