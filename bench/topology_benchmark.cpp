#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "topology/cyclic_cover.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"
#include "topology/triangulation.hpp"

// Costs of the topology module. The answer is checked before it is timed; `us_per_tet` and the
// other counters are per tetrahedron, so that linear growth shows as a constant column.

namespace tripus::topology {
namespace {

/// Some four-tetrahedron manifolds, with and without symmetry.
const std::vector<std::string> kFour{"eLAkbcbddmenur", "eLAkbcbddmejur", "eLAkbcbddhewtj",
                                     "eLAkbcbddhejtj", "eLAkbccdddprdk", "eLAkbccddepner"};

void require(bool right, benchmark::State& state, const char* what) {
  if (!right) state.SkipWithError(what);
}

/// The cyclic cover of the tripus with 2 * degree tetrahedra.
Gluings tripus_cover(std::int64_t degree) {
  const Triangulation base(decode_isosig("cPcbbbihq"));
  return cyclic_cover(base.gluings(), *primitive_class(base), static_cast<std::size_t>(degree));
}

std::vector<Gluings> shuffled_four() {
  std::vector<Gluings> inputs;
  for (std::uint64_t seed = 0; seed < 64; ++seed)
    for (const std::string& signature : kFour)
      inputs.push_back(random_relabelling(decode_isosig(signature), seed));
  return inputs;
}

void BM_IsosigEncodeFour(benchmark::State& state) {
  const auto inputs = shuffled_four();
  for (std::size_t i = 0; i < inputs.size(); ++i)
    require(isosig(inputs[i]) == kFour[i % kFour.size()], state, "wrong signature");
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(isosig(inputs[i++ % inputs.size()]));
}
BENCHMARK(BM_IsosigEncodeFour);

void BM_IsosigDecodeFour(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(decode_isosig(kFour[i++ % kFour.size()]));
}
BENCHMARK(BM_IsosigDecodeFour);

void BM_SkeletonFour(benchmark::State& state) {
  const auto inputs = shuffled_four();
  std::size_t i = 0;
  for (auto _ : state) {
    const Triangulation triangulation(inputs[i++ % inputs.size()]);
    benchmark::DoNotOptimize(triangulation.edge_count());
  }
}
BENCHMARK(BM_SkeletonFour);

void BM_HomologyFour(benchmark::State& state) {
  std::vector<Triangulation> inputs;
  inputs.reserve(kFour.size());
  for (const std::string& signature : kFour) inputs.emplace_back(decode_isosig(signature));
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(first_homology(inputs[i++ % inputs.size()]));
}
BENCHMARK(BM_HomologyFour);

void count_per_tetrahedron(benchmark::State& state, std::size_t tetrahedra) {
  state.counters["tets_per_s"] = benchmark::Counter(static_cast<double>(tetrahedra),
                                                    benchmark::Counter::kIsIterationInvariantRate);
}

void BM_SkeletonCover(benchmark::State& state) {
  const Gluings cover = random_relabelling(tripus_cover(state.range(0)), 1);
  std::size_t bytes = 0;
  for (auto _ : state) {
    const Triangulation triangulation(cover);
    bytes = triangulation.memory_bytes();
    require(triangulation.edge_count() == static_cast<std::size_t>(state.range(0)), state, "E");
  }
  count_per_tetrahedron(state, cover.tetrahedron_count());
  state.counters["bytes_per_tet"] =
      static_cast<double>(bytes) / static_cast<double>(cover.tetrahedron_count());
}
BENCHMARK(BM_SkeletonCover)->Arg(1000)->Arg(50'000)->Arg(500'000)->Unit(benchmark::kMillisecond);

void BM_IsosigEncodeCover(benchmark::State& state) {
  const Gluings cover = random_relabelling(tripus_cover(state.range(0)), 1);
  for (auto _ : state) benchmark::DoNotOptimize(isosig(cover));
  count_per_tetrahedron(state, cover.tetrahedron_count());
}
BENCHMARK(BM_IsosigEncodeCover)->Arg(1000)->Arg(50'000)->Unit(benchmark::kMillisecond);

void BM_IsosigDecodeCover(benchmark::State& state) {
  const std::string signature = isosig(tripus_cover(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(decode_isosig(signature));
  count_per_tetrahedron(state, 2 * static_cast<std::size_t>(state.range(0)));
}
BENCHMARK(BM_IsosigDecodeCover)->Arg(1000)->Arg(50'000)->Unit(benchmark::kMillisecond);

void BM_HomologyCover(benchmark::State& state) {
  const Triangulation cover(random_relabelling(tripus_cover(state.range(0)), 1));
  for (auto _ : state) benchmark::DoNotOptimize(first_homology(cover));
  count_per_tetrahedron(state, cover.tetrahedron_count());
}
BENCHMARK(BM_HomologyCover)->Arg(1000)->Arg(50'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tripus::topology
