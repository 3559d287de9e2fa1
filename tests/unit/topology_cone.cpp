#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/support/cube_meshes.hpp"
#include "tests/support/triangulations.hpp"
#include "topology/cone.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"
#include "topology/subdivide.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {
namespace {

using testing::cube_mesh;
using ::testing::HasSubstr;

std::vector<int> genera(const Triangulation& triangulation) {
  std::vector<int> found;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).genus() != 0) found.push_back(triangulation.link(v).genus());
  return found;
}

template <class Function>
std::string message_of(Function&& function) {
  try {
    function();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "nothing was thrown";
}

// Law B1.
TEST(Cone, OfATetrahedronIsTheSphereWithFiveVertices) {
  const Triangulation sphere(cone_boundary(Gluings(1)));
  EXPECT_EQ(sphere.tetrahedron_count(), 5u);
  EXPECT_EQ(sphere.vertex_count(), 5u);
  EXPECT_EQ(sphere.edge_count(), 10u);
  for (std::size_t v = 0; v < 5; ++v) EXPECT_EQ(sphere.link(v).euler_characteristic, 2);
  EXPECT_TRUE(testing::is_oriented(sphere.gluings()));
}

TEST(Cone, OfAClosedTriangulationIsItself) {
  const Gluings tripus = decode_isosig("cPcbbbihq");
  EXPECT_EQ(cone_boundary(tripus), tripus);
}

// Two faces of a tetrahedron folded together by a half turn: a solid torus.
TEST(Cone, OfASolidTorusHasATorusLink) {
  Gluings gluings(1);
  gluings.glue(0, 0, 0, Perm4::from_images(1, 2, 3, 0));
  const Triangulation coned(cone_boundary(gluings));
  EXPECT_EQ(coned.tetrahedron_count(), 3u);
  EXPECT_EQ(genera(coned), std::vector<int>{1});
  EXPECT_EQ(to_string(first_homology(coned)), "Z");
}

TEST(Cone, OfSolidsOfCubes) {
  // A hole through the middle, two that meet, and a cavity.
  const auto handle =
      cone_boundary(cube_mesh(3, [](int x, int y, int) { return x != 1 || y != 1; }));
  EXPECT_EQ(genera(Triangulation(handle)), std::vector<int>{1});
  const auto two = cone_boundary(cube_mesh(
      3, [](int x, int y, int z) { return (x != 1 || y != 1) && (x == 0 || y != 1 || z != 1); }));
  EXPECT_EQ(genera(Triangulation(two)), std::vector<int>{2});
  const auto mesh = cube_mesh(3, [](int x, int y, int z) { return x != 1 || y != 1 || z != 1; });
  const Triangulation shell(cone_boundary(mesh));
  EXPECT_TRUE(genera(shell).empty());
  EXPECT_EQ(shell.vertex_count(), 64u + 2u);
}

TEST(Cone, KeepsNumbersAndLabels) {
  const auto mesh = cube_mesh(2, [](int, int, int) { return true; });
  const auto coned = cone_boundary(mesh);
  std::size_t open = 0;
  for (std::size_t t = 0; t < mesh.tetrahedron_count(); ++t)
    for (int f = 0; f < 4; ++f) {
      if (mesh.is_open(t, f)) {
        EXPECT_EQ(coned.neighbour(t, f), mesh.tetrahedron_count() + open++);
      } else {
        EXPECT_EQ(coned.neighbour(t, f), mesh.neighbour(t, f));
        EXPECT_EQ(coned.gluing(t, f), mesh.gluing(t, f));
      }
    }
  EXPECT_EQ(open, 48u);
}

TEST(Cone, NamesThePinchedVertex) {
  // Two opposite corners of a cube of eight are missing: their gaps meet in the middle.
  const auto mesh =
      cube_mesh(2, [](int x, int y, int z) { return x + y + z != 0 && x + y + z != 3; });
  EXPECT_THAT(message_of([&] { cone_boundary(mesh); }),
              HasSubstr("the boundary surface is pinched at vertex 2 of tetrahedron 0: 2 sheets of "
                        "it meet there; pull"));
}

// A reversed edge is refused by name, not as a trouble with the boundary.
TEST(Cone, LeavesReversedEdgesToTheSkeleton) {
  Gluings gluings(1);
  gluings.glue(0, 0, 0, Perm4::from_images(1, 0, 3, 2));
  const Gluings coned = cone_boundary(gluings);
  EXPECT_THAT(message_of([&] { (void)Triangulation(coned); }), HasSubstr("its own reverse"));
}

TEST(Cone, RefusesInconsistentGluings) {
  Gluings gluings(2);
  gluings.set_one_side(0, 1, 1, Perm4());
  EXPECT_THAT(message_of([&] { cone_boundary(gluings); }),
              HasSubstr("face 1 of tetrahedron 0 is glued to tetrahedron 1 by 0123"));
}

// Random gluings with open faces: what is let through has discs for links on its boundary, so the
// cone has spheres there, and its own links are the boundary; what is refused has a place.
TEST(Cone, OfRandomGluingsIsClosedOrRefused) {
  std::mt19937_64 engine(5);
  int coned_count = 0;
  int pinched = 0;
  int no_disc = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const std::size_t count = 1 + engine() % 4;
    Gluings gluings(count);
    for (int k = 0; k < 8; ++k) {
      const auto t = static_cast<TetrahedronIndex>(engine() % count);
      const auto u = static_cast<TetrahedronIndex>(engine() % count);
      const int f = static_cast<int>(engine() % 4);
      const Perm4 p = Perm4::from_rank(static_cast<int>(engine() % 24));
      if (gluings.is_open(t, f) && gluings.is_open(u, p(f)) && (t != u || p(f) != f))
        gluings.glue(t, f, u, p);
    }
    Gluings coned;
    try {
      coned = cone_boundary(gluings);
    } catch (const InvalidInput& error) {
      const std::string message = error.what();
      ASSERT_THAT(message, HasSubstr("of tetrahedron"));
      (message.find("pinched") != std::string::npos ? pinched : no_disc) += 1;
      continue;
    }
    ASSERT_NO_THROW(require_consistent(coned, OpenFaces::kRefused));
    try {
      const Triangulation triangulation(coned);
      for (std::size_t t = 0; t < count; ++t)
        for (int f = 0; f < 4; ++f)
          for (int v = 0; v < 4 && gluings.is_open(t, f); ++v) {
            if (v == f) continue;
            ASSERT_EQ(triangulation.link(triangulation.vertex_class(t, v)).euler_characteristic, 2);
          }
      ++coned_count;
    } catch (const InvalidInput&) {  // an edge that is its own reverse, inside
    }
  }
  EXPECT_GT(coned_count, 100);
  EXPECT_GT(pinched, 100);
  EXPECT_GT(no_disc, 10);
}

