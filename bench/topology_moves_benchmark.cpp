#include <array>
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "topology/cyclic_cover.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"

// Moves a second, made and undone on cyclic covers of the tripus. A move that looked at more than
// its neighbourhood would slow down with the size; Rebuild is that baseline: the skeleton made
// anew after every move. The table must come back as it was, up to labels, before it is timed.

namespace tripus::topology {
namespace {

Gluings tripus_cover(std::int64_t tetrahedra) {
  const Triangulation base(decode_isosig("cPcbbbihq"));
  return cyclic_cover(base.gluings(), *primitive_class(base),
                      static_cast<std::size_t>(tetrahedra / 2));
}

void make_and_undo(Gluings& gluings, const Move& move) {
  const MoveChange change = apply(gluings, move);
  apply(gluings, *change.inverse);
}

void run_pairs(benchmark::State& state, Move move) {
  Gluings gluings = tripus_cover(state.range(0));
  {
    Gluings once = gluings;
    make_and_undo(once, move);
    if (!is_isomorphic(once, gluings)) state.SkipWithError("the move was not undone");
  }
  const auto count = static_cast<TetrahedronIndex>(gluings.tetrahedron_count());
  TetrahedronIndex t = 0;
  for (auto _ : state) {
    move.tetrahedron = t;
    make_and_undo(gluings, move);
    t = (t + 7919) % count;
  }
  state.counters["moves_per_s"] =
      benchmark::Counter(2, benchmark::Counter::kIsIterationInvariantRate);
}

void BM_TwoThree(benchmark::State& state) { run_pairs(state, {.kind = MoveKind::kTwoThree}); }
BENCHMARK(BM_TwoThree)->Arg(20)->Arg(2000)->Arg(200'000);

void BM_OneFour(benchmark::State& state) { run_pairs(state, {.kind = MoveKind::kOneFour}); }
BENCHMARK(BM_OneFour)->Arg(2000);

void BM_ZeroTwoEdge(benchmark::State& state) {
  run_pairs(state, {.kind = MoveKind::kZeroTwoEdge, .steps = 3});
}
BENCHMARK(BM_ZeroTwoEdge)->Arg(2000);

void BM_TwoThreeRebuild(benchmark::State& state) {
  Gluings gluings = tripus_cover(state.range(0));
  const Move move{.kind = MoveKind::kTwoThree};
  for (auto _ : state) {
    const MoveChange change = apply(gluings, move);
    benchmark::DoNotOptimize(Triangulation(gluings).edge_count());
    apply(gluings, *change.inverse);
    benchmark::DoNotOptimize(Triangulation(gluings).edge_count());
  }
  state.counters["moves_per_s"] =
      benchmark::Counter(2, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(BM_TwoThreeRebuild)->Arg(20)->Arg(2000);

void BM_RandomWalk(benchmark::State& state) {
  const Gluings start = tripus_cover(state.range(0));
  const auto limit = start.tetrahedron_count() + 20;
  std::uint64_t seed = 1;
  for (auto _ : state) {
    Gluings gluings = start;
    const auto made = randomize(gluings, {.count = 1000, .seed = seed++, .max_tetrahedra = limit});
    if (made.size() != 1000) state.SkipWithError("the walk stopped");
  }
  state.counters["moves_per_s"] =
      benchmark::Counter(1000, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(BM_RandomWalk)->Arg(20);

void BM_AllMoves(benchmark::State& state) {
  const Triangulation triangulation(tripus_cover(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(all_moves(triangulation, kUsualMoves).size());
}
BENCHMARK(BM_AllMoves)->Arg(20)->Arg(2000);

}  // namespace
}  // namespace tripus::topology
