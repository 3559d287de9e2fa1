// The renderer of faces against what it must show: independent rays on the processor, and the
// pictures of the OpenCSG renderer.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/moebius.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/drawn_scenes.hpp"
#include "tests/support/orb_examples.hpp"
#include "tests/support/scene_rays.hpp"
#include "viewer/faces/proxies.hpp"
#include "viewer/scene_words.hpp"

namespace tripus::viewer {
namespace {

using geometry::kModels;

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
  int edge_walls = 0;  ///< of these pixels show the wall of a parabolic edge

  void add(const Agreement& other) {
    compared += other.compared;
    edge_walls += other.edge_walls;
    wrong += other.wrong;
  }
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
    result.edge_walls += expected.cell != 0 && is_edge_wall(expected.wall - 1);
    result.wrong += pixel.cell != expected.cell || pixel.wall != expected.wall;
  }
  return result;
}

/// The same for a random view of up to e^most cells, with one of three models by the number.
Agreement compare_random_view(const testing::Embedded& manifold, int number, double most,
                              const std::string& name, std::mt19937& random) {
  PictureOptions options;
  options.model = kModels[number % 3];
  options.camera = random_camera(random);
  const auto cells = static_cast<std::size_t>(std::exp(uniform(random, 0, most)));
  const Scene scene = scene_of(manifold, cells, options.model);
  if (random() % 3 == 0)
    options.cut_away = bounding_ball(options.model, scene).centre.x() + uniform(random, -0.3, 0.3);
  const Agreement agreement = compare(scene, options, random, 250);
  EXPECT_LE(agreement.wrong, 1) << name << ", " << cells << " cells, "
                                << geometry::to_string(options.model);
  return agreement;
}

TEST(ViewerFaces, AreWhereRaysMeetThemInRandomManifoldsAndViews) {
  std::mt19937 random(20261130);
  int manifolds = 0;
  Agreement agreement;
  for (const std::string& signature : random_signatures(random)) {
    const auto manifold = testing::try_embed(signature);
    if (!manifold) continue;
    agreement.add(compare_random_view(*manifold, manifolds, 5.5, signature, random));
    if (++manifolds == 50) break;
  }
  EXPECT_EQ(manifolds, 50);
  EXPECT_GT(agreement.compared, 8000);
  EXPECT_LE(agreement.wrong * 1000, agreement.compared);
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
      found = testing::try_embed(example.triangulation, example.cone_angles);
      if (found && !found->embedding.develops()) continue;
    }
    if (found) result.push_back(std::move(*found));
  }
  return result;
}

TEST(ViewerFaces, AreWhereRaysMeetThemWithVerticesOfAllKinds) {
  std::mt19937 random(20261202);
  int number = 0, ideal = 0, finite = 0;
  Agreement agreement;
  for (const testing::Embedded& manifold : random_of_all_kinds(random)) {
    for (const auto& tetrahedron : manifold.embedding.tetrahedra) {
      ideal += tetrahedron.is_ideal(0);
      finite += tetrahedron.is_finite(0);
    }
    agreement.add(compare_random_view(manifold, number, 5, std::to_string(number), random));
    ++number;
  }
  EXPECT_GT(agreement.compared, 8000);
  EXPECT_LE(agreement.wrong * 1000, agreement.compared);
  EXPECT_GT(ideal, 30);
  EXPECT_GT(finite, 5);
}

/// All of two tetrahedra with an edge class that is parabolic in turn, some of three, and others.
std::vector<testing::Embedded> parabolic_manifolds() {
  std::vector<std::string> names(std::begin(testing::kParabolic), std::end(testing::kParabolic));
  for (const std::string& line : testing::data_lines("triangulations-2.txt"))
    names.push_back(line + " 0=0");
  const auto three = testing::data_lines("triangulations-3.txt");
  for (std::size_t n = 0; n < three.size(); n += 10) {
    const topology::Triangulation triangulation(topology::decode_isosig(three[n]));
    names.push_back(three[n] + " " + std::to_string(n / 10 % triangulation.edge_count()) + "=0");
  }
  std::vector<testing::Embedded> result;
  for (const std::string& name : names)
    if (auto found = testing::try_embed_parabolic(name)) result.push_back(std::move(*found));
  return result;
}

TEST(ViewerFaces, AreWhereRaysMeetThemAtParabolicEdges) {
  std::mt19937 random(20261204);
  int number = 0;
  Agreement agreement;
  for (const testing::Embedded& manifold : parabolic_manifolds()) {
    ASSERT_TRUE(std::ranges::any_of(manifold.embedding.tetrahedra,
                                    [](const auto& shape) { return shape.parabolic_edges != 0; }));
    agreement.add(compare_random_view(manifold, number, 4.5, std::to_string(number), random));
    ++number;
  }
  EXPECT_GT(number, 25);
  EXPECT_GT(agreement.compared, 4000);
  EXPECT_GT(agreement.edge_walls, 300);
  EXPECT_LE(agreement.wrong * 1000, agreement.compared);
}

TEST(ViewerFaces, HaveNamesOfParabolicEdgesOnTheirWalls) {
  const testing::Embedded manifold = *testing::try_embed_parabolic("cPcbbbihq 0=0");
  int names = 0;
  for (const Model model : kModels) {
    Scene scene = scene_of(manifold, 1, model);
    add_classes(scene, manifold.triangulation, manifold.report.edge_lengths);
    PictureOptions options;
    options.model = model;
    const Image image = draw(scene, options, Pixels::kIdentities, 400, 300);
    for (const SceneLabel& label : labels_of(scene, options, image)) {
      if (label.text != "e0") continue;
      ++names;
      const auto seen = seen_at(image, static_cast<int>(label.x), static_cast<int>(label.y));
      ASSERT_TRUE(seen);
      EXPECT_TRUE(is_edge_wall(seen->wall)) << geometry::to_string(model) << ' ' << seen->wall;
    }
  }
  EXPECT_GE(names, 4);
}

TEST(ViewerFaces, AreWhereRaysMeetThemWithAsManyCellsAsThereMayBe) {
  std::mt19937 random(20261203);
  const testing::Embedded manifold = *testing::try_embed("cPcbbbihq");
  Agreement agreement;
  for (const Model model : kModels) {
    PictureOptions options;
    options.model = model;
    options.camera.distance = 2.6;
    const Scene scene = scene_of(manifold, kMostDrawnCells, model);
    EXPECT_EQ(scene.cells.size(), 20000U);
    agreement.add(compare(scene, options, random, 60));
  }
  EXPECT_GT(agreement.compared, 60);
  EXPECT_LE(agreement.wrong * 1000, agreement.compared);
}

TEST(ViewerFaces, AreWhereRaysMeetThemAfterMoebiusMoves) {
  std::mt19937 random(20261201);
  const testing::Embedded manifold = *testing::try_embed("dLQbcccherw");
  Agreement agreement;
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
    agreement.add(compare(scene, options, random, 400));
  }
  EXPECT_GT(agreement.compared, 3000);
  EXPECT_LE(agreement.wrong * 1000, agreement.compared);
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
