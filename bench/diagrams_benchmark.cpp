#include <cstdint>
#include <string>

#include <benchmark/benchmark.h>

#include "drawing/drawing.hpp"
#include "meshing/formats/read_graph.hpp"
#include "meshing/manifold.hpp"
#include "meshing/tube/tube_surface.hpp"
#include "structure/solve.hpp"
#include "topology/diagrams/exterior.hpp"
#include "topology/diagrams/random_diagram.hpp"
#include "topology/diagrams/small_exterior.hpp"
#include "topology/diagrams/tables.hpp"
#include "topology/simplify/simplify.hpp"

// From a diagram to its exterior, and the way through space (drawing, tube, mesh) as the baseline.
// Answers are checked first: boundary genera, volumes.

namespace tripus {
namespace {

using topology::Diagram;
using topology::Triangulation;

void BM_TriangulateRandomDiagram(benchmark::State& state) {
  const Diagram diagram = topology::random_diagram(std::size_t(state.range(0)), 1);
  std::size_t tetrahedra = 0;
  for (auto _ : state) tetrahedra = topology::exterior(diagram).gluings.tetrahedron_count();
  state.counters["T"] = double(tetrahedra);
}
BENCHMARK(BM_TriangulateRandomDiagram)
    ->Arg(1000)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Unit(benchmark::kMillisecond);

void BM_SimplifyRandomDiagram(benchmark::State& state) {
  const auto made = topology::exterior(topology::random_diagram(std::size_t(state.range(0)), 1));
  std::size_t left = 0;
  for (auto _ : state) left = topology::simplify(made.gluings).tetrahedron_count();
  state.counters["T"] = double(made.gluings.tetrahedron_count());
  state.counters["left"] = double(left);
}
BENCHMARK(BM_SimplifyRandomDiagram)
    ->Arg(1000)
    ->Arg(10'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

double volume_of(const Triangulation& triangulation) {
  structure::SolveOptions options;
  options.evidence = false;
  const structure::Report report = structure::solve(triangulation, options);
  return report.outcome == structure::Outcome::kGeometric ? report.volume : 0;
}

/// All 90: diagram to small triangulation to volume, where it carries the metric.
void BM_HandlebodyKnotsToVolumes(benchmark::State& state) {
  std::size_t geometric = 0;
  for (auto _ : state) {
    geometric = 0;
    for (const auto& entry : topology::table_of(topology::DiagramTable::kHandlebodyKnots))
      geometric +=
          volume_of(Triangulation(
              topology::small_exterior({.name = {}, .diagram = entry.diagram}).gluings)) > 0;
  }
  state.counters["geometric"] = double(geometric);
}
BENCHMARK(BM_HandlebodyKnotsToVolumes)->Unit(benchmark::kMillisecond);

constexpr const char* kTen[] = {"hk5_3", "hk6_2", "hk6_3", "hk6_5", "hk6_6",
                                "hk6_8", "hk6_9", "hk7_2", "hk7_5", "hk7_6"};

void BM_TenByOctahedra(benchmark::State& state) {
  double sum = 0;
  for (auto _ : state) {
    sum = 0;
    for (const char* name : kTen)
      sum += volume_of(Triangulation(
          topology::small_exterior({.name = {}, .diagram = topology::find_diagram(name)->diagram})
              .gluings));
  }
  state.counters["volumes"] = sum;
}
BENCHMARK(BM_TenByOctahedra)->Unit(benchmark::kMillisecond);

/// The baseline: round = 0 with straight pipes, 1 with the round tube of 6,000 triangles.
void BM_TenThroughSpace(benchmark::State& state) {
  double sum = 0;
  for (auto _ : state) {
    sum = 0;
    for (const char* name : kTen) {
      const auto graph =
          meshing::read_graph(drawing::to_polylines(topology::find_diagram(name)->diagram));
      meshing::TubeOptions options;
      if (state.range(0) == 1) options.triangles = 6000;
      meshing::SurfaceFile file{meshing::make_tube(graph, options).surface, {}, {}};
      sum += volume_of(Triangulation(meshing::manifold_of(std::move(file)).gluings));
    }
  }
  state.counters["volumes"] = sum;
}
BENCHMARK(BM_TenThroughSpace)
    ->ArgName("round")
    ->Arg(0)
    ->Arg(1)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

void BM_Draw(benchmark::State& state) {
  std::size_t bytes = 0;
  for (auto _ : state)
    for (const auto& entry : topology::table_of(topology::DiagramTable::kHandlebodyKnots))
      bytes += drawing::to_svg(entry.diagram).size();
  state.counters["bytes"] = double(bytes);
}
BENCHMARK(BM_Draw)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tripus
