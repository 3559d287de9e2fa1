// Two routes from a diagram to its manifold: the octahedral triangulation; and the drawing in
// space, the tube around it, a mesh. The manifolds agree, orientation included.
#include <string>

#include <gtest/gtest.h>

#include "canonical/compare.hpp"
#include "drawing/drawing.hpp"
#include "meshing/formats/read_graph.hpp"
#include "meshing/manifold.hpp"
#include "meshing/tube/tube_surface.hpp"
#include "topology/covers/cover_homology.hpp"
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
