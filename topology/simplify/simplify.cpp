#include "topology/simplify/simplify.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "topology/simplify/locality.hpp"
#include "topology/simplify/record.hpp"
#include "topology/simplify/reducer.hpp"
#include "topology/simplify/search.hpp"
#include "topology/simplify/simplify_keeping.hpp"
#include "topology/simplify/simplify_recording.hpp"

namespace tripus::topology {
namespace {

/// Trials of the search: until this many in a row, and this many in all, have brought nothing.
/// Small triangulations get some milliseconds. A trial takes some microseconds.
constexpr double kTrialsInARow = 6000;
constexpr double kTrialsInARowATetrahedron = 8;
constexpr double kTrials = 60'000;
constexpr double kTrialsATetrahedron = 60;

/// Random moves in a trial; more of them where fewer bring nothing.
constexpr int kLeastDepth = 2;
constexpr int kMostDepth = 8;

/// Steps between two looks at the stop flag.
constexpr unsigned kStepsBetweenLooks = 1024;

/// Components in which every vertex is finite; one must stay in each.
std::size_t closed_components(const Triangulation& triangulation, std::span<const EdgePlace> kept) {
  std::set<std::uint32_t> ends;  // of kept edges, which are not finite
  for (const auto& [t, e] : kept)
    for (const int end : kEdgeEnds[static_cast<std::size_t>(e)])
      ends.insert(triangulation.vertex_class(t, end));
  const std::size_t count = triangulation.tetrahedron_count();
  std::vector<bool> seen(count, false);
  std::vector<std::uint32_t> stack;
  std::size_t closed = 0;
  for (std::uint32_t first = 0; first < count; ++first) {
    if (seen[first]) continue;
    bool finite = true;
    seen[first] = true;
    stack.push_back(first);
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      for (int v = 0; v < 4; ++v) {
        const std::uint32_t vertex = triangulation.vertex_class(t, v);
        finite = finite && triangulation.link(vertex).euler_characteristic == 2 &&
                 (ends.empty() || ends.count(vertex) == 0);
        const std::uint32_t other = triangulation.gluings().neighbour(t, v);
        if (seen[other]) continue;
        seen[other] = true;
        stack.push_back(other);
      }
    }
    closed += finite;
  }
  return closed;
}

/// With the tetrahedra in another order where that is better for the caches; but what is wrong is
/// named by the caller's numbers.
Triangulation skeleton_of(const Gluings& closed, bool in_their_order) {
  require_consistent(closed, OpenFaces::kRefused);
  if (!in_their_order && is_scattered(closed)) {
    try {
      return Triangulation(breadth_first(closed));
    } catch (const InvalidInput&) {
    }
  }
  return Triangulation(closed);
}

class Simplifier {
 public:
  Simplifier(const Gluings& closed, const SimplifyOptions& options,
             std::span<const EdgePlace> kept = {}, SimplificationRecord* record = nullptr)
      : options_(&options), record_(record), kept_(kept.begin(), kept.end()) {
    const Triangulation triangulation = skeleton_of(closed, !kept.empty() || record != nullptr);
    require_different(triangulation);
    result_.given = triangulation.tetrahedron_count();
    component_count_ = triangulation.component_count();
    finite_to_keep_ = closed_components(triangulation, kept_);
    start(triangulation);
  }

  Simplified run();
  const std::vector<EdgePlace>& kept() const { return kept_; }

 private:
  void require_different(const Triangulation& triangulation) const {
    std::set<std::uint32_t> classes;
    for (const auto& [t, e] : kept_)
      if (t >= triangulation.tetrahedron_count() || e < 0 || e > 5 ||
          !classes.insert(triangulation.edge_class(t, e)).second)
        throw InvalidInput("edge " + std::to_string(e) + " of tetrahedron " + std::to_string(t) +
                           " is to be kept, but does not exist or is of a class kept already");
  }

  /// Before and after every run of moves; true if the caller wants to stop.
  bool looks_stopped(std::string_view stage) {
    if (++steps_ % kStepsBetweenLooks != 1) return result_.stopped;
    if (options_->progress) options_->progress(stage, m_->tetrahedron_count());
    if (options_->stop.requested()) result_.stopped = true;
    return result_.stopped;
  }
  std::size_t finite_vertices_to_go() const { return m_->finite_vertex_count() - finite_to_keep_; }

