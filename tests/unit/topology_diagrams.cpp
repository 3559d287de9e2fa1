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
#include "topology/formats/formats.hpp"
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
       {kFigureEight,
        "X[4,2,5,1],X[8,6,1,5],X[6,3,7,4],X[2,7,3,8]",
        "PD[X[4,2,5,1], X[8,6,1,5], X[6,3,7,4], X[2,7,3,8]]",
        "PD: PD[X[4,2,5,1], X[8,6,1,5], X[6,3,7,4], X[2,7,3,8]]",
        "PD = PD[X[4,2,5,1], X[8,6,1,5], X[6,3,7,4], X[2,7,3,8]]",
        "pd = [(4,2,5,1),(8,6,1,5),(6,3,7,4),(2,7,3,8)]",
        "PD([[4,2,5,1],[8,6,1,5],[6,3,7,4],[2,7,3,8]])",
        "pd: x[4,2,5,1] Xp[8,6,1,5] xm[6,3,7,4] x[2,7,3,8]",
        "{{4,2,5,1},{8,6,1,5},{6,3,7,4},{2,7,3,8}}",
        "{(4,2,5,1),(8,6,1,5),(6,3,7,4),(2,7,3,8)}",
        "X_{4251} X_{8615} X_{6374} X_{2738}",
        "X4251 X8615 X6374 X2738",
        "X_{4,2,5,1} X_{8,6,1,5} X_{6,3,7,4} X_{2,7,3,8}",
        "X4,2,5,1, X8,6,1,5, X6,3,7,4, X2738",
        "X_{4,2,5,1} X_{8,6,1,5} X_{6,3,7,4} X_{2,7,3,8}",
        "[[4,2,5,1],[8,6,1,5],[6,3,7,4],[2,7,3,8]]",
        "PD: [(4,2,5,1),(8,6,1,5),(6,3,7,4),(2,7,3,8)]",
        "((3,1,4,0), (7,5,0,4), (5,2,6,3), (1,6,2,7))",
        "PD: [3 1 4 0] [7 5 0 4] [5 2 6 3] [1 6 2 7]",
        "# a comment\nPD:\n X[4,2,5,1]\n X[8,6,1,5] # another\n X[6,3,7,4]\n X[2,7,3,8]\n",
        "X[40,-2,51,17] X[88,66,17,51] X[66,33,77,40] X[-2,77,33,88]",
        R"({"diagram": [["X",[4,2,5,1]], ["X",[8,6,1,5]], [6,3,7,4], [2,7,3,8]]})",
        "DT: 4 6 8 2",
        "DT:[(4,6,8,2)]",
        "DT[dadbcda]",
        "DTCode[4, 6, 8, 2]",
        "dtcode {[4 6 8 2]}",
        "[4, 6, 8, 2]",
        "Braid: 1 -2 1 -2",
        "BR[1,-2,1,-2]",
        "BR[3, {1,-2,1,-2}]",
        "braid = {1,-2,1,-2}",
        "Braid: aBaB",
        "Gauss: 1 -2 3 -1 4 -3 2 -4",
        "GaussCode[-1, 2, -3, 1, -4, 3, -2, 4]",
        "[[-1, 2, -3, 1, -4, 3, -2, 4]]",
        "gausscode {{1 -2 3 -1 4 -3 2 -4}}",
        "knot {\n ^ ^ ;\n( x );\n X ||;\n| x |;\n( x );\n U U ;\n}\n"}) {
    SCOPED_TRACE(text);
    EXPECT_TRUE(looks_like_diagram(text));
    EXPECT_EQ(isosig(small_exterior(read_diagram(text)).gluings), "cPcbbbiht");
  }
}

TEST(Diagrams, SignaturesAndTriangulationsAreNoDiagrams) {
  for (const char* text : {"cPcbbbihq", "8_19", "", "{\"gluings\": [[[1,\"1230\"]]]}",
                           "% Triangulation", "[1]", "PDaXX", "DTa", "Braids"})
    EXPECT_FALSE(looks_like_diagram(text)) << text;
}

