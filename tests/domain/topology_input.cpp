#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "topology/formats/formats.hpp"
#include "topology/isosig.hpp"
#include "topology/requirements.hpp"
#include "topology/triangulation.hpp"

// Everything that can be wrong with an input, and what its message must say.

namespace tripus::topology {
namespace {

struct BadInput {
  const char* label;
  std::string text;
  const char* message;  // a part of what is said
};

void PrintTo(const BadInput& bad, std::ostream* out) { *out << bad.label; }

class BadInputs : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadInputs, AreRefusedWithTheirPlace) {
  try {
    require_geodesic_boundary(Triangulation(read_triangulation(GetParam().text).gluings));
    FAIL() << "accepted";
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr(GetParam().message));
  }
}

const char* const kY =
    R"([[[1,"1230"],[1,"3012"],[1,"0321"],[1,"0213"]],[[0,"1230"],[0,"3012"],[0,"0321"],[0,"0213"]]])";

std::string json_gluings(const std::string& table) { return R"({"gluings": )" + table + "}"; }

std::string y_with(const std::string& from, const std::string& to) {
  std::string table = kY;
  return json_gluings(table.replace(table.find(from), from.size(), to));
}

INSTANTIATE_TEST_SUITE_P(
    General, BadInputs,
    ::testing::Values(BadInput{"empty", "", "the input is empty"},
                      BadInput{"blank", " \n\t", "the input is empty"},
                      BadInput{"prose", "hello, world",
                               "unrecognised input, starting with \"hello, world\""},
                      BadInput{"gzip", "\x1f\x8b\x08 zz", "the compressed data are"},
                      BadInput{"binary", "\x01\x02", "unrecognised input; expected one of"}));

INSTANTIATE_TEST_SUITE_P(
    Isosig, BadInputs,
    ::testing::Values(
        BadInput{"short", "cPcbbb", "character 7: the signature ends here; expected a gluing"},
        BadInput{"no_joins", "cPc", "expected 3 destinations and as many permutations"},
        BadInput{"actions", "c3c", "character 2: face action 3"},
        BadInput{"permutation", "cPcbbbihz", "character 9: permutation number 25"},
        BadInput{"destination", "cPcbdbihq", "character 5: a gluing to tetrahedron 3"},
        BadInput{"huge", "-k----------aaaa", "the header announces 1152921504606846975"},
        BadInput{"width", "-laaa", "numbers of 11 characters"},
        BadInput{"zero_width", "-a", "numbers of 0 characters"},
        BadInput{"only_marker", "-", "character 2: the signature ends here"},
        BadInput{"twice_glued", "bkaahi", "is glued to a face that is glued already"},
        BadInput{"opened_then_glued", "febaaabbaaeafaaa", "glued already or declared open"},
        BadInput{"no_tetrahedra", "a", "no tetrahedra"}));

INSTANTIATE_TEST_SUITE_P(
    Json, BadInputs,
    ::testing::Values(
        BadInput{"syntax", R"({"gluings": [})", "JSON: syntax error at byte 14"},
        BadInput{"no_gluings", R"({"name": "x"})", "an array \"gluings\""},
        BadInput{"array", "[1, 2]", "an array of 2"},
        BadInput{"table_twice", R"({"gluings": )" + std::string(kY) + R"(, "gluings": [3]})",
                 "the key \"gluings\" occurs twice"},
        BadInput{"name_twice",
                 R"({"name": "", "gluings": )" + std::string(kY) + R"(, "name": "y"})",
                 "the key \"name\" occurs twice"},
        BadInput{"no_tetrahedra", json_gluings("[]"), "no tetrahedra"},
        BadInput{"row", json_gluings("[3]"), "tetrahedron 0: \"3\"; expected an array"},
        BadInput{"neighbour", y_with(R"([1,"0321"])", R"([7,"0321"])"),
                 "face 2 of tetrahedron 0: tetrahedron \"7\"; expected 0 to 1"},
        BadInput{"negative", y_with(R"([1,"0321"])", R"([-1,"0321"])"),
                 "face 2 of tetrahedron 0: tetrahedron \"-1\""},
        BadInput{"permutation", y_with(R"([0,"3012"])", R"([0,"3013"])"),
                 "face 1 of tetrahedron 1: permutation"},
        BadInput{"one_sided", y_with(R"([0,"3012"])", R"([0,"3021"])"),
                 "but face 1 of tetrahedron 1 is glued to tetrahedron 0 by 3021; expected "
                 "tetrahedron 0 by 3012"},
        BadInput{"open", y_with(R"([1,"0321"])", "null"),
                 "face 2 of tetrahedron 1 is glued to tetrahedron 0 by 0321, but face 2 of "
                 "tetrahedron 0 is open"},
        BadInput{"all_open", json_gluings("[[null,null,null,null]]"),
                 "face 0 of tetrahedron 0 is open"},
        BadInput{"itself", json_gluings(R"([[[0,"0213"],null,null,null]])"),
                 "face 0 of tetrahedron 0 is glued to itself"},
        BadInput{"deep", std::string(100000, '['), "nested more than 32 levels deep"}));

