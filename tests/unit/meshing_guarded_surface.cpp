// The laws are those of meshing/tube/README.md.
#include <random>

#include <gtest/gtest.h>

#include "meshing/self_intersection.hpp"
#include "meshing/tube/detail/guarded_surface.hpp"
#include "tests/support/sample_graphs.hpp"
#include "tests/support/sample_surfaces.hpp"

namespace tripus::meshing::tube {
namespace {

double real(std::mt19937_64& random) { return double(random() >> 11) * 0x1p-52 - 1; }

Point random_point(std::mt19937_64& random) { return {real(random), real(random), real(random)}; }

/// Whether a triangle meets a tetrahedron beyond common corners, with exact tests of its faces
/// (a triangle inside, away from all faces, is found by its first corner that is not common).
bool really_meet(const Simplex<4>& t, const Simplex<3>& f) {
  SurfaceMesh mesh;
  const auto add = [&](std::uint32_t name, const Point& p) {
    if (mesh.points.size() <= name) mesh.points.resize(name + 1);
    mesh.points[name] = p;
  };
  for (int k = 0; k < 4; ++k) add(t.names[k], t.points[k]);
  for (int k = 0; k < 3; ++k) add(f.names[k], f.points[k]);
  for (int k = 0; k < 4; ++k)
    mesh.triangles.push_back({t.names[(k + 1) % 4], t.names[(k + 2) % 4], t.names[(k + 3) % 4]});
  mesh.triangles.push_back({f.names[0], f.names[1], f.names[2]});
  for (std::size_t k = 0; k < 4; ++k)
    if (triangles_cross(mesh, k, 4)) return true;
  for (int k = 0; k < 3; ++k) {
    if (std::ranges::find(t.names, f.names[k]) != t.names.end()) continue;
    const Point& p = f.points[k];
    int inside = 0;
    const auto volume = [](const Point& a, const Point& b, const Point& c, const Point& d) {
      return dot(cross(b - a, c - a), d - a);
    };
    const double whole = volume(t.points[0], t.points[1], t.points[2], t.points[3]);
    for (int v = 0; v < 4; ++v) {
      auto q = t.points;
      q[v] = p;
      inside += volume(q[0], q[1], q[2], q[3]) * whole > 0 ? 1 : 0;
    }
    return inside == 4;
  }
  return false;
}

/// Law 4: what is called clear is clear.
TEST(Sweep, NeverCallsClearWhatMeets) {
  std::mt19937_64 random(7);
  std::array<int, 3> clear{}, meeting{};
  for (int trial = 0; trial < 30'000; ++trial) {
    const int common = trial % 3;
    Simplex<4> t{{0, 1, 2, 3}, {}};
    for (Point& p : t.points) p = random_point(random);
    Simplex<3> f{{4, 5, 6}, {}};
    for (Point& p : f.points) p = random_point(random);
    for (int k = 0; k < common; ++k) {
      f.names[k] = t.names[k + 1];
      f.points[k] = t.points[k + 1];
    }
    std::rotate(f.names.begin(), f.names.begin() + trial % 5 % 3, f.names.end());
    std::rotate(f.points.begin(), f.points.begin() + trial % 5 % 3, f.points.end());
    const bool says_clear = meet_in_common_face_only(t, f), meet = really_meet(t, f);
    EXPECT_FALSE(says_clear && meet) << trial;
    // In general position it does not refuse what is clear either.
    EXPECT_TRUE(says_clear || meet) << trial;
    ++(meet ? meeting : clear)[common];
  }
  for (int common = 0; common < 3; ++common) {
    EXPECT_GT(clear[common], 500);
    EXPECT_GT(meeting[common], 500);
  }
}

TEST(Sweep, TellsFlatBodiesApart) {
  const Simplex<4> flat{{0, 1, 2, 3}, {Point{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
  const Simplex<3> beside{{0, 4, 5}, {Point{0, 0, 0}, {-1, 0.5, 0}, {-1, -1, 0}}};
  const Simplex<3> across{{0, 4, 5}, {Point{0, 0, 0}, {2, 1, 0}, {2, 2, 0}}};
  const Simplex<3> away{{4, 5, 6}, {Point{2, 0, 0}, {3, 0, 0}, {2, 1, 0}}};
  EXPECT_TRUE(meet_in_common_face_only(flat, beside));
  EXPECT_FALSE(meet_in_common_face_only(flat, across));
  EXPECT_TRUE(meet_in_common_face_only(flat, away));
}

/// Flat faces and straight rows of edges are nothing special.
TEST(GuardedSurface, CoarsensABoxToAFewTriangles) {
  GuardedSurface surface(testing::box_surface(0, 1, 8));
  for (int pass = 0; pass < 10; ++pass)
    for (std::uint32_t v = 0; v < surface.point_count(); ++v)
      for (int k = 0; k < 3 && !surface.star(v).empty(); ++k) {
        const Triangle& t = surface.triangle(surface.star(v).front());
        if (t[std::size_t(k)] != v) surface.collapse(v, t[std::size_t(k)], 0.05);
      }
  EXPECT_LT(surface.triangle_count(), 150u);  // of 768
  EXPECT_FALSE(first_self_intersection(surface.mesh()));
}

/// Two rings in each other, so that motions have something to run into.
SurfaceMesh linked_tori() {
  SurfaceMesh one = testing::torus_surface(1, 0.4, 24, 10), other = one;
  for (Point& p : other.points) p = {p[0] + 1, p[2], p[1]};
  for (Triangle& t : other.triangles) std::swap(t[1], t[2]);
  return testing::joined(one, other);
}

TEST(GuardedSurface, StaysFreeOfSelfIntersectionsUnderRandomMoves) {
  std::mt19937_64 random(3);
  GuardedSurface surface(linked_tori());
  const auto before = testing::counted_characteristics(surface.mesh());
  int done = 0, refused = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    const auto v = std::uint32_t(random() % surface.point_count());
    const double far = std::pow(10, -1.5 * (1 + real(random)));  // 0.001 to 1
    ++(surface.move(v, surface.point(v) + far * random_point(random), 0.02) ? done : refused);
  }
  EXPECT_GT(done, 1000);
  EXPECT_GT(refused, 1000);
  const SurfaceMesh mesh = surface.mesh();
  EXPECT_FALSE(first_self_intersection(mesh));
  EXPECT_EQ(testing::counted_characteristics(mesh), before);
}

TEST(GuardedSurface, CollapsesAsFarAsTheShapeAllows) {
  std::mt19937_64 random(5);
  GuardedSurface surface(linked_tori());
  const auto before = testing::counted_characteristics(surface.mesh());
  const std::size_t start = surface.triangle_count();
  for (int trial = 0; trial < 30'000; ++trial) {
    const auto v = std::uint32_t(random() % surface.point_count());
    if (surface.star(v).empty()) continue;
    const Triangle& t = surface.triangle(surface.star(v)[random() % surface.star(v).size()]);
    if (const std::uint32_t w = t[random() % 3]; w != v) surface.collapse(v, w, 0);
  }
  const SurfaceMesh mesh = surface.mesh();
  EXPECT_EQ(mesh.triangles.size(), surface.triangle_count());
  EXPECT_LT(4 * mesh.triangles.size(), start);
  EXPECT_GE(mesh.triangles.size(), 28u);  // two tori have 14 each at least
  EXPECT_FALSE(first_self_intersection(mesh));
  EXPECT_EQ(testing::counted_characteristics(mesh), before);
}

TEST(GuardedSurface, RefusesToMakeATetrahedronFlat) {
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  GuardedSurface surface(mesh);
  EXPECT_FALSE(surface.collapse(0, 1, 0));
  EXPECT_FALSE(surface.move(0, {1, 1, 1}, 0));
  EXPECT_TRUE(surface.move(0, {0.1, 0.1, 0.1}, 0));
}

}  // namespace
}  // namespace tripus::meshing::tube
