#include <cmath>
#include <cstdint>
#include <utility>

#include <benchmark/benchmark.h>

#include "tests/support/cube_meshes.hpp"
#include "topology/cone.hpp"
#include "topology/cyclic_cover.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"
#include "topology/simplify/locality.hpp"
#include "topology/simplify/reducer.hpp"
#include "topology/simplify/simplify.hpp"
#include "topology/subdivide.hpp"

// Simplification at 1e4, 1e5 and 1e6 tetrahedra, in nanoseconds a tetrahedron of the input: the
// same at every size if the work is linear, up to the caches. Inputs: barycentric subdivisions of
// cyclic covers of the tripus, as they are numbered and in random order, and meshes of cubes. The
// baseline is collapse with the skeleton made anew after every edge. Answers are checked first.

namespace tripus::topology {
namespace {

Gluings subdivided_cover(std::int64_t tetrahedra) {
  const Triangulation base(decode_isosig("cPcbbbihq"));
  const auto degree = static_cast<std::size_t>(tetrahedra / 48);
  return barycentric_subdivision(cyclic_cover(base.gluings(), *primitive_class(base), degree));
}

/// A ball of cubes with two tunnels that meet: a handlebody of genus 2.
Gluings cube_handlebody(std::int64_t tetrahedra) {
  const int n = static_cast<int>(std::cbrt(static_cast<double>(tetrahedra) / 6.0));
  return testing::cube_mesh(n, [&](int x, int y, int z) {
    return y != n / 2 || (x != n / 2 && (z != n / 2 || x < n / 2));
  });
}

void report(benchmark::State& state, std::size_t tetrahedra, std::size_t left) {
  state.counters["T"] = static_cast<double>(tetrahedra);
  state.counters["left"] = static_cast<double>(left);
  state.counters["per_T"] = benchmark::Counter(
      static_cast<double>(tetrahedra),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void BM_Subdivide(benchmark::State& state) {
  const Triangulation base(decode_isosig("cPcbbbihq"));
  const Gluings cover = cyclic_cover(base.gluings(), *primitive_class(base),
                                     static_cast<std::size_t>(state.range(0) / 48));
  for (auto _ : state) benchmark::DoNotOptimize(barycentric_subdivision(cover).memory_bytes());
  report(state, 24 * cover.tetrahedron_count(), 24 * cover.tetrahedron_count());
}
BENCHMARK(BM_Subdivide)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void BM_Cone(benchmark::State& state) {
  const Gluings mesh = cube_handlebody(state.range(0));
  const Triangulation coned(cone_boundary(mesh));
  int genus = 0;
  for (std::size_t v = 0; v < coned.vertex_count(); ++v) genus += coned.link(v).genus();
  if (genus != 2) state.SkipWithError("the cone is wrong");
  for (auto _ : state) benchmark::DoNotOptimize(cone_boundary(mesh).memory_bytes());
  report(state, mesh.tetrahedron_count(), coned.tetrahedron_count());
}
BENCHMARK(BM_Cone)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

std::size_t collapse_all(MutableTriangulation& m) {
  Reducer reducer(m);
  reducer.allow(Reducer::Moves::kCollapse);
  reducer.push_all();
  reducer.run();
  return m.tetrahedron_count();
}

void BM_Collapse(benchmark::State& state) {
  Gluings fine = random_relabelling(subdivided_cover(state.range(0)), 1);
  if (is_scattered(fine)) fine = breadth_first(fine);  // as simplify does
  const MutableTriangulation start{Triangulation(fine)};
  std::size_t left = 0;
  for (auto _ : state) {
    state.PauseTiming();
    MutableTriangulation m = start;
    state.ResumeTiming();
    left = collapse_all(m);
    if (m.finite_vertex_count() > 0) state.SkipWithError("finite vertices are left");
  }
  report(state, fine.tetrahedron_count(), left);
}
BENCHMARK(BM_Collapse)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void BM_CollapseRebuild(benchmark::State& state) {
  const Gluings fine = random_relabelling(subdivided_cover(state.range(0)), 1);
  std::size_t left = 0;
  for (auto _ : state) {
    MutableTriangulation m{Triangulation(fine)};
    for (bool again = true; again;) {
      again = false;
      MutableTriangulation rebuilt{Triangulation(m.compacted())};
      m = std::move(rebuilt);
      EdgeCollapse collapse(m);
      for (TetrahedronIndex t = 0; t < m.slot_count() && !again; ++t)
        for (int e = 0; e < 6 && !again; ++e)
          again = collapse.try_apply(t, e) == CollapseRefusal::kNone;
    }
    left = m.tetrahedron_count();
  }
  report(state, fine.tetrahedron_count(), left);
}
BENCHMARK(BM_CollapseRebuild)->Arg(1000)->Arg(10'000)->Unit(benchmark::kMillisecond);

/// 2-3 moves and back on a large triangulation whose labels are kept: what a move costs.
void BM_LabelledMoves(benchmark::State& state) {
  const Gluings fine = subdivided_cover(state.range(0));
  MutableTriangulation m{Triangulation(fine)};
  TetrahedronIndex t = 0;
  for (auto _ : state) {
    if (m.try_apply({.kind = MoveKind::kTwoThree, .tetrahedron = t})) {
      const TetrahedronIndex made = m.touched()[0];
      for (int e = 0; e < 6; ++e)
        if (m.valence(m.edge(made, e)) == 3 && m.try_apply({.kind = MoveKind::kThreeTwo,
                                                            .tetrahedron = made,
                                                            .place = static_cast<std::uint8_t>(e)}))
          break;
    }
    t = (t + 7919) % static_cast<TetrahedronIndex>(m.slot_count());
    while (!m.is_live(t)) t = (t + 1) % static_cast<TetrahedronIndex>(m.slot_count());
  }
  if (m.tetrahedron_count() != fine.tetrahedron_count())
    state.SkipWithError("a move was not undone");
  state.counters["moves_per_s"] =
      benchmark::Counter(2, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(BM_LabelledMoves)->Arg(1000)->Arg(1'000'000);

void simplify_to(benchmark::State& state, const Gluings& gluings, std::size_t least) {
  std::size_t left = 0;
  for (auto _ : state) left = simplify(gluings).tetrahedron_count();
  if (left > least) state.SkipWithError("not made as small as it can be");
  report(state, gluings.tetrahedron_count(), left);
}

void BM_SimplifyCover(benchmark::State& state) {
  const Gluings fine = subdivided_cover(state.range(0));
  simplify_to(state, fine, fine.tetrahedron_count() / 24);
}
BENCHMARK(BM_SimplifyCover)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond);

void BM_SimplifyShuffledCover(benchmark::State& state) {
  const Gluings fine = random_relabelling(subdivided_cover(state.range(0)), 1);
  simplify_to(state, fine, fine.tetrahedron_count() / 24);
}
BENCHMARK(BM_SimplifyShuffledCover)
    ->Arg(2'544)  // sizes for which the times of other programs are known
    ->Arg(10'128)
    ->Arg(50'448)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond);

void BM_SimplifyMesh(benchmark::State& state) {
  simplify_to(state, cone_boundary(cube_handlebody(state.range(0))), 3);
}
BENCHMARK(BM_SimplifyMesh)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tripus::topology
