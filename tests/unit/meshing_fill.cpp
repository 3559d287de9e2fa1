// Filling without TetGen's help, and what is taken for a filling.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "meshing/detail/convex_cells.hpp"
#include "meshing/detail/filling.hpp"
#include "meshing/formats/formats.hpp"
#include "meshing/manifold.hpp"
#include "meshing/predicates.hpp"
#include "meshing/tube/tube_surface.hpp"
#include "meshing/validate_tetrahedra.hpp"
#include "tests/support/data_folder.hpp"
#include "tests/support/sample_graphs.hpp"
#include "tests/support/sample_surfaces.hpp"
#include "topology/cone.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"
#include "topology/simplify/simplify.hpp"

namespace tripus::meshing {
namespace {

using detail::boundary_fault;
using detail::ConvexCells;
using testing::box_surface;
using testing::joined;
using testing::torus_surface;

constexpr double kNoDeadline = 1e18;
constexpr std::uint64_t kMuchMemory = std::uint64_t{4} << 30;

std::optional<TetrahedralMesh> by_planes(const Region& region, std::uint64_t memory = kMuchMemory) {
  return detail::fill_by_planes(region, memory, kNoDeadline, nullptr);
}

TEST(ConvexCells, OfTwoCutsFitTogether) {
  ConvexCells cells({0, 0, 0}, {4, 4, 4});
  const detail::RationalPlane level({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  const detail::RationalPlane slanted({1, 0, 0}, {1, 1, 0}, {2, 0, 3});
  const std::uint32_t upper = cells.cut(0, level, 0);
  EXPECT_EQ(cells.cells()[0].faces.size(), 6u);
  const std::uint32_t part = cells.cut(upper, slanted, 1);
  EXPECT_EQ(cells.cells().size(), 3u);
  // The face between the lower and the upper box was cut with the upper one, on both sides.
  EXPECT_EQ(cells.cells()[0].faces.size(), 7u);
  EXPECT_EQ(cells.cells()[upper].faces.size() + cells.cells()[part].faces.size(), 12u);
  for (const ConvexCells::Face& face : cells.faces()) {
    EXPECT_GE(face.loop.size(), 4u);
    EXPECT_EQ(face.cells[1] == ConvexCells::kNone, face.plane == ConvexCells::kNone);
  }
}

TEST(ConvexCells, TellSidesThatDoublesDoNot) {
  const detail::RationalPlane plane({0, 0, 0}, {1, 1e-20, 3}, {0, 1, 1e9});
  const detail::RationalPoint p(Point{1, 1e-20, 3});
  EXPECT_EQ(plane.side(p), 0);
  const detail::RationalPoint above(
      std::array<BigRational, 3>{p.exact[0], p.exact[1], p.exact[2] + BigRational(1e-100)});
  EXPECT_EQ(above.near, p.near);
  EXPECT_EQ(plane.side(above), 1);
}

TEST(FillByPlanes, FillsBoxesWithHolesExactly) {
  const SurfaceMesh surface =
      joined(joined(box_surface(0, 8, 2), box_surface(1, 2)), box_surface(4, 7));
  const Region region = require_valid(surface);
  const auto mesh = by_planes(region);
  ASSERT_TRUE(mesh);
  const Solid solid = require_valid(*mesh);
  EXPECT_EQ(solid.mesh, *mesh);  // in positive order already
  EXPECT_EQ(solid.boundary_genera, (std::vector<int>{0, 0, 0}));
}

TEST(FillByPlanes, FindsTheKnottedY) {
  for (const char* name : {"knotted-y", "knotted-theta"}) {
    const Region region = require_valid(tube_surface(testing::example_graph(name)));
    const auto mesh = by_planes(region);
    ASSERT_TRUE(mesh);
    const auto simplified = topology::simplify(topology::cone_boundary(gluings_of(*mesh)), {});
    EXPECT_EQ(topology::isosig(simplified.gluings), "cPcbbbihq") << name;
  }
}

TEST(FillByPlanes, TakesNoMoreMemoryThanItMay) {
  EXPECT_FALSE(by_planes(require_valid(torus_surface(2, 0.7, 20, 12)), 1 << 20));
}

/// Solids by boolean operations, turned off the axes: TetGen puts points on their boundary.
TEST(TurnedSolids, AreFilledBothWays) {
  for (const char* name : {"csg-turned-1", "csg-turned-2"}) {
    SCOPED_TRACE(name);
    std::ifstream file(testing::data_folder() + "/../tests/turned-solids/" + name + ".off");
    std::stringstream text;
    text << file.rdbuf();
    const Region region = require_valid(read_off(text.str()).mesh);
    ASSERT_EQ(region.components.size(), 1u);
    const int genus = region.components[0].genus;
    EXPECT_GE(genus, 1);
    for (const TetrahedralMesh& mesh : {tetrahedralize(region), *by_planes(region)}) {
      const auto simplified = topology::simplify(topology::cone_boundary(gluings_of(mesh)), {});
      // Alexander duality: what a surface of genus g bounds in space has the homology Z^g.
      const topology::AbelianGroup group =
          topology::first_homology(topology::Triangulation(simplified.gluings));
      EXPECT_EQ(group.rank, std::size_t(genus));
      EXPECT_TRUE(group.invariant_factors.empty());
    }
    EXPECT_EQ(boundary_fault(tetrahedralize(region), region, nullptr), "");
  }
}

/// A corner of a cube, and fillings of it.
class BoundaryFault : public ::testing::Test {
 protected:
  SurfaceMesh surface_{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                       {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  Region region_ = require_valid(surface_);

  /// Three tetrahedra around a new point on the slanted side, or near it.
  std::string with_point(const Point& p) const {
    TetrahedralMesh mesh{surface_.points, {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 3, 1, 4}}};
    mesh.points.push_back(p);
    for (const Tetrahedron& t : mesh.tetrahedra)
      EXPECT_GT(
          orientation(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]),
          0);
    return boundary_fault(mesh, region_, nullptr);
  }
};

TEST_F(BoundaryFault, IsNoneForTheSurfaceItself) {
  EXPECT_EQ(boundary_fault({surface_.points, {{0, 1, 2, 3}}}, region_, nullptr), "");
}

TEST_F(BoundaryFault, IsNoneForASubdivision) {
  EXPECT_EQ(with_point({0.25, 0.25, 0.5}), "");
  EXPECT_EQ(with_point({1.0 / 3, 1.0 / 3, 1.0 / 3}), "");  // not in the plane, by rounding
}

TEST_F(BoundaryFault, IsADent) {
  EXPECT_NE(with_point({0.33, 0.33, 0.33}), "");
  EXPECT_NE(with_point({0.34, 0.34, 0.34}), "");
}

TEST_F(BoundaryFault, IsAMovedPoint) {
  SurfaceMesh moved = surface_;
  moved.points[1][0] = 1 + 1e-15;
  EXPECT_NE(boundary_fault({moved.points, {{0, 1, 2, 3}}}, region_, nullptr), "");
}

TEST_F(BoundaryFault, IsAHoleThatIsFilled) {
  const SurfaceMesh hollow = joined(box_surface(0, 9, 3), box_surface(4, 5));
  const Region region = require_valid(hollow);
  TetrahedralMesh mesh = tetrahedralize(region);
  EXPECT_EQ(boundary_fault(mesh, region, nullptr), "");
  const TetrahedralMesh lid = tetrahedralize(require_valid(box_surface(4, 5)));
  const auto first = std::uint32_t(hollow.points.size() - 8);
  for (Tetrahedron t : lid.tetrahedra) {
    if (std::any_of(t.begin(), t.end(), [](std::uint32_t v) { return v >= 8; })) GTEST_SKIP();
    for (std::uint32_t& v : t) v += first;
    mesh.tetrahedra.push_back(t);
  }
  EXPECT_NE(boundary_fault(mesh, region, nullptr), "");
}

TEST_F(BoundaryFault, IsATetrahedronLess) {
  const Region region = require_valid(torus_surface(2, 0.7, 9, 5));
  TetrahedralMesh mesh = tetrahedralize(region);
  mesh.tetrahedra.pop_back();
  EXPECT_NE(boundary_fault(mesh, region, nullptr), "");
}

}  // namespace
}  // namespace tripus::meshing
