// The discs on the truncations: their points by the definition, and where pictures show them.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "embedding/universal_cover.hpp"
#include "geometry/hyperbolic_space.hpp"
#include "tests/support/embedded_manifolds.hpp"
#include "tests/support/one_renderer.hpp"
#include "tests/support/scene_rays.hpp"
#include "viewer/legend.hpp"

namespace tripus::viewer {
namespace {

using geometry::lorentz_product;

WallDiscs discs_of(const testing::Embedded& manifold, std::optional<double> length) {
  return find_wall_discs(manifold.embedding, manifold.triangulation, manifold.report.edge_lengths,
                         length);
}

/// The number of the disc of a tile that holds a point, from 1, or 0.
std::size_t disc_at(const std::vector<WallDisc>& tile, const Vector4& x) {
  for (std::size_t n = 0; n < tile.size(); ++n) {
    const Vector4 away = x - tile[n].centre;
    if (lorentz_product(away, away) < tile[n].extent) return n + 1;
  }
  return 0;
}

/// The poles of all boundary planes near a tetrahedron.
std::vector<Vector4> poles_around(const testing::Embedded& manifold, std::size_t t, double radius) {
  embedding::UniversalCoverOptions options;
  options.max_radius = radius;
  options.root = static_cast<std::uint32_t>(t);
  std::vector<Vector4> poles;
  for (const embedding::Cell& cell :
       embedding::universal_cover(manifold.embedding, manifold.triangulation, options))
    for (const Vector4& pole : manifold.embedding.tetrahedra[cell.tetrahedron].vertices)
      poles.push_back(cell.isometry * pole);
  return poles;
}

/// The length of the arc to the plane that the normal at x of the plane of v runs into, if it is at
/// most `length`; 0 if none is; -1 if the normal runs close to where a plane begins.
double arc_met_by_normal(const std::vector<Vector4>& poles, const Vector4& v, const Vector4& x,
                         double length) {
  double found = 0;
  for (const Vector4& w : poles) {
    const double cosh = -lorentz_product(v, w);
    if (cosh < 1 + 1e-9 || cosh > std::cosh(length)) continue;
    // x cosh t - v sinh t meets the plane of w where tanh t = <x, w> / <v, w>.
    const double tanh = -lorentz_product(x, w) / cosh;
    if (std::abs(tanh - 1) < 1e-6) return -1;
    if (tanh > 0 && tanh < 1) found = std::acosh(cosh);
  }
  return found;
}

TEST(WallDiscs, HoldThePointsWhoseNormalsRunIntoOnePlane) {
  constexpr double kLength = 2.7;
  std::mt19937 random(20261130);
  std::uniform_real_distribution<double> share(0.01, 1);
  for (const char* name : {"cPcbbbihq", "dLQabccjkjn", "dLQbcbcdhjw", testing::kNonOrientable[0]}) {
    const testing::Embedded manifold = *testing::try_embed(name);
    const WallDiscs discs = discs_of(manifold, kLength);
    ASSERT_EQ(discs.tiles.size(), 4 * manifold.embedding.tetrahedra.size());
    int held = 0, bare = 0;
    for (std::size_t tile = 0; tile < discs.tiles.size(); ++tile) {
      const auto& shape = manifold.embedding.tetrahedra[tile / 4];
      const int v = static_cast<int>(tile % 4);
      double reach = 0;
      for (int w = 0; w < 4; ++w)
        if (w != v) reach = std::max(reach, std::acosh(geometry::corner(shape, v, w)[3]));
      const auto poles = poles_around(manifold, tile / 4, kLength + reach);
      for (int sample = 0; sample < 60; ++sample) {
        Vector4 x = Vector4::Zero();
        for (int w = 0; w < 4; ++w)
          if (w != v) x += share(random) * geometry::corner(shape, v, w);
        x /= std::sqrt(-lorentz_product(x, x));
        const double expected = arc_met_by_normal(poles, shape.vertices[tile % 4], x, kLength);
        if (expected < 0) continue;
        const std::size_t disc = disc_at(discs.tiles[tile], x);
        const double length = disc == 0 ? 0 : discs.tiles[tile][disc - 1].length;
        EXPECT_NEAR(length, expected, 1e-7) << name << " tile " << tile;
        ++(disc == 0 ? bare : held);
      }
    }
    EXPECT_GT(held, 100) << name;
    EXPECT_GT(bare, 10) << name;
  }
}

TEST(WallDiscs, AreThoseOfTheShortestArcsWhereNoLengthIsGiven) {
  const testing::Embedded manifold = testing::embedded_tripus();
  const WallDiscs discs = discs_of(manifold, std::nullopt);
  EXPECT_NEAR(discs.length, 4.91198, 1e-5);  // 71 shorter arcs, and 48 of this length
  EXPECT_NEAR(discs.scale.shortest, 0.596133894891, 1e-12);
  std::size_t count = 0;
  for (const auto& tile : discs.tiles) {
    EXPECT_TRUE(std::ranges::is_sorted(tile, std::greater(), &WallDisc::extent));
    count += tile.size();
  }
  EXPECT_EQ(count, discs.count);
  EXPECT_GT(count, 2 * 119u);  // some reach over into other tiles
}

TEST(WallDiscs, RefuseLengthsThatGiveTooMany) {
  const testing::Embedded manifold = testing::embedded_tripus();
  for (const double length : {0.0, -1.0, 1e9, 15.0, std::nan("")})
    EXPECT_THROW(discs_of(manifold, length), InvalidInput) << length;
  EXPECT_EQ(discs_of(manifold, 0.1).count, 0u);
}

struct Drawn {
  Scene scene;
  PictureOptions options;
};

Drawn drawn(const char* name, Model model, std::size_t cells, double length) {
  const testing::Embedded manifold = *testing::try_embed(name);
  embedding::UniversalCoverOptions cover;
  cover.max_cells = cells;
  Drawn result;
  result.scene =
      make_scene(name, manifold.embedding,
                 embedding::universal_cover(manifold.embedding, manifold.triangulation, cover),
                 default_frame(model, manifold.embedding));
  result.scene.discs = std::make_shared<const WallDiscs>(discs_of(manifold, length));
  result.options.model = model;
  return result;
}

/// What the ray through a place of the picture says of discs: the number in the tile, or -1 where
/// no truncation of that cell is met.
int disc_by_ray(const Drawn& drawn, const View& view, double x, double y, const Hit& pixel) {
  const Ray ray = ray_through(view, 320, 240, x, y);
  const Model model = drawn.options.model;
  const Hit hit = first_hit(drawn.scene, model, ray, view.far);
  if (hit.cell == 0 || hit.cell != pixel.cell || hit.wall != pixel.wall || hit.wall < 5) return -1;
  const SceneCell& cell = drawn.scene.cells[hit.cell - 1];
  const Vector4 point = geometry::lorentz_inverse(cell.place) *
                        geometry::from_model(model, ray.origin + hit.distance * ray.direction);
  return static_cast<int>(
      disc_at(drawn.scene.discs->tiles[4 * std::size_t{cell.tetrahedron} + hit.wall - 5], point));
}

TEST(WallDiscs, AreDrawnWhereRaysMeetThem) {
  for (const Model model : geometry::kModels) {
    for (const char* name : {"cPcbbbihq", "dLQabccjkjn", testing::kNonOrientable[0]}) {
      Drawn picture = drawn(name, model, 12, 4.5);
      // Hollow pictures are faster.
      const bool is_tripus = std::string(name) == "cPcbbbihq";
      picture.options.drawing = is_tripus ? Material::kSolid : Material::kHollow;
      const Image image =
          one_renderer().draw(picture.scene, picture.options, 320, 240, Pixels::kIdentities);
      const View view =
          view_of(picture.options.camera, bounding_ball(model, picture.scene), 320, 240);
      std::mt19937 random(20261130);
      int compared = 0, in_discs = 0, moved = 0;
      for (int sample = 0; sample < 3000; ++sample) {
        const int x = static_cast<int>(random() % 320), y = static_cast<int>(random() % 240);
        const Hit pixel = shown(image, x, y);
        const int expected = disc_by_ray(picture, view, x + 0.5, y + 0.5, pixel);
        if (expected < 0) continue;
        const int seen = image.pixels[4 * static_cast<std::size_t>(320 * y + x) + 2] >> 4;
        ++compared;
        in_discs += seen > 0;
        if (seen == std::min(expected, 15)) continue;
        ++moved;
        bool near = false;
        for (const double dx : {-0.7, 0.0, 0.7})
          for (const double dy : {-0.7, 0.0, 0.7})
            near = near || seen == std::min(15, disc_by_ray(picture, view, x + 0.5 + dx,
                                                            y + 0.5 + dy, pixel));
        EXPECT_TRUE(near) << name << " at " << x << ", " << y << ": " << seen << " for "
                          << expected;
      }
      EXPECT_GT(compared, 100) << name;
      EXPECT_GT(in_discs, compared / 3) << name;
      EXPECT_LT(moved, compared / 10) << name;
    }
  }
}

TEST(WallDiscs, AreSwitchedOffAndHaveALegend) {
  Drawn picture = drawn("cPcbbbihq", Model::kPoincareBall, 1, 4);
  picture.options.samples = 1;
  picture.options.drawing = Material::kHollow;
  const auto draw = [&] {
    return one_renderer().draw(picture.scene, picture.options, 400, 300).pixels;
  };
  const auto with = draw();
  EXPECT_EQ(with, draw());
  picture.options.discs = false;
  const auto without = draw();
  picture.scene.discs = nullptr;
  EXPECT_EQ(without, draw());
  EXPECT_NE(with, without);

  // The bar of the legend has the very colours of the scale, from left to right.
  const Drawn again = drawn("cPcbbbihq", Model::kPoincareBall, 1, 4);
  const auto legend = legend_of(*again.scene.discs, 400, 300);
  ASSERT_GT(legend.size(), 100u);
  for (const std::size_t n : {0u, 49u, 99u}) {
    const LegendRectangle& step = legend[1 + n];
    const auto x = static_cast<std::size_t>(step.left), y = static_cast<std::size_t>(step.top) + 2;
    const auto colour = orthospectrum::length_colour((static_cast<double>(n) + 0.5) / 100);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(step.colour[c], colour[c]);
      EXPECT_EQ(with[4 * (400 * y + x) + c], colour[c]) << n;
    }
  }
  EXPECT_TRUE(legend_of(*again.scene.discs, 100, 300).empty());
}

}  // namespace
}  // namespace tripus::viewer
