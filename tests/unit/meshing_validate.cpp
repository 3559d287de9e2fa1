#include <algorithm>
#include <atomic>
#include <random>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "meshing/manifold.hpp"
#include "meshing/validate.hpp"
#include "meshing/validate_tetrahedra.hpp"
#include "tests/support/sample_surfaces.hpp"
#include "topology/homology.hpp"

namespace tripus::meshing {
namespace {

using testing::box_surface;
using testing::joined;
using testing::torus_surface;

TEST(MeshingValidate, CountsComponentsAndGenera) {
  const Region region = require_valid(joined(torus_surface(2, 0.5, 9, 7, {5, 5, 5}),
                                             joined(box_surface(0, 10, 3), box_surface(0.5, 1))));
  ASSERT_EQ(region.components.size(), 3u);
  EXPECT_EQ(region.outermost, 1u);
  EXPECT_EQ(region.components[0].genus, 1);
  EXPECT_EQ(region.components[1].genus, 0);
  EXPECT_EQ(region.components[2].triangle_count, 12u);
  EXPECT_EQ(region.turned, 0u);
  // The torus takes 2 pi R pi r^2 away, but for its corners.
  EXPECT_NEAR(volume(region), 1000 - 0.125 - 9.87 * 0.82, 1);
}

TEST(MeshingValidate, TurnsTrianglesRound) {
  const SurfaceMesh good = joined(box_surface(0, 9, 2), torus_surface(2, 0.5, 9, 7, {5, 5, 5}));
  SurfaceMesh mixed = good;
  std::mt19937 random(1);
  std::size_t turned = 0;
  for (auto& t : mixed.triangles)
    if (random() % 4 == 0) std::swap(t[0], t[1]), ++turned;
  const Region region = require_valid(mixed);
  EXPECT_EQ(region.turned, turned);
  for (std::size_t t = 0; t < good.triangles.size(); ++t) {
    Triangle mended = region.surface.triangles[t];
    std::rotate(mended.begin(), std::min_element(mended.begin(), mended.end()), mended.end());
    Triangle wanted = good.triangles[t];
    std::rotate(wanted.begin(), std::min_element(wanted.begin(), wanted.end()), wanted.end());
    EXPECT_EQ(mended, wanted) << t;
  }
  // A whole component that faces inwards is no fault.
  SurfaceMesh inwards = good;
  for (auto& t : inwards.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(require_valid(inwards).turned, 0u);
}

TEST(MeshingValidate, HolesOnAGridAreFoundExactly) {
  // Corners of the holes lie in the planes and on the diagonals of the outer faces, so that rays
  // are unlucky whenever they can be.
  SurfaceMesh mesh = box_surface(0, 8, 8);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      SurfaceMesh hole = box_surface(0, 1);
      for (Point& p : hole.points) p = {p[0] + 1 + 2 * i, p[1] + 1 + 2 * j, p[2] + 3};
      mesh = joined(mesh, hole);
    }
  const Region region = require_valid(mesh);
  ASSERT_EQ(region.components.size(), 10u);
  EXPECT_EQ(region.outermost, 0u);
  EXPECT_DOUBLE_EQ(volume(region), 512 - 9);
  for (std::uint32_t c = 1; c < 10; ++c) {
    const Point p = point_in_hole(region, c);
    const Point& low =
        region.surface.points[region.surface.triangles[region.components[c].first_triangle][0]];
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LT(std::abs(p[k] - low[k]), 1) << c;
  }
}

double volume_of(const TetrahedralMesh& mesh, const Tetrahedron& t) {
  std::array<std::array<double, 3>, 3> v;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) v[i][k] = mesh.points[t[i + 1]][k] - mesh.points[t[0]][k];
  return (v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
          v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
          v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0])) /
         6;
}

TEST(MeshingTetrahedralize, FillsRegionsExactly) {
  const SurfaceMesh surface = joined(
      box_surface(0, 9, 3), joined(torus_surface(2, 0.5, 9, 7, {5, 5, 5}), box_surface(0.5, 1)));
  const Region region = require_valid(surface);
  for (const double factor : {1.0, 0x1p-100, 0x1p100}) {
    Region scaled = region;
    for (Point& p : scaled.surface.points)
      for (double& x : p) x *= factor;
    const TetrahedralMesh mesh = tetrahedralize(scaled);
    double sum = 0;
    for (const Tetrahedron& t : mesh.tetrahedra) sum += volume_of(mesh, t);
    EXPECT_NEAR(sum / volume(scaled), 1, 1e-12);
    const Solid solid = require_valid(mesh);
    EXPECT_EQ(solid.mesh, mesh);
    EXPECT_EQ(solid.boundary_genera, (std::vector<int>{0, 0, 1}));
  }
}

