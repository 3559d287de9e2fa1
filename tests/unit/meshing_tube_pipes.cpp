// The tube as straight pipes (laws 1, 2 and 6 of meshing/tube/README.md).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meshing/tube/detail/convex_hull.hpp"
#include "meshing/tube/detail/pipe_plan.hpp"
#include "meshing/tube/tube_surface.hpp"
#include "meshing/validate.hpp"
#include "tests/support/sample_graphs.hpp"

namespace tripus::meshing {
namespace {

using ::testing::ElementsAre;
using testing::ring_graph;

TEST(ConvexHull, OfACubeHasTwelveFacetsWithoutItsMiddle) {
  std::vector<Point> points;
  std::vector<std::uint32_t> names;
  for (std::uint32_t i = 0; i < 8; ++i) {
    names.push_back(i);
    points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  }
  names.push_back(8);
  points.push_back({0.5, 0.5, 0.5});
  tube::ConvexHull hull(points, names);
  EXPECT_EQ(hull.facets().size(), 12u);
  EXPECT_EQ(testing::enclosed_volume({points, hull.facets()}), 1);
  points.push_back({0.5, 0.5, 3});
  EXPECT_TRUE(hull.add(points, 9));
  EXPECT_NEAR(testing::enclosed_volume({points, hull.facets()}), 1 + 2.0 / 3, 1e-15);
  points.push_back({0.5, 0.5, 2});
  EXPECT_FALSE(hull.add(points, 10));
}

TEST(ConvexHull, OfPointsInAPlaneHasNoFacets) {
  const std::vector<Point> points{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  EXPECT_TRUE(tube::ConvexHull(points, {0, 1, 2, 3}).facets().empty());
}

TEST(ConvexHull, TakesOutFacetsByTheirWayRound) {
  std::vector<Triangle> facets{{0, 1, 2}, {3, 1, 0}, {2, 1, 3}};
  EXPECT_FALSE(tube::take_out(facets, {{0, 1, 3}}));
  EXPECT_TRUE(tube::take_out(facets, {{1, 0, 3}}));
  EXPECT_THAT(facets, ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 3}));
}

/// Everything that a tube promises of its surface.
void expect_good(const Tube& tube) {
  EXPECT_FALSE(tube.sampled);
  EXPECT_EQ(testing::counted_characteristics(tube.surface), tube.euler_characteristics);
  EXPECT_GT(testing::enclosed_volume(tube.surface), 0);
  const Region region = require_valid(tube.surface);
  EXPECT_EQ(region.turned, 0u);
  EXPECT_GT(tube.radius, 0);
  EXPECT_GE(tube.thickest, tube.radius);
}

TEST(Pipes, OfTheExamplesTakeHundredsOfTriangles) {
  for (const char* name : {"four-legs", "knotted-pipe", "knotted-theta", "knotted-y",
                           "linked-handcuff", "trefoil", "unknotted-theta"}) {
    SCOPED_TRACE(name);
    const Tube tube = make_tube(testing::example_graph(name));
    expect_good(tube);
    EXPECT_LT(tube.surface.triangles.size(), 700u);
  }
}

TEST(Pipes, HaveTheShapeOfTheSampledTube) {
  const SpatialGraph graph = testing::example_graph("knotted-y");
  const Tube sampled = make_tube(graph, {.triangles = 1000});
  EXPECT_TRUE(sampled.sampled);
  EXPECT_EQ(testing::counted_characteristics(make_tube(graph).surface),
            testing::counted_characteristics(sampled.surface));
}

/// A sharp corner, or strands that nearly touch, at one place of the graph leave the rest alone.
TEST(Pipes, AreAsThickAsTheirOwnSurroundingsAllow) {
  SpatialGraph graph = ring_graph(6, 10);
  const double alone = make_tube(graph).thickest;
  SpatialGraph knot = ring_graph(5, 1e-4, {9.9, 0, 3});
  graph.edges.push_back(knot.edges[0]);
  const Tube both = make_tube(graph);
  expect_good(both);
  EXPECT_GT(both.thickest, 0.9 * alone);
  EXPECT_LT(both.radius, 1e-4);
}

TEST(Pipes, EndOnSphereAndBox) {
  for (const Outer& outer :
       {Outer(OuterSphere{{0, 0, 0}, 4}), Outer(OuterBox{{-4, -4, -4}, {4, 4, 4}})}) {
    SpatialGraph graph;
    graph.outer = outer;
    for (const double x : {-1.0, 0.0, 1.0}) graph.edges.push_back({{x, 0, -5}, {x, 0.3, 5}});
    const Tube tube = make_tube(graph);
    expect_good(tube);
    EXPECT_THAT(tube.euler_characteristics, ElementsAre(-4));
  }
}

/// The outer surface is where the drawing says, and close strands get a finer one.
TEST(Pipes, StayWithinAnOuterSphereThatIsNear) {
  SpatialGraph graph = ring_graph(40, 2);
  graph.outer = OuterSphere{{0, 0, 0}, 2.01};
  const Tube tube = make_tube(graph);
  expect_good(tube);
  for (const Point& p : tube.surface.points) EXPECT_LE(tube::norm(p), 2.01 * (1 + 1e-15));
}

TEST(Pipes, WithoutOuterSurfaceBoundTheTubeItself) {
  SpatialGraph graph;
  graph.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j)
      graph.edges.push_back({graph.vertices[std::size_t(i)], graph.vertices[std::size_t(j)]});
  graph.outer = NoOuter{};
  const Tube tube = make_tube(graph);
  expect_good(tube);
  EXPECT_THAT(tube.euler_characteristics, ElementsAre(-4));
}

