#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "topology/formats/formats.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"

namespace tripus::topology {
namespace {

// dLQbcbchejw and one loose tetrahedron, as Regina 7.3 saves and prints them.
constexpr char kThirdGeneration[] = R"(<?xml version="1.0"?>
<regina engine="7.3">
<tri dim="3" size="4" perm="index" label="x &amp; y">
  <simplex> 1 0 2 0 1 6 2 4 </simplex>
  <simplex> 0 0 1 9 1 19 0 6 </simplex>
  <simplex> 2 23 0 0 0 2 2 17 </simplex>
  <simplex> -1 -1 -1 -1 -1 -1 -1 -1 </simplex>
</tri>
</regina>
)";
constexpr char kSecondGeneration[] = R"(<?xml version="1.0"?>
<reginadata engine="7.3">
<packet type="3-Manifold Triangulation" typeid="3" label="x">
  <tetrahedra ntet="4">
    <tet desc=""> 1 228 2 228 1 177 2 156 </tet>
    <tet desc=""> 0 228 1 57 1 147 0 177 </tet>
    <tet desc=""> 2 75 0 228 0 120 2 30 </tet>
    <tet desc=""> -1 -1 -1 -1 -1 -1 -1 -1 </tet>
  </tetrahedra>
</packet> <!-- Triangulation -->
</reginadata>
)";
constexpr char kDetail[] = R"(Size of the skeleton:
  Tetrahedra: 4
  Triangles: 10

Tetrahedron gluing:
  Tet  |  glued to:      (012)      (013)      (023)      (123)
  -----+-------------------------------------------------------
    0  |               2 (031)    1 (102)    2 (023)    1 (123)
    1  |               0 (103)    1 (302)    1 (130)    0 (123)
    2  |               2 (231)    0 (021)    0 (023)    2 (201)
    3  |              boundary   boundary   boundary   boundary

Vertices:
  Tet  |  vertex:    0   1   2   3
)";
// The figure eight knot complement, as Regina 7.3 exports it.
constexpr char kSnapPeaFile[] = R"(% Triangulation
Regina_Triangulation
not_attempted 0.0
unknown_orientability
CS_unknown

0 0

2
   1    1    1    1 
 1302 2031 0321 2103
  -1   -1   -1   -1 
  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0
  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0
  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0
  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0
0.0 0.0

   0    0    0    0 
 1302 2031 0321 2103
  -1   -1   -1   -1 
  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0
  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0
  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0
  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0
0.0 0.0
)";
constexpr char kYJson[] =
    R"({"name": "knotted-Y", "gluings": [[[1,"1230"],[1,"3012"],[1,"0321"],[1,"0213"]],
        [[0,"1230"],[0,"3012"],[0,"0321"],[0,"0213"]]]})";

Gluings regina_sample() {
  Gluings sample = decode_isosig("dLQbcbchejw");
  sample.resize(4);
  return sample;
}

TEST(Formats, ReadsBothGenerationsOfReginaAndItsTable) {
  const Gluings sample = regina_sample();
  EXPECT_EQ(read_triangulation(kThirdGeneration).gluings, sample);
  EXPECT_EQ(read_triangulation(kThirdGeneration).name, "x & y");
  EXPECT_EQ(read_triangulation(kSecondGeneration).gluings, sample);
  EXPECT_EQ(read_triangulation(kSecondGeneration).name, "x");
  EXPECT_EQ(read_triangulation(kDetail).gluings, sample);
  const std::string table = write_regina_table({"", sample});
  EXPECT_NE(std::string(kDetail).find(table), std::string::npos) << table;
}

// The heading of Regina 7.4.1.
TEST(Formats, ReadsTheTableOfNewerRegina) {
  std::string table = kDetail;
  table.replace(table.find("glued to:   "), 12, "gluing:     ");
  EXPECT_EQ(read_triangulation(table).gluings, regina_sample());
}

// Regina nests packets: the link below a triangulation is not part of it.
TEST(Formats, LeavesNestedPacketsOfReginaAlone) {
  std::string nested = kThirdGeneration;
  nested.insert(nested.find("</tri>"),
                "<H1><abeliangroup rank=\"1\"> </abeliangroup></H1>\n"
                "<tri dim=\"2\" size=\"1\" perm=\"index\" label=\"Vertex Link\">\n"
                "  <simplex> -1 -1 -1 -1 -1 -1 </simplex>\n</tri>\n<empty/>\n");
  EXPECT_EQ(read_triangulation(nested).gluings, regina_sample());
}

TEST(Formats, ReadsSnappea) {
  const NamedGluings knot = read_triangulation(kSnapPeaFile);
  EXPECT_EQ(knot.name, "Regina_Triangulation");
  EXPECT_EQ(isosig(knot.gluings), "cPcbbbiht");  // Regina: Example3.figureEight().isoSig()
}

