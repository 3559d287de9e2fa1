// Texts of people: abelian groups in any spelling, names of other programs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "topology/formats/formats.hpp"
#include "topology/homology.hpp"

namespace tripus::topology {
namespace {

TEST(AbelianGroups, AreReadInAnySpelling) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"0", "0"},
      {"trivial", "0"},
      {"Z", "Z"},
      {" 2 Z ", "2 Z"},
      {"2Z+Z_3", "2 Z + Z_3"},
      {"Z_3 + 2Z", "2 Z + Z_3"},
      {"Z^2 + Z/3", "2 Z + Z_3"},
      {"Z+Z+Z/3Z", "2 Z + Z_3"},
      {"z + z + z3", "2 Z + Z_3"},
      {"Z^{2} \\oplus Z_{3}", "2 Z + Z_3"},
      {"\u2124^2\u2295\u2124/3\u2124", "2 Z + Z_3"},
      {"Z x Z x Z_3", "2 Z + Z_3"},
      {"2*Z, Z_3", "2 Z + Z_3"},
      {"(Z/2)^2", "2 Z_2"},
      {"2 Z_2", "2 Z_2"},
      {"Z_2 + Z_3", "Z_6"},
      {"Z_4 + Z_6 + Z_9", "Z_6 + Z_36"},  // the 2-parts 2 and 4, the 3-parts 3 and 9
      {"3 Z + Z_1", "3 Z"},
      {"Z_0", "Z"},
      {"0 Z + Z_5", "Z_5"},
      {"Z_123456789012345678901234567890", "Z_123456789012345678901234567890"},
  };
  for (const auto& [text, expected] : cases) {
    SCOPED_TRACE(text);
    EXPECT_EQ(to_string(parse_abelian_group(text)), expected);
  }
}

TEST(AbelianGroups, AreReadAsWritten) {
  for (const char* text : {"0", "Z", "2 Z + Z_3", "Z + 2 Z_2 + Z_6", "4 Z", "Z_8", "2 Z + 2 Z_2"})
    EXPECT_EQ(to_string(parse_abelian_group(text)), text);
}

TEST(AbelianGroups, ThatAreNoneAreRefused) {
  for (const char* text :
       {"", " ", "banana", "2", "Z+", "+Z", "Z_", "Z/", "Z_x", "Z^", "Z^-1", "-Z", "Q", "Z + R",
        "99999999999999999999 Z", "Z Z", "Z_3.5", "Z^100000000 "}) {
    SCOPED_TRACE(text);
    EXPECT_THROW(parse_abelian_group(text), InvalidInput);
  }
}

TEST(ForeignNames, AreKnown) {
  for (const char* name :
       {"m004",          "m003(-3,1)",      "s776",           "v1234",        "t12345",
        "o9_00001",      "o10_150729",      "x101",           "y042",         "L5a1",
        "L14n12345",     "K11n34",          "K3a1",           "8_19",         "4_1",
        "8^3_2",         "7^2_1(1,0)(0,0)", "11a17",          "otet08_00010", "ocube01_00002",
        "odode02_00913", "DT:[(4,6,2)]",    "Braid:[1,2,-1]", " m004 "}) {
    SCOPED_TRACE(name);
    const auto message = foreign_name(name);
    ASSERT_TRUE(message);
    EXPECT_THAT(*message, ::testing::HasSubstr("is a SnapPy name"));
    EXPECT_THAT(*message, ::testing::HasSubstr("give its signature"));
  }
  for (const char* text : {"", "m", "cPcbbbihq", "t3g2.13", "knot.json", "m004.tri", "8_", "_19",
                           "L5b1", "hello", "a", "list-3"}) {
    SCOPED_TRACE(text);
    EXPECT_FALSE(foreign_name(text));
  }
}

}  // namespace
}  // namespace tripus::topology
