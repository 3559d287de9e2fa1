// Graphs that have no tube: each is refused with its place and reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "meshing/tube/tube_surface.hpp"

namespace tripus::meshing {
namespace {

struct Bad {
  const char* name;
  const char* text;
  std::vector<std::string> message;
};

class BadGraph : public ::testing::TestWithParam<Bad> {};

TEST_P(BadGraph, IsRefusedWithPlaceAndReason) {
  try {
    make_tube(read_spatial_graph(GetParam().text));
    FAIL() << "was taken";
  } catch (const InvalidInput& error) {
    for (const std::string& part : GetParam().message)
      EXPECT_THAT(error.what(), ::testing::HasSubstr(part));
  }
}

const Bad kBad[] = {
    {"Nothing", "", {"JSON: syntax error at byte"}},
    {"NoObject", "[1,2]", {"found an array of 2", "expected an object"}},
    {"KeyTwice", R"({"edges": [], "edges": []})", {"the key", "occurs twice"}},
    {"NaN", R"({"edges": [[[NaN,0,0],[1,0,0]]]})", {"JSON: syntax error"}},
    {"HugeNumber", R"({"edges": [[[1e999,0,0],[1,0,0]]]})", {"too large; numbers must be finite"}},
    {"LargeNumber",
     R"({"vertices": [[0,0,0],[1e300,0,0]], "edges": [[[0,0,0],[1e300,0,0]]]})",
     {"vertex 1", "beyond 1e60"}},
    {"TinyDrawing",
     R"({"vertices": [[0,0,0],[1e-200,0,0]], "edges": [[[0,0,0],[1e-200,0,0]]]})",
     {"scale it up"}},
    {"FarAway",
     R"({"vertices": [[1e9,0,0],[1000000001,0,0]],
                    "edges": [[[1e9,0,0],[1000000001,0,0]]]})",
     {"move it to the origin"}},
    {"UnknownKey", R"({"nodes": [], "edges": []})", {"unknown key \"nodes\"", "\"vertices\""}},
    {"NoEdgesKey", R"({"vertices": []})", {"\"edges\" is missing"}},
    {"NoEdges", R"({"edges": []})", {"no edges"}},
    {"PointOfTwo", R"({"edges": [[[0,0,0],[1,0]]]})", {"edge 0: point 1", "an array of 2"}},
    {"PointOfText", R"({"edges": [[[0,0,0],[1,0,"x"]]]})", {"edge 0: point 1: coordinate 2"}},
    {"EdgeNoList", R"({"edges": [7]})", {"edge 0 is \"7\""}},
    {"OnePoint", R"({"vertices": [[0,0,0]], "edges": [[[0,0,0]]]})", {"edge 0 has 1 points"}},
    {"NegativeSphere",
     R"({"edges": [], "outer": {"sphere": {"center": [0,0,0], "radius": -1}}})",
     {"outer sphere", "greater than 0"}},
    {"SphereWithoutCenter",
     R"({"edges": [], "outer": {"sphere": {"radius": 1}}})",
     {"\"center\" is missing"}},
    {"InvertedBox",
     R"({"edges": [], "outer": {"box": {"low": [0,0,0], "high": [1,-1,1]}}})",
     {"outer box: coordinate 1"}},
    {"UnknownOuter", R"({"edges": [], "outer": "torus"})", {"\"outer\"", "automatic"}},
    {"TwoOuters", R"({"edges": [], "outer": {"sphere": 1, "box": 2}})", {"\"outer\""}},
    {"OnePointAgainAndAgain",
     R"({"vertices": [[1,2,0],[0,0,0]], "edges": [[[1,2,0],[1,2,0],[1,2,0]], [[0,0,0],[1,2,0]]]})",
     {"edge 0 is the point (1, 2, 0) alone"}},
    {"RepeatedVertex",
     R"({"vertices": [[0,0,0],[0,0,0]], "edges": [[[0,0,0],[1,0,0]]]})",
     {"vertex 1", "is vertex 0 again"}},
    {"UnusedVertex",
     R"({"vertices": [[0,0,0],[1,0,0],[5,5,5]], "edges": [[[0,0,0],[1,0,0]]]})",
     {"vertex 2 at (5, 5, 5)", "the end of no edge"}},
    {"VertexOnTheWay",
     R"({"vertices": [[0,0,0],[1,0,0],[2,0,0]], "edges": [[[0,0,0],[1,0,0],[2,0,0]]]})",
     {"edge 0: point 1 is vertex 1", "split the edge"}},
    {"LoopOfThree",
     R"({"vertices": [[0,0,0]], "edges": [[[0,0,0],[1,0,0],[0,0,0]]]})",
     {"edge 0 ends where it begins", "4 points"}},
    {"StrandsCross",
     R"({"vertices": [[-1,0,0],[1,0,0],[0,-1,0],[0,1,0]],
         "edges": [[[-1,0,0],[1,0,0]], [[0,-1,0],[0,1,0]]]})",
     {"edge 0 segment 0 and edge 1 segment 0 touch"}},
    {"StrandsOverlap",
     R"({"vertices": [[0,0,0],[3,0,0],[1,0,0],[2,0,0]],
         "edges": [[[0,0,0],[3,0,0]], [[1,0,0],[2,0,0]]]})",
     {"edge 0 segment 0 and edge 1 segment 0 touch"}},
    {"SelfCrossing",
     R"({"edges": [[[0,0,0],[2,2,0],[0,2,0],[2,0,0],[0,0,0]]]})",
     {"edge 0 segment 0 and edge 0 segment 2 touch"}},
    {"FoldsBack",
     R"({"vertices": [[0,0,0],[0.5,0,0]], "edges": [[[0,0,0],[1,0,0],[0.5,0,0]]]})",
     {"edge 0 segment 0 and edge 0 segment 1", "same direction from (1, 0, 0)"}},
    {"SameEdgeTwice",
     R"({"vertices": [[0,0,0],[1,0,0]], "edges": [[[0,0,0],[1,0,0]], [[0,0,0],[1,0,0]]]})",
     {"edge 0 segment 0 and edge 1 segment 0", "same direction"}},
    {"NearlyTouching",
     R"({"vertices": [[0,0,0],[4,0,0],[2,-3,1e-13],[2,3,1e-13]],
         "edges": [[[0,0,0],[4,0,0]], [[2,-3,1e-13],[2,3,1e-13]]]})",
     {"too thin for the size of the whole", "edge 0 segment 0 and edge 1 segment 0"}},
    {"VertexOutside",
     R"({"vertices": [[0,0,0],[3,0,0]], "edges": [[[0,0,0],[3,0,0]]],
         "outer": {"sphere": {"center": [0,0,0], "radius": 2}}})",
     {"vertex 1 at (3, 0, 0) does not lie inside"}},
    {"ComesBack",
     R"({"vertices": [[0,0,0],[1,0,0]], "edges": [[[0,0,0],[0,3,0],[1,3,0],[1,0,0]]],
         "outer": {"sphere": {"center": [0,0,0], "radius": 2}}})",
     {"edge 0: point 1 at (0, 3, 0)", "comes back"}},
    {"AllOutside",
     R"({"edges": [[[3,0,0],[4,0,0]]], "outer": {"sphere": {"center": [0,0,0], "radius": 2}}})",
     {"edge 0 has no point inside"}},
    {"OneInside",
     R"({"edges": [[[0,0,0],[4,0,0]]], "outer": {"sphere": {"center": [0,0,0], "radius": 2}}})",
     {"edge 0 has one point inside"}},
    {"LeavesFlatly",
     R"({"vertices": [[0,1.9,0]], "edges": [[[0,1.9,0],[4,1.9,0]]],
         "outer": {"sphere": {"center": [0,0,0], "radius": 2}}})",
     {"edge 0 meets the outer surface", "too flatly", "71.8"}},
    {"LeavesAtTheRim",
     R"({"vertices": [[0,0,0]], "edges": [[[0,0,0],[1.8,1.99999999999998,2]]],
         "outer": {"box": {"low": [-1,-1,-1], "high": [1,1,1]}}})",
     {"too thin", "from the next face of the outer box"}},
    {"LooseWithoutOuter",
     R"({"edges": [[[0,0,0],[1,0,0]]], "outer": "none"})",
     {"edge 0 has an end that is no vertex"}},
    {"TouchesTheSphere",
     R"({"vertices": [[-1.999999999999,0,0],[1,0,0]], "edges": [[[-1.999999999999,0,0],[1,0,0]]],
         "outer": {"sphere": {"center": [0,0,0], "radius": 2}}})",
     {"too thin", "e-12 from the outer surface"}},
};

