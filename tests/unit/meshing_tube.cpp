// The laws are those of meshing/tube/README.md.
#include <atomic>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/stop.hpp"
#include "meshing/tube/detail/clearance.hpp"
#include "meshing/tube/tube_surface.hpp"
#include "tests/support/sample_graphs.hpp"

namespace tripus::meshing {
namespace {

using ::testing::ElementsAre;
using testing::ring_graph;

double room_of(const SpatialGraph& graph) {
  return tube::find_clearance(tube::make_strands(graph, tube::OuterSurface{})).room;
}

/// Law 3: never more than the true radius, at which the tube's hole closes.
TEST(TubeClearance, OfAFinePolygonIsNearlyItsRadius) {
  for (const int n : {12, 48, 200}) {
    const double inradius = 3 * std::cos(std::numbers::pi / n);
    const double room = room_of(ring_graph(n, 3));
    EXPECT_LE(room, inradius);
    // Points that face each other over 109.47 degrees and more of turning count: their distance.
    EXPECT_GE(room, 3 * std::sin(std::acos(-1.0 / 3) / 2) - 4 * std::numbers::pi / n) << n;
  }
}

TEST(TubeClearance, OfATriangleIsBelowItsInradius) {
  const double room = room_of(ring_graph(3, 2));  // inradius 1
  EXPECT_LE(room, 1);
  EXPECT_GT(room, 0.7);
}

TEST(TubeClearance, OfTwoStrandsIsHalfTheirDistance) {
  SpatialGraph graph;
  graph.vertices = {{0, 0, 0}, {4, 0, 0}, {2, -3, 0.75}, {2, 3, 0.75}};
  graph.edges = {{{0, 0, 0}, {4, 0, 0}}, {{2, -3, 0.75}, {2, 3, 0.75}}};
  EXPECT_DOUBLE_EQ(room_of(graph), 0.375);
}

TEST(TubeClearance, IgnoresBendsButNotHairpins) {
  SpatialGraph graph;
  graph.vertices = {{0, 0, 0}, {0, 1, 0}};
  graph.edges = {{{0, 0, 0}, {5, 0, 0}, {5, 1, 0}, {0, 1, 0}}};
  EXPECT_DOUBLE_EQ(room_of(graph), 0.5);
  graph.vertices = {{0, 0, 0}, {9, 4, 0}};
  graph.edges = {{{0, 0, 0}, {5, 0, 0}, {5.1, 0.1, 0}, {9, 4, 0}}};
  EXPECT_GT(room_of(graph), 9);  // nothing but the size of the drawing limits a gentle bend
}

TEST(TubeClearance, NamesThePlace) {
  const Tube tube = make_tube(testing::example_graph("knotted-theta"), {.triangles = 2000});
  EXPECT_DOUBLE_EQ(tube.room, 0.5);
  EXPECT_THAT(tube.room_place, ::testing::HasSubstr("segment"));
  EXPECT_THAT(tube.room_place, ::testing::HasSubstr("come within 1 of each other"));
}

TEST(Tube, VolumeIsThatOfTheBallLessTheTorus) {
  // A ring's tube is a solid torus of volume 2 pi^2 R r^2.
  SpatialGraph graph = ring_graph(100, 2);
  graph.outer = OuterSphere{{0, 0, 0}, 4};
  const Tube tube = make_tube(graph, {.radius = 0.5, .triangles = 8000});
  const double pi = std::numbers::pi;
  const double exact = 4 * pi / 3 * 64 - 2 * pi * pi * 2 * 0.25;
  EXPECT_NEAR(testing::enclosed_volume(tube.surface), exact, 1e-2 * exact);
}

TEST(Tube, IsTheSameEveryTime) {
  const TubeOptions options{.triangles = 2000};
  EXPECT_EQ(tube_surface(testing::example_graph("knotted-y"), options),
            tube_surface(testing::example_graph("knotted-y"), options));
}

TEST(Tube, WithoutOuterSurfaceBoundsTheTubeItself) {
  SpatialGraph graph = ring_graph(60, 2);
  graph.outer = NoOuter{};
  const Tube tube = make_tube(graph, {.radius = 0.5, .triangles = 10'000});
  EXPECT_THAT(tube.euler_characteristics, ElementsAre(0));
  const double exact = 2 * std::numbers::pi * std::numbers::pi * 2 * 0.25;
  EXPECT_NEAR(testing::enclosed_volume(tube.surface), exact, 0.02 * exact);
}

TEST(Tube, OfALooseEndInsideGoesStraightOn) {
  SpatialGraph graph;
  graph.edges = {{{-0.5, 0, 0}, {0.5, 0, 0}}};
  graph.outer = OuterBox{{-2, -1, -1}, {2, 1, 1}};
  EXPECT_THAT(make_tube(graph, {.radius = 0.2}).euler_characteristics, ElementsAre(0));
}

/// Strands that part at 15 degrees leave a cleft that a lattice often does not resolve.
TEST(Tube, OfStrandsThatPartAtSmallAnglesHasTheirGenus) {
  for (int turn = 0; turn < 8; ++turn) {
    const double around = 0.3 + 0.7 * turn, apart = std::numbers::pi / 12;
    SpatialGraph graph;
    graph.outer = NoOuter{};
    graph.vertices = {{0, 0, 0}};
    for (int k = -1; k <= 1; ++k) {
      const double x = 12 * std::cos(k * apart), y = 12 * std::sin(k * apart);
      const Point end{x, y * std::cos(around), y * std::sin(around)};
      graph.vertices.push_back(end);
      graph.edges.push_back({{0, 0, 0}, end});
    }
    EXPECT_THAT(make_tube(graph, {.radius = 0.4, .triangles = 500}).euler_characteristics,
                ElementsAre(2))
        << turn;
  }
}

TEST(Tube, OfStraightPipesThroughTheOuterSurfaceHasTheirNumberAsGenus) {
  for (const Outer& outer :
       {Outer(OuterSphere{{0, 0, 0}, 4}), Outer(OuterBox{{-4, -4, -4}, {4, 4, 4}})}) {
    SpatialGraph graph;
    graph.outer = outer;
    graph.edges = {{{-1, 0, -5}, {-1, 0, 5}}};
    EXPECT_THAT(testing::counted_characteristics(make_tube(graph, {.triangles = 2000}).surface),
                ElementsAre(0));
    graph.edges.push_back({{1, 0, -5}, {1, 0, 5}});
    EXPECT_THAT(testing::counted_characteristics(make_tube(graph, {.triangles = 2000}).surface),
                ElementsAre(-2));
  }
}

TEST(Tube, StopsWhenAsked) {
  const std::atomic<bool> stop = true;
  EXPECT_THROW(make_tube(testing::example_graph("knotted-y"), {.stop = &stop}), Stopped);
}

}  // namespace
}  // namespace tripus::meshing