TEST(Diagrams, OneStrandMayHaveItsLabelTwice) {
  const std::string eight = std::string(kFigureEight) + " Cone[1,3]";
  EXPECT_EQ(signature(eight + " Cone[1,3] Cone[5,3]"), signature(eight));
  EXPECT_THAT([&] { signature(eight + " Cone[2,4]"); },
              refused("arc 1 has the cone order 3 and arc 2 has the cone order 4"));
}

TEST(Diagrams, ClockwiseOrdersGiveTheMirrorImage) {
  const std::string trefoil = "X[1,5,2,4] X[3,1,4,6] X[5,3,6,2]";
  EXPECT_NE(signature("PD: " + trefoil), signature("PD clockwise: " + trefoil));
  for (const char* heading : {"PD(clockwise): ", "pd Clockwise = ", "PD clockwise: PD = "})
    EXPECT_EQ(signature("PD clockwise: " + trefoil), signature(heading + trefoil)) << heading;
  const Diagram plain = read_diagram("PD: " + trefoil).diagram;
  EXPECT_EQ(plain.mirror_image(), read_diagram("PD clockwise: " + trefoil).diagram);
  EXPECT_EQ(plain.mirror_image().mirror_image(), plain);
  for (const char* heading :
       {"PD counterclockwise: ", "PD counter-clockwise: ", "PD Anticlockwise "})
    EXPECT_EQ(read_diagram(heading + trefoil).diagram, plain) << heading;
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
      {"PD: X[4,2,5,1", "the bracket [ of line 1, column 6 is not closed; add ] at the end"},
      {"PD: X[4,2,5,1 X[8,6,1,5]", "add ] before \"X[8,6,1,5]\" (line 1, column 15)"},
      {"PD[X[4,2,5,1]", "the bracket [ of line 1, column 3 is not closed; add ]"},
      {"PD: X[4,2,5,1]]", "closes nothing that is open"},
      {"PD: X[4,2,5,1)", "the bracket [ of line 1, column 6 is closed by ); write ]"},
      {"PD: X[4,2,5,1] Cone[1,3", "the bracket [ of line 1, column 20 is not closed; add ]"},
      {"PD: Loop[1] Loop[1]", "the last time in Loop[1] (line 1, column 13)"},
      {"PD: Loop[1,2]", "a circle is Loop[1]"},
      {"PD: X[4,2,5,1] Y[1]", "is no kind of node"},
      {"PD: X[4,two,5,1]", "expected a whole number, found \"two,5,1]\""},
      {"PD: X[a,b,c,d]", "expected a whole number, found \"a,b,c,d]\" (line 1, column 7)"},
      {"PD: X[4,2,5,1] Cone[1]", "a comma and a cone order, as in Cone[1,3]"},
      {"[1,-2,1,-2]", "numbers alone do not say what they are; write Braid: [1,-2,1,-2]"},
      {"{'diagram': [[4,2,5,1]]}", "keys stand in double quotes"},
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
      {"DT: 4 6 8 10 2", "no diagram in the plane has this code"},
      {"Braid: 1 0 1", "is no generator"},
      {"Braid:", "has no letters"},
      {"Braid: 1 1 1]", "closes nothing that is open; take it away (line 1, column 13)"},
      {"Braid: (1 1 1", "the bracket ( of line 1, column 8 is not closed; add ) at the end"},
      {"BR[2, {1,2,1}]", "the letter 2 needs more strands than the 2 that are announced"},
      {"BR[1,2,{1}]", "a bracket among the letters"},
      {"Gauss:", "the Gauss code is empty; write Gauss: 1 -2 3 -1 2 -3"},
      {"Gauss: 1 -2 3 -1 2", "crossing 3 of the Gauss code is named once"},
      {"Gauss: 1 -1 1 -1", "crossing 1 of the Gauss code is named 4 times"},
      {"Gauss: 1 -2 -3 -1 2 -3", "crossing 3 of the Gauss code is passed twice below"},
      {"Gauss: 1 0 -1", "number them from 1 on (line 1, column 10)"},
      {"Gauss: 1 2 -1 -2", "no diagram in the plane has this code"},
      {"O1-U2-O3-U1-O4-U3-O2-U4-", "cannot be drawn in the plane"},
      {"O1-U2-U1+O2-", "crossing 1 has both signs"},
      {"O1-U2U1-O2-", "expected the sign of the crossing"},
      {"Gauss: [[[1,-2,3,-1,2,-3]],[1,1]]", "3 crossings and 2 signs"},
      {"Gauss: [[[1,-1]],[3]]", "the sign 3 of crossing 1 is neither 1 nor -1"},
      {"knot { ^ ; ", "a row is not finished"},
      {"knot { ^ ; | ; U ; }", "this row takes up 1 strands, but the one above hands down 2"},
      {"knot { ^ ; X X ; UU ; }", "X takes up a strand that the row above does not have"},
      {"knot { ^ ; | | ; }", "the picture ends with 2 open strands; close them by U"},
      {"knot { ^ ; Z ; }", "\"Z\" is no letter of a knot picture"},
      {"knot { }", "has no nodes"},
      {"morse { ^ ; U ; }", "it is the contour of a surface (appcontour's \"morse\")"},
      {"embedding:16 {0: (1,1,1,1), 1: (0,0,0,0)}", "has no 2 bits"},
      {"embedding:1 {0: odd(1,1,1,1), 1: (0,0,0,0)}", "by the number behind"},
      {"embedding {0: odd(1,1,1), 1: (0,0,0)}", "is for crossings"},
      {"embedding {0: (1,1,1), 1: (0,0,0)", "is not closed; add }"},
      {"embedding:0 {0: (1,1,1), 1: (0,0)}", "names node 1 3 times, and that one names it 2 times"},
      {"embedding:0 {1: (0)}", "expected node 0"},
      {"a=V(b0) b=V(a0 a1)", "node a has no arc end 1: its 1 are counted from 0"},
      {"a=V(b0) b=V(a1)", "node a names b0, which is not met from the other side"},
      {"a=X(b0) b=V(a0)", "a=X(b0) (line 1, column 1) has 1 arcs; a crossing X has four"},
      {R"({"diagram": 3})", "no list of nodes"},
      {R"({"diagram": [["Loop",[1,2]]]})", "Loop (with one arc) a circle"},
      {R"({"diagram": [["Y",[1,2]]]})", "no kind of node"},
      {R"({"diagram": [["X",[1,"a"]]]})", "node 0"},
      {R"({"diagram": [["X",[1,)", "JSON"},
      {R"({"diagram": [["V",[1,1]]], "cone_order": {"1": 3}})", "is no key of a diagram"},
      {R"({"diagram": [["V",[1,1]]], "clockwise": "yes"})", "is \"yes\"; write true or false"},
      {R"({"diagram": [["V",[1,18446744073709551615]]]})", "node 0"},
      {R"({"diagram": [["V",[1,1]]], "name": 3})", "\"name\" is no text"},
  };
  for (const auto& [text, message] : cases) {
    SCOPED_TRACE(text);
    EXPECT_THAT([text = text] { small_exterior(read_diagram(text)); }, refused(message));
  }
}

