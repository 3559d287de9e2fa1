// Planar diagrams: reading, checking, the octahedral triangulation, the Wirtinger presentation.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "topology/covers/covers.hpp"
#include "topology/diagrams/exterior.hpp"
#include "topology/diagrams/read_diagram.hpp"
#include "topology/diagrams/small_exterior.hpp"
#include "topology/diagrams/tables.hpp"
#include "topology/diagrams/wirtinger.hpp"
#include "topology/formats/foreign_names.hpp"
#include "topology/formats/signature.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"
#include "topology/orientation.hpp"

namespace tripus::topology {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Property;
using ::testing::ThrowsMessage;

constexpr const char* kFigureEight = "PD: X[4,2,5,1] X[8,6,1,5] X[6,3,7,4] X[2,7,3,8]";

std::string signature(const std::string& text) {
  return full_isosig(small_exterior(read_diagram(text)).gluings).oriented();
}

auto refused(const char* what) { return ThrowsMessage<InvalidInput>(HasSubstr(what)); }

TEST(Diagrams, TheFigureEightKnotIsReadInAllItsForms) {
  for (const char* text :
       {kFigureEight, "X[4,2,5,1],X[8,6,1,5],X[6,3,7,4],X[2,7,3,8]",
        "PD[X[4,2,5,1], X[8,6,1,5], X[6,3,7,4], X[2,7,3,8]]",
        "X_{4,2,5,1} X_{8,6,1,5} X_{6,3,7,4} X_{2,7,3,8}",
        "[[4,2,5,1],[8,6,1,5],[6,3,7,4],[2,7,3,8]]",
        "PD: [(4,2,5,1),(8,6,1,5),(6,3,7,4),(2,7,3,8)]",
        "((3,1,4,0), (7,5,0,4), (5,2,6,3), (1,6,2,7))",
        "PD: [3 1 4 0] [7 5 0 4] [5 2 6 3] [1 6 2 7]",
        "# a comment\nPD:\n X[4,2,5,1]\n X[8,6,1,5] # another\n X[6,3,7,4]\n X[2,7,3,8]\n",
        "X[40,-2,51,17] X[88,66,17,51] X[66,33,77,40] X[-2,77,33,88]",
        R"({"diagram": [["X",[4,2,5,1]], ["X",[8,6,1,5]], [6,3,7,4], [2,7,3,8]]})", "DT: 4 6 8 2",
        "DT:[(4,6,8,2)]", "DT[dadbcda]", "Braid: 1 -2 1 -2", "BR[1,-2,1,-2]"}) {
    SCOPED_TRACE(text);
    EXPECT_TRUE(looks_like_diagram(text));
    EXPECT_EQ(isosig(small_exterior(read_diagram(text)).gluings), "cPcbbbiht");
  }
}

TEST(Diagrams, SignaturesAndTriangulationsAreNoDiagrams) {
  for (const char* text : {"cPcbbbihq", "8_19", "", "{\"gluings\": [[[1,\"1230\"]]]}",
                           "% Triangulation", "[1, 2]", "PDaXX", "DTa", "Braids"})
    EXPECT_FALSE(looks_like_diagram(text)) << text;
}

TEST(Diagrams, KnotPysNotationIsRead) {
  const auto read = read_diagram("a=V(b0 c0 d3) b=V(a0 d2 c1) c=X(a1 b2 d1 d0) d=X(c3 c2 b1 a2)");
  EXPECT_EQ(read.diagram.crossing_count(), 2u);
  EXPECT_EQ(to_text(read.diagram), "V[1,2,3] V[1,4,5] X[2,5,6,7] X[7,6,4,3]");
  EXPECT_THAT([] { read_diagram("a=V(b0 b1) b=X(a0 a1 b3 b0)"); },
              refused("not met from the other side"));
  EXPECT_THAT([] { read_diagram("a=V(b0) b=Y(a0)"); }, refused("no kind of node"));
}

TEST(Diagrams, AppcontoursEmbeddingIsRead) {
  // hk5_3 and the diagram that the table has for it.
  const Diagram read =
      read_diagram(
          "embedding:4 { 0: (4, 5, 6), 1: (3, 6, 5), 2: (3, 4, 6, 6), 3: (1, 5, 4, 2), "
          "4: (0, 2, 3, 5), 5: (0, 4, 3, 1), 6: (0, 1, 2, 2) }")
          .diagram;
  EXPECT_EQ(
      full_isosig(small_exterior({.name = {}, .diagram = read}).gluings).oriented(),
      full_isosig(small_exterior({.name = {}, .diagram = find_diagram("hk5_3")->diagram}).gluings)
          .oriented());
}

TEST(Diagrams, ClockwiseOrdersGiveTheMirrorImage) {
  const std::string trefoil = "X[1,5,2,4] X[3,1,4,6] X[5,3,6,2]";
  EXPECT_NE(signature("PD: " + trefoil), signature("PD clockwise: " + trefoil));
  EXPECT_EQ(signature("PD clockwise: " + trefoil), signature("PD(clockwise): " + trefoil));
  const Diagram plain = read_diagram("PD: " + trefoil).diagram;
  EXPECT_EQ(plain.mirror_image(), read_diagram("PD clockwise: " + trefoil).diagram);
  EXPECT_EQ(plain.mirror_image().mirror_image(), plain);
}

/// Of the octahedral triangulation itself: two diagrams have it in common if and only if they are
/// the same up to numbering, on the sphere and with the same orientation.
std::string octahedra(const std::string& text) {
  return full_isosig(exterior(read_diagram(text).diagram).gluings).oriented();
}

// The PD codes that Spherogram 2.4.1 makes of these braids.
TEST(Diagrams, BraidsAreThoseOfSnapPy) {
  EXPECT_EQ(octahedra("Braid: 1 1 1"), octahedra("[(1,5,2,4),(5,3,0,2),(3,1,4,0)]"));
  EXPECT_NE(octahedra("Braid: -1 -1 -1"), octahedra("[(1,5,2,4),(5,3,0,2),(3,1,4,0)]"));
  EXPECT_EQ(octahedra("Braid: 1 1 1 2 -1 2"),
            octahedra("[(8,2,9,1),(2,10,3,9),(10,4,11,3),(11,7,0,6),(7,4,8,5),(5,1,6,0)]"));
}

TEST(Diagrams, WhatIsWrongIsSaidWithPlaceAndRemedy) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"PD: V[1,6,11]",
       "arc 1 is named once, in V[1,6,11] (line 1, column 5); every arc has two ends"},
      {"PD: X[1,1,2,2] V[1,3,3]", "arc 1 is named 3 times"},
      {"PD: X[4,2,5]", "has 3 arcs; a crossing X has four, a vertex is written V"},
      {"PD: X[1,2,1,2]", "cannot be drawn in the plane"},
      {"PD: X[4,2,5,1] X[8,6,1,5] X[6,3,7,4] X[2,3,7,8]",
       "has genus 1, not 0. Look along the region"},
      {"PD: X[4,2,5,1", "the bracket [ is not closed; add ] (line 1, column 5)"},
      {"PD[X[4,2,5,1]", "the bracket [ is not closed; add ]"},
      {"PD: X[4,2,5,1]]", "closes nothing that is open"},
      {"PD: X[4,2,5,1)", "the bracket [ is not closed"},
      {"PD: X[4,2,5,1] Y[1]", "is no kind of node"},
      {"PD: X[4,two,5,1]", "expected a whole number"},
      {"PD: X[4,2,5,99999999999999999999]", "is too large"},
      {"PD: V[]", "has no arcs"},
      {"PD:", "has no nodes"},
      {"PD: X[1,2,3,4] and more", "expected a node such as"},
      {"PD: X[2,1,1,2] PD: X[2,1,1,2]", "second diagram"},
      {"PD: V[1,1] Cone[2,3]", "there is no arc 2 in the diagram"},
      {"PD: V[1,1] Cone[1,-3]", "Cone of arc 1"},
      {"DT: 4 6 8", "entry 8 of the DT code: expected the even numbers from 2 to 6"},
      {"DT: 4 6 4", "comes twice"},
      {"DT: 4 3 2", "expected the even numbers"},
      {"DT[abc]", "are no DT code"},
      {"DT: [(4,6,2)", "is not closed"},
      {"DT: 4 6 8 10 2", "no diagram in the plane has this DT code"},
      {"Braid: 1 0 1", "is no generator"},
      {"Braid:", "has no letters"},
      {"embedding:0 {0: (1,1,1), 1: (0,0)}", "names node 1 3 times, and that one names it 2 times"},
      {"embedding:0 {1: (0)}", "expected node 0"},
      {R"({"diagram": 3})", "no list of nodes"},
      {R"({"diagram": [["Y",[1,2]]]})", "no kind of node"},
      {R"({"diagram": [["X",[1,"a"]]]})", "node 0"},
      {R"({"diagram": [["X",[1,)", "JSON"},
  };
  for (const auto& [text, message] : cases) {
    SCOPED_TRACE(text);
    EXPECT_THAT([text = text] { small_exterior(read_diagram(text)); }, refused(message));
  }
}

