#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "meshing/self_intersection.hpp"
#include "tests/support/sample_surfaces.hpp"

namespace tripus::meshing {
namespace {

using testing::box_surface;
using testing::joined;
using testing::torus_surface;

bool cross(const SurfaceMesh& mesh) {
  const bool answer = triangles_cross(mesh, 0, 1);
  EXPECT_EQ(triangles_cross(mesh, 1, 0), answer);
  EXPECT_EQ(first_self_intersection(mesh).has_value(), answer);
  return answer;
}

/// Two triangles on the points given.
SurfaceMesh two(std::vector<Point> points, Triangle s, Triangle t) {
  return {std::move(points), {s, t}};
}

TEST(MeshingSelfIntersection, TrianglesWithoutCommonCorners) {
  const Point a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  const auto with = [&](Point p, Point q, Point r) {
    return cross(two({a, b, c, p, q, r}, {0, 1, 2}, {3, 4, 5}));
  };
  EXPECT_TRUE(with({1, 1, -1}, {1, 1, 1}, {9, 9, 1}));       // an edge through the other
  EXPECT_TRUE(with({1, -1, -1}, {1, -1, 1}, {1, 9, 0}));     // the other's edge through it
  EXPECT_TRUE(with({1, 1, 0}, {1, 1, 1}, {2, 2, 1}));        // touches with a corner
  EXPECT_TRUE(with({1, 1, 0}, {2, 1, 0}, {1, 2, 0}));        // lies inside, same plane
  EXPECT_TRUE(with({-9, -9, 0}, {99, -9, 0}, {-9, 99, 0}));  // lies around, same plane
  EXPECT_TRUE(with({4, 0, 0}, {5, 1, 1}, {5, 0, 1}));        // equal points, not shared by number
  EXPECT_FALSE(with({3, 3, 0}, {5, 3, 0}, {3, 5, 0}));       // beside, same plane
  EXPECT_FALSE(with({1, 1, 1}, {2, 1, 1}, {1, 2, 1}));       // parallel
  EXPECT_FALSE(with({3, 3, -1}, {3, 3, 1}, {9, 9, 0}));      // its plane crosses beside
}

TEST(MeshingSelfIntersection, TrianglesWithACommonCorner) {
  const Point o{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  const auto with = [&](Point p, Point q) {
    return cross(two({o, b, c, p, q}, {0, 1, 2}, {3, 4, 0}));
  };
  EXPECT_TRUE(with({1, 1, 1}, {1, 1, -1}));
  EXPECT_TRUE(with({9, 9, 9}, {9, 9, -9}));
  EXPECT_TRUE(with({9, 9, 0}, {9, 9, 9}));      // meets along a ray from the corner
  EXPECT_TRUE(with({2, 0, 0}, {0, -3, 1}));     // along a side
  EXPECT_TRUE(with({9, 1, 0}, {1, 9, 0}));      // same plane
  EXPECT_FALSE(with({-1, -1, 0}, {-1, 1, 0}));  // same plane, other side
  EXPECT_FALSE(with({-1, -1, 1}, {-1, -1, -1}));
  EXPECT_FALSE(with({1, 1, 1}, {2, 1, 1}));
}

TEST(MeshingSelfIntersection, TrianglesWithACommonEdge) {
  const Point o{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  const auto with = [&](Point p) { return cross(two({o, b, c, p}, {0, 1, 2}, {3, 1, 0})); };
  EXPECT_TRUE(with({1, 1, 0}));    // folded back
  EXPECT_FALSE(with({1, -1, 0}));  // flat
  EXPECT_FALSE(with({1, 1, 0x1p-100}));
}

TEST(MeshingSelfIntersection, ProperSurfacesHaveNone) {
  for (const std::uint32_t n : {1u, 2u, 7u})
    EXPECT_FALSE(first_self_intersection(box_surface(0, 1, n)));
  EXPECT_FALSE(first_self_intersection(torus_surface(2, 0.7, 30, 20)));
  EXPECT_FALSE(first_self_intersection(
      joined(box_surface(0, 9, 3), torus_surface(2, 0.5, 9, 7, {4, 4, 4}))));
}

TEST(MeshingSelfIntersection, AgreesWithAllPairs) {
  std::mt19937 random(3);
  int crossing = 0;
  for (int trial = 0; trial < 300; ++trial) {
    // A small grid makes touching, overlapping and flat configurations frequent.
    std::uniform_int_distribution<int> whole(0, trial % 2 ? 4 : 40), count(2, 14);
    SurfaceMesh mesh;
    for (int i = 0; i < 30; ++i)
      mesh.points.push_back({double(whole(random)), double(whole(random)), double(whole(random))});
    std::uniform_int_distribution<std::uint32_t> pick(0, 29);
    const int wanted = count(random);
    while (int(mesh.triangles.size()) < wanted) {
      const Triangle t{pick(random), pick(random), pick(random)};
      const auto axis_of = [&](const Triangle& u) {
        for (std::size_t k = 0; k < 3; ++k) {
          const auto &p = mesh.points[u[0]], &q = mesh.points[u[1]], &r = mesh.points[u[2]];
          const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
          if ((q[i] - p[i]) * (r[j] - p[j]) != (q[j] - p[j]) * (r[i] - p[i])) return true;
        }
        return false;
      };
      auto sorted = t;
      std::ranges::sort(sorted);
      const bool known = std::ranges::any_of(mesh.triangles, [&](Triangle u) {
        std::ranges::sort(u);
        return u == sorted;
      });
      if (axis_of(t) && !known) mesh.triangles.push_back(t);
    }
    std::optional<std::array<std::uint32_t, 2>> first;
    for (std::uint32_t s = 0; s < mesh.triangles.size() && !first; ++s)
      for (std::uint32_t t = s + 1; t < mesh.triangles.size() && !first; ++t)
        if (triangles_cross(mesh, s, t)) first = {{s, t}};
    ASSERT_EQ(first_self_intersection(mesh), first) << "trial " << trial;
    crossing += first.has_value();
  }
  EXPECT_GT(crossing, 100);
  EXPECT_LT(crossing, 300);
}

}  // namespace
}  // namespace tripus::meshing
