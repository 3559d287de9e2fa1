// Whole solves: thousands of small manifolds, inside the library and end to end, and one large
// manifold at a time.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "structure/solve.hpp"
#include "structure/solve_all.hpp"
#include "tests/support/data_files.hpp"
#include "topology/cyclic_cover.hpp"
#include "topology/isosig.hpp"

namespace {

using namespace tripus;

/// Triangulations that carry a metric.
struct Census {
  std::vector<std::string> signatures;
  std::vector<topology::Triangulation> triangulations;
};

Census geometric_ones(const std::vector<std::string>& signatures) {
  Census census;
  for (const auto& signature : signatures) {
    topology::Triangulation triangulation(topology::decode_isosig(signature));
    if (triangulation.tetrahedron_count() != 4) continue;
    if (structure::solve(triangulation).outcome != structure::Outcome::kGeometric) continue;
    census.signatures.push_back(signature);
    census.triangulations.push_back(std::move(triangulation));
  }
  return census;
}

/// Of four tetrahedra, with compact geodesic boundary.
const Census& geometric_census() {
  static const Census kCensus = geometric_ones(testing::data_lines("triangulations-4.txt"));
  return kCensus;
}

/// Of four tetrahedra, with cusps and no other boundary: SnapPy's.
const Census& cusped_census() {
  static const Census kCensus = [] {
    std::vector<std::string> signatures;
    for (const auto& row : testing::data_table("cusped-census-5.tsv"))
      signatures.push_back(row.at("isosig"));
    return geometric_ones(signatures);
  }();
  return kCensus;
}

/// Of four tetrahedra, with cusps beside geodesic boundary.
const Census& mixed_census() {
  static const Census kCensus = geometric_ones(testing::data_lines("triangulations-cusped.txt"));
  return kCensus;
}

void run_census(benchmark::State& state, const std::string& method,
                const Census& (*list)() = geometric_census) {
  const Census& census = list();
  structure::SolveOptions options;
  options.method = method;
  long iterations = 0, solved = 0;
  for (auto _ : state) {
    for (const auto& triangulation : census.triangulations) {
      const auto report = structure::solve(triangulation, options);
      if (report.outcome != structure::Outcome::kGeometric) state.SkipWithError("not geometric");
      iterations += report.iterations;
      ++solved;
    }
  }
  state.SetItemsProcessed(solved);
  state.counters["iterations"] = static_cast<double>(iterations) / static_cast<double>(solved);
}

/// Eight triangulations at a time.
void run_census_at_once(benchmark::State& state) {
  const Census& census = geometric_census();
  structure::Solutions solutions;
  for (auto _ : state) {
    solutions = structure::solve_all(census.triangulations);
    benchmark::DoNotOptimize(solutions.volumes.data());
  }
  for (const structure::Outcome outcome : solutions.outcomes)
    if (outcome != structure::Outcome::kGeometric) state.SkipWithError("not geometric");
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(solutions.size()));
  state.counters["one by one"] = static_cast<double>(solutions.reports.size());
}

/// The program itself: signatures in, JSON out.
void run_program(benchmark::State& state) {
  const Census& census = geometric_census();
  const std::string list = std::string(std::tmpnam(nullptr)) + ".txt";
  {
    std::ofstream out(list);
    for (const auto& signature : census.signatures) out << signature << '\n';
  }
  const std::string command =
      std::string(TRIPUS_PROGRAM) + " solve --json --threads 1 --batch " + list + " > /dev/null";
  for (auto _ : state)
    if (std::system(command.c_str()) != 0) state.SkipWithError("the program failed");
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(census.signatures.size()));
  std::remove(list.c_str());
}

/// A manifold with two tetrahedra and its volume.
struct Base {
  const char* signature;
  double volume;
};
constexpr Base kTripus{"cPcbbbihq", 6.4519902708350328653};
constexpr Base kFigureEight{"cPcbbbiht", 2.0298832128193072500};  // a cusp

enum class Start { kRandom, kDefault };

/// The cyclic cover with the given number of tetrahedra.
void run_cover(benchmark::State& state, const std::string& method, const Base& base,
               Start start = Start::kRandom) {
  const auto tetrahedra = static_cast<std::size_t>(state.range(0));
  const topology::Triangulation below(topology::decode_isosig(base.signature));
  const auto shifts = topology::primitive_class(below);
  const topology::Triangulation cover(
      topology::cyclic_cover(below.gluings(), *shifts, tetrahedra / 2));
  structure::SolveOptions options;
  options.method = method;
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> sample(0.4, 0.9);
  if (start == Start::kRandom) options.initial_lengths.resize(cover.edge_count());
  for (double& l : options.initial_lengths) l = sample(random);
  structure::Report report;
  for (auto _ : state) report = structure::solve(cover, options);
  const double expected = base.volume * static_cast<double>(tetrahedra) / 2;
  if (report.outcome != structure::Outcome::kGeometric ||
      std::fabs(report.volume / expected - 1) > 1e-12)
    state.SkipWithError("not the metric of the cover");
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.counters["newton"] = report.iterations;
  state.counters["cg"] = static_cast<double>(report.linear_iterations);
  state.counters["ns/tetrahedron"] = benchmark::Counter(
      static_cast<double>(state.range(0)) * 1e-9,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["peak MiB"] = static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace

int main(int argc, char** argv) {
  using benchmark::RegisterBenchmark;
  for (const std::int64_t size : {1000, 10000, 100000, 1000000}) {
    RegisterBenchmark("cover of the tripus/newton-cg",
                      [](benchmark::State& s) { run_cover(s, "newton-cg", kTripus); })
        ->Arg(size)
        ->Unit(benchmark::kMillisecond);
    RegisterBenchmark(
        "cover of the figure-eight knot's complement, default start/auto",
        [](benchmark::State& s) { run_cover(s, "auto", kFigureEight, Start::kDefault); })
        ->Arg(size)
        ->Unit(benchmark::kMillisecond);
    RegisterBenchmark("cover of the figure-eight knot's complement/newton-cg",
                      [](benchmark::State& s) { run_cover(s, "newton-cg", kFigureEight); })
        ->Arg(size)
        ->Unit(benchmark::kMillisecond);
  }
  for (const std::int64_t size : {1000, 10000}) {
    RegisterBenchmark("cover of the tripus/newton (baseline)",
                      [](benchmark::State& s) { run_cover(s, "newton", kTripus); })
        ->Arg(size)
        ->Unit(benchmark::kMillisecond);
  }
  for (const char* method : {"newton", "newton-cg", "ceres-lbfgs", "flow:curvature/euler"}) {
    const bool baseline = std::string(method).starts_with("flow");
    RegisterBenchmark(
        ("census of four tetrahedra/" + std::string(method) + (baseline ? " (baseline)" : ""))
            .c_str(),
        [method](benchmark::State& s) { run_census(s, method); })
        ->Unit(benchmark::kMillisecond);
  }
  RegisterBenchmark("census of four tetrahedra/newton, cusps", [](benchmark::State& s) {
    run_census(s, "newton", cusped_census);
  })->Unit(benchmark::kMillisecond);
  RegisterBenchmark("census of four tetrahedra/newton, cusps beside geodesic boundary",
                    [](benchmark::State& s) { run_census(s, "newton", mixed_census); })
      ->Unit(benchmark::kMillisecond);
  RegisterBenchmark("census of four tetrahedra/eight at a time", run_census_at_once)
      ->Unit(benchmark::kMillisecond);
  RegisterBenchmark("census of four tetrahedra/program, JSON", run_program)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
