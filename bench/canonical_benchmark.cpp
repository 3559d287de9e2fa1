// Canonical decompositions: one comparison, and whole lists.
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "canonical/census.hpp"
#include "canonical/compare.hpp"
#include "tests/support/data_files.hpp"
#include "topology/isosig.hpp"

namespace {

using namespace tripus;

const std::vector<std::string>& four_tetrahedra() {
  static const auto kList = testing::data_lines("triangulations-4.txt");
  return kList;
}

/// Manifolds of four tetrahedra that only their decompositions tell apart, and the dearest ones,
/// whose zeros need 50 digits.
void run_compare(benchmark::State& state, const char* cells) {
  canonical::CensusQuery query;
  query.tetrahedra = 4;
  query.cells = cells;
  std::vector<topology::Triangulation> manifolds;
  for (const auto* entry : canonical::select(canonical::shipped_census(), query)) {
    if (manifolds.size() == 64) break;
    manifolds.emplace_back(topology::decode_isosig(entry->triangulations.back()));
  }
  std::size_t k = 0;
  for (auto _ : state) {
    const auto& a = manifolds[k % manifolds.size()];
    const auto& b = manifolds[(k + k / manifolds.size() % 2) % manifolds.size()];
    const bool same = (k / manifolds.size()) % 2 == 0;
    const auto comparison = canonical::compare(a, b);
    if ((comparison.verdict == canonical::Verdict::kHomeomorphic) != same)
      state.SkipWithError("wrong verdict");
    ++k;
  }
}

/// The first so many of the list; time a triangulation must not depend on their number.
void run_classify(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  // Evenly over the list, which is sorted by kind.
  std::vector<std::string> list;
  for (std::size_t k = 0; k < count; ++k)
    list.push_back(four_tetrahedra()[k * four_tetrahedra().size() / count]);
  canonical::ClassifyOptions options;
  options.threads = 1;
  options.canonize.retriangulation.budget = canonical::kCensusBudget;
  for (auto _ : state) {
    const auto census = canonical::make_census(canonical::classify(list, options));
    if (census.manifolds.empty()) state.SkipWithError("no manifolds");
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.counters["time/triangulation"] = benchmark::Counter(
      static_cast<double>(state.range(0)),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void run_whole_census(benchmark::State& state) {
  std::vector<std::string> list;
  for (const char* file : {"triangulations-2.txt", "triangulations-3.txt", "triangulations-4.txt"})
    for (const auto& signature : testing::data_lines(file)) list.push_back(signature);
  canonical::ClassifyOptions options;
  options.threads = 2;
  options.canonize.retriangulation.budget = canonical::kCensusBudget;
  for (auto _ : state) {
    if (canonical::make_census(canonical::classify(list, options)).manifolds.size() != 5160)
      state.SkipWithError("not the census");
  }
}

}  // namespace

int main(int argc, char** argv) {
  using benchmark::RegisterBenchmark;
  for (const char* cells : {"4 tetrahedra", "5 tetrahedra", "1 octahedron", "2 pyramids"}) {
    RegisterBenchmark(("compare/" + std::string(cells)).c_str(), [cells](benchmark::State& s) {
      run_compare(s, cells);
    })->Unit(benchmark::kMicrosecond);
  }
  for (const std::int64_t size : {100, 1000, 10000})
    RegisterBenchmark("classify", run_classify)->Arg(size)->Unit(benchmark::kMillisecond);
  RegisterBenchmark("whole census, 2 threads", run_whole_census)
      ->Unit(benchmark::kSecond)
      ->UseRealTime();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