// Law B2.
TEST(Subdivision, HasTheVerticesThatItShould) {
  const Triangulation tripus(decode_isosig("cPcbbbihq"));
  const Triangulation fine(barycentric_subdivision(tripus.gluings()));
  EXPECT_EQ(fine.tetrahedron_count(), 48u);
  EXPECT_EQ(fine.vertex_count(), 1u + 1u + 4u + 2u);
  EXPECT_EQ(genera(fine), std::vector<int>{2});
  EXPECT_EQ(to_string(first_homology(fine)), to_string(first_homology(tripus)));
  EXPECT_TRUE(fine.is_orientable());
}

TEST(Subdivision, KeepsOrientedTablesOriented) {
  Gluings oriented(2);
  for (int f = 0; f < 4; ++f) oriented.glue(0, f, 1, Perm4::from_images(1, 0, 2, 3));
  ASSERT_TRUE(testing::is_oriented(oriented));
  EXPECT_TRUE(testing::is_oriented(barycentric_subdivision(oriented)));
}

TEST(Subdivision, KeepsNonOrientability) {
  const Triangulation gieseking(decode_isosig("bkaaid"));
  ASSERT_FALSE(gieseking.is_orientable());
  const Triangulation fine(barycentric_subdivision(gieseking.gluings()));
  EXPECT_FALSE(fine.is_orientable());
  EXPECT_EQ(to_string(first_homology(fine)), to_string(first_homology(gieseking)));
}

TEST(Subdivision, CutsOpenFacesInSix) {
  const Gluings fine = barycentric_subdivision(Gluings(1));
  std::size_t open = 0;
  for (std::size_t t = 0; t < 24; ++t)
    for (int f = 0; f < 4; ++f) open += fine.is_open(t, f);
  EXPECT_EQ(open, 24u);
  EXPECT_EQ(Triangulation(cone_boundary(fine)).vertex_count(), 15u + 1u);
}

TEST(Subdivision, MakesReversedEdgesHarmless) {
  Gluings gluings(1);
  gluings.glue(0, 2, 0, Perm4::from_images(1, 0, 3, 2));  // edge 01 becomes its own reverse
  gluings.glue(0, 0, 0, Perm4::from_images(1, 0, 2, 3));
  EXPECT_THROW(Triangulation{gluings}, InvalidInput);
  const Triangulation fine(barycentric_subdivision(gluings));
  bool projective = false;
  for (std::size_t v = 0; v < fine.vertex_count(); ++v)
    projective = projective || fine.link(v).euler_characteristic == 1;
  EXPECT_TRUE(projective);
}

}  // namespace
}  // namespace tripus::topology
