// Verdicts with their evidence: every triangulation with four tetrahedra, and one certificate of a
// thousand. What is timed is checked first: verdicts by their evidence, certificates exactly.
#include <chrono>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "structure/detail/angle_programme.hpp"
#include "structure/detail/existence_routes.hpp"
#include "structure/existence.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "topology/cyclic_cover.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

const std::vector<topology::Triangulation>& four_tetrahedra() {
  static const auto kAll = [] {
    std::vector<topology::Triangulation> all;
    for (const auto& signature : testing::data_lines("triangulations-4.txt"))
      all.emplace_back(topology::decode_isosig(signature));
    return all;
  }();
  return kAll;
}

bool has_evidence(const topology::Triangulation& triangulation, const Report& report) {
  if (report.outcome == Outcome::kGeometric) return report.max_curvature <= 1e-12;
  const bool proved = (report.certificate && check(triangulation, *report.certificate)) ||
                      (report.strict_angles && check(triangulation, *report.strict_angles));
  return proved && report.outcome != Outcome::kUnresolved;
}

// The whole list. Minimising is the same without evidence; certifying is the difference.
void BM_Census(benchmark::State& state) {
  for (const auto& triangulation : four_tetrahedra())
    if (!has_evidence(triangulation, solve(triangulation))) state.SkipWithError("no evidence");
  SolveOptions plain;
  plain.evidence = false;
  double minimising = 0, all = 0;
  for (auto _ : state) {
    auto start = Clock::now();
    for (const auto& triangulation : four_tetrahedra())
      benchmark::DoNotOptimize(solve(triangulation));
    all += seconds_since(start);
    state.PauseTiming();
    start = Clock::now();
    for (const auto& triangulation : four_tetrahedra())
      benchmark::DoNotOptimize(solve(triangulation, plain));
    minimising += seconds_since(start);
    state.ResumeTiming();
  }
  state.counters["minimising"] = minimising / all;
  state.counters["certifying"] = 1 - minimising / all;
  state.counters["triangulations/s"] =
      static_cast<double>(state.iterations()) * static_cast<double>(four_tetrahedra().size()) / all;
}
BENCHMARK(BM_Census)->Unit(benchmark::kMillisecond);

/// Those without metric, every one in ten.
const std::vector<topology::Triangulation>& without_metric() {
  static const auto kSome = [] {
    std::vector<topology::Triangulation> some;
    int number = 0;
    for (const auto& triangulation : four_tetrahedra()) {
      const bool metric = solve(triangulation).outcome == Outcome::kGeometric;
      if (!metric && number++ % 10 == 0) some.push_back(triangulation);
    }
    return some;
  }();
  return kSome;
}

void BM_Certify(benchmark::State& state) {
  for (const auto& triangulation : without_metric()) existence(triangulation);  // checks itself
  for (auto _ : state)
    for (const auto& triangulation : without_metric())
      benchmark::DoNotOptimize(existence(triangulation));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(without_metric().size()));
}
BENCHMARK(BM_Certify)->Unit(benchmark::kMillisecond);

// The same decisions by the simplex method in rational arithmetic from the start.
void BM_CertifyByExactSimplex_Baseline(benchmark::State& state) {
  const auto decide = [](const topology::Triangulation& triangulation) {
    detail::AngleProgramme programme(triangulation);
    return programme.solve_exactly() ? detail::by_exact_basis(triangulation, programme)
                                     : std::nullopt;
  };
  for (const auto& triangulation : without_metric()) {
    const auto found = decide(triangulation);
    if (!found || found->index() != existence(triangulation).index()) state.SkipWithError("wrong");
  }
  for (auto _ : state)
    for (const auto& triangulation : without_metric())
      benchmark::DoNotOptimize(decide(triangulation));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(without_metric().size()));
}
BENCHMARK(BM_CertifyByExactSimplex_Baseline)->Unit(benchmark::kMillisecond);

topology::Triangulation large(const char* signature, std::int64_t tetrahedra) {
  const topology::Triangulation base(topology::decode_isosig(signature));
  const auto degree = static_cast<std::size_t>(tetrahedra) / base.tetrahedron_count();
  return topology::Triangulation(topology::random_relabelling(
      topology::cyclic_cover(base.gluings(), *topology::primitive_class(base), degree), 20));
}

// A cyclic cover with its labels shuffled: the minimisation that runs away, and the certificate.
void run_large(benchmark::State& state, const char* signature, bool whole_verdict) {
  const auto triangulation = large(signature, state.range(0));
  const auto found = existence(triangulation);
  if (!std::holds_alternative<Certificate>(found)) state.SkipWithError("no certificate");
  for (auto _ : state) {
    if (whole_verdict) {
      benchmark::DoNotOptimize(solve(triangulation));
    } else {
      benchmark::DoNotOptimize(existence(triangulation));
    }
  }
}
void BM_LargeNone(benchmark::State& state) { run_large(state, "dLQbcbcmebs", false); }
void BM_LargeSemi(benchmark::State& state) { run_large(state, "dLQbcbcaekw", false); }
void BM_LargeVerdictNone(benchmark::State& state) { run_large(state, "dLQbcbcmebs", true); }
void BM_LargeVerdictSemi(benchmark::State& state) { run_large(state, "dLQbcbcaekw", true); }
BENCHMARK(BM_LargeNone)->Arg(99)->Arg(999)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_LargeSemi)->Arg(99)->Arg(999)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_LargeVerdictNone)->Arg(999)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_LargeVerdictSemi)->Arg(999)->Unit(benchmark::kMillisecond);

// The exact simplex method alone on the same cover: what rounding the optimum saves.
void BM_LargeNoneByExactSimplex_Baseline(benchmark::State& state) {
  const auto triangulation = large("dLQbcbcmebs", state.range(0));
  for (auto _ : state) {
    detail::AngleProgramme programme(triangulation);
    if (!programme.solve_exactly() || !detail::by_exact_basis(triangulation, programme))
      state.SkipWithError("undecided");
  }
}
BENCHMARK(BM_LargeNoneByExactSimplex_Baseline)->Arg(99)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tripus::structure