TEST(Formats, ReadsTheKnottedYFromJson) {
  const NamedGluings y = read_triangulation(kYJson);
  EXPECT_EQ(y.name, "knotted-Y");
  EXPECT_EQ(isosig(y.gluings), "cPcbbbihq");
}

// Law F1: what is written reads back to the same table.
TEST(Formats, RoundTrips) {
  for (const char* signature : {"cPcbbbihq", "eLAkbccdddprdk", "dLQbcbchejwcPcbbbihq"}) {
    const NamedGluings original{"a name/with \"signs\"",
                                random_relabelling(decode_isosig(signature), 5)};
    EXPECT_EQ(read_json(write_json(original)).gluings, original.gluings);
    EXPECT_EQ(read_json(write_json(original)).name, original.name);
    EXPECT_EQ(read_snappea(write_snappea(original)).gluings, original.gluings);
    EXPECT_EQ(read_regina_table(write_regina_table(original)).gluings, original.gluings);
    const auto data_file = read_regina_xml(write_regina_xml(original));
    ASSERT_EQ(data_file.size(), 1u);
    EXPECT_EQ(data_file[0].gluings, original.gluings);
    EXPECT_EQ(data_file[0].name, original.name);
  }
  EXPECT_EQ(read_json(write_json({"", regina_sample()})).gluings, regina_sample());
  EXPECT_THROW((void)write_snappea({"", regina_sample()}), InvalidInput);
}

// Regina 7.4.1: locks in hexadecimal, a description.
TEST(Formats, SaysWhatIsNotRead) {
  std::string locked = kThirdGeneration;
  locked.replace(locked.find("<simplex>"), 9, "<simplex lock=\"12\" desc=\"first\">");
  const NamedGluings read = read_triangulation(locked);
  EXPECT_EQ(read.gluings, regina_sample());
  EXPECT_EQ(read.notes, (std::vector<std::string>{"locks of tetrahedra and faces not read",
                                                  "descriptions of tetrahedra not read"}));
  EXPECT_TRUE(read_triangulation(kThirdGeneration).notes.empty());
}

TEST(Formats, ReadsSnapPeaPacketsOfRegina) {
  for (const char* element : {"snappeadata", "snappea"}) {
    const std::string text = std::string("<regina engine=\"7.4\"><") + element +
                             " label=\"knot\">" + kSnapPeaFile + "</" + element + "></regina>";
    EXPECT_EQ(read_triangulation(text).name, "knot");
    EXPECT_EQ(isosig(read_triangulation(text).gluings), "cPcbbbiht");
  }
}

// Fields instead of lines: all on one, and one on each.
TEST(Formats, ReadsSnappeaInFreeForm) {
  const std::string text = kSnapPeaFile;
  const std::size_t body = text.find("not_attempted");
  for (const char separator : {' ', '\n'}) {
    std::string free = text.substr(body);
    for (char& c : free)
      if (c == ' ' || c == '\n') c = separator;
    EXPECT_EQ(read_snappea(text.substr(0, body) + free).gluings, read_snappea(text).gluings);
  }
}

TEST(Formats, ReadsSignaturesWithWhatProgramsAdd) {
  for (const char* text :
       {"cPcbbbiht_BaCB", "cPcbbbiht.qa", "cPcbbbiht_BaCB(0,0)", "cPcbbbiht(0,0)"})
    EXPECT_EQ(isosig(read_triangulation(text).gluings), "cPcbbbiht") << text;
  for (const char* text : {"cPcbbbiht_BaCB(1,2)", "cPcbbbiht(-3,0)", "cPcbbbiht_BaCB(0,0)(0.5,0)"})
    EXPECT_THROW((void)read_triangulation(text), Unsupported) << text;
}

TEST(Formats, AreRecognisedByContent) {
  EXPECT_EQ(detect_format(kYJson), kJson);
  EXPECT_EQ(detect_format(kSnapPeaFile), "SnapPea triangulation");
  EXPECT_EQ(detect_format(kThirdGeneration), kReginaDataFile);
  EXPECT_EQ(detect_format(kDetail), "Regina gluing table");
  EXPECT_EQ(detect_format("  cPcbbbihq\n"), kIsomorphismSignature);
  EXPECT_EQ(detect_format("\x1f\x8b\x08"), kGzip);
  EXPECT_EQ(detect_format("two words"), "");
  EXPECT_EQ(detect_format(""), "");
}

TEST(Formats, BatchLinesKeepTheirNumbers) {
  const auto lines = read_batch("# list\r\n\n cPcbbbihq  # the tripus\r\n#x\nfile#1.json\n");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].line_number, 3u);
  EXPECT_EQ(lines[0].text, "cPcbbbihq");
  EXPECT_EQ(lines[1].line_number, 5u);
  EXPECT_EQ(lines[1].text, "file#1.json");
}

}  // namespace
}  // namespace tripus::topology
