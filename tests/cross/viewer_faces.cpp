// The renderer of faces against what it must show: independent rays on the processor, and the
// pictures of the OpenCSG renderer.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "embedding/universal_cover.hpp"
#include "geometry/moebius.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/embedded_manifolds.hpp"
#include "tests/support/one_renderer.hpp"
#include "tests/support/orb_examples.hpp"
#include "tests/support/scene_rays.hpp"
#include "viewer/faces/proxies.hpp"
#include "viewer/faces/tubes.hpp"

namespace tripus::viewer {
namespace {

using geometry::kModels;
constexpr int kWidth = 200, kHeight = 150;

Scene scene_of(const testing::Embedded& manifold, std::size_t cells, Model model) {
  embedding::UniversalCoverOptions options;
  options.max_cells = cells;
  return make_scene("scene", manifold.embedding,
                    embedding::universal_cover(manifold.embedding, manifold.triangulation, options),
                    default_frame(model, manifold.embedding));
}

Image draw(const Scene& scene, const PictureOptions& options, Pixels pixels, int width = kWidth,
           int height = kHeight) {
  return one_renderer().draw(scene, options, width, height, pixels);
}

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Camera random_camera(std::mt19937& random) {
  Camera camera;
  camera.azimuth = uniform(random, -180, 180);
  camera.elevation = uniform(random, -80, 80);
  camera.distance = uniform(random, 2.4, 8);
  camera.zoom = std::exp(uniform(random, -0.2, 1.5));
  camera.shift = {uniform(random, -0.3, 0.3), uniform(random, -0.3, 0.3)};
  return camera;
}

/// 50 manifolds by random: signatures of three lists, and the non-orientable ones.
std::vector<std::string> random_signatures(std::mt19937& random) {
  std::vector<std::string> result(std::begin(testing::kNonOrientable),
                                  std::end(testing::kNonOrientable));
  const char* files[] = {"triangulations-2.txt", "triangulations-3.txt", "triangulations-4.txt"};
  while (result.size() < 200) {
    const auto lines = testing::data_lines(files[result.size() % 3]);
    result.push_back(lines[random() % lines.size()]);
  }
  return result;
}

struct Agreement {
  int compared = 0;  ///< away from silhouettes: one cell and wall all around
  int wrong = 0;
};

/// Compares pixels with rays, where all rays within a pixel meet the same wall.
Agreement compare(const Scene& scene, const PictureOptions& options, std::mt19937& random,
                  int samples) {
  const Image image = draw(scene, options, Pixels::kIdentities);
  const BoundingBall ball = focus_of(options.model, scene);
  const View view = view_of(options.camera, options.model, scene, kWidth, kHeight);
  Agreement result;
  for (int i = 0; i < samples; ++i) {
    const int x = static_cast<int>(random() % kWidth), y = static_cast<int>(random() % kHeight);
    const auto met = [&](double dx, double dy) {
      return first_hit(scene, options.model,
                       ray_through(view, kWidth, kHeight, x + 0.5 + dx, y + 0.5 + dy),
                       options.camera.distance * ball.radius,
                       options.cut_away.value_or(std::numeric_limits<double>::infinity()));
    };
    const Hit expected = met(0, 0);
    bool alone = true;
    for (const double dx : {-0.5, 0.5})
      for (const double dy : {-0.5, 0.5}) {
        const Hit other = met(dx, dy);
        alone = alone && other.cell == expected.cell && other.wall == expected.wall;
      }
    if (!alone) continue;
    const Hit pixel = shown(image, x, y);
    ++result.compared;
    result.wrong += pixel.cell != expected.cell || pixel.wall != expected.wall;
  }
  return result;
}

TEST(ViewerFaces, AreWhereRaysMeetThemInRandomManifoldsAndViews) {
  std::mt19937 random(20261130);
  int manifolds = 0, compared = 0, wrong = 0;
  for (const std::string& signature : random_signatures(random)) {
    const auto manifold = testing::try_embed(signature);
    if (!manifold) continue;
    PictureOptions options;
    options.model = kModels[manifolds % 3];
    options.camera = random_camera(random);
    const auto cells = static_cast<std::size_t>(std::exp(uniform(random, 0, 5.5)));
    const Scene scene = scene_of(*manifold, cells, options.model);
    if (random() % 3 == 0)
      options.cut_away =
          bounding_ball(options.model, scene).centre.x() + uniform(random, -0.3, 0.3);
    const Agreement agreement = compare(scene, options, random, 250);
    EXPECT_LE(agreement.wrong, 1) << signature << ", " << cells << " cells, "
                                  << geometry::to_string(options.model);
    compared += agreement.compared;
    wrong += agreement.wrong;
    if (++manifolds == 50) break;
  }
  EXPECT_EQ(manifolds, 50);
  EXPECT_GT(compared, 8000);
  EXPECT_LE(wrong * 1000, compared);
}

/// 50 manifolds and orbifolds by random, with vertices of all kinds and non-orientable ones:
/// Gieseking's, SnapPy's, those with cusps beside geodesic boundary, and Orb's.
std::vector<testing::Embedded> random_of_all_kinds(std::mt19937& random) {
  std::vector<testing::Embedded> result{*testing::try_embed("bkaaid")};
  const auto census = testing::data_table("cusped-census-5.tsv");
  const auto beside = testing::data_lines("triangulations-cusped.txt");
  const auto orbifolds = testing::data_table("orb-examples.tsv");
  while (result.size() < 50) {
    std::optional<testing::Embedded> found;
    if (result.size() % 3 == 0)
      found = testing::try_embed(census[random() % census.size()].at("isosig"));
    if (result.size() % 3 == 1) found = testing::try_embed(beside[random() % beside.size()]);
    if (result.size() % 3 == 2) {
      const auto& row = orbifolds[random() % orbifolds.size()];
      if (row.at("solution") != "geometric_solution") continue;
      const testing::Labelled example = testing::orb_example(row);
      if (std::ranges::any_of(example.cone_angles,
                              [](const auto& angle) { return angle.is_parabolic(); }))
        continue;
      found = testing::try_embed(example.triangulation, example.cone_angles);
      if (found && !found->embedding.develops()) continue;
    }
    if (found) result.push_back(std::move(*found));
  }
  return result;
}

TEST(ViewerFaces, AreWhereRaysMeetThemWithVerticesOfAllKinds) {
  std::mt19937 random(20261202);
  int compared = 0, wrong = 0, number = 0, ideal = 0, finite = 0;
  for (const testing::Embedded& manifold : random_of_all_kinds(random)) {
    for (const auto& tetrahedron : manifold.embedding.tetrahedra) {
      ideal += tetrahedron.is_ideal(0);
      finite += tetrahedron.is_finite(0);
    }
    PictureOptions options;
    options.model = kModels[number++ % 3];
    options.camera = random_camera(random);
    const auto cells = static_cast<std::size_t>(std::exp(uniform(random, 0, 5)));
    const Scene scene = scene_of(manifold, cells, options.model);
    if (random() % 3 == 0)
      options.cut_away =
          bounding_ball(options.model, scene).centre.x() + uniform(random, -0.3, 0.3);
    const Agreement agreement = compare(scene, options, random, 250);
    EXPECT_LE(agreement.wrong, 1) << number << ", " << cells << " cells, "
                                  << geometry::to_string(options.model);
    compared += agreement.compared;
    wrong += agreement.wrong;
  }
  EXPECT_GT(compared, 8000);
  EXPECT_LE(wrong * 1000, compared);
  EXPECT_GT(ideal, 30);
  EXPECT_GT(finite, 5);
}

/// The pixel numbers of an image, 0 for the background.
std::vector<std::uint32_t> numbers(const Image& image) {
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4)
    result.push_back(image.pixels[i] + 256U * image.pixels[i + 1] + 65536U * image.pixels[i + 2]);
  return result;
}

TEST(ViewerFaces, AreWhereRaysMeetThemAfterMoebiusMoves) {
  std::mt19937 random(20261201);
  const testing::Embedded manifold = *testing::try_embed("dLQbcccherw");
  int compared = 0, wrong = 0;
  for (int n = 0; n < 12; ++n) {
    PictureOptions options;
    options.model = kModels[n % 3];
    options.camera = random_camera(random);
    options.camera.zoom = 1;
    // w -> (w + b) / (c w + 1 + bc), far from the identity.
    const auto number = [&] {
      return geometry::Complex(uniform(random, -1, 1), uniform(random, -1, 1));
    };
    const geometry::Complex b = number(), c = number();
    const Scene scene = moved(options.model, scene_of(manifold, 60, options.model),
                              geometry::to_matrix({1, b, c, 1.0 + b * c}));
    const Agreement agreement = compare(scene, options, random, 400);
    compared += agreement.compared;
    wrong += agreement.wrong;
  }
  EXPECT_GT(compared, 3000);
  EXPECT_LE(wrong * 1000, compared);
}

TEST(ViewerFaces, OfATransparentTetrahedronHideNothing) {
  for (const char* signature : {"dLQbcccherw", "cPcbbbihq"}) {
    const testing::Embedded manifold = *testing::try_embed(signature);
    for (const Model model : kModels) {
      const Scene scene = scene_of(manifold, 40, model);
      Scene rest = scene;  // without the cells that one looks through
      rest.focus = focus_of(model, scene);
      std::erase_if(rest.cells, [](const SceneCell& cell) { return cell.tetrahedron == 1; });
      std::vector<std::uint32_t> number{0};  // of the other scene's cells in this one
      for (std::size_t i = 0; i < scene.cells.size(); ++i)
        if (scene.cells[i].tetrahedron != 1) number.push_back(static_cast<std::uint32_t>(i + 1));
      PictureOptions options;
      options.model = model;
      options.samples = 1;
      options.occlusion = false;
      const auto opaque = draw(scene, options, Pixels::kColours).pixels;
      const auto without = numbers(draw(rest, options, Pixels::kIdentities));
      const auto without_colours = draw(rest, options, Pixels::kColours).pixels;
      options.transparent = 1;
      const auto seen = numbers(draw(scene, options, Pixels::kIdentities));
      const auto colours = draw(scene, options, Pixels::kColours).pixels;
      std::size_t different = 0, tinted = 0;
      for (std::size_t i = 0; i < seen.size(); ++i) {
        const std::uint32_t expected =
            number[without[i] & 65535U] + (without[i] & ~std::uint32_t{65535});
        different += seen[i] != expected;
        int change = 0, from_opaque = 0;
        for (std::size_t k = 4 * i; k < 4 * i + 3; ++k) {
          change = std::max(change, std::abs(colours[k] - without_colours[k]));
          from_opaque = std::max(from_opaque, std::abs(colours[k] - opaque[k]));
        }
        tinted += change > 2 && from_opaque > 2;
      }
      // Depths of two views of other ranges are rounded otherwise.
      EXPECT_LE(different * 1000, seen.size()) << signature << geometry::to_string(model);
      EXPECT_GT(tinted, seen.size() / 100) << signature << geometry::to_string(model);
    }
  }
}

/// Whether all pixels of an image within `reach` of one have its number.
bool is_alone(const std::vector<std::uint32_t>& of, int x, int y, int reach) {
  const auto at = [&](int i, int j) { return of[static_cast<std::size_t>(j * kWidth + i)]; };
  for (int j = std::max(0, y - reach); j <= std::min(kHeight - 1, y + reach); ++j)
    for (int i = std::max(0, x - reach); i <= std::min(kWidth - 1, x + reach); ++i)
      if (at(i, j) != at(x, y)) return false;
  return true;
}

/// Manifolds of three kinds: with geodesic boundary, with a cusp, non-orientable with a cusp.
class ViewerStillness : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, ViewerStillness,
                         ::testing::Values("cPcbbbihq", "cPcbbbiht", "bkaaid"));

