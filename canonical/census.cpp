#include "canonical/census.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <unordered_map>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

std::string boundary_of(const topology::Triangulation& triangulation) {
  BoundaryComponents boundary;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v) {
    const topology::VertexLink& link = triangulation.link(v);
    if (link.euler_characteristic == 0) {
      ++(link.orientable ? boundary.tori : boundary.klein_bottles);
    } else if (link.orientable) {
      boundary.genera.push_back(static_cast<std::size_t>(link.genus()));
    } else {
      boundary.crosscaps.push_back(static_cast<std::size_t>(2 - link.euler_characteristic));
    }
  }
  return to_string(std::move(boundary));
}

/// Where the metric was found on a simplification, the triangulation itself may carry it too.
bool carries_metric(const topology::Triangulation& triangulation, const CanonizeAnswer& answer,
                    structure::SolveOptions solve) {
  if (answer.manifold->simplified.empty())
    return answer.report.outcome == structure::Outcome::kGeometric;
  solve.evidence = false;
  return structure::solve(triangulation, solve).outcome == structure::Outcome::kGeometric;
}

CensusLine classify_one(const std::string& signature, CanonizeOptions options) {
  options.solve.evidence = false;
  CensusLine line;
  line.triangulation = signature;
  try {
    const topology::Triangulation triangulation(topology::decode_isosig(signature));
    const CanonizeAnswer answer = canonize(triangulation, options);
    line.resolved = answer.manifold.has_value();
    if (!line.resolved) return line;
    const CanonicalManifold& manifold = *answer.manifold;
    line.own_metric = carries_metric(triangulation, answer, options.solve);
    line.entry.boundary = boundary_of(triangulation);
    line.entry.volume = manifold.report.volume;
    line.entry.homology = topology::to_string(topology::first_homology(triangulation));
    line.entry.cells = manifold.cells;
    line.entry.keeping = manifold.isometries.orientation_preserving;
    line.entry.reversing = manifold.isometries.order - manifold.isometries.orientation_preserving;
    line.entry.signature = manifold.signature.unoriented;
  } catch (const InvalidInput& error) {
    line.reason = error.what();
  }
  return line;
}

/// Signatures of fewer tetrahedra are shorter.
bool shorter(const std::string& a, const std::string& b) {
  return a.size() != b.size() ? a.size() < b.size() : a < b;
}

/// Volumes that are equal come out equal to within rounding.
long long rounded_volume(const CensusEntry& entry) { return std::llround(entry.volume * 1e9); }

/// The order of the names: the larger the genus, the fewer edges.
bool comes_before(const CensusEntry& a, const CensusEntry& b) {
  if (a.tetrahedra != b.tetrahedra) return a.tetrahedra < b.tetrahedra;
  if (a.boundary != b.boundary)
    return a.boundary.size() != b.boundary.size() ? a.boundary.size() > b.boundary.size()
                                                  : a.boundary > b.boundary;
  if (rounded_volume(a) != rounded_volume(b)) return a.volume < b.volume;
  return shorter(a.signature, b.signature);
}

}  // namespace

std::vector<CensusLine> classify(const std::vector<std::string>& triangulations,
                                 const ClassifyOptions& options) {
  std::vector<std::optional<CensusLine>> results(triangulations.size());
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  std::atomic<bool> stop{false};
  const auto work = [&] {
    try {
      while (!stop && !options.stop) {
        const std::size_t k = next++;
        if (k >= triangulations.size()) return;
        CensusLine line = classify_one(triangulations[k], options.canonize);
        // What was interrupted is not "unresolved".
        if (options.stop.requested()) return;
        results[k] = std::move(line);
        if (!options.on_line) continue;
        const std::lock_guard lock(mutex);
        options.on_line(*results[k]);
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      stop = true;
    }
  };
  run_on_threads(std::min<std::size_t>(thread_count(options.threads), triangulations.size()), work);
  if (failure) std::rethrow_exception(failure);
  std::vector<CensusLine> lines;
  for (auto& result : results)
    if (result) lines.push_back(std::move(*result));
  return lines;
}

namespace {

/// "t4g3.17": by the place in a family of the same size and boundary.
void number_manifolds(Census& census) {
  std::map<std::string, std::size_t> count;
  for (CensusEntry& entry : census.manifolds) {
    const std::string family = fmt::format("t{}{}", entry.tetrahedra, entry.boundary);
    entry.name = fmt::format("{}.{}", family, ++count[family]);
  }
}

/// The names of the shipped census for its manifolds; any other is called by its signature.
void name_manifolds(Census& census) {
  std::unordered_map<std::string_view, const CensusEntry*> shipped;
  for (const CensusEntry& entry : shipped_census().manifolds) shipped[entry.signature] = &entry;
  for (CensusEntry& entry : census.manifolds) {
    const auto found = shipped.find(entry.signature);
    entry.name = found == shipped.end() ? entry.signature : found->second->name;
  }
}

}  // namespace

Census make_census(const std::vector<CensusLine>& lines, CensusNames names) {
  Census census;
  std::map<std::string, std::vector<const CensusLine*>> by_signature;
  for (const CensusLine& line : lines) {
    if (line.resolved) by_signature[line.entry.signature].push_back(&line);
    if (!line.resolved && line.reason.empty()) census.unresolved.push_back(line.triangulation);
  }
  std::ranges::sort(census.unresolved, shorter);
  census.unresolved.erase(std::unique(census.unresolved.begin(), census.unresolved.end()),
                          census.unresolved.end());
  for (auto& [signature, group] : by_signature) {
    std::ranges::sort(group, [](const CensusLine* a, const CensusLine* b) {
      return shorter(a->triangulation, b->triangulation);
    });
    // The numbers are those of the first triangulation, whatever order the lines came in.
    CensusEntry entry = group.front()->entry;
    entry.tetrahedra = topology::decode_isosig(group.front()->triangulation).tetrahedron_count();
    for (const CensusLine* line : group)
      if (entry.triangulations.empty() || entry.triangulations.back() != line->triangulation)
        entry.triangulations.push_back(line->triangulation);
    census.manifolds.push_back(std::move(entry));
  }
  std::ranges::sort(census.manifolds, comes_before);
  if (names == CensusNames::kNumbered) {
    number_manifolds(census);
  } else {
    name_manifolds(census);
  }
  return census;
}

}  // namespace tripus::canonical
