// Edges are drawn as tubes where rays on the processor come near them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/drawn_scenes.hpp"
#include "tests/support/scene_rays.hpp"
#include "viewer/faces/proxies.hpp"
#include "viewer/faces/tubes.hpp"

namespace tripus::viewer {
namespace {

using geometry::kModels;

/// The least distance from an edge between its ends among many points of a ray up to `reach`, of
/// which `close` is the nearest: by the edge's corners, whose products with a point tell what of it
/// lies in their plane.
double nearest_edge(const Scene& scene, Model model, const Ray& ray, double reach, Vector3& close) {
  double least = std::numeric_limits<double>::infinity();
  for (double t = std::max(reach - 2, 0.0); t < reach; t += 0.003) {
    const Vector3 place = ray.origin + t * ray.direction;
    if (!in_model(model, place)) continue;
    const Vector4 x = geometry::from_model(model, place);
    for (const SceneCell& cell : scene.cells) {
      for (std::size_t v = 0; v < 4; ++v) {
        for (std::size_t w = v + 1; w < 4; ++w) {
          const Vector4 &p = cell.corners[3 * v + w - 1], &q = cell.corners[3 * w + v];
          const double c = geometry::lorentz_product(p, q), xp = geometry::lorentz_product(x, p),
                       xq = geometry::lorentz_product(x, q);
          if (xq + c * xp < 0 || xp + c * xq < 0) continue;  // beyond an end
          const double in_plane = (2 * c * xp * xq + xp * xp + xq * xq) / (c * c - 1);
          const double away = std::asinh(std::sqrt(std::max(-1 - in_plane, 0.0)));
          if (away < least) close = place;
          least = std::min(least, away);
        }
      }
    }
  }
  return least;
}

// Beside the rims of tubes, and where they are too thin to be drawn, nothing is claimed.
TEST(ViewerTubes, AreWhereRaysComeNearEdges) {
  int inside = 0, outside = 0, missing = 0, wrong = 0;
  for (const char* signature : {"cPcbbbihq", "cPcbbbiht", "bkaaid"}) {
    const testing::Embedded manifold = *testing::try_embed(signature);
    for (const Model model : kModels) {
      const Scene scene = scene_of(manifold, 2, model);
      const BoundingBall ball = bounding_ball(model, scene);
      PictureOptions options;
      options.model = model;
      options.samples = 1;
      options.occlusion = false;
      options.camera = {50, 35, 2.5, 1.5, {0, 0}};
      const auto with = draw(scene, options, Pixels::kColours).pixels;
      options.tubes = false;
      const auto without = draw(scene, options, Pixels::kColours).pixels;
      const View view = view_of(options.camera, ball, kWidth, kHeight);
      std::mt19937 random(5);
      for (int n = 0; n < 600; ++n) {
        const int x = static_cast<int>(random() % kWidth), y = static_cast<int>(random() % kHeight);
        const Ray ray = ray_through(view, kWidth, kHeight, x + 0.5, y + 0.5);
        const Hit hit = first_hit(scene, model, ray, options.camera.distance * ball.radius);
        if (hit.cell == 0) continue;
        int change = 0, brightest = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          const auto i = 4 * static_cast<std::size_t>(y * kWidth + x) + c;
          change = std::max(change, std::abs(with[i] - without[i]));
          brightest = std::max(brightest, static_cast<int>(with[i]));
        }
        Vector3 close = Vector3::Zero();
        const double near = nearest_edge(scene, model, ray, hit.distance, close);
        if (near > 2 * kTubeRadius) {
          ++outside;
          wrong += change > 1;
          continue;
        }
        const Projector projector(view, kWidth, kHeight);
        const double scale = model == Model::kUpperHalfSpace ? close.z()
                             : model == Model::kPoincareBall ? (1 - close.squaredNorm()) / 2
                                                             : 1 - close.squaredNorm();
        if (near > 0.6 * kTubeRadius ||
            projector.pixels({close, kTubeRadius * scale}) < 1.3 * kThinnestTube)
          continue;
        ++inside;
        missing += change <= 1 && brightest > 100;
      }
    }
  }
  EXPECT_GT(outside, 1000);
  EXPECT_GT(inside, 10);
  EXPECT_LE(200 * wrong, outside);
  EXPECT_LE(10 * missing, inside);
  RecordProperty("inside", inside);
}

}  // namespace
}  // namespace tripus::viewer