TEST(Pipes, TakeStarsOfAllDegreesAndSharpness) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int degree = 1; degree <= 12; ++degree)
    for (const double spread : {1.0, 0.1, 0.01}) {
      SpatialGraph graph;
      graph.vertices = {{0, 0, 0}};
      for (int k = 0; k < degree; ++k) {
        const Point end{1 + spread * number(random), spread * number(random),
                        spread * number(random)};
        graph.vertices.push_back(end);
        graph.edges.push_back({{0, 0, 0}, end});
      }
      const Tube tube = make_tube(graph);
      expect_good(tube);
      EXPECT_THAT(tube.euler_characteristics, ElementsAre(2, 2)) << degree << " " << spread;
    }
}

/// The rules of pipe_plan.hpp, measured.
TEST(Pipes, KeepTheirDistances) {
  const SpatialGraph graph = testing::example_graph("knotted-theta");
  const tube::PipePlan plan =
      tube::plan_pipes(tube::make_strands(graph, tube::OuterSurface(OuterSphere{{1, 1, 1}, 9})));
  for (const tube::Joint& a : plan.joints)
    for (const tube::Joint& b : plan.joints)
      if (&a != &b) {
        EXPECT_LT(a.radius + b.radius, tube::distance(a.point, b.point));
      }
  for (const tube::Pipe& pipe : plan.pipes) {
    EXPECT_GT(std::min(pipe.radius_a, pipe.radius_b), 0);
    EXPECT_LT(pipe.radius_a, plan.joints[pipe.a].radius);
    EXPECT_LT(pipe.radius_b, plan.joints[pipe.b].radius);
  }
}

TEST(Pipes, OfPointsThatRepeatThemselvesAreThoseWithoutThem) {
  SpatialGraph graph = testing::example_graph("knotted-theta");
  const SurfaceMesh once = tube_surface(graph);
  for (auto& edge : graph.edges)
    for (const std::size_t place : {edge.size() - 1, edge.size() / 2, std::size_t{0}})
      edge.insert(edge.begin() + std::ptrdiff_t(place), 2, edge[place]);
  EXPECT_EQ(tube_surface(graph), once);
}

TEST(Pipes, AreTheSameAtEveryScale) {
  SpatialGraph graph = testing::example_graph("knotted-theta");
  const SurfaceMesh one = tube_surface(graph);
  for (Point& p : graph.vertices)
    for (double& x : p) x *= 0x1p-100;
  for (auto& edge : graph.edges)
    for (Point& p : edge)
      for (double& x : p) x *= 0x1p-100;
  EXPECT_EQ(tube_surface(graph).triangles, one.triangles);
}

}  // namespace
}  // namespace tripus::meshing
