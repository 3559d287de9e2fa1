// Two routes from a diagram to its manifold: the octahedral triangulation; and the drawing in
// space, the tube around it, a mesh. The manifolds agree, orientation included.
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "canonical/compare.hpp"
#include "drawing/drawing.hpp"
#include "meshing/formats/read_graph.hpp"
#include "meshing/manifold.hpp"
#include "meshing/tube/tube_surface.hpp"
#include "topology/covers/cover_homology.hpp"
#include "topology/diagrams/read_diagram.hpp"
#include "topology/diagrams/small_exterior.hpp"
#include "topology/diagrams/tables.hpp"
#include "topology/isosig.hpp"

namespace tripus {
namespace {

topology::Gluings through_space(const topology::Diagram& diagram) {
  const meshing::Tube tube =
      meshing::make_tube(meshing::read_graph(drawing::to_polylines(diagram)), {});
  return meshing::manifold_of(meshing::SurfaceFile{tube.surface, {}, {}}).gluings;
}

topology::Gluings by_octahedra(const topology::Diagram& diagram) {
  return topology::small_exterior({.name = {}, .diagram = diagram}).gluings;
}

class DiagramRoutes : public ::testing::TestWithParam<const char*> {};

// tests/full/diagrams.py does it for all that are hyperbolic.
TEST_P(DiagramRoutes, HandlebodyKnotsAreIsometric) {
  const topology::Diagram& diagram = topology::find_diagram(GetParam())->diagram;
  const canonical::Comparison comparison =
      canonical::compare(topology::Triangulation(by_octahedra(diagram)),
                         topology::Triangulation(through_space(diagram)));
  EXPECT_EQ(comparison.verdict, canonical::Verdict::kHomeomorphic) << comparison.message;
}

INSTANTIATE_TEST_SUITE_P(Table, DiagramRoutes,
                         ::testing::Values("5_1 theta", "hk5_3", "hk6_2", "hk6_9"));

// What appcontour has of these: pictures and Gauss codes.
TEST(DiagramRoutes, OtherNotationsGiveTheManifoldsOfTheTables) {
  for (const auto& [name, text] : std::vector<std::pair<const char*, const char*>>{
           {"hk5_3", "knot { ^  ^  ; |  X | ; h X | ; | x || ; || X | ; | x y  ; U U   ; }"},
           {"5_1 theta", "knot { ^ ; h ^ ^ |; | x x x ; X X U |; | U  y  ; U ; }"},
           {"L6a4", "knot {^ ^; / x \\; /( ^ )\\; (  x x  ); X  X  %; (  U U  ); U; }"},
           {"L5a1", "Gauss: 1 -4 5 -3 / 3 -1 2 -5 4 -2"},
           {"L6n1", "gausscode {{1 6 -5 -3} {-4 -1 2 5} {-6 4 3 -2}}"}}) {
    const topology::Diagram read = topology::read_diagram(text).diagram;
    const canonical::Comparison comparison = canonical::compare(
        topology::Triangulation(by_octahedra(topology::find_diagram(name)->diagram)),
        topology::Triangulation(by_octahedra(read)));
    EXPECT_EQ(comparison.verdict, canonical::Verdict::kHomeomorphic)
        << name << ": " << comparison.message;
  }
}

TEST(DiagramRoutes, OrientationsAgree) {
  const topology::Diagram& diagram = topology::find_diagram("5_1 theta")->diagram;
  const auto signature = [](const topology::Gluings& gluings) {
    return topology::full_isosig(gluings).oriented();
  };
  EXPECT_EQ(signature(by_octahedra(diagram)), "cPcbbbihq-");
  EXPECT_EQ(signature(through_space(diagram)), "cPcbbbihq-");
  EXPECT_EQ(signature(by_octahedra(diagram.mirror_image())), "cPcbbbihq+");
}

TEST(DiagramRoutes, KnotsHaveTheSameCovers) {
  for (const char* name : {"4_1", "8_19", "L5a1"}) {
    const topology::Diagram& diagram = topology::find_diagram(name)->diagram;
    for (const std::size_t degree : {2u, 3u})
      EXPECT_EQ(topology::cover_homology(topology::Triangulation(by_octahedra(diagram)), degree),
                topology::cover_homology(topology::Triangulation(through_space(diagram)), degree))
          << name;
  }
}

}  // namespace
}  // namespace tripus