TEST(Diagrams, WhatHasNoCrossingsIsReadAllTheSame) {
  for (const auto& [text, homology] : std::vector<std::pair<const char*, const char*>>{
           {"Loop[1]", "Z"},
           {R"({"diagram": [["Loop",[1]], ["Loop",[2]]]})", "2 Z"},
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
  for (const char* name : {"T5_1", "t5_1", "5_1theta", "5_1 Theta-curve", "theta 5_1", "5_1_theta",
                           "theta_5_1", "Theta-curve 5_1", "Kinoshita theta"}) {
    ASSERT_NE(find_diagram(name), nullptr) << name;
    EXPECT_EQ(find_diagram(name)->name, "5_1 theta") << name;
  }
  for (const auto& [name, known] :
       std::vector<std::pair<const char*, const char*>>{{"unknot", "0_1"},
                                                        {"Trefoil", "3_1"},
                                                        {"figure-eight knot", "4_1"},
                                                        {"Borromean rings", "L6a4"},
                                                        {"L5a1{0}", "L5a1"},
                                                        {"L6a4{0,1}", "L6a4"},
                                                        {"handcuff 2_1", "2_1 handcuff"}}) {
    ASSERT_NE(find_diagram(name), nullptr) << name;
    EXPECT_EQ(find_diagram(name)->name, known) << name;
    EXPECT_THROW(decode_isosig(name), InvalidInput) << name;
  }
  EXPECT_EQ(find_diagram("H2_1")->name, "2_1 handcuff");
  EXPECT_EQ(find_diagram("HK5_3")->name, "hk5_3");
  EXPECT_EQ(find_diagram("l5a1")->name, "L5a1");
  EXPECT_EQ(find_diagram("hk9_9"), nullptr);
  EXPECT_TRUE(is_diagram_name("hk9_9"));
  EXPECT_TRUE(is_diagram_name("10_165"));
  EXPECT_FALSE(is_diagram_name("cPcbbbihq"));
  EXPECT_FALSE(is_diagram_name("m004"));
  for (const auto& [name, nearest] :
       std::vector<std::pair<const char*, const char*>>{{"hk5_9", "hk5_"},
                                                        {"hk5_3m", "hk5_3, "},
                                                        {"m(3_1)", "3_1, "},
                                                        {"K4a1", "4_1, "},
                                                        {"9n6", "9_"},
                                                        {"4^2_1", "L4a1, "},
                                                        {"L5a7", "L5a1, "},
                                                        {"theta 5_9", "5_1 theta"}}) {
    EXPECT_TRUE(is_diagram_name(name)) << name;
    EXPECT_THAT(nearest_diagram_names(name), ::testing::StartsWith(nearest)) << name;
  }
}

TEST(DiagramTables, NamesOfMirrorImagesAreFoundInAllTables) {
  for (const DiagramTable table : kDiagramTables)
    for (const TabledDiagram& entry : table_of(table)) {
      const Diagram mirrored = entry.diagram.mirror_image();
      for (const std::string& name :
           {"m(" + entry.name + ")", entry.name + "m", entry.name + "*", entry.name + " mirror",
            "mirror " + entry.name, "Mirror(" + entry.name + ")", "mirror image of " + entry.name,
            entry.name + "(m)", entry.name + "_m", "m(m(" + entry.name + "m))"}) {
        const auto found = find_diagram_or_mirror(name);
        ASSERT_TRUE(found) << name;
        EXPECT_EQ(found->name, "m(" + entry.name + ")") << name;
        EXPECT_EQ(found->diagram, mirrored) << name;
        EXPECT_EQ(find_diagram(name), nullptr) << name;
        EXPECT_THROW(decode_isosig(name), InvalidInput) << name;
      }
      for (const std::string& name : {entry.name, "m(" + entry.name + "*)"}) {
        ASSERT_TRUE(find_diagram_or_mirror(name)) << name;
        EXPECT_EQ(find_diagram_or_mirror(name)->diagram, entry.diagram) << name;
        EXPECT_EQ(find_diagram_or_mirror(name)->name, entry.name) << name;
      }
    }
  for (const auto& [name, known] :
       std::vector<std::pair<const char*, const char*>>{{"T5_1m", "m(5_1 theta)"},
                                                        {"5_1m theta", "m(5_1 theta)"},
                                                        {"m(T5_1)", "m(5_1 theta)"},
                                                        {"trefoil*", "m(3_1)"},
                                                        {"m(L5a1{0})", "m(L5a1)"},
                                                        {"L5a1{0}m", "m(L5a1)"}}) {
    ASSERT_TRUE(find_diagram_or_mirror(name)) << name;
    EXPECT_EQ(find_diagram_or_mirror(name)->name, known) << name;
  }
  for (const char* name : {"hk9_9m", "m", "m()", "mirror", "m004", "*", "hk5_3 {", "mm", "()m"})
    EXPECT_FALSE(find_diagram_or_mirror(name)) << name;
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