TEST_P(ViewerStillness, HasNoCracks) {
  const testing::Embedded manifold = *testing::try_embed(GetParam());
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
  const testing::Embedded manifold = *testing::try_embed(GetParam());
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

TEST(ViewerFaces, LookLikeOpenCsgButAtSilhouettes) {
  const testing::Embedded manifold = *testing::try_embed("dLQabccjkjn");
  for (const Model model : kModels) {
    for (const ColourBy colour_by : {ColourBy::kTetrahedron, ColourBy::kFace, ColourBy::kDepth}) {
      const Scene scene = scene_of(manifold, 8, model);
      PictureOptions options;
      options.model = model;
      options.colour_by = colour_by;
      options.samples = 1;
      options.occlusion = false;
      options.tubes = false;  // OpenCSG has lines
      if (colour_by == ColourBy::kDepth) options.cut_away = 0.05;
      const auto faces = draw(scene, options, Pixels::kColours).pixels;
      const auto seen = numbers(draw(scene, options, Pixels::kIdentities));
      options.renderer = RendererKind::kOpenCsg;
      const auto reference = draw(scene, options, Pixels::kColours).pixels;
      const auto reference_seen = numbers(draw(scene, options, Pixels::kIdentities));
      int compared = 0, different = 0, largest = 0;
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          if (!is_alone(seen, x, y, 3) || !is_alone(reference_seen, x, y, 3)) continue;
          ++compared;
          int most = 0;
          for (std::size_t c = 0; c < 3; ++c) {
            const auto i = 4 * static_cast<std::size_t>(y * kWidth + x) + c;
            most = std::max(most, std::abs(faces[i] - reference[i]));
          }
          different += most > 1;
          largest = std::max(largest, most);
        }
      }
      EXPECT_GT(compared, kWidth * kHeight / 4);
      EXPECT_LE(1000 * different, compared) << geometry::to_string(model) << " "
                                            << static_cast<int>(colour_by) << ": up to " << largest;
    }
  }
}

}  // namespace
}  // namespace tripus::viewer
