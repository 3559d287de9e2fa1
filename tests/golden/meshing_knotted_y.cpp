// The knotted Y from its boundary surface to its metric: whatever the resolution, two tetrahedra
// and the volume of docs/theory.md (28).
#include <gtest/gtest.h>

#include "meshing/formats/formats.hpp"
#include "meshing/manifold.hpp"
#include "meshing/tube/spatial_graph.hpp"
#include "meshing/tube/tube_surface.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "topology/isosig.hpp"

namespace tripus::meshing {
namespace {

using testing::data_text;

/// Through the file format, as a user's surface comes.
SurfaceFile surface_of(const std::string& graph, std::size_t triangles) {
  TubeOptions options;
  options.triangles = triangles;
  return read_off(write_off(
      tube_surface(read_spatial_graph(data_text("../examples/graphs/" + graph)), options)));
}

void expect_knotted_y(SurfaceFile file, std::size_t least, std::size_t most,
                      const ManifoldOptions& options = {}) {
  const MeshedManifold manifold = manifold_of(std::move(file), options);
  EXPECT_GE(manifold.tetrahedra[0], least);
  EXPECT_LE(manifold.tetrahedra[0], most);
  EXPECT_EQ(manifold.tetrahedra[3], 2u);
  EXPECT_EQ(topology::isosig(manifold.gluings), "cPcbbbihq");
  const auto report = structure::solve(topology::Triangulation(manifold.gluings));
  EXPECT_EQ(report.outcome, structure::Outcome::kGeometric) << report.message;
  EXPECT_NEAR(report.volume, 6.4519902708350328653, 1e-12);
}

TEST(MeshingKnottedY, FromItsSurfaceFile) {
  expect_knotted_y(read_off(data_text("../examples/surfaces/knotted-y.off")), 4000, 7000);
}

TEST(MeshingKnottedY, AsAThetaCurveWhoseOuterSphereDisappears) {
  SurfaceFile file = read_off(data_text("../examples/surfaces/knotted-theta.off"));
  const Region region = require_valid(file.mesh, file.lines);
  ASSERT_EQ(region.components.size(), 2u);
  EXPECT_EQ(region.components[region.outermost].genus, 0);
  expect_knotted_y(std::move(file), 4000, 7000);
}

TEST(MeshingKnottedY, FromTwentyThousandTetrahedra) {
  expect_knotted_y(surface_of("knotted-y.json", 11'000), 18'000, 23'000);
  expect_knotted_y(surface_of("knotted-theta.json", 11'000), 18'000, 23'000);
}

TEST(MeshingKnottedY, FromTwoHundredThousandTetrahedra) {
  expect_knotted_y(surface_of("knotted-y.json", 113'000), 180'000, 220'000);
}

TEST(MeshingKnottedY, RefinedInside) {
  ManifoldOptions options;
  options.tetrahedralize.tetrahedra = 50'000;
  for (const std::uint64_t seed : {0u, 1u}) {
    options.seed = seed;
    expect_knotted_y(read_off(data_text("../examples/surfaces/knotted-y.off")), 44'000, 56'000,
                     options);
  }
}

}  // namespace
}  // namespace tripus::meshing