TEST(Diagrams, WhatHasNoCrossingsIsReadAllTheSame) {
  for (const auto& [text, homology] : std::vector<std::pair<const char*, const char*>>{
           {"Loop[1]", "Z"},
           {"V[1,1]", "Z"},
           {"V[1] V[1]", "0"},
           {"V[1,2,3] V[1,3,2]", "2 Z"},
           {"V[1,1,2] V[2,3,3]", "2 Z"},
           {"(1,4,2,1) (2,4,3,3)", "Z"},
           {"X[1,1,2,2]", "Z"},
           {"X[2,1,1,2]", "Z"},
           {"V[1,1] V[2,2] V[3,3]", "3 Z"},
           {"V[1,2,3,4] V[4,3,2,1]", "3 Z"},
           {"V[1] V[1,2] V[2]", "0"},
           {"X[4,2,5,1] X[8,6,1,5] X[6,3,7,4] X[2,7,3,8] V[21,22] V[22,21]", "2 Z"}}) {
    SCOPED_TRACE(text);
    EXPECT_EQ(to_string(first_homology(Triangulation(small_exterior(read_diagram(text)).gluings))),
              homology);
  }
}

TEST(Diagrams, APieceThatTouchesNothingIsTold) {
  const auto loaded =
      small_exterior(read_diagram(std::string(kFigureEight) + " V[21,22] V[21,22]"));
  ASSERT_EQ(loaded.notes.size(), 1u);
  EXPECT_THAT(loaded.notes[0], HasSubstr("arcs 21 and 22 form a piece of their own"));
}

