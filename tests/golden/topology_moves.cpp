#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/data_folder.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::topology {
namespace {

// Columns: isosig, move, signature of the result or "-" where Regina refuses the move.
TEST(MovesGolden, AgreeWithRegina) {
  std::ifstream in(testing::data_folder() + "/moves-golden.tsv");
  std::map<std::pair<MoveKind, bool>, int> counts;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#' || line.starts_with("isosig")) continue;
    std::istringstream row(line);
    std::string signature;
    std::string text;
    std::string result;
    std::getline(row, signature, '\t');
    std::getline(row, text, '\t');
    std::getline(row, result, '\t');
    const Move move = parse_move(text);
    EXPECT_EQ(to_string(move), text);
    Gluings gluings = decode_isosig(signature);
    const MoveRefusal reason = refusal(gluings, move);
    EXPECT_EQ(reason == MoveRefusal::kNone, result != "-") << line << ": " << to_string(reason);
    ++counts[{move.kind, result != "-"}];
    if (reason != MoveRefusal::kNone || result == "-") continue;
    apply(gluings, move);
    EXPECT_EQ(isosig(gluings), result) << line;
  }
  // Every kind that Regina has, legal and, where that can be, illegal.
  for (const MoveKind kind :
       {MoveKind::kTwoThree, MoveKind::kThreeTwo, MoveKind::kFourFour, MoveKind::kTwoZeroEdge,
        MoveKind::kZeroTwoEdge, MoveKind::kTwoZeroVertex, MoveKind::kTwoOne, MoveKind::kOneFour,
        MoveKind::kFourOne}) {
    const int legal = counts[{kind, true}];
    const int illegal = counts[{kind, false}];
    EXPECT_GE(legal, 20) << info(kind).name;
    EXPECT_GE(illegal, kind == MoveKind::kOneFour ? 0 : 20) << info(kind).name;
  }
}

}  // namespace
}  // namespace tripus::topology
