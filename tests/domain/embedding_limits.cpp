// Extreme shapes, bad input and interruption in embedding/ and the hyperbolic part of geometry/.
#include <atomic>
#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "embedding/moebius_gluing.hpp"
#include "embedding/tessellate.hpp"
#include "geometry/circle_packing.hpp"
#include "geometry/moebius.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "tests/support/embedded_manifolds.hpp"
#include "tests/support/sample_lengths.hpp"

namespace tripus::embedding {
namespace {

using geometry::lorentz_product;
using ::testing::HasSubstr;

template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "nothing was thrown";
}

/// The Gram matrix within a few ulp of the coordinates, the origin inside, no NaN.
void expect_sound(const HyperboloidTetrahedron& tetrahedron, const std::array<double, 6>& l) {
  double largest = 0;
  for (const double x : l) largest = std::max(largest, x);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_GT(tetrahedron.vertices[i][3], 0);
    EXPECT_GT(tetrahedron.faces[i][3], 0);
    // No coordinate is larger than the lengths ask for.
    EXPECT_LT(tetrahedron.vertices[i].norm(), 8 * std::exp(largest));
    for (std::size_t j = 0; j < 4; ++j) {
      if (i == j) continue;
      const double product = lorentz_product(tetrahedron.vertices[i], tetrahedron.vertices[j]);
      const double size = tetrahedron.vertices[i].norm() * tetrahedron.vertices[j].norm();
      const double expected = -std::cosh(l[static_cast<std::size_t>(topology::kEdgeNumber[i][j])]);
      EXPECT_NEAR(product, expected, 4e-15 * size);
      EXPECT_NEAR(lorentz_product(tetrahedron.faces[i], tetrahedron.vertices[j]), 0,
                  4e-15 * tetrahedron.faces[i].norm() * tetrahedron.vertices[j].norm());
    }
  }
}

TEST(ExtremeShapes, RegularTetrahedraOfEverySize) {
  for (const double l : {1e-6, 1e-3, 0.1, 1.0, 5.0, 20.0, 100.0, 300.0}) {
    const std::array<double, 6> lengths{l, l, l, l, l, l};
    const HyperboloidTetrahedron tetrahedron = geometry::hyperboloid_tetrahedron(lengths);
    expect_sound(tetrahedron, lengths);
    // By symmetry all planes are equally far from the centre.
    for (std::size_t i = 1; i < 4; ++i)
      EXPECT_NEAR(tetrahedron.vertices[i][3] / tetrahedron.vertices[0][3], 1, 1e-13);
    const CellShape shape = cell_shape(tetrahedron, 2);
    for (const Vector4& point : shape.points)
      for (const Model model : geometry::kModels)
        EXPECT_TRUE(to_model(model, point).allFinite()) << l;
  }
}

TEST(ExtremeShapes, UnevenTetrahedra) {
  std::mt19937_64 random(7);
  std::size_t true_ones = 0;
  for (int n = 0; n < 2000; ++n) {
    const auto l = n % 2 == 0 ? testing::balanced_lengths(random, 9)
                              : testing::log_uniform_lengths(random, 1e-3, 20);
    std::array<double, 6> theta{};
    if (geometry::dihedral_angles(l, theta) != geometry::TetrahedronKind::kTruncated) {
      EXPECT_THROW(geometry::hyperboloid_tetrahedron(l), InvalidInput);
      continue;
    }
    expect_sound(geometry::hyperboloid_tetrahedron(l), l);
    ++true_ones;
  }
  EXPECT_GT(true_ones, 800u);
}

