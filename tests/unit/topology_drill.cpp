// Drilling edges out, and keeping strands as edges, undo each other.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "canonical/compare.hpp"
#include "topology/diagrams/exterior.hpp"
#include "topology/diagrams/small_exterior.hpp"
#include "topology/diagrams/tables.hpp"
#include "topology/drill.hpp"
#include "topology/formats/formats.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"
#include "topology/orientation.hpp"
#include "topology/simplify/simplify_keeping.hpp"

namespace tripus::topology {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::string oriented_signature(const Gluings& gluings) {
  return full_isosig(simplify(gluings).gluings).oriented();
}

/// One arc of each strand.
std::vector<std::int64_t> arcs_of_strands(const Diagram& diagram) {
  std::vector<std::int64_t> arcs;
  for (const Strand& strand : strands(diagram).all) arcs.push_back(diagram.arc(strand.darts[0]));
  return arcs;
}

// A meridian of a strand is the boundary curve along which a 2-handle fills it in. The strand stays
// an edge while the sphere around becomes small; drilled out again, it gives the exterior.
TEST(Drill, UndoesKeepingStrandsAlsoAfterSimplification) {
  for (const char* name : {"4_1", "5_1 theta", "hk5_3", "6_1 handcuff"}) {
    SCOPED_TRACE(name);
    const Diagram& diagram = find_diagram(name)->diagram;
    const std::vector<std::int64_t> arcs = arcs_of_strands(diagram);
    const DiagramExterior made = exterior(diagram, arcs);
    std::vector<EdgePlace> edges;
    for (const KeptStrand& strand : made.kept) edges.push_back({strand.tetrahedron, strand.edge});
    const SimplifiedKeeping small = simplify_keeping(made.gluings, edges);
    EXPECT_LT(small.result.tetrahedron_count(), made.gluings.tetrahedron_count());
    EXPECT_EQ(to_string(first_homology(Triangulation(small.result.gluings))), "0");
    const Gluings again = drilled(small.result.gluings, small.kept);
    EXPECT_EQ(again, oriented(again));
    EXPECT_EQ(again.tetrahedron_count(), small.result.tetrahedron_count() + 4 * small.kept.size());
    const canonical::Comparison comparison =
        canonical::compare(Triangulation(simplify(again).gluings),
                           Triangulation(small_exterior({.name = {}, .diagram = diagram}).gluings));
    EXPECT_EQ(comparison.verdict, canonical::Verdict::kHomeomorphic) << comparison.message;
  }
}

TEST(Drill, KeepsTheOrientation) {
  const Diagram& theta = find_diagram("5_1 theta")->diagram;
  const std::vector<std::int64_t> arcs = arcs_of_strands(theta);
  for (const bool mirrored : {false, true}) {
    const Diagram diagram = mirrored ? theta.mirror_image() : theta;
    const DiagramExterior made = exterior(diagram, arcs);
    std::vector<EdgePlace> edges;
    for (const KeptStrand& strand : made.kept) edges.push_back({strand.tetrahedron, strand.edge});
    EXPECT_EQ(oriented_signature(drilled(made.gluings, edges)),
              mirrored ? "cPcbbbihq+" : "cPcbbbihq-");
  }
}

TEST(Drill, GivesTheLinkAHandle) {
  for (const char* signature : {"cPcbbbiht", "cPcbbbihq", "dLQbcccdero"}) {
    const Gluings gluings = decode_isosig(signature);
    const Triangulation before(gluings);
    for (std::uint32_t t = 0; t < gluings.tetrahedron_count(); ++t)
      for (int edge = 0; edge < 6; ++edge) {
        const EdgePlace place[] = {{t, edge}};
        const Triangulation after(drilled(gluings, place));
        std::vector<int> genera;
        for (std::size_t v = 0; v < after.vertex_count(); ++v)
          genera.push_back(after.link(v).genus());
        std::ranges::sort(genera);
        EXPECT_EQ(genera, (std::vector<int>{0, 0, before.link(0).genus() + 1})) << signature;
        EXPECT_EQ(first_homology(after).rank, first_homology(before).rank + 1) << signature;
      }
  }
}

TEST(Drill, JoinsTwoLinksByATube) {
  // An edge between the two cusps of the Whitehead link: one component of genus 2 is left.
  const Gluings gluings =
      small_exterior({.name = {}, .diagram = find_diagram("L5a1")->diagram}).gluings;
  const Triangulation before(gluings);
  std::size_t joined = 0;
  for (std::uint32_t t = 0; t < gluings.tetrahedron_count(); ++t)
    for (int edge = 0; edge < 6; ++edge) {
      const auto [a, b] = kEdgeEnds[std::size_t(edge)];
      if (before.vertex_class(t, a) == before.vertex_class(t, b)) continue;
      ++joined;
      const EdgePlace place[] = {{t, edge}};
      const Triangulation after(simplify(drilled(gluings, place)).gluings);
      ASSERT_EQ(after.vertex_count(), 1u);
      EXPECT_EQ(after.link(0).genus(), 2);
      EXPECT_EQ(to_string(first_homology(after)), "2 Z");
    }
  EXPECT_GT(joined, 0u);
}

TEST(Drill, RefusesWhatIsNoEdgeOrComesTwice) {
  const Gluings gluings = decode_isosig("cPcbbbiht");
  const Triangulation triangulation(gluings);
  const auto refused = [&](std::vector<EdgePlace> places, const char* what) {
    EXPECT_THAT([&] { drilled(gluings, places); }, ThrowsMessage<InvalidInput>(HasSubstr(what)));
  };
  refused({{2, 0}}, "there is no edge 0 of tetrahedron 2");
  refused({{0, 6}}, "there is no edge 6");
  for (int edge = 1; edge < 6; ++edge)
    if (triangulation.edge_class(0, edge) == triangulation.edge_class(0, 0))
      refused({{0, 0}, {0, edge}}, "is to be drilled twice");
  EXPECT_EQ(drilled(gluings, {}), gluings);
}

}  // namespace
}  // namespace tripus::topology
