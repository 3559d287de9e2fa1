#include <cmath>
#include <numbers>

#include <benchmark/benchmark.h>

#include "meshing/self_intersection.hpp"
#include "meshing/tube/detail/stages.hpp"
#include "meshing/tube/tube_surface.hpp"

// Triangles a second of a trefoil's tube in a sphere. Baseline of the sampling: the same function
// at every point of the grid instead of the blocks near the surface, without drawing anything. A
// whole tube is checked (genus, self-intersections) every time, as for users. Baseline of the
// pipes: the sampled tube of 10 edges around, which is what they replaced.

namespace tripus::meshing {
namespace {

SpatialGraph trefoil() {
  SpatialGraph graph;
  graph.edges.emplace_back();
  for (int k = 0; k <= 48; ++k) {
    const double t = 2 * std::numbers::pi * (k % 48) / 48;
    graph.edges[0].push_back({(2 + std::cos(3 * t)) * std::cos(2 * t),
                              (2 + std::cos(3 * t)) * std::sin(2 * t), std::sin(3 * t)});
  }
  graph.outer = OuterSphere{{0, 0, 0}, 4.5};
  return graph;
}

tube::TubeStrands trefoil_strands() {
  return tube::make_strands(trefoil(), tube::OuterSurface(OuterSphere{{0, 0, 0}, 4.5}));
}

/// Cells along the sphere's diameter: state.range(0).
void BM_Sampling(benchmark::State& state) {
  const tube::TubeStrands strands = trefoil_strands();
  const double cell = 9.0 / double(state.range(0));
  const tube::TubeRegion region(strands, 0.4, 0.35);
  std::size_t triangles = 0;
  for (auto _ : state) triangles = tube::march(region, cell, 1u << 24, {}).triangles.size();
  state.counters["triangles"] = double(triangles);
  state.counters["triangles_per_s"] =
      benchmark::Counter(double(triangles), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(BM_Sampling)->Arg(32)->Arg(64)->Arg(128)->Unit(benchmark::kMillisecond);

void BM_SamplingDenseBaseline(benchmark::State& state) {
  const tube::TubeStrands strands = trefoil_strands();
  const double cell = 9.0 / double(state.range(0));
  const tube::TubeRegion region(strands, 0.4, 0.35);
  const std::size_t triangles = tube::march(region, cell, 1u << 24, {}).triangles.size();
  for (auto _ : state) {
    double sum = 0;
    const int n = int(state.range(0));
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        for (int k = 0; k <= n; ++k) {
          const Point even{cell * i - 4.5, cell * j - 4.5, cell * k - 4.5};
          const double half = cell / 2;
          sum +=
              region.value(even) + region.value({even[0] + half, even[1] + half, even[2] + half});
        }
    benchmark::DoNotOptimize(sum);
  }
  state.counters["triangles_per_s"] =
      benchmark::Counter(double(triangles), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(BM_SamplingDenseBaseline)->Arg(32)->Arg(64)->Arg(128)->Unit(benchmark::kMillisecond);

void BM_Tube(benchmark::State& state) {
  const SpatialGraph graph = trefoil();
  std::size_t triangles = 0;
  for (auto _ : state) {
    const Tube tube = make_tube(graph, {.triangles = std::size_t(state.range(0))});
    triangles = tube.surface.triangles.size();
  }
  state.counters["triangles"] = double(triangles);
  state.counters["triangles_per_s"] =
      benchmark::Counter(double(triangles), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(BM_Tube)
    ->Arg(3'000)
    ->Arg(30'000)
    ->Arg(300'000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

/// The tube without wishes, in pipes, and as it was before there were any.
void BM_Pipes(benchmark::State& state) {
  const SpatialGraph graph = trefoil();
  std::size_t triangles = 0;
  for (auto _ : state) triangles = make_tube(graph).surface.triangles.size();
  state.counters["triangles"] = double(triangles);
}
BENCHMARK(BM_Pipes)->Unit(benchmark::kMillisecond);

void BM_PipesSampledBaseline(benchmark::State& state) {
  const SpatialGraph graph = trefoil();
  std::size_t triangles = 0;
  for (auto _ : state) triangles = make_tube(graph, {.edges_around = 10}).surface.triangles.size();
  state.counters["triangles"] = double(triangles);
}
BENCHMARK(BM_PipesSampledBaseline)->Unit(benchmark::kMillisecond)->Iterations(1);

/// The check alone, for comparison.
void BM_SelfIntersectionCheck(benchmark::State& state) {
  const SurfaceMesh surface = tube_surface(trefoil(), {.triangles = std::size_t(state.range(0))});
  for (auto _ : state)
    if (first_self_intersection(surface)) state.SkipWithError("the surface crosses itself");
  state.counters["triangles_per_s"] = benchmark::Counter(
      double(surface.triangles.size()), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(BM_SelfIntersectionCheck)->Arg(30'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tripus::meshing
