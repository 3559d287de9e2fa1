// The graphs of examples/graphs and their tubes. The laws are those of meshing/tube/README.md.
#include <algorithm>

#include <gtest/gtest.h>

#include "meshing/self_intersection.hpp"
#include "meshing/tube/tube_surface.hpp"
#include "tests/support/sample_graphs.hpp"

namespace tripus::meshing {
namespace {

using testing::example_graph;

struct Shape {
  const char* name;
  std::vector<long> euler_characteristics;
};

class TubeExamples : public ::testing::TestWithParam<Shape> {};

/// Law 1: closed, manifold, without self-intersections, with the graph's genera.
TEST_P(TubeExamples, HaveTheGeneraOfTheirGraphs) {
  const Tube tube = make_tube(example_graph(GetParam().name), {.triangles = 3000});
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

TEST(Tube, AThickerTubeLeavesLess) {
  double before = HUGE_VAL;
  for (const double radius : {0.2, 0.3, 0.4}) {
    const Tube tube = make_tube(example_graph("knotted-y"), {.radius = radius, .triangles = 6000});
    const double volume = testing::enclosed_volume(tube.surface);
    EXPECT_LT(volume, before) << radius;
    before = volume;
  }
}

TEST(Tube, HasAboutAsManyTrianglesAsAsked) {
  for (const std::size_t count : {2'000u, 12'000u}) {
    const SurfaceMesh surface = tube_surface(example_graph("knotted-y"), {.triangles = count});
    EXPECT_NEAR(double(surface.triangles.size()), double(count), 0.02 * double(count));
  }
}

TEST(Tube, IsTheSameAtEveryScale) {
  const auto scaled = [](double s) {
    SpatialGraph graph = example_graph("knotted-theta");
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

}  // namespace
}  // namespace tripus::meshing
