// Tubes around whole families of graphs. The laws are those of meshing/tube/README.md.
#include <gtest/gtest.h>

#include "meshing/self_intersection.hpp"
#include "meshing/tube/tube_surface.hpp"
#include "tests/support/sample_graphs.hpp"

namespace tripus::meshing {
namespace {

/// Laws 1 and 2 on random subgraphs of the lattice, of every density, closed and open.
TEST(TubeFamily, RandomLatticeGraphsHaveTheirOwnGenera) {
  std::mt19937_64 random(20261122);
  std::size_t most_components = 0;
  long least = 2;
  for (int trial = 0; trial < 16; ++trial) {
    const double density = 0.1 + 0.1 * (trial % 7);
    const auto lattice =
        testing::random_lattice_graph(2 + trial % 2, density, trial % 4 > 1, random);
    if (lattice.graph.edges.empty()) continue;
    const Tube tube = make_tube(lattice.graph, {.triangles = 4000});
    const auto counted = testing::counted_characteristics(tube.surface);
    EXPECT_EQ(counted, lattice.euler_characteristics) << trial;
    EXPECT_FALSE(first_self_intersection(tube.surface)) << trial;
    EXPECT_GT(testing::enclosed_volume(tube.surface), 0) << trial;
    most_components = std::max(most_components, counted.size());
    least = std::min(least, counted.front());
  }
  EXPECT_GE(most_components, 4u);
  EXPECT_LE(least, -20);
}

/// A thicker tube takes more away, whatever the graph.
TEST(TubeFamily, VolumeFallsWithTheRadius) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 2; ++trial) {
    const auto lattice = testing::random_lattice_graph(2, 0.6, trial % 2 == 1, random);
    if (lattice.graph.edges.empty()) continue;
    double before = HUGE_VAL;
    for (const double radius : {0.2, 0.3}) {
      const Tube tube = make_tube(lattice.graph, {.radius = radius, .triangles = 4000});
      const double volume = testing::enclosed_volume(tube.surface);
      EXPECT_LT(volume, before) << trial << " at " << radius;
      before = volume;
    }
  }
}

/// Tilting the drawing moves every lattice sign, and changes nothing.
TEST(TubeFamily, TiltedKnotsKeepTheirShape) {
  for (int trial = 0; trial < 5; ++trial) {
    const double a = 1.1 * trial, b = 0.7 * trial;
    SpatialGraph graph;
    graph.edges.emplace_back();
    for (int k = 0; k < 40; ++k) {  // a trefoil
      const double t = 2 * std::numbers::pi * k / 40;
      const Point p{(2 + std::cos(3 * t)) * std::cos(2 * t),
                    (2 + std::cos(3 * t)) * std::sin(2 * t), std::sin(3 * t)};
      const Point q{p[0] * std::cos(a) - p[1] * std::sin(a),
                    p[0] * std::sin(a) + p[1] * std::cos(a), p[2]};
      graph.edges[0].push_back(
          {q[0], q[1] * std::cos(b) - q[2] * std::sin(b), q[1] * std::sin(b) + q[2] * std::cos(b)});
    }
    graph.edges[0].push_back(graph.edges[0].front());
    const Tube tube = make_tube(graph, {.triangles = 2000});
    EXPECT_EQ(testing::counted_characteristics(tube.surface), (std::vector<long>{0, 2}));
    EXPECT_NEAR(tube.room, 0.835, 0.1);
  }
}

/// The same laws for pipes, on many more.
TEST(PipesFamily, RandomLatticeGraphsHaveTheirOwnGenera) {
  std::mt19937_64 random(20261129);
  for (int trial = 0; trial < 200; ++trial) {
    const double density = 0.1 + 0.1 * (trial % 8);
    const auto lattice =
        testing::random_lattice_graph(2 + trial % 3, density, trial % 4 > 1, random);
    if (lattice.graph.edges.empty()) continue;
    const Tube tube = make_tube(lattice.graph);
    EXPECT_FALSE(tube.sampled) << trial;
    EXPECT_EQ(testing::counted_characteristics(tube.surface), lattice.euler_characteristics)
        << trial;
    EXPECT_FALSE(first_self_intersection(tube.surface)) << trial;
    EXPECT_GT(testing::enclosed_volume(tube.surface), 0) << trial;
  }
}

/// Edges that part at any angle and pass each other at any distance.
TEST(PipesFamily, RandomGraphsInStraightLinesHaveTheirOwnGenera) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    SpatialGraph graph;
    const std::size_t count = 4 + std::size_t(trial) % 8;
    for (std::size_t v = 0; v < count; ++v) {
      graph.vertices.push_back({number(random), number(random), number(random)});
      for (std::size_t w = v < 2 ? 0 : v - 2; w < v; ++w)
        graph.edges.push_back({graph.vertices[w], graph.vertices[v]});
    }
    if (trial % 3 == 0) graph.outer = NoOuter{};
    if (trial % 3 == 1) graph.outer = OuterSphere{{0, 0, 0}, 1.8};
    const Tube tube = make_tube(graph);
    const long inside = 2 * (long(count) - long(graph.edges.size()));
    const auto counted = testing::counted_characteristics(tube.surface);
    EXPECT_EQ(counted, trial % 3 == 0 ? std::vector<long>{inside} : (std::vector<long>{inside, 2}))
        << trial;
    EXPECT_FALSE(tube.sampled) << trial;
    EXPECT_FALSE(first_self_intersection(tube.surface)) << trial;
  }
}

}  // namespace
}  // namespace tripus::meshing