TEST(Diagrams, TheTextOfADiagramIsReadBack) {
  for (const DiagramTable table : kDiagramTables)
    for (const TabledDiagram& entry : table_of(table))
      EXPECT_EQ(read_diagram(to_text(entry.diagram)).diagram, entry.diagram) << entry.name;
}

TEST(DiagramTables, HoldWhatTheirSourcesHave) {
  EXPECT_EQ(table_of(DiagramTable::kKnots).size(), 85u);
  EXPECT_EQ(table_of(DiagramTable::kLinks).size(), 130u);
  EXPECT_EQ(table_of(DiagramTable::kThetaCurves).size(), 39u);
  EXPECT_EQ(table_of(DiagramTable::kHandlebodyKnots).size(), 90u);
}

TEST(DiagramTables, NamesAreFoundHoweverTheyAreWritten) {
  EXPECT_EQ(find_diagram("5_1 theta")->name, "5_1 theta");
  for (const char* name : {"T5_1", "t5_1", "5_1theta", "5_1 Theta-curve", "theta 5_1", "5_1_theta"})
    if (const auto* found = find_diagram(name))
      EXPECT_EQ(found->name, "5_1 theta") << name;
    else
      EXPECT_STREQ(name, "theta 5_1");
  EXPECT_EQ(find_diagram("H2_1")->name, "2_1 handcuff");
  EXPECT_EQ(find_diagram("HK5_3")->name, "hk5_3");
  EXPECT_EQ(find_diagram("l5a1")->name, "L5a1");
  EXPECT_EQ(find_diagram("hk9_9"), nullptr);
  EXPECT_TRUE(is_diagram_name("hk9_9"));
  EXPECT_TRUE(is_diagram_name("10_165"));
  EXPECT_FALSE(is_diagram_name("cPcbbbihq"));
  EXPECT_FALSE(is_diagram_name("m004"));
  EXPECT_THAT(nearest_diagram_names("hk5_9"), HasSubstr("hk5_"));
}

// A name that were a signature could not be told from it.
TEST(DiagramTables, NoNameIsASignature) {
  for (const DiagramTable table : kDiagramTables)
    for (const TabledDiagram& entry : table_of(table))
      EXPECT_THROW(decode_isosig(entry.name), InvalidInput) << entry.name;
}

TEST(Exterior, HasFourTetrahedraACrossingAndIsOriented) {
  for (const DiagramTable table : kDiagramTables)
    for (const TabledDiagram& entry : table_of(table)) {
      const DiagramExterior made = exterior(entry.diagram);
      EXPECT_EQ(made.gluings.tetrahedron_count(), 4 * (entry.crossings + made.kinks)) << entry.name;
      EXPECT_EQ(oriented(made.gluings), made.gluings) << entry.name;
      EXPECT_TRUE(Triangulation(made.gluings).is_connected()) << entry.name;
    }
}

TEST(Exterior, KeptStrandsAreEdgesWithTheLinksOfTheRest) {
  const Diagram theta = find_diagram("5_1 theta")->diagram;
  const std::int64_t all[] = {1, 6, 11};
  const DiagramExterior made = exterior(theta, all);
  const Triangulation triangulation(made.gluings);
  ASSERT_EQ(made.kept.size(), 3u);
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    EXPECT_EQ(triangulation.link(v).euler_characteristic, 2);  // space itself
  EXPECT_EQ(to_string(first_homology(triangulation)), "0");
  for (const KeptStrand& strand : made.kept)
    EXPECT_EQ(triangulation.valence(triangulation.edge_class(strand.tetrahedron, strand.edge)), 2u);
  const std::int64_t one[] = {1};
  const Triangulation rest(exterior(theta, one).gluings);
  EXPECT_EQ(to_string(first_homology(rest)), "Z");
  const std::int64_t twice[] = {1, 1};
  EXPECT_THAT([&] { exterior(theta, twice); }, refused("has a label already"));
}

}  // namespace
}  // namespace tripus::topology
