// A picture of the tripus's universal cover, without a display.
#include <cstdio>

#include "embedding/universal_cover.hpp"
#include "structure/solve.hpp"
#include "topology/isosig.hpp"
#include "viewer/egl/offscreen.hpp"

int main() {
  using namespace tripus;
  const topology::Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  const auto embedding = embedding::embed(tripus, structure::solve(tripus).edge_lengths);
  embedding::UniversalCoverOptions cover;
  cover.max_cells = 12;

  viewer::PictureOptions options;
  options.model = viewer::Model::kPoincareBall;
  const auto frame = viewer::default_frame(options.model, embedding);
  const auto cells = embedding::universal_cover(embedding, tripus, cover);
  const viewer::Scene scene = viewer::make_scene("tripus", embedding, cells, frame);
  try {
    const viewer::Image image = viewer::render_picture(scene, options, 160, 120);
    std::printf("%zu cells, %dx%d pixels\n", scene.cells.size(), image.width, image.height);
  } catch (const viewer::NoOpenGl& reason) {
    std::printf("%s\n", reason.what());
  }
  return 0;
}
