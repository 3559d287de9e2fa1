// Cone angles on strands of diagrams: orbifolds with known volumes, and strands filled in again.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "structure/solve.hpp"
#include "topology/covers/cover_homology.hpp"
#include "topology/diagrams/exterior.hpp"
#include "topology/diagrams/small_exterior.hpp"
#include "topology/diagrams/tables.hpp"
#include "topology/simplify/simplify_keeping.hpp"

namespace tripus {
namespace {

using topology::Triangulation;

double volume(const std::string& text) {
  const auto loaded = topology::small_exterior(topology::read_diagram(text));
  structure::SolveOptions options;
  options.evidence = false;
  options.cone_angles = loaded.cone_angles;
  const structure::Report report = structure::solve(Triangulation(loaded.gluings), options);
  EXPECT_EQ(report.outcome, structure::Outcome::kGeometric) << text << ": " << report.message;
  return report.volume;
}

std::string text_of(const char* name) {
  return "PD: " + to_text(topology::find_diagram(name)->diagram);
}

// SnapPy 3.3.2: Manifold('4_1').dehn_fill((n, 0)), high_precision().volume().
TEST(DiagramOrbifolds, TheFigureEightKnotAsSingularSet) {
  for (const auto& [order, expected] :
       std::vector<std::pair<int, double>>{{4, 0.507470803204826812510601277137260143},
                                           {5, 0.937206854760522506142498129925463954},
                                           {6, 1.221287458902958686739471353243178814},
                                           {8, 1.543863276144775021842038054803269002},
                                           {20, 1.945782050907782351751533061465874754}})
    EXPECT_NEAR(volume(text_of("4_1") + " Cone[1," + std::to_string(order) + "]"), expected, 1e-9);
}

// The same with one component of the Whitehead link left as a cusp: dehn_fill([(0,0), (n,0)]).
TEST(DiagramOrbifolds, TheWhiteheadLinkWithACusp) {
  for (const auto& [order, expected] :
       std::vector<std::pair<int, double>>{{3, 1.7778298556}, {4, 2.5373540160}, {5, 2.9206121507}})
    for (const char* arc : {"1", "5"})
      EXPECT_NEAR(volume(text_of("L5a1") + " Cone[" + arc + "," + std::to_string(order) + "]"),
                  expected, 1e-9);
}

// Kinoshita's theta curve has a symmetry that permutes its strands.
TEST(DiagramOrbifolds, LabelsStayOnTheirStrands) {
  const std::string theta = text_of("5_1 theta");
  const auto labelled = [&](int a, int b, int c) {
    return volume(theta + " Cone[1," + std::to_string(a) + "] Cone[6," + std::to_string(b) +
                  "] Cone[11," + std::to_string(c) + "]");
  };
  EXPECT_NEAR(labelled(3, 4, 5), labelled(4, 5, 3), 1e-9);
  EXPECT_NEAR(labelled(3, 4, 5), labelled(5, 3, 4), 1e-9);
  EXPECT_GT(labelled(4, 4, 5), labelled(3, 4, 5) + 0.1);
  EXPECT_GT(labelled(0, 0, 0), labelled(9, 9, 9) + 0.1);
}

// The strand of a theta curve filled in: what is left is the exterior of a knot. Three of the
// curve's constituents; for 3_1 the trefoil is one.
TEST(DiagramOrbifolds, AFilledStrandLeavesTheKnotOfTheOthers) {
  const auto covers = [](const topology::Gluings& gluings) {
    std::vector<topology::CoverHomology> all;
    for (const std::size_t degree : {1u, 2u, 3u, 4u})
      all.push_back(topology::cover_homology(Triangulation(gluings), degree));
    return all;
  };
  const auto exterior_of = [](const std::string& text) {
    return topology::small_exterior(topology::read_diagram(text)).gluings;
  };
  const topology::Diagram theta = topology::find_diagram("3_1 theta")->diagram;
  const auto trefoil = covers(exterior_of(text_of("3_1"))), circle = covers(exterior_of("Loop[1]"));
  std::size_t trefoils = 0;
  for (const topology::Strand& strand : topology::strands(theta).all) {
    const auto rest = covers(exterior_of("PD: " + to_text(theta) + " Cone[" +
                                         std::to_string(theta.arc(strand.darts[0])) + ",1]"));
    EXPECT_TRUE(rest == trefoil || rest == circle);
    trefoils += rest == trefoil;
  }
  EXPECT_EQ(trefoils, 1u);
}

TEST(SimplifyKeeping, KeepsTheEdgesAndWhatIsAroundThem) {
  for (const topology::TabledDiagram& entry :
       topology::table_of(topology::DiagramTable::kThetaCurves)) {
    SCOPED_TRACE(entry.name);
    const auto all = topology::strands(entry.diagram).all;
    std::vector<std::int64_t> arcs;
    for (const topology::Strand& strand : all) arcs.push_back(entry.diagram.arc(strand.darts[0]));
    const auto made = topology::exterior(entry.diagram, arcs);
    std::vector<topology::EdgePlace> places;
    for (const auto& strand : made.kept) places.push_back({strand.tetrahedron, strand.edge});
    const auto small = topology::simplify_keeping(made.gluings, places, {.effort = 0.1});
    const Triangulation triangulation(small.result.gluings);
    ASSERT_EQ(small.kept.size(), 3u);
    EXPECT_EQ(triangulation.vertex_count(), 2u);  // those of the graph
    EXPECT_EQ(small.result.finite_vertices_left, 0u);
    std::vector<std::uint32_t> classes;
    for (const auto& [t, e] : small.kept) classes.push_back(triangulation.edge_class(t, e));
    std::ranges::sort(classes);
    EXPECT_EQ(std::ranges::adjacent_find(classes), classes.end());
  }
}

}  // namespace
}  // namespace tripus
