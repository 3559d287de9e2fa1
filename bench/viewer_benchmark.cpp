// Frame times of the desktop viewer, at one sample a pixel as in its window: visible faces alone
// against the baseline, image-based CSG. Drawn by whatever EGL finds.
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

void frame(benchmark::State& state, viewer::Model model, viewer::RendererKind renderer_kind) {
  const auto cells = static_cast<std::size_t>(state.range(0));
  const viewer::Scene scene = scene_of(cells, model);
  viewer::OffscreenRenderer renderer;
  viewer::PictureOptions options;
  options.model = model;
  options.renderer = renderer_kind;
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
  using viewer::Model;
  using viewer::RendererKind;
  for (const RendererKind kind : {RendererKind::kFaces, RendererKind::kOpenCsg}) {
    const bool faces = kind == RendererKind::kFaces;
    for (const Model model : geometry::kModels) {
      const std::string name = "frame_800x600/" + std::string(geometry::to_string(model)) +
                               (faces ? "/faces" : "/opencsg");
      auto* all = benchmark::RegisterBenchmark(name.c_str(), frame, model, kind);
      for (const int cells : {1, 20, 100, 500}) all->Arg(cells);
      if (faces) all->Arg(2000)->Arg(20000);
      all->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
    }
  }
}

const bool kRegistered = [] {
  register_all();
  return true;
}();

}  // namespace
