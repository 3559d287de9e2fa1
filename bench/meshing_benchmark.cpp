#include <cmath>

#include <benchmark/benchmark.h>

#include "meshing/formats/formats.hpp"
#include "meshing/manifold.hpp"
#include "meshing/self_intersection.hpp"
#include "tests/support/sample_surfaces.hpp"

// Surfaces of 2k to 200k triangles: a torus has as many neighbours
// as any. The baseline of the self-intersection test is that over all pairs of triangles; that
// of the pipeline its largest part, TetGen.

namespace tripus::meshing {
namespace {

SurfaceMesh torus(std::int64_t triangles) {
  const auto n = static_cast<std::uint32_t>(std::sqrt(double(triangles)));
  return testing::torus_surface(2, 0.7, n, n / 2);
}

void count_triangles(benchmark::State& state, const SurfaceMesh& mesh) {
  state.counters["triangles_per_s"] = benchmark::Counter(
      double(mesh.triangles.size()), benchmark::Counter::kIsIterationInvariantRate);
}

void BM_ReadOff(benchmark::State& state) {
  const SurfaceMesh mesh = torus(state.range(0));
  const std::string text = write_off(mesh);
  if (read_off(text).mesh != mesh) state.SkipWithError("the surface was not read back");
  for (auto _ : state) benchmark::DoNotOptimize(read_off(text));
  count_triangles(state, mesh);
  state.SetBytesProcessed(std::int64_t(text.size()) * state.iterations());
}
BENCHMARK(BM_ReadOff)->Arg(2000)->Arg(200'000)->Unit(benchmark::kMillisecond);

void BM_SelfIntersection(benchmark::State& state) {
  const SurfaceMesh mesh = torus(state.range(0));
  for (auto _ : state)
    if (first_self_intersection(mesh)) state.SkipWithError("a torus was found to intersect itself");
  count_triangles(state, mesh);
}
BENCHMARK(BM_SelfIntersection)->Arg(2000)->Arg(20'000)->Arg(200'000)->Unit(benchmark::kMillisecond);

void BM_SelfIntersectionAllPairs(benchmark::State& state) {
  const SurfaceMesh mesh = torus(state.range(0));
  for (auto _ : state)
    for (std::size_t s = 0; s < mesh.triangles.size(); ++s)
      for (std::size_t t = s + 1; t < mesh.triangles.size(); ++t)
        if (triangles_cross(mesh, s, t))
          state.SkipWithError("a torus was found to intersect itself");
  count_triangles(state, mesh);
}
BENCHMARK(BM_SelfIntersectionAllPairs)->Arg(2000)->Unit(benchmark::kMillisecond);

void BM_Validate(benchmark::State& state) {
  const SurfaceMesh mesh = torus(state.range(0));
  if (require_valid(mesh).components.front().genus != 1) state.SkipWithError("not a torus");
  for (auto _ : state) benchmark::DoNotOptimize(require_valid(mesh));
  count_triangles(state, mesh);
}
BENCHMARK(BM_Validate)->Arg(2000)->Arg(20'000)->Arg(200'000)->Unit(benchmark::kMillisecond);

/// Every box face is a plane with thousands of triangles, where floating point decides nothing.
void BM_ValidateFlat(benchmark::State& state) {
  const auto n = static_cast<std::uint32_t>(std::sqrt(double(state.range(0)) / 12));
  SurfaceMesh mesh = testing::box_surface(0, 1, n);
  for (Point& p : mesh.points)  // turned, so that no face is along an axis
    p = {0.6 * p[0] - 0.8 * p[1], 0.8 * p[0] + 0.6 * p[1], p[2] + 0.1 * p[0]};
  for (auto _ : state) benchmark::DoNotOptimize(require_valid(mesh));
  count_triangles(state, mesh);
}
BENCHMARK(BM_ValidateFlat)->Arg(200'000)->Unit(benchmark::kMillisecond);

void BM_Tetrahedralize(benchmark::State& state) {
  const Region region = require_valid(torus(state.range(0)));
  std::size_t tetrahedra = 0;
  for (auto _ : state) tetrahedra = tetrahedralize(region).tetrahedra.size();
  state.counters["tetrahedra"] = double(tetrahedra);
}
BENCHMARK(BM_Tetrahedralize)->Arg(20'000)->UseRealTime()->Unit(benchmark::kMillisecond);

void BM_Manifold(benchmark::State& state) {
  const SurfaceMesh mesh = torus(state.range(0));
  if (manifold_of(SurfaceFile{mesh, {}}).tetrahedra[3] > 3) state.SkipWithError("not simplified");
  for (auto _ : state) benchmark::DoNotOptimize(manifold_of(SurfaceFile{mesh, {}}));
}
BENCHMARK(BM_Manifold)->Arg(20'000)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tripus::meshing
