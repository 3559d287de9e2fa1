// Diagrams in the notations of other programs.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "topology/diagrams/exterior.hpp"
#include "topology/diagrams/read_diagram.hpp"
#include "topology/diagrams/small_exterior.hpp"
#include "topology/diagrams/tables.hpp"
#include "topology/isosig.hpp"

namespace tripus::topology {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

auto refused_form(const char* what) { return ThrowsMessage<InvalidInput>(HasSubstr(what)); }

/// Of the octahedral triangulation itself: two diagrams have it in common if and only if they are
/// the same up to numbering, on the sphere and with the same orientation.
std::string octahedra(const std::string& text) {
  return full_isosig(exterior(read_diagram(text).diagram).gluings).oriented();
}

TEST(Diagrams, KnotPysNotationIsRead) {
  const auto read = read_diagram("a=V(b0 c0 d3) b=V(a0 d2 c1) c=X(a1 b2 d1 d0) d=X(c3 c2 b1 a2)");
  EXPECT_EQ(read.diagram.crossing_count(), 2u);
  EXPECT_EQ(to_text(read.diagram), "V[1,2,3] V[1,4,5] X[2,5,6,7] X[7,6,4,3]");
  EXPECT_THAT([] { read_diagram("a=V(b0 b1) b=X(a0 a1 b3 b0)"); },
              refused_form("not met from the other side"));
  EXPECT_THAT([] { read_diagram("a=V(b0) b=Y(a0)"); }, refused_form("no kind of node"));
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

TEST(Diagrams, AppcontoursEmbeddingSaysInWordsToo) {
  const char* const tail = "1: (3, 6, 5), 2: (3, 4, 6, 6), 3: %(1, 5, 4, 2), ";
  const auto embedding = [&](const std::string& head, const std::string& word) {
    std::string text =
        head + " 0: (4, 5, 6), " + tail + "4: (0 2 3 5), 5: (0, 4, 3, 1), 6: even(0, 1, 2, 2) }";
    text.replace(text.find('%'), 1, word);
    return text;
  };
  const Diagram odd = read_diagram(embedding("embedding {", "odd")).diagram;
  std::string number = embedding("embedding:2 {", "");
  number.replace(number.find("even"), 4, "");
  EXPECT_EQ(odd, read_diagram(number).diagram);
  EXPECT_EQ(odd, read_diagram(embedding("embedding {", "o")).diagram);
  EXPECT_NE(odd, read_diagram(embedding("embedding {", "e")).diagram);
  EXPECT_EQ(odd.mirror_image(), read_diagram(embedding("embedding -{", "odd")).diagram);
  EXPECT_EQ(to_text(read_diagram("embedding {0: (1,1,1), 1: (0,0,0) +1}").diagram),
            "V[1,2,3] V[3,2,1] V[9,9]");
}

TEST(Diagrams, AppcontoursPicturesAreRead) {
  // The strand from upper left to lower right is above in x: this is the trefoil turned right.
  EXPECT_EQ(octahedra("knot { ^ ^ ; | X | ; | X | ; | X | ; U U ; }"), octahedra("Braid: 1 1 1"));
  EXPECT_EQ(octahedra("knot { ^ ^ ; ( x ) ; | x / ; \\ x | ; U U ; }"),
            octahedra("Braid: -1 -1 -1"));
  // A vertex that forks and one that joins, free ends, a circle that meets nothing.
  EXPECT_EQ(to_text(read_diagram("knot { ^ ; h | ; | y ; U ; }").diagram), "V[1,4,3] V[1,3,4]");
  EXPECT_EQ(to_text(read_diagram("knot { , , ; % ; ' ' ; }").diagram),
            "V[1] V[2] X[1,3,4,2] V[3] V[4]");
  EXPECT_EQ(to_text(read_diagram("knot { ^ ^ ; | U | ; U ; }").diagram), "V[2,2]");
}

TEST(Diagrams, GaussCodesWithSignsKnowTheirOrientation) {
  for (const char* text : {"O1+U2+O3+U1+O2+U3+", "Gauss: O1+ U2+ O3+ U1+ O2+ U3+",
                           "Gauss: [[[1, -2, 3, -1, 2, -3]], [1, 1, 1]]"}) {
    EXPECT_TRUE(read_diagram(text).orientation_known) << text;
    EXPECT_EQ(octahedra(text), octahedra("Braid: 1 1 1")) << text;
  }
  EXPECT_EQ(octahedra("Gauss: [[[-1, 2, -3, 1, -2, 3]], [-1, -1, -1]]"),
            octahedra("Braid: -1 -1 -1"));
  EXPECT_EQ(octahedra("O1+U2-O3-U1+O4+U3-O2-U4+"), octahedra("Braid: 1 -2 1 -2"));
  EXPECT_FALSE(read_diagram("Gauss: 1 -2 3 -1 2 -3").orientation_known);
}

TEST(Diagrams, GaussCodesOfLinksAreRead) {
  const Diagram link = read_diagram("Gauss: 1 -4 5 -3 / 3 -1 2 -5 4 -2").diagram;
  for (const char* text :
       {"gausscode {{1 -4 5 -3} {3 -1 2 -5 4 -2}}", "[[1,-4,5,-3],[3,-1,2,-5,4,-2]]",
        "GaussCode[{1, -4, 5, -3}, {3, -1, 2, -5, 4, -2}]"})
    EXPECT_EQ(read_diagram(text).diagram, link) << text;
  EXPECT_EQ(strands(link).all.size(), 2u);
  EXPECT_EQ(strands(read_diagram("Gauss: [[1,-2,3,-1,2,-3],[]]").diagram).all.size(), 2u);
}

TEST(Diagrams, KnotTheorysBraidsHaveTheirNumberOfStrands) {
  EXPECT_EQ(read_diagram("BR[2, {1,1,1}]").diagram, read_diagram("Braid: 1 1 1").diagram);
  EXPECT_EQ(strands(read_diagram("BR[4, {1,1,1}]").diagram).all.size(), 3u);
}

// The PD codes that Spherogram 2.4.1 makes of these braids.
TEST(Diagrams, BraidsAreThoseOfSnapPy) {
  EXPECT_EQ(octahedra("Braid: 1 1 1"), octahedra("[(1,5,2,4),(5,3,0,2),(3,1,4,0)]"));
  EXPECT_NE(octahedra("Braid: -1 -1 -1"), octahedra("[(1,5,2,4),(5,3,0,2),(3,1,4,0)]"));
  EXPECT_EQ(octahedra("Braid: 1 1 1 2 -1 2"),
            octahedra("[(8,2,9,1),(2,10,3,9),(10,4,11,3),(11,7,0,6),(7,4,8,5),(5,1,6,0)]"));
}

}  // namespace
}  // namespace tripus::topology
