// The way of a census: the list, verdicts with certificates, other triangulations where one carries
// no metric, classification. What is timed is checked by its counts, which are published or come
// from other programs.
#include <algorithm>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "canonical/census.hpp"
#include "structure/retriangulate.hpp"
#include "structure/solve.hpp"
#include "structure/solve_all.hpp"
#include "tests/support/data_files.hpp"
#include "topology/enumerate.hpp"
#include "topology/isosig.hpp"

namespace {

using namespace tripus;

/// All with so many tetrahedra; of five every 20th.
std::vector<std::string> list_of(std::size_t tetrahedra) {
  std::vector<std::string> list;
  std::size_t number = 0;
  for (const auto& piece :
       topology::enumeration_pieces(tetrahedra, topology::LinkChoice::kGeodesic))
    topology::enumerate(tetrahedra, topology::LinkChoice::kGeodesic, piece,
                        [&](const topology::Gluings& gluings, unsigned) {
                          if (tetrahedra < 5 || number++ % 20 == 0)
                            list.push_back(topology::isosig(gluings));
                        });
  return list;
}

void BM_Enumerate(benchmark::State& state) {
  const auto tetrahedra = static_cast<std::size_t>(state.range(0));
  std::uint64_t count = 0;
  for (auto _ : state) {
    count = 0;
    for (const auto& piece :
         topology::enumeration_pieces(tetrahedra, topology::LinkChoice::kGeodesic))
      count += topology::enumerate(tetrahedra, topology::LinkChoice::kGeodesic, piece,
                                   [](const topology::Gluings&, unsigned) {});
  }
  if (count != (tetrahedra == 4 ? 11048u : 579113u)) state.SkipWithError("wrong number");
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}
BENCHMARK(BM_Enumerate)->Arg(4)->Arg(5)->Unit(benchmark::kMillisecond);

void run_verdicts(benchmark::State& state, const structure::SolveOptions& options) {
  const auto list = list_of(static_cast<std::size_t>(state.range(0)));
  std::size_t geometric = 0;
  for (auto _ : state) {
    geometric = 0;
    for (const std::string& signature : list) {
      const auto report =
          structure::solve(topology::Triangulation(topology::decode_isosig(signature)), options);
      geometric += report.outcome == structure::Outcome::kGeometric;
      if (report.outcome == structure::Outcome::kUnresolved) state.SkipWithError("unresolved");
    }
  }
  if (state.range(0) == 4 && geometric != 5820) state.SkipWithError("wrong number");
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(list.size()));
}

void BM_Verdicts(benchmark::State& state) { run_verdicts(state, {}); }
/// The baseline: the way of verdicts before small programmes and quick steps, which a callback asks
/// for: up to a hundred steps of Newton's method, and only then the exact decision.
void BM_VerdictsAfterLongSearches(benchmark::State& state) {
  structure::SolveOptions options;
  options.on_iteration = [](int, double) {};
  run_verdicts(state, options);
}
BENCHMARK(BM_VerdictsAfterLongSearches)->Arg(4)->Arg(5)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Verdicts)->Arg(4)->Arg(5)->Unit(benchmark::kMillisecond);

/// Eight triangulations at a time: the same verdicts, with whole reports of what is not geometric.
void BM_VerdictsAtOnce(benchmark::State& state) {
  const auto list = list_of(static_cast<std::size_t>(state.range(0)));
  std::size_t geometric = 0;
  for (auto _ : state) {
    std::vector<topology::Triangulation> triangulations;
    triangulations.reserve(list.size());
    for (const std::string& signature : list)
      triangulations.emplace_back(topology::decode_isosig(signature));
    const auto solutions = structure::solve_all(triangulations);
    geometric = static_cast<std::size_t>(
        std::ranges::count(solutions.outcomes, structure::Outcome::kGeometric));
    if (std::ranges::count(solutions.outcomes, structure::Outcome::kUnresolved) > 0)
      state.SkipWithError("unresolved");
  }
  if (state.range(0) == 4 && geometric != 5820) state.SkipWithError("wrong number");
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(list.size()));
}
BENCHMARK(BM_VerdictsAtOnce)->Arg(4)->Arg(5)->Unit(benchmark::kMillisecond);

void BM_Retriangulate(benchmark::State& state) {
  std::vector<std::pair<topology::Triangulation, structure::Report>> starts;
  for (const std::string& signature : list_of(4)) {
    topology::Triangulation triangulation(topology::decode_isosig(signature));
    auto report = structure::solve(triangulation);
    if (report.outcome != structure::Outcome::kGeometric)
      starts.emplace_back(std::move(triangulation), std::move(report));
  }
  std::size_t found = 0;
  for (auto _ : state) {
    found = 0;
    for (const auto& [triangulation, report] : starts)
      found +=
          structure::retriangulate(triangulation, report, {}).end == structure::SearchEnd::kFound;
  }
  if (found != 387) state.SkipWithError("wrong number");
}
BENCHMARK(BM_Retriangulate)->Unit(benchmark::kSecond)->Iterations(1);

void BM_ClassifyUpToFour(benchmark::State& state) {
  std::vector<std::string> list;
  for (const std::size_t tetrahedra : {2u, 3u, 4u})
    for (std::string& each : list_of(tetrahedra)) list.push_back(std::move(each));
  canonical::ClassifyOptions options;
  options.canonize.retriangulation.budget = canonical::kCensusBudget;
  options.threads = static_cast<unsigned>(state.range(0));
  for (auto _ : state) {
    const auto census = canonical::make_census(canonical::classify(list, options));
    if (census.manifolds.size() != 5160) state.SkipWithError("wrong number");
  }
}
BENCHMARK(BM_ClassifyUpToFour)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kSecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
