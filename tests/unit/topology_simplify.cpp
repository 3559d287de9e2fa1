#include <atomic>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/support/cube_meshes.hpp"
#include "tests/support/manifold_invariants.hpp"
#include "topology/cone.hpp"
#include "topology/cyclic_cover.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"
#include "topology/simplify/simplify.hpp"
#include "topology/subdivide.hpp"

namespace tripus::topology {
namespace {

using testing::ManifoldInvariants;

Gluings fine_tripus(std::size_t degree) {
  const Triangulation base(decode_isosig("cPcbbbihq"));
  return barycentric_subdivision(cyclic_cover(base.gluings(), *primitive_class(base), degree));
}

// Law R1: E = T + chi/2 leaves no room below 2 n tetrahedra but for a few edge classes, and the
// covers carry the metric with 2 n.
TEST(Simplify, BringsSubdividedCoversBack) {
  for (const std::size_t degree : {1u, 2u, 7u, 100u}) {
    const Gluings fine = random_relabelling(fine_tripus(degree), degree);
    const Simplified result = simplify(fine);
    EXPECT_EQ(result.given, 48 * degree);
    EXPECT_EQ(result.tetrahedron_count(), 2 * degree);
    EXPECT_GE(result.given, result.collapsed);
    EXPECT_GE(result.collapsed, result.reduced);
    EXPECT_GE(result.reduced, result.tetrahedron_count());
    EXPECT_EQ(result.finite_vertices_left, 0u);
    EXPECT_FALSE(result.stopped);
    const ManifoldInvariants before{Triangulation(fine)};
    testing::expect_kept(before, ManifoldInvariants(Triangulation(result.gluings)),
                         -before.spheres);
  }
}

TEST(Simplify, MakesSolidsSmall) {
  const auto ball =
      simplify(cone_boundary(testing::cube_mesh(4, [](int, int, int) { return true; })));
  EXPECT_EQ(ball.tetrahedron_count(), 1u);
  const Triangulation sphere(ball.gluings);
  EXPECT_EQ(sphere.vertex_count(), 1u);
  EXPECT_EQ(to_string(first_homology(sphere)), "0");
  // A cavity is filled in; a hole becomes an ideal vertex.
  const auto hole = simplify(cone_boundary(testing::cube_mesh(5, [](int x, int y, int z) {
    return (x != 2 || y != 2) && (x != 0 || y != 0 || z != 0) && (x != 3 || y != 3 || z != 3);
  })));
  const Triangulation torus(hole.gluings);
  EXPECT_EQ(torus.vertex_count(), 1u);
  EXPECT_EQ(torus.link(0).genus(), 1);
  EXPECT_EQ(to_string(first_homology(torus)), "Z");
  EXPECT_LE(hole.tetrahedron_count(), 2u);
}

// One vertex is left of a closed manifold: Poincare's sphere with 5 tetrahedra, L(3,1) with 2,
// the projective plane times a circle with 3, and three-spheres with 1.
TEST(Simplify, KnowsClosedManifolds) {
  const std::vector<std::pair<std::string, std::size_t>> known{
      {"fvPQcdecedekrsnrs", 5}, {"cMcabbjak", 2}, {"dLQbcccajqs", 3}, {"bkaagb", 1}};
  for (const auto& [signature, count] : known) {
    SCOPED_TRACE(signature);
    const Triangulation given(decode_isosig(signature));
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Gluings fine = random_relabelling(barycentric_subdivision(given.gluings()), seed);
      const Simplified result = simplify(fine, {.seed = seed});
      EXPECT_LE(result.tetrahedron_count(), count);
      EXPECT_EQ(result.finite_vertices_left, 0u);
      const Triangulation small(result.gluings);
      EXPECT_EQ(small.vertex_count(), 1u);
      EXPECT_EQ(small.is_orientable(), given.is_orientable());
      EXPECT_EQ(first_homology(small), first_homology(given));
    }
  }
}

TEST(Simplify, TakesComponentsOneByOne) {
  const Gluings one = fine_tripus(1);
  Gluings both(2 * one.tetrahedron_count() + 2);
  for (std::size_t t = 0; t < one.tetrahedron_count(); ++t)
    for (int f = 0; f < 4; ++f)
      for (const std::size_t shift : {std::size_t{0}, one.tetrahedron_count()})
        both.set_one_side(t + shift, f, one.neighbour(t, f) + static_cast<TetrahedronIndex>(shift),
                          one.gluing(t, f));
  const auto last = static_cast<TetrahedronIndex>(2 * one.tetrahedron_count());
  for (int f = 0; f < 4; ++f) both.glue(last, f, last + 1, Perm4());
  const Simplified result = simplify(both);
  const Triangulation small(result.gluings);
  EXPECT_EQ(small.component_count(), 3u);
  EXPECT_EQ(small.vertex_count(), 3u);
  EXPECT_EQ(small.tetrahedron_count(), 5u);
}

TEST(Simplify, IsDeterministic) {
  const Gluings fine = random_relabelling(fine_tripus(20), 1);
  EXPECT_EQ(simplify(fine, {.seed = 3}).gluings, simplify(fine, {.seed = 3}).gluings);
}

TEST(Simplify, KeepsOrientedTablesOriented) {
  Gluings oriented(2);
  for (int f = 0; f < 4; ++f) oriented.glue(0, f, 1, Perm4::from_images(1, 0, 2, 3));
  const Gluings small = simplify(barycentric_subdivision(oriented)).gluings;
  for (std::size_t t = 0; t < small.tetrahedron_count(); ++t)
    for (int f = 0; f < 4; ++f) EXPECT_TRUE(small.gluing(t, f).is_odd());
}

// Stopped at every possible moment: what comes back is the manifold.
TEST(Simplify, StopsWithWhatItHas) {
  const Gluings fine = fine_tripus(200);
  const ManifoldInvariants before{Triangulation(fine)};
  for (int looks = 1; looks < 30; looks += 4) {
    std::atomic<bool> stop = false;
    int seen = 0;
    SimplifyOptions options;
    options.stop = &stop;
    options.progress = [&](std::string_view, std::size_t) { stop = ++seen >= looks; };
    const Simplified result = simplify(fine, options);
    const ManifoldInvariants after{Triangulation(result.gluings)};
    EXPECT_EQ(after.homology, before.homology);
    EXPECT_EQ(after.links, before.links);
    EXPECT_LE(result.tetrahedron_count(), fine.tetrahedron_count());
    EXPECT_EQ(static_cast<std::size_t>(after.spheres), result.finite_vertices_left);
    if (looks == 1) {
      EXPECT_TRUE(result.stopped);
      EXPECT_EQ(result.tetrahedron_count(), fine.tetrahedron_count());
    }
  }
}

TEST(Simplify, TellsItsProgress) {
  std::vector<std::string> stages;
  SimplifyOptions options;
  std::size_t last = 0;
  options.progress = [&](std::string_view stage, std::size_t tetrahedra) {
    if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
    last = tetrahedra;
  };
  const Simplified result = simplify(random_relabelling(fine_tripus(50), 9), options);
  EXPECT_EQ(stages.front(), "collapse");
  EXPECT_EQ(stages.back(), "done");
  EXPECT_EQ(last, result.tetrahedron_count());
}

TEST(Simplify, WithoutEffortStillRemovesFiniteVertices) {
  const Simplified result = simplify(decode_isosig("bkaagb"), {.effort = 0});
  EXPECT_EQ(result.finite_vertices_left, 0u);
  EXPECT_EQ(Triangulation(result.gluings).vertex_count(), 1u);
}

TEST(Simplify, RefusesWhatItCannotTake) {
  EXPECT_THROW(simplify(Gluings(1)), InvalidInput);
  EXPECT_THROW(simplify(Gluings()), InvalidInput);
  for (const double effort :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(simplify(decode_isosig("cPcbbbihq"), {.effort = effort}), InvalidInput);
}

}  // namespace
}  // namespace tripus::topology