INSTANTIATE_TEST_SUITE_P(
    SnappeaAndRegina, BadInputs,
    ::testing::Values(
        BadInput{"orb", "% orb\nx\n", "expected \"% orb\""},
        BadInput{"no_count", "% Triangulation\nx\n", "the number of tetrahedra is missing"},
        BadInput{"huge", "% Triangulation\nx\n99999999999\n", "more than the file has lines for"},
        BadInput{"missing", "% Triangulation\nx\n1\n 0 0 0 0\n", "tetrahedron 0 is missing"},
        BadInput{"neighbour", "% Triangulation\nx\n1\n 0 0 5 0\n 0132 0132 0132 0132\n",
                 "line 4: face 2 of tetrahedron 0: neighbour \"5\""},
        BadInput{"permutation", "% Triangulation\nx\n1\n 0 0 0 0\n 0132 0132 0132 0133\n",
                 "line 5: face 3 of tetrahedron 0: permutation \"0133\""},
        BadInput{"xml_none", "<regina></regina>", "no 3-manifold triangulation"},
        BadInput{"xml_open", "<tri dim=\"3\"><simplex> -1 0 -1 0 -1 0 -1 0", "not closed"},
        BadInput{"old_regina_broken",
                 "<reginadata><packet type=\"Triangulation\"><tetrahedra>"
                 "<tet> 0 228 </tet></tetrahedra></packet></reginadata>",
                 "face 1 of tetrahedron 0"},
        BadInput{"two", "<regina><tri dim=\"3\" label=\"a\"/><tri dim=\"3\" label=\"b\"/></regina>",
                 "there are 2 triangulations in it; choose one by its label: \"a\", \"b\""},
        BadInput{"not_regina", "<VTKFile></VTKFile>", "unrecognised input"},
        BadInput{"filled",
                 "% Triangulation\nx\nnot_attempted 0.0\noriented_manifold\nCS_unknown\n"
                 "1 0\n torus -3.0 1\n1\n",
                 "line 7: cusp 0 has the Dehn filling \"(-3.0,1)\""},
        BadInput{"filled_signature", "cPcbbbiht_BaCB(0,2)", "has the Dehn filling \"(0,2)\""},
        BadInput{"xml_perm", "<tri dim=\"3\"><simplex> 0 1 0 1 0 1 0 1 </simplex></tri>",
                 "face 0 of tetrahedron 0: \"1\""},
        BadInput{"table_row", "Tet | glued to: (012) (013) (023) (123)\n 1 | 0 (012)\n",
                 "line 2: row \"1\"; expected tetrahedron 0"},
        BadInput{"table_entry", "Tet | glued to: (012) (013) (023) (123)\n 0 | 0 (011)\n",
                 "line 2: face 3 of tetrahedron 0: \"(011)\""},
        BadInput{"table_columns", "Tet | glued to: (123)\n 0 | 0 (011)\n", "line 1: the columns"}));

// Regina's signatures of: two tripuses, the figure eight knot complement, a one-tetrahedron
// 3-sphere, the Gieseking manifold.
INSTANTIATE_TEST_SUITE_P(
    Unsolvable, BadInputs,
    ::testing::Values(
        BadInput{"disconnected", "cPcbbbihqcPcbbbihq", "has 2 components"},
        BadInput{"cusp", "cPcbbbiht",
                 "the link of vertex class 0 (vertex 0 of tetrahedron 0) is a torus; a metric"},
        BadInput{"sphere", "bkaagj",
                 "is a sphere, so the manifold is closed; its metric can be solved for"},
        BadInput{"klein", "bkaaid", "is a Klein bottle"}));

TEST(Requirements, ACuspIsUnsupportedRatherThanInvalid) {
  const Triangulation cusped(decode_isosig("cPcbbbiht"));
  EXPECT_THROW(require_geodesic_boundary(cusped), Unsupported);
  EXPECT_NO_THROW(require_solvable(cusped));
}

TEST(Requirements, AnEdgeReversedOntoItselfIsRefused) {
  bool met = false;
  for (int p = 0; p < 24 && !met; ++p)
    for (int q = 0; q < 24 && !met; ++q) {
      Gluings one(1);
      if (Perm4::from_rank(p)(0) != 1 || Perm4::from_rank(q)(2) != 3) continue;
      one.glue(0, 0, 0, Perm4::from_rank(p));
      one.glue(0, 2, 0, Perm4::from_rank(q));
      try {
        const Triangulation triangulation(one);
      } catch (const InvalidInput& error) {
        met = std::string(error.what()).find("its own reverse") != std::string::npos;
      }
    }
  EXPECT_TRUE(met);
}

}  // namespace
}  // namespace tripus::topology
