// The pictures of the desktop viewer against what they must show: rays through pixels, cut with the
// half-spaces of every cell, on the processor and by formulae of their own.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "embedding/universal_cover.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/embedded_manifolds.hpp"
#include "tests/support/one_renderer.hpp"
#include "tests/support/scene_rays.hpp"

namespace tripus::viewer {
namespace {

Scene scene_of(const std::string& signature, std::size_t cells, Model model) {
  const testing::Embedded manifold = *testing::try_embed_parabolic(signature);
  embedding::UniversalCoverOptions options;
  options.max_cells = cells;
  return make_scene(signature, manifold.embedding,
                    embedding::universal_cover(manifold.embedding, manifold.triangulation, options),
                    default_frame(model, manifold.embedding));
}

Image identities(const Scene& scene, const PictureOptions& options, int width, int height) {
  return one_renderer().draw(scene, options, width, height, Pixels::kIdentities);
}

struct Agreement {
  int compared = 0;
  int near_an_edge = 0;  ///< not what the ray meets, but an edge is within 2 pixels
  int slipped = 0;       ///< of these: through a seam
  int wrong = 0;
  std::set<std::size_t> cells;  ///< that are seen
  std::string first;
};

Agreement compare(const Scene& scene, const PictureOptions& options, int width, int height,
                  int samples) {
  const Image image = identities(scene, options, width, height);
  const BoundingBall ball = bounding_ball(options.model, scene);
  const View view = view_of(options.camera, ball, width, height);
  const double length = options.camera.distance * ball.radius;
  const double cut = options.cut_away.value_or(std::numeric_limits<double>::infinity());
  std::mt19937 random(20261122);
  Agreement result;
  for (int i = 0; i < samples; ++i) {
    const int x = static_cast<int>(random() % static_cast<unsigned>(width));
    const int y = static_cast<int>(random() % static_cast<unsigned>(height));
    const Hit pixel = shown(image, x, y);
    const auto met = [&](double dx, double dy) {
      return first_hit(scene, options.model,
                       ray_through(view, width, height, x + 0.5 + dx, y + 0.5 + dy), length, cut);
    };
    const auto same = [&](const Hit& hit) {
      return hit.cell == pixel.cell && hit.wall == pixel.wall;
    };
    const Hit expected = met(0, 0);
    ++result.compared;
    if (pixel.cell != 0) result.cells.insert(pixel.cell);
    if (same(expected)) continue;
    // Near an edge, within 2 pixels, anything goes that is there: the wall of a neighbouring pixel,
    // or, in the seam between two cells, another wall of one of them.
    bool edge = false, same_cell = expected.cell == pixel.cell, near = false;
    for (const double radius : {0.5, 1.0, 1.5, 2.0}) {
      for (int k = 0; k < 8 && !near; ++k) {
        const double angle = k * std::numbers::pi / 4;
        const Hit hit = met(radius * std::cos(angle), radius * std::sin(angle));
        edge = edge || hit.cell != expected.cell || hit.wall != expected.wall;
        same_cell = same_cell || hit.cell == pixel.cell;
        near = same(hit) || (edge && same_cell);
      }
    }
    // Through the seam of two cells a ray may slip between their pixels, to whatever is behind.
    if (!near && edge) ++result.slipped;
    near = near || edge;
    if (near) {
      ++result.near_an_edge;
      continue;
    }
    if (result.wrong++ == 0) {
      std::ostringstream text;
      text << "pixel " << x << "," << y << " shows cell " << pixel.cell << " wall " << pixel.wall
           << ", and the ray meets cell " << expected.cell << " wall " << expected.wall;
      result.first = text.str();
    }
  }
  return result;
}

struct Case {
  std::string signature;
  std::size_t cells;
  Model model;
  RendererKind renderer;
};

class ViewerPicture : public ::testing::TestWithParam<Case> {};

/// `seen`: at least so many cells are.
void expect_agreement(const Agreement& agreement, std::size_t cells, std::size_t seen) {
  EXPECT_EQ(agreement.wrong, 0) << agreement.first;
  EXPECT_LE(agreement.slipped, 1 + agreement.compared / 500);
  // Edges are everywhere where there are many cells.
  EXPECT_LE(agreement.near_an_edge, agreement.compared * (cells > 100 ? 0.03 : 0.01));
  EXPECT_GE(agreement.cells.size(), seen);
}

TEST_P(ViewerPicture, ShowsWhatRaysMeet) {
  const auto& [signature, cells, model, renderer] = GetParam();
  const Scene scene = scene_of(signature, cells, model);
  ASSERT_EQ(scene.cells.size(), cells);
  PictureOptions options;
  options.model = model;
  options.renderer = renderer;
  expect_agreement(compare(scene, options, 320, 240, cells > 100 ? 600 : 1500), cells,
                   std::min<std::size_t>(cells, 8));
}

TEST_P(ViewerPicture, IsTheSameHollowAndFromElsewhere) {
  const auto& [signature, cells, model, renderer] = GetParam();
  const Scene scene = scene_of(signature, cells, model);
  PictureOptions options;
  options.model = model;
  options.drawing = Material::kHollow;
  options.renderer = renderer;
  options.camera = {-100, 55, 6, 1.5, {0.1, -0.05}};
  expect_agreement(compare(scene, options, 320, 240, cells > 100 ? 300 : 800), cells,
                   cells > 2 ? 5 : 1);
}

TEST(ViewerPictures, ShowParabolicEdges) {
  for (const char* name : {"cPcbbbihq 0=0", "dLQbcccherw 1=0"}) {
    for (const Model model : {Model::kUpperHalfSpace, Model::kPoincareBall}) {
      const Scene scene = scene_of(name, 12, model);
      for (const RendererKind renderer : {RendererKind::kFaces, RendererKind::kOpenCsg}) {
        PictureOptions options;
        options.model = model;
        options.renderer = renderer;
        expect_agreement(compare(scene, options, 320, 240, 1500), 12, 5);
      }
    }
  }
}

TEST(ViewerPictures, AreCutOpen) {
  for (const auto& [model, renderer] : std::initializer_list<std::pair<Model, RendererKind>>{
           {Model::kUpperHalfSpace, RendererKind::kFaces},
           {Model::kPoincareBall, RendererKind::kFaces},
           {Model::kKleinBall, RendererKind::kFaces},
           {Model::kUpperHalfSpace, RendererKind::kOpenCsg},
           {Model::kPoincareBall, RendererKind::kOpenCsg}}) {
    const Scene scene = scene_of("cPcbbbihq", 20, model);
    PictureOptions options;
    options.model = model;
    options.renderer = renderer;
    options.cut_away = 0.1;
    const Agreement agreement = compare(scene, options, 320, 240, 2000);
    EXPECT_EQ(agreement.wrong, 0) << agreement.first;
    const Image image = identities(scene, options, 320, 240);
    std::size_t cut = 0;
    for (std::size_t i = 2; i < image.pixels.size(); i += 4)
      cut += image.pixels[i] == kWallCount + 1 ? 1 : 0;
    EXPECT_GT(cut, image.pixels.size() / 4 / 50);
  }
}

void PrintTo(const Case& of, std::ostream* out) {
  *out << of.signature << ", " << of.cells << " cells, " << geometry::to_string(of.model)
       << (of.renderer == RendererKind::kOpenCsg ? ", OpenCSG" : "");
}

std::string name_of(const ::testing::TestParamInfo<Case>& info) {
  const auto& [signature, cells, model, renderer] = info.param;
  return signature + "_" + std::to_string(cells) + "_" + std::string(geometry::to_string(model)) +
         (renderer == RendererKind::kOpenCsg ? "_opencsg" : "");
}

std::vector<Case> cases() {
  std::vector<Case> result;
  for (const RendererKind renderer : {RendererKind::kFaces, RendererKind::kOpenCsg}) {
    for (const Model model : geometry::kModels) {
      for (const std::size_t cells : {1, 2, 20})
        result.push_back({"cPcbbbihq", cells, model, renderer});
      // So many cells are thinner than a pixel in the Klein ball.
      if (model != Model::kKleinBall) result.push_back({"cPcbbbihq", 500, model, renderer});
      for (const char* signature : {"cMcabbjds", "dLQabccjkjn", "eLMkbbddddhape"})
        result.push_back({signature, 20, model, renderer});
    }
  }
  return result;
}

INSTANTIATE_TEST_SUITE_P(All, ViewerPicture, ::testing::ValuesIn(cases()), name_of);

}  // namespace
}  // namespace tripus::viewer
