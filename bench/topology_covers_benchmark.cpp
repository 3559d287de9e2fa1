#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "topology/covers/cover_homology.hpp"
#include "topology/covers/covers.hpp"
#include "topology/isosig.hpp"

// Searching for covers, against running through all permutations at all generators. Counts are
// those of Regina 7.3; `covers_per_s` counts covers found.

namespace tripus::topology {
namespace {

using Permutation = std::vector<std::uint32_t>;

const Triangulation& tripus() {
  static const Triangulation triangulation(decode_isosig("cPcbbbihq"));
  return triangulation;
}

std::size_t expected(std::int64_t degree) {
  static constexpr std::size_t kCounts[] = {0, 1, 3, 7, 30, 125, 996, 5343};
  return kCounts[degree];
}

void finish(benchmark::State& state, std::size_t found) {
  if (found != expected(state.range(0))) state.SkipWithError("wrong number of covers");
  state.counters["covers_per_s"] =
      benchmark::Counter(static_cast<double>(found), benchmark::Counter::kIsIterationInvariantRate);
}

/// Actions of the group alone.
void BM_TransitiveActions(benchmark::State& state) {
  const Presentation group = reduced(fundamental_group(tripus()).presentation).presentation;
  std::size_t found = 0;
  for (auto _ : state) {
    found = 0;
    for_each_transitive_action(group, static_cast<std::size_t>(state.range(0)),
                               [&](const TransitiveAction&) { return ++found > 0; });
  }
  finish(state, found);
}
BENCHMARK(BM_TransitiveActions)->DenseRange(3, 7)->Unit(benchmark::kMillisecond);

/// With the gluing tables, as `tripus cover` makes them.
void BM_Covers(benchmark::State& state) {
  std::size_t found = 0;
  for (auto _ : state) {
    found = 0;
    for_each_cover(tripus(), static_cast<std::size_t>(state.range(0)),
                   [&](const Cover&) { return ++found > 0; });
  }
  finish(state, found);
}
BENCHMARK(BM_Covers)->DenseRange(3, 7)->Unit(benchmark::kMillisecond);

/// With the homology of each, from the presentation.
void BM_CoverHomology(benchmark::State& state) {
  std::size_t found = 0;
  for (auto _ : state) {
    found = 0;
    for (const auto& [homology, count] :
         cover_homology(tripus(), static_cast<std::size_t>(state.range(0))))
      found += count;
  }
  finish(state, found);
}
BENCHMARK(BM_CoverHomology)->DenseRange(2, 5)->Unit(benchmark::kMillisecond);

bool satisfies(const std::vector<Permutation>& images, const std::vector<Permutation>& inverses,
               const Word& relator) {
  for (std::uint32_t k = 0; k < images[0].size(); ++k) {
    std::uint32_t at = k;
    for (const Letter letter : relator)
      at = (letter > 0 ? images : inverses)[generator_of(letter)][at];
    if (at != k) return false;
  }
  return true;
}

/// The baseline: every choice of permutations at the generators that are left, against the
/// relators. It does not even sort out what is not transitive or conjugate.
void BM_AllPermutations(benchmark::State& state) {
  const Presentation group = reduced(fundamental_group(tripus()).presentation).presentation;
  const auto degree = static_cast<std::uint32_t>(state.range(0));
  Permutation p(degree);
  for (std::uint32_t k = 0; k < degree; ++k) p[k] = k;
  std::vector<Permutation> all;
  std::vector<Permutation> all_inverse;
  do {
    all.push_back(p);
    all_inverse.push_back(p);
    for (std::uint32_t k = 0; k < degree; ++k) all_inverse.back()[p[k]] = k;
  } while (std::next_permutation(p.begin(), p.end()));
  std::size_t cases = 1;
  for (std::size_t g = 0; g < group.generator_count; ++g) cases *= all.size();
  std::vector<Permutation> images(group.generator_count);
  std::vector<Permutation> inverses(group.generator_count);
  for (auto _ : state) {
    std::size_t homomorphisms = 0;
    for (std::size_t code = 0; code < cases; ++code) {
      for (std::size_t g = 0, rest = code; g < images.size(); ++g, rest /= all.size()) {
        images[g] = all[rest % all.size()];
        inverses[g] = all_inverse[rest % all.size()];
      }
      homomorphisms += std::ranges::all_of(group.relators, [&](const Word& relator) {
        return satisfies(images, inverses, relator);
      });
    }
    benchmark::DoNotOptimize(homomorphisms);
  }
  state.counters["cases"] = static_cast<double>(cases);
}
BENCHMARK(BM_AllPermutations)->DenseRange(3, 5)->Unit(benchmark::kMillisecond);

/// A cyclic cover with very many sheets, from its class to its gluing table.
void BM_CyclicCover(benchmark::State& state) {
  const auto degree = static_cast<std::size_t>(state.range(0));
  const std::vector<std::int64_t> values{1, 2};
  for (auto _ : state) {
    const Cover cover = cyclic_cover_of_class(tripus(), degree, values);
    benchmark::DoNotOptimize(cover.gluings.tetrahedron_count());
  }
  state.counters["tets_per_s"] = benchmark::Counter(static_cast<double>(2 * degree),
                                                    benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(BM_CyclicCover)->Arg(500)->Arg(500'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tripus::topology
