#include <cmath>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "meshing/formats/read_mesh.hpp"
#include "parameterise/harmonic_map.hpp"
#include "parameterise/quality.hpp"
#include "tests/support/data_files.hpp"

// The harmonic map of the knotted Y, from the marked solid to a gradient of 1e-10 (checked, and the
// volume of the image with it). Baseline, in the same iteration: steepest descent on the same
// energy from the same start, for kRatio times as long as Newton's method took. Where it has not
// come to Newton's energy by then, Newton's method is more than kRatio times as fast; what is
// missing is reported.

namespace tripus::parameterise {
namespace {

constexpr double kRatio = 40;

std::unique_ptr<MarkedSolid> knotted_y(std::size_t tetrahedra) {
  const std::string path = "../examples/surfaces/knotted-y.off";
  MarkOptions options;
  options.tetrahedralize.tetrahedra = tetrahedra;
  return mark_solid(meshing::read_mesh(testing::data_text(path), path,
                                       [](const std::string&) { return std::string(); }),
                    options);
}

/// About so many tetrahedra: state.range(0), or as few as it takes for 0.
void BM_HarmonicMap(benchmark::State& state) {
  const auto solid = knotted_y(static_cast<std::size_t>(state.range(0)));
  MapOptions options;
  options.tolerance = 1e-10;
  HarmonicMap map;
  for (auto _ : state) map = harmonic_map(*solid, Weights::kCotangent, options);
  if (map.max_gradient > 1e-10 ||
      std::abs(quality(*solid, map.points).image_volume - solid->report.volume) > 1e-8)
    state.SkipWithError("the map is wrong");
  const auto tetrahedra = static_cast<double>(solid->mesh.tetrahedra.size());
  state.counters["tetrahedra"] = tetrahedra;
  state.counters["steps"] = map.iterations;
  state.counters["cg_steps"] = static_cast<double>(map.linear_iterations);
  state.counters["us_per_tetrahedron_step"] = 1e6 * map.seconds / (tetrahedra * map.iterations);
}
BENCHMARK(BM_HarmonicMap)->Arg(0)->Arg(20'000)->Arg(200'000)->Unit(benchmark::kMillisecond);

void BM_AgainstSteepestDescent(benchmark::State& state) {
  const auto solid = knotted_y(static_cast<std::size_t>(state.range(0)));
  MapOptions options;
  options.tolerance = 1e-10;
  MapOptions descending = options;
  descending.minimiser = Minimiser::kDescent;
  descending.max_iterations = 1'000'000;
  HarmonicMap map, descent;
  for (auto _ : state) {
    map = harmonic_map(*solid, Weights::kCotangent, options);
    descending.time_limit = kRatio * map.seconds;
    descent = harmonic_map(*solid, Weights::kCotangent, descending);
  }
  if (map.max_gradient > 1e-10) state.SkipWithError("the map is wrong");
  state.counters["newton_s"] = map.seconds;
  state.counters["descent_s"] = descent.seconds;
  state.counters["descent_steps"] = descent.iterations;
  state.counters["descent_gradient"] = descent.max_gradient;
  state.counters["energy_too_much"] = descent.energy / map.energy - 1;
}
BENCHMARK(BM_AgainstSteepestDescent)
    ->Arg(0)
    ->Arg(20'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tripus::parameterise