TEST(MeshingTetrahedralize, AimsAtANumberOfTetrahedra) {
  const Region region = require_valid(torus_surface(2, 0.7, 20, 12));
  TetrahedralizeOptions options;
  for (const std::size_t aim : {3000u, 20'000u}) {
    options.tetrahedra = aim;
    EXPECT_NEAR(double(tetrahedralize(region, options).tetrahedra.size()), double(aim),
                0.1 * double(aim));
  }
  options.tetrahedra = 1;  // the boundary needs more
  EXPECT_EQ(tetrahedralize(region, options), tetrahedralize(region));
}

/// Where the boundary is so coarse that TetGen adds no point at all.
TEST(MeshingTetrahedralize, KeepsItsPromisesInsideACoarseBoundary) {
  SurfaceMesh simplex;
  simplex.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  simplex.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  for (const SurfaceMesh& surface :
       {simplex, box_surface(0, 1), joined(box_surface(0, 9), box_surface(4, 5)),
        torus_surface(2, 0.7, 9, 5)}) {
    const Region region = require_valid(surface);
    for (const std::size_t aim : {200u, 3000u}) {
      TetrahedralizeOptions options;
      options.tetrahedra = aim;
      const double made = double(tetrahedralize(region, options).tetrahedra.size());
      EXPECT_NEAR(made, double(aim), 0.1 * double(aim));
      options.tetrahedra = 0;
      options.max_volume = volume(region) / double(aim);
      const TetrahedralMesh mesh = tetrahedralize(region, options);
      double sum = 0;
      for (const Tetrahedron& t : mesh.tetrahedra) {
        sum += volume_of(mesh, t);
        EXPECT_LE(volume_of(mesh, t), options.max_volume * (1 + 1e-12));
      }
      EXPECT_NEAR(sum / volume(region), 1, 1e-12);
      EXPECT_EQ(require_valid(mesh).mesh, mesh);
    }
  }
  TetrahedralizeOptions tiny;
  tiny.max_volume = 1e-300;
  tiny.memory_limit = 1 << 28;
  EXPECT_THROW(tetrahedralize(require_valid(simplex), tiny), InvalidInput);
}

TEST(MeshingTetrahedra, OrderOfCornersIsMended) {
  TetrahedralMesh mesh = tetrahedralize(require_valid(torus_surface(2, 0.7, 9, 5)));
  const Solid solid = require_valid(mesh);
  EXPECT_EQ(solid.gluings, gluings_of(mesh));
  EXPECT_EQ(solid.boundary_genera, std::vector<int>{1});
  std::mt19937 random(5);
  for (Tetrahedron& t : mesh.tetrahedra) std::shuffle(t.begin(), t.end(), random);
  const Solid again = require_valid(mesh);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    for (int f = 0; f < 4; ++f)
      EXPECT_TRUE(again.gluings.is_open(t, f) || again.gluings.gluing(t, f).is_odd());
  topology::require_consistent(again.gluings, topology::OpenFaces::kAllowed);
}

TEST(MeshingManifold, BallsAndSolidTori) {
  const auto made = [](SurfaceMesh mesh) { return manifold_of(SurfaceFile{std::move(mesh), {}}); };
  const MeshedManifold ball = made(box_surface(0, 1, 2));
  EXPECT_TRUE(ball.has_only_spheres());
  EXPECT_EQ(ball_message(ball).substr(0, 16), "it bounds a ball");
  const MeshedManifold shell = made(joined(box_surface(0, 9), box_surface(3, 4)));
  EXPECT_NE(ball_message(shell).find("a ball with 1 ball taken out"), std::string::npos);
  const MeshedManifold torus = made(torus_surface(2, 0.7, 9, 5));
  EXPECT_FALSE(torus.has_only_spheres());
  const topology::Triangulation m(torus.gluings);
  EXPECT_EQ(topology::to_string(topology::first_homology(m)), "Z");
  ASSERT_EQ(m.vertex_count(), 1u);
  EXPECT_EQ(m.link(0).genus(), 1);
  // The unknotted ring in a box is again a solid torus, seen from outside.
  const MeshedManifold outside = made(joined(box_surface(-4, 4, 2), torus_surface(2, 0.7, 9, 5)));
  EXPECT_EQ(topology::to_string(topology::first_homology(topology::Triangulation(outside.gluings))),
            "Z");
}

TEST(MeshingManifold, StopsWhenAsked) {
  const std::atomic<bool> stop = true;
  ManifoldOptions options;
  options.stop = &stop;
  EXPECT_THROW(manifold_of(SurfaceFile{box_surface(), {}}, options), Stopped);
}

}  // namespace
}  // namespace tripus::meshing
