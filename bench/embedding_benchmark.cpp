// Placing tetrahedra, growing the universal cover, cutting cells into triangles.
#include <cmath>
#include <queue>
#include <vector>

#include <benchmark/benchmark.h>

#include "embedding/tessellate.hpp"
#include "structure/solve.hpp"
#include "topology/cyclic_cover.hpp"
#include "topology/isosig.hpp"

namespace {

using namespace tripus;

struct Sample {
  topology::Triangulation triangulation;
  embedding::Embedding embedded;
};

Sample make_sample(topology::Gluings gluings) {
  topology::Triangulation triangulation(std::move(gluings));
  const auto report = structure::solve(triangulation);
  auto embedded = embedding::embed(triangulation, report.edge_lengths);
  return {std::move(triangulation), std::move(embedded)};
}

const Sample& tripus_sample() {
  static const Sample kSample = make_sample(topology::decode_isosig("cPcbbbihq"));
  return kSample;
}

/// A cover of the tripus: the time to place it is linear in its tetrahedra.
void place(benchmark::State& state) {
  const topology::Triangulation base(topology::decode_isosig("cPcbbbihq"));
  const topology::Triangulation cover(topology::cyclic_cover(
      base.gluings(), *topology::primitive_class(base), static_cast<std::size_t>(state.range(0))));
  const std::vector<double> lengths(cover.edge_count(), std::acosh((3 + std::sqrt(3.0)) / 4));
  for (auto _ : state) benchmark::DoNotOptimize(embedding::embed(cover, lengths));
  state.counters["us/tetrahedron"] = benchmark::Counter(
      static_cast<double>(cover.tetrahedron_count()) * 1e-6,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(place)->Arg(50)->Arg(5000)->Unit(benchmark::kMillisecond);

void grow(benchmark::State& state) {
  const Sample& sample = tripus_sample();
  embedding::UniversalCoverOptions options;
  options.max_cells = static_cast<std::size_t>(state.range(0));
  for (auto _ : state) {
    const auto cells = embedding::universal_cover(sample.embedded, sample.triangulation, options);
    if (cells.size() != options.max_cells) state.SkipWithError("wrong number of cells");
  }
}
BENCHMARK(grow)->Arg(2'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

/// The baseline: 4x4 matrices, and each new centre compared with all that are there.
void grow_by_comparing_all(benchmark::State& state) {
  const Sample& sample = tripus_sample();
  const auto& gluings = sample.triangulation.gluings();
  const auto wanted = static_cast<std::size_t>(state.range(0));
  for (auto _ : state) {
    std::vector<embedding::Cell> found{{0, embedding::Matrix4::Identity(), 0, embedding::kNoCell}};
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    queue.emplace(1.0, 0);
    std::size_t done = 0;
    for (; done < wanted; ++done) {
      const embedding::Cell cell = found[queue.top().second];
      queue.pop();
      for (std::size_t f = 0; f < 4; ++f) {
        const embedding::Matrix4 place =
            cell.isometry * sample.embedded.face_pairings[cell.tetrahedron][f];
        bool is_new = true;
        for (const embedding::Cell& other : found)
          is_new = is_new && (other.isometry.col(3) - place.col(3)).squaredNorm() > 1e-2;
        if (!is_new) continue;
        queue.emplace(place(3, 3), found.size());
        found.push_back({gluings.neighbour(cell.tetrahedron, static_cast<int>(f)), place,
                         cell.depth + 1, embedding::kNoCell});
      }
    }
    benchmark::DoNotOptimize(found);
  }
}
BENCHMARK(grow_by_comparing_all)->Arg(2'000)->Unit(benchmark::kMillisecond);

void tessellate(benchmark::State& state) {
  const Sample& sample = tripus_sample();
  const auto cells =
      embedding::universal_cover(sample.embedded, sample.triangulation, {.max_cells = 2000});
  std::size_t triangles = 0;
  for (auto _ : state) {
    const embedding::Tessellation cut(sample.embedded, cells,
                                      {embedding::Model::kPoincareBall, 0.01});
    triangles = cut.triangle_count();
    for (std::size_t c = 0; c < cells.size(); ++c) benchmark::DoNotOptimize(cut.points(c));
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(tessellate)->Unit(benchmark::kMillisecond);

}  // namespace
