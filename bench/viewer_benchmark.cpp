// Frame times of the desktop viewer, at one sample a pixel as in its window: image-based CSG
// against the baseline, hollow cells by discarded pixels. Drawn by whatever EGL finds: label.
#include <stdexcept>

#include <benchmark/benchmark.h>

#include "embedding/universal_cover.hpp"
#include "structure/solve.hpp"
#include "topology/isosig.hpp"
#include "viewer/egl/offscreen.hpp"

namespace {

using namespace tripus;

viewer::Scene scene_of(std::size_t cells, viewer::Model model) {
  const topology::Triangulation triangulation(topology::decode_isosig("cPcbbbihq"));
  const auto report = structure::solve(triangulation);
  const auto embedding = embedding::embed(triangulation, report.edge_lengths);
  embedding::UniversalCoverOptions options;
  options.max_cells = cells;
  return viewer::make_scene("cPcbbbihq", embedding,
                            embedding::universal_cover(embedding, triangulation, options),
                            viewer::default_frame(model, embedding));
}

void frame(benchmark::State& state, viewer::Model model, viewer::Drawing drawing) {
  const auto cells = static_cast<std::size_t>(state.range(0));
  const viewer::Scene scene = scene_of(cells, model);
  viewer::OffscreenRenderer renderer;
  viewer::PictureOptions options;
  options.model = model;
  options.drawing = drawing;
  options.samples = 1;
  // The first picture makes the meshes and compiles the shaders; it must not be blank.
  const viewer::Image first = renderer.draw(scene, options, 800, 600, viewer::Pixels::kIdentities);
  std::size_t drawn = 0;
  for (std::size_t i = 2; i < first.pixels.size(); i += 4) drawn += first.pixels[i] != 0 ? 1 : 0;
  if (drawn < first.pixels.size() / 40) throw std::runtime_error("the picture is blank");
  renderer.draw(scene, options, 800, 600);
  for (auto step : state) {
    options.camera.azimuth += 1;
    benchmark::DoNotOptimize(renderer.draw(scene, options, 800, 600));
  }
  state.counters["cells"] = static_cast<double>(cells);
}

void register_all() {
  using viewer::Drawing;
  using viewer::Model;
  for (const Model model : {Model::kUpperHalfSpace, Model::kPoincareBall}) {
    for (const Drawing drawing : {Drawing::kSolid, Drawing::kHollow}) {
      const std::string name = "frame_800x600/" + std::string(geometry::to_string(model)) +
                               (drawing == Drawing::kSolid ? "/opencsg" : "/hollow");
      benchmark::RegisterBenchmark(name.c_str(), frame, model, drawing)
          ->Arg(1)
          ->Arg(2)
          ->Arg(20)
          ->Arg(100)
          ->Arg(500)
          ->Unit(benchmark::kMillisecond)
          ->MeasureProcessCPUTime();
    }
  }
}

const bool kRegistered = [] {
  register_all();
  return true;
}();

}  // namespace
