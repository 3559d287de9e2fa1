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

/// The triangulations of triangulations-4.txt that carry a metric.
struct Census {
  std::vector<std::string> signatures;
  std::vector<topology::Triangulation> triangulations;
};

const Census& geometric_census() {
  static const Census kCensus = [] {
    Census census;
    for (const auto& signature : testing::data_lines("triangulations-4.txt")) {
      topology::Triangulation triangulation(topology::decode_isosig(signature));
      if (structure::solve(triangulation).outcome != structure::Outcome::kGeometric) continue;
      census.signatures.push_back(signature);
      census.triangulations.push_back(std::move(triangulation));
    }
    return census;
  }();
  return kCensus;
}

void run_census(benchmark::State& state, const std::string& method) {
  const Census& census = geometric_census();
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

/// The cyclic cover of the tripus with the given number of tetrahedra, from random lengths.
void run_cover(benchmark::State& state, const std::string& method) {
  const auto tetrahedra = static_cast<std::size_t>(state.range(0));
  const topology::Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  const auto shifts = topology::primitive_class(tripus);
  const topology::Triangulation cover(
      topology::cyclic_cover(tripus.gluings(), *shifts, tetrahedra / 2));
  structure::SolveOptions options;
  options.method = method;
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> sample(0.4, 0.9);
  options.initial_lengths.resize(cover.edge_count());
  for (double& l : options.initial_lengths) l = sample(random);
  structure::Report report;
  for (auto _ : state) report = structure::solve(cover, options);
  const double expected = 6.4519902708350328653 * static_cast<double>(tetrahedra) / 2;
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
                      [](benchmark::State& s) { run_cover(s, "newton-cg"); })
        ->Arg(size)
        ->Unit(benchmark::kMillisecond);
  }
  for (const std::int64_t size : {1000, 10000}) {
    RegisterBenchmark("cover of the tripus/newton (baseline)",
                      [](benchmark::State& s) { run_cover(s, "newton"); })
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
  RegisterBenchmark("census of four tetrahedra/eight at a time", run_census_at_once)
      ->Unit(benchmark::kMillisecond);
  RegisterBenchmark("census of four tetrahedra/program, JSON", run_program)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
