// Orthospectra: arcs a second, and what the same list costs by whole cells of the universal cover.
#include <benchmark/benchmark.h>

#include "orthospectrum/identities.hpp"
#include "tests/support/spectra.hpp"

namespace {

using namespace tripus;

/// The last has a cusp beside its boundary.
constexpr const char* kNames[] = {"cPcbbbihq", "dLQbcbcdhjw", "eLAkbbcdddujdj", "dLQacccjjkg"};

struct Sample {
  topology::Triangulation triangulation;
  structure::Report report;
};

const Sample& sample(std::int64_t n) {
  static const std::vector<Sample> kSamples = [] {
    std::vector<Sample> samples;
    for (const char* name : kNames) {
      topology::Triangulation triangulation(topology::decode_isosig(name));
      structure::Report report = structure::solve(triangulation);
      samples.push_back({std::move(triangulation), std::move(report)});
    }
    return samples;
  }();
  return kSamples[static_cast<std::size_t>(n)];
}

/// Unfolding from every tile; arcs listed, or sums alone.
void unfold(benchmark::State& state, bool keep_arcs) {
  const Sample& manifold = sample(state.range(0));
  orthospectrum::SpectrumOptions options;
  options.length = static_cast<double>(state.range(1));
  options.keep_arcs = keep_arcs;
  Context context;
  context.threads = 1;
  double arcs = 0, windows = 0;
  for (auto _ : state) {
    const auto spectrum = orthospectrum::orthospectrum(
        manifold.triangulation, manifold.report.edge_lengths, options, context);
    arcs = static_cast<double>(spectrum.arc_count);
    windows = static_cast<double>(spectrum.windows);
    double area = 0;
    for (const auto& vertex : manifold.report.vertices)
      if (vertex.kind == topology::VertexKind::kHyperideal) area += vertex.area;
    if (!(spectrum.sums.area() < area && spectrum.sums.area() > 0.97 * area))
      state.SkipWithError("the discs do not cover the boundary");
  }
  state.SetLabel(kNames[state.range(0)]);
  state.counters["arcs"] = arcs;
  state.counters["windows/arc"] = windows / arcs;
  state.counters["arcs/s"] =
      benchmark::Counter(arcs, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_CAPTURE(unfold, list, true)
    ->Args({0, 6})
    ->Args({0, 8})
    ->Args({0, 10})
    ->Args({1, 9})
    ->Args({2, 9})
    ->Args({3, 9})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(unfold, sums, false)
    ->Args({0, 8})
    ->Args({0, 10})
    ->Args({0, 12})
    ->Unit(benchmark::kMillisecond);

/// The baseline: all planes of all cells of the universal cover that are near enough.
void by_all_cells(benchmark::State& state) {
  static const testing::Embedded manifold = testing::embedded_tripus();
  const auto length = static_cast<double>(state.range(0));
  const auto expected = testing::counted_by_length(
      testing::spectrum_of(manifold.triangulation, manifold.report, length));
  double arcs = 0;
  for (auto _ : state) {
    const auto found = testing::counted_by_length(testing::brute_force_arcs(manifold, length));
    if (found.size() != expected.size()) state.SkipWithError("other arcs");
    arcs = 0;
    for (const auto& group : found) arcs += group.count;
  }
  state.counters["arcs"] = arcs;
  state.counters["arcs/s"] =
      benchmark::Counter(arcs, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(by_all_cells)->Arg(4)->Unit(benchmark::kMillisecond);

/// The same list as the baseline.
void by_unfolding(benchmark::State& state) {
  const Sample& manifold = sample(0);
  orthospectrum::SpectrumOptions options;
  options.length = static_cast<double>(state.range(0));
  Context context;
  context.threads = 1;
  double arcs = 0;
  for (auto _ : state) {
    arcs = static_cast<double>(orthospectrum::orthospectrum(manifold.triangulation,
                                                            manifold.report.edge_lengths, options,
                                                            context)
                                   .arc_count);
  }
  state.counters["arcs/s"] =
      benchmark::Counter(arcs, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(by_unfolding)->Arg(4)->Arg(6)->Unit(benchmark::kMicrosecond);

}  // namespace
