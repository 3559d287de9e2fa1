// The laws are those of meshing/tube/README.md.
#include <fstream>
#include <numbers>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meshing/self_intersection.hpp"
#include "meshing/stopped.hpp"
#include "meshing/tube/detail/clearance.hpp"
#include "meshing/tube/tube_surface.hpp"
#include "tests/support/sample_graphs.hpp"

namespace tripus::meshing {
namespace {

using ::testing::ElementsAre;
using testing::ring_graph;

SpatialGraph example(const std::string& name) {
  std::ifstream file(std::string(TRIPUS_DATA_DIR) + "/../examples/graphs/" + name + ".json");
  std::stringstream text;
  text << file.rdbuf();
  return read_spatial_graph(text.str());
}

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
  const Tube tube = make_tube(example("knotted-theta"), {.triangles = 2000});
  EXPECT_DOUBLE_EQ(tube.room, 0.5);
  EXPECT_THAT(tube.room_place, ::testing::HasSubstr("segment"));
  EXPECT_THAT(tube.room_place, ::testing::HasSubstr("come within 1 of each other"));
}

struct Shape {
  const char* name;
  std::vector<long> euler_characteristics;
};

class TubeExamples : public ::testing::TestWithParam<Shape> {};

/// Law 1: closed, manifold, without self-intersections, with the graph's genera.
TEST_P(TubeExamples, HaveTheGeneraOfTheirGraphs) {
  const Tube tube = make_tube(example(GetParam().name), {.triangles = 3000});
  EXPECT_EQ(testing::counted_characteristics(tube.surface), GetParam().euler_characteristics);
  EXPECT_EQ(tube.euler_characteristics, GetParam().euler_characteristics);
  EXPECT_FALSE(first_self_intersection(tube.surface));
  EXPECT_GT(testing::enclosed_volume(tube.surface), 0);
}

INSTANTIATE_TEST_SUITE_P(All, TubeExamples,
                         ::testing::Values(Shape{"knotted-y", {-2}},
                                           Shape{"knotted-theta", {-2, 2}},
                                           Shape{"unknotted-theta", {-2, 2}},
                                           Shape{"four-legs", {-4}}, Shape{"trefoil", {0, 2}},
                                           Shape{"linked-handcuff", {-2, 2}}),
                         [](const auto& param) {
                           std::string name = param.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Tube, VolumeIsThatOfTheBallLessTheTorus) {
  // A ring's tube is a solid torus of volume 2 pi^2 R r^2.
  SpatialGraph graph = ring_graph(100, 2);
  graph.outer = OuterSphere{{0, 0, 0}, 4};
  const Tube tube = make_tube(graph, {.radius = 0.5, .triangles = 8000});
  const double pi = std::numbers::pi;
  const double exact = 4 * pi / 3 * 64 - 2 * pi * pi * 2 * 0.25;
  EXPECT_NEAR(testing::enclosed_volume(tube.surface), exact, 1e-2 * exact);
}

TEST(Tube, AThickerTubeLeavesLess) {
  double before = HUGE_VAL;
  for (const double radius : {0.2, 0.3, 0.4}) {
    const Tube tube = make_tube(example("knotted-y"), {.radius = radius, .triangles = 6000});
    const double volume = testing::enclosed_volume(tube.surface);
    EXPECT_LT(volume, before) << radius;
    before = volume;
  }
}

TEST(Tube, HasAboutAsManyTrianglesAsAsked) {
  for (const std::size_t count : {2'000u, 12'000u}) {
    const SurfaceMesh surface = tube_surface(example("knotted-y"), {.triangles = count});
    EXPECT_NEAR(double(surface.triangles.size()), double(count), 0.02 * double(count));
  }
}

TEST(Tube, IsTheSameEveryTime) {
  const TubeOptions options{.triangles = 2000};
  EXPECT_EQ(tube_surface(example("knotted-y"), options),
            tube_surface(example("knotted-y"), options));
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

TEST(Tube, IsTheSameAtEveryScale) {
  const auto scaled = [](double s) {
    SpatialGraph graph = example("knotted-theta");
    for (Point& p : graph.vertices)
      for (double& x : p) x *= s;
    for (auto& edge : graph.edges)
      for (Point& p : edge)
        for (double& x : p) x *= s;
    return make_tube(graph, {.triangles = 3000});
  };
  const Tube one = scaled(1);
  for (const double s : {0x1p-100, 0x1p100}) {
    const Tube other = scaled(s);
    EXPECT_EQ(other.radius, s * one.radius);
    EXPECT_EQ(other.euler_characteristics, one.euler_characteristics);
    EXPECT_EQ(other.surface.triangles, one.surface.triangles);
  }
}

TEST(Tube, StopsWhenAsked) {
  const std::atomic<bool> stop = true;
  EXPECT_THROW(make_tube(example("knotted-y"), {.stop_requested = &stop}), Stopped);
}

}  // namespace
}  // namespace tripus::meshing
