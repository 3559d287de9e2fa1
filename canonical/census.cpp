#include "canonical/census.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "base/error.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

std::vector<int> genera(const topology::Triangulation& triangulation) {
  std::vector<int> result;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    result.push_back(triangulation.link(v).genus());
  std::ranges::sort(result);
  return result;
}

std::string boundary_of(const topology::Triangulation& triangulation) {
  std::string text;
  for (const int genus : genera(triangulation))
    text += fmt::format("{}g{}", text.empty() ? "" : "+", genus);
  return text;
}

CensusLine classify_one(const std::string& signature, const CanonizeOptions& options) {
  CensusLine line;
  line.triangulation = signature;
  try {
    const topology::Triangulation triangulation(topology::decode_isosig(signature));
    const CanonizeAnswer answer = canonize(triangulation, options);
    line.own_metric = answer.report.outcome == structure::Outcome::kGeometric;
    line.resolved = answer.manifold.has_value();
    if (!line.resolved) return line;
    const CanonicalManifold& manifold = *answer.manifold;
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
bool in_order(const CensusEntry& a, const CensusEntry& b) {
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
      while (!stop && (options.stop_requested == nullptr || !*options.stop_requested)) {
        const std::size_t k = next++;
        if (k >= triangulations.size()) return;
        CensusLine line = classify_one(triangulations[k], options.canonize);
        // What was interrupted is not "unresolved".
        if (options.stop_requested != nullptr && *options.stop_requested) return;
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
  const unsigned wanted =
      options.threads != 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> threads;
    for (unsigned k = 1; k < wanted && k < triangulations.size(); ++k) threads.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  std::vector<CensusLine> lines;
  for (auto& result : results)
    if (result) lines.push_back(std::move(*result));
  return lines;
}

Census make_census(const std::vector<CensusLine>& lines) {
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
  std::ranges::sort(census.manifolds, in_order);
  std::map<std::string, std::size_t> count;
  for (CensusEntry& entry : census.manifolds) {
    const std::string family = fmt::format("t{}{}", entry.tetrahedra, entry.boundary);
    entry.name = fmt::format("{}.{}", family, ++count[family]);
  }
  return census;
}

const CensusEntry* Census::find(std::string_view text) const {
  const auto found = std::ranges::find_if(manifolds, [&](const CensusEntry& entry) {
    return entry.signature == text || entry.name == text ||
           std::ranges::find(entry.triangulations, text) != entry.triangulations.end();
  });
  return found == manifolds.end() ? nullptr : &*found;
}

std::vector<const CensusEntry*> select(const Census& census, const CensusQuery& query) {
  std::vector<const CensusEntry*> result;
  for (const CensusEntry& entry : census.manifolds) {
    const bool fits = entry.volume >= query.least_volume && entry.volume <= query.greatest_volume &&
                      (query.boundary.empty() || entry.boundary == query.boundary) &&
                      (query.homology.empty() || entry.homology == query.homology) &&
                      (query.cells.empty() || entry.cells == query.cells) &&
                      (query.tetrahedra == 0 || entry.tetrahedra == query.tetrahedra);
    if (fits) result.push_back(&entry);
  }
  return result;
}

}  // namespace tripus::canonical