  void start(const Triangulation& triangulation) {
    m_.emplace(triangulation, kept_);
    m_->record_steps(record_);
    reducer_.emplace(*m_);
  }
  void run_queue(std::string_view stage) {
    while (!reducer_->is_idle() && !looks_stopped(stage)) reducer_->step();
  }
  void collapse_edges();
  void search();
  bool is_least() const;

  const SimplifyOptions* options_;
  SimplificationRecord* record_;
  std::vector<EdgePlace> kept_;  // in m_ as it was at the last start
  Simplified result_;
  std::size_t component_count_ = 0;
  std::size_t finite_to_keep_ = 0;
  std::optional<MutableTriangulation> m_;
  std::optional<Reducer> reducer_;
  unsigned steps_ = 0;
};

// A collapse somewhere may open the way for one elsewhere that does not touch it, so the whole is
// looked through again as long as that brings something; two or three times in practice.
void Simplifier::collapse_edges() {
  reducer_->allow(Reducer::Moves::kCollapse);
  std::size_t before = 0;
  do {
    before = m_->finite_vertex_count();
    reducer_->push_all();
    run_queue("collapse");
  } while (!result_.stopped && finite_vertices_to_go() > 0 && m_->finite_vertex_count() < before);
  reducer_->clear();
  reducer_->allow(Reducer::Moves::kAll);
}

/// E = T + chi/2 with a fixed chi, and every component has an edge: T cannot fall below this.
bool Simplifier::is_least() const {
  return m_->edge_count() == component_count_ || m_->tetrahedron_count() == component_count_;
}

void Simplifier::search() {
  LocalSearch search(*m_, *reducer_, finite_to_keep_, options_->seed);
  const auto size = static_cast<double>(m_->tetrahedron_count());
  const double in_a_row = kTrialsInARow + kTrialsInARowATetrahedron * size;
  const double in_all = kTrials + kTrialsATetrahedron * size;
  double in_vain = 0;
  for (double made = 0; !looks_stopped("search"); ++made, ++in_vain) {
    // No effort is spared for vertices that ought to go.
    const bool to_go = finite_vertices_to_go() > 0;
    const double effort = to_go ? std::max(1.0, options_->effort) : options_->effort;
    if (made >= effort * in_all || in_vain >= effort * in_a_row || (!to_go && is_least())) return;
    const int depth = kLeastDepth + static_cast<int>((kMostDepth - kLeastDepth) *
                                                     std::min(1.0, in_vain / in_a_row));
    const SearchSize before = search.size();
    search.trial(depth);
    if (search.size() < before) in_vain = -1;
  }
}

Simplified Simplifier::run() {
  collapse_edges();
  result_.collapsed = m_->tetrahedron_count();
  if (!result_.stopped) {
    reducer_->push_all();
    run_queue("reduce");
  }
  reducer_->clear();
  result_.reduced = m_->tetrahedron_count();
  if (!result_.stopped && (options_->effort > 0 || finite_vertices_to_go() > 0)) {
    const Triangulation compact(m_->compacted());  // close together in memory again
    kept_ = m_->compacted_kept();
    if (record_ != nullptr) record_->compact();
    start(compact);
    search();
  }
  result_.gluings = m_->compacted();
  kept_ = m_->compacted_kept();
  result_.finite_vertices_left = finite_vertices_to_go();
  if (options_->progress) options_->progress("done", m_->tetrahedron_count());
  return std::move(result_);
}

void require_effort(const SimplifyOptions& options) {
  if (!std::isfinite(options.effort) || options.effort < 0)
    throw InvalidInput("the effort of a simplification is " + std::to_string(options.effort) +
                       "; it must be 0 or more");
}

}  // namespace

Simplified simplify(const Gluings& closed, const SimplifyOptions& options) {
  require_effort(options);
  return Simplifier(closed, options).run();
}

Simplified simplify_recording(const Gluings& closed, SimplificationRecord& record,
                              const SimplifyOptions& options) {
  require_effort(options);
  return Simplifier(closed, options, {}, &record).run();
}

SimplifiedKeeping simplify_keeping(const Gluings& closed, std::span<const EdgePlace> kept,
                                   const SimplifyOptions& options) {
  require_effort(options);
  Simplifier simplifier(closed, options, kept);
  SimplifiedKeeping all{simplifier.run(), {}};
  all.kept = simplifier.kept();
  return all;
}

}  // namespace tripus::topology