TEST(ExtremeShapes, LabelsOnlyMoveTheFrame) {
  // The centre depends on the shape alone: relabelled tetrahedra have the same times.
  std::mt19937_64 random(8);
  for (int n = 0; n < 200; ++n) {
    const auto l = testing::balanced_lengths(random, 2);
    std::array<double, 6> theta{};
    if (geometry::dihedral_angles(l, theta) != geometry::TetrahedronKind::kTruncated) continue;
    const auto p = topology::Perm4::from_rank(n % 24);
    std::array<double, 6> moved{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        if (i != j)
          moved[std::size_t(
              topology::kEdgeNumber[std::size_t(p(int(i)))][std::size_t(p(int(j)))])] =
              l[std::size_t(topology::kEdgeNumber[i][j])];
    const auto first = geometry::hyperboloid_tetrahedron(l);
    const auto second = geometry::hyperboloid_tetrahedron(moved);
    for (int v = 0; v < 4; ++v)
      EXPECT_NEAR(first.vertices[std::size_t(v)][3], second.vertices[std::size_t(p(v))][3],
                  1e-10 * first.vertices[std::size_t(v)].norm());
  }
}

TEST(BadInput, IsNamed) {
  const testing::Embedded tripus = testing::embedded_tripus();
  const auto embed_with = [&](double length) {
    return [&tripus, length] { embed(tripus.triangulation, std::vector<double>{length}); };
  };
  EXPECT_THAT(refusal(embed_with(0.7)), HasSubstr("edge class 0 miss 2 pi"));
  EXPECT_THAT(refusal(embed_with(-1)), HasSubstr("edge class 0 is -1"));
  EXPECT_THAT(refusal(embed_with(std::nan(""))), HasSubstr("edge class 0"));
  EXPECT_THAT(refusal(embed_with(301)), HasSubstr("tetrahedron 0: edge 0"));
  EXPECT_THAT(refusal([&] { embed(tripus.triangulation, {}); }), HasSubstr("0 edge lengths"));
  // det G > 0: angle pi at the edges 01 and 23.
  EXPECT_THAT(refusal([] {
                geometry::hyperboloid_tetrahedron(std::array<double, 6>{5, 1, 1, 1, 1, 5});
              }),
              HasSubstr("flat"));
  EXPECT_THAT(refusal([] {
                geometry::circle_packing(std::array<double, 6>{1.1, 1.1, 1.1, 1.1, 1.1, 1.1});
              }),
              HasSubstr("sum to less than pi"));
  EXPECT_THAT(refusal([&] { embed_by_circles(tripus.triangulation, {}); }),
              HasSubstr("0 tetrahedra"));
  EXPECT_THAT(refusal([&] { cell_shape(tripus.embedding.tetrahedra[0], 8); }),
              HasSubstr("8 times"));
}

TEST(BadInput, UniversalCoverOptions) {
  const testing::Embedded tripus = testing::embedded_tripus();
  const auto grow = [&](const UniversalCoverOptions& options) {
    return refusal([&] { universal_cover(tripus.embedding, tripus.triangulation, options); });
  };
  EXPECT_THAT(grow({.max_cells = 0}), HasSubstr("0 cells"));
  EXPECT_THAT(grow({.max_cells = kMostCells + 1}), HasSubstr("2000000 are possible"));
  EXPECT_THAT(grow({.max_radius = -1}), HasSubstr("radius"));
  EXPECT_THAT(grow({.max_radius = std::nan("")}), HasSubstr("radius"));
  EXPECT_THAT(grow({.root = 2}), HasSubstr("no tetrahedron 2"));
}

TEST(Limits, InterruptionAndNumbersEndTheGrowthWithWhatIsThere) {
  const testing::Embedded tripus = testing::embedded_tripus();
  const std::atomic<bool> stop{true};
  UniversalCover cover =
      grow_universal_cover(tripus.embedding, tripus.triangulation, {.stop = &stop});
  EXPECT_EQ(cover.end, CoverEnd::kInterrupted);
  EXPECT_EQ(cover.cells.size(), 0u);
  cover = grow_universal_cover(tripus.embedding, tripus.triangulation,
                               {.max_cells = 10, .max_depth = 50});
  EXPECT_EQ(cover.end, CoverEnd::kCells);
  EXPECT_EQ(cover.cells.size(), 10u);
  cover = grow_universal_cover(tripus.embedding, tripus.triangulation, {.max_radius = 0});
  EXPECT_EQ(cover.end, CoverEnd::kComplete);
  EXPECT_EQ(cover.cells.size(), 1u);
}

TEST(Limits, PrecisionEndsTheGrowthBeforeCellsAreConfused) {
  // Straight out in one direction, doubling the distance: no cells are told apart beyond some 30.
  const testing::Embedded tripus = testing::embedded_tripus();
  Embedding far = tripus.embedding;
  const geometry::MoebiusMap away{std::exp(20.0), 0, 0, std::exp(-20.0)};
  for (std::size_t f = 0; f < 4; ++f)
    far.face_pairings[0][f] = geometry::to_matrix(away) * far.face_pairings[0][f];
  const UniversalCover cover = grow_universal_cover(far, tripus.triangulation, {.max_cells = 3000});
  EXPECT_EQ(cover.end, CoverEnd::kPrecision);
  ASSERT_FALSE(cover.cells.empty());
  for (const Cell& cell : cover.cells) EXPECT_TRUE(cell.isometry.allFinite());
}

TEST(Limits, TessellationThatCannotKeepItsErrorSaysSo) {
  const testing::Embedded tripus = testing::embedded_tripus();
  const auto cells = universal_cover(tripus.embedding, tripus.triangulation, {.max_cells = 2});
  const auto cut = [&](double error) {
    return refusal([&] { Tessellation(tripus.embedding, cells, {Model::kPoincareBall, error}); });
  };
  EXPECT_THAT(cut(1e-12), HasSubstr("cell 0 cannot be drawn"));
  EXPECT_THAT(cut(0), HasSubstr("greater than 0"));
  EXPECT_THAT(cut(std::nan("")), HasSubstr("greater than 0"));
}

}  // namespace
}  // namespace tripus::embedding