INSTANTIATE_TEST_SUITE_P(All, BadGraph, ::testing::ValuesIn(kBad),
                         [](const auto& param) { return param.param.name; });

TEST(TubeDomain, TooThickATubeNamesTheStrandsAndTheLimit) {
  const SpatialGraph graph = read_spatial_graph(
      R"({"vertices": [[0,0,0],[4,0,0],[2,-3,1],[2,3,1]],
          "edges": [[[0,0,0],[4,0,0]], [[2,-3,1],[2,3,1]]]})");
  try {
    make_tube(graph, {.radius = 0.49});
    FAIL() << "was taken";
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("radius 0.49 does not fit"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("edge 0 segment 0 and edge 1 segment 0"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("must not exceed 0.475"));
  }
  EXPECT_NO_THROW(make_tube(graph, {.radius = 0.2, .triangles = 2000}));
}

TEST(TubeDomain, RefusesRadiiAndResolutionsThatAreNone) {
  const SpatialGraph graph =
      read_spatial_graph(R"({"vertices": [[0,0,0],[1,0,0]], "edges": [[[0,0,0],[1,0,0]]]})");
  for (const double radius : {0.0, -1.0, double(NAN), HUGE_VAL})
    EXPECT_THROW(make_tube(graph, {.radius = radius}), InvalidInput) << radius;
  for (const double around : {0.0, 2.9, -1.0, double(NAN), 1e9})
    EXPECT_THROW(make_tube(graph, {.edges_around = around}), InvalidInput) << around;
}

TEST(TubeDomain, ALoneSegmentAndAPinHaveTubes) {
  const SpatialGraph segment =
      read_spatial_graph(R"({"vertices": [[0,0,0],[1,0,0]], "edges": [[[0,0,0],[1,0,0]]]})");
  EXPECT_EQ(make_tube(segment).euler_characteristics, (std::vector<long>{2, 2}));
}

}  // namespace
}  // namespace tripus::meshing
