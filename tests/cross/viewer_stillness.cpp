// Pictures of faces have no cracks, and do not flicker.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/drawn_scenes.hpp"
#include "tests/support/scene_rays.hpp"
#include "viewer/faces/proxies.hpp"

namespace tripus::viewer {
namespace {

using geometry::kModels;

/// Manifolds of four kinds: with geodesic boundary, with a cusp, non-orientable with a cusp, with a
/// parabolic edge.
class ViewerStillness : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, ViewerStillness,
                         ::testing::Values("cPcbbbihq", "cPcbbbiht", "bkaaid", "dLQbcccherw 0=0"));

TEST_P(ViewerStillness, HasNoCracks) {
  const testing::Embedded manifold = *testing::try_embed_parabolic(GetParam());
  for (const Model model : kModels) {
    const Scene scene = scene_of(manifold, 300, model);
    const BoundingBall ball = bounding_ball(model, scene);
    PictureOptions options;
    options.model = model;
    int lonely = 0, covered = 0;
    for (int turn = 0; turn < 12; ++turn) {
      options.camera = {30.0 * turn + 0.123, 7.0 * turn - 40, 3.0 + 0.2 * turn, 2, {0, 0}};
      const View view = view_of(options.camera, ball, kWidth, kHeight);
      const auto shown_numbers = numbers(draw(scene, options, Pixels::kIdentities));
      for (int y = 1; y + 1 < kHeight; ++y) {
        for (int x = 1; x + 1 < kWidth; ++x) {
          const auto at = [&](int i, int j) {
            return shown_numbers[static_cast<std::size_t>(j * kWidth + i)];
          };
          covered += at(x, y) != 0;
          // A pixel unlike the eight around it, of which opposite ones are alike.
          const bool alike = at(x - 1, y) == at(x + 1, y) && at(x, y - 1) == at(x, y + 1) &&
                             at(x - 1, y) != 0 && at(x, y - 1) != 0;
          bool other = true;
          for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i)
              other = other && ((i == 0 && j == 0) || at(x + i, y + j) != at(x, y));
          if (!alike || !other) continue;
          ++lonely;
          // It is no crack if the ray there meets just that, or one a fifth of a pixel away does.
          bool real = false;
          for (const double dx : {0.0, -0.2, 0.2}) {
            for (const double dy : {0.0, -0.2, 0.2}) {
              const Hit hit = first_hit(
                  scene, model, ray_through(view, kWidth, kHeight, x + 0.5 + dx, y + 0.5 + dy),
                  options.camera.distance * ball.radius);
              real = real || hit.cell + 65536 * hit.wall == at(x, y);
            }
          }
          EXPECT_TRUE(real) << geometry::to_string(model) << " turn " << turn << " at " << x << ", "
                            << y << ": " << at(x, y);
        }
      }
    }
    EXPECT_GT(covered, 12 * kWidth * kHeight / 10);
    RecordProperty("lonely", lonely);
  }
}

TEST_P(ViewerStillness, IsWithoutFlicker) {
  const testing::Embedded manifold = *testing::try_embed_parabolic(GetParam());
  for (const Model model : kModels) {
    const Scene scene = scene_of(manifold, 200, model);
    PictureOptions options;
    options.model = model;
    options.samples = 1;
    const double moved = 1e-6 * 180 / std::numbers::pi;
    for (const bool nooks : {false, true}) {
      options.occlusion = nooks;
      const auto one = draw(scene, options, Pixels::kColours).pixels;
      PictureOptions turned = options;
      turned.camera.azimuth += moved;
      turned.camera.elevation -= moved;
      const auto other = draw(scene, turned, Pixels::kColours).pixels;
      int changed = 0;
      for (std::size_t i = 0; i < one.size(); i += 4) {
        int most = 0;
        for (std::size_t c = 0; c < 3; ++c)
          most = std::max(most, std::abs(one[i + c] - other[i + c]));
        changed += most > 2;
      }
      // What moves by a five-thousandth of a pixel changes such a part of the pixels on edges.
      EXPECT_LE(changed, kWidth * kHeight / 1000) << geometry::to_string(model) << nooks;
    }
  }
}

}  // namespace
}  // namespace tripus::viewer
