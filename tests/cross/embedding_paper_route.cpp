// The embedding by circles alone, and volumes by numerical integration.
#include <cmath>

#include <gtest/gtest.h>

#include "embedding/moebius_gluing.hpp"
#include "embedding/tessellate.hpp"
#include "tests/support/embedded_manifolds.hpp"

namespace tripus::embedding {
namespace {

TEST(PaperRoute, GluesAsTheHyperboloidDoes) {
  testing::for_geometric_triangulations(40, [](const std::string& name, const testing::Embedded& m,
                                               bool) {
    const CircleEmbedding circles = embed_by_circles(m.triangulation, m.report.dihedral_angles);
    const topology::Gluings& gluings = m.triangulation.gluings();
    std::vector<geometry::MoebiusMap> frames;
    for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t) {
      frames.push_back(geometry::map_of_triples(
          face_circle_points(circles.tetrahedra[t], {0, 1, 2}),
          face_circle_points(geometry::circles_of(m.embedding.tetrahedra[t]), {0, 1, 2})));
    }
    for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t) {
      for (int f = 0; f < 4; ++f) {
        const auto face = static_cast<std::size_t>(f);
        const geometry::MoebiusMap moved =
            frames[t] * circles.face_pairings[t][face] * inverse(frames[gluings.neighbour(t, f)]);
        EXPECT_LT(geometry::difference(normalised(moved),
                                       geometry::to_moebius(m.embedding.face_pairings[t][face])),
                  1e-10)
            << name;
      }
    }
  });
}

double integrated_volume(const Embedding& embedding, int subdivisions) {
  double volume = 0;
  for (const HyperboloidTetrahedron& tetrahedron : embedding.tetrahedra) {
    const CellShape shape = cell_shape(tetrahedron, subdivisions);
    std::vector<Vector3> places;
    for (const Vector4& point : shape.points)
      places.push_back(geometry::to_model(Model::kKleinBall, point));
    volume += enclosed_volume(places, shape.triangles);
  }
  return volume;
}

TEST(PaperRoute, IntegratedVolumeIsThatOfTheFormula) {
  testing::for_geometric_triangulations(
      97, [](const std::string& name, const testing::Embedded& m, bool) {
        EXPECT_NEAR(integrated_volume(m.embedding, 4), m.report.volume, 1e-4) << name;
      });
}

TEST(PaperRoute, IntegratedVolumeConvergesWithOrderSix) {
  const testing::Embedded tripus = testing::embedded_tripus();
  std::vector<double> errors;
  for (const int n : {3, 4, 5})
    errors.push_back(std::abs(integrated_volume(tripus.embedding, n) - tripus.report.volume));
  for (std::size_t n = 0; n + 1 < errors.size(); ++n) {
    const double order = std::log2(errors[n] / errors[n + 1]);
    EXPECT_NEAR(order, 6, 0.2);
  }
}

TEST(PaperRoute, MovedCellsEncloseTheSameVolume) {
  // The divergence theorem does not care where the origin is: cells of the universal cover too.
  const testing::Embedded tripus = testing::embedded_tripus();
  UniversalCoverOptions options;
  options.max_cells = 12;
  const double volume = tripus.report.volume / 2;
  const CellShape shape = cell_shape(tripus.embedding.tetrahedra[0], 5);
  for (const Cell& cell : universal_cover(tripus.embedding, tripus.triangulation, options)) {
    if (cell.tetrahedron != 0) continue;
    std::vector<Vector3> places;
    for (const Vector4& point : shape.points)
      places.push_back(geometry::to_model(Model::kKleinBall, cell.isometry * point));
    EXPECT_NEAR(enclosed_volume(places, shape.triangles), volume, 1e-4) << cell.depth;
  }
}

}  // namespace
}  // namespace tripus::embedding
