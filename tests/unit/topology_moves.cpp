#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/support/triangulations.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::topology {
namespace {

Gluings knotted_y() { return decode_isosig("cPcbbbihq"); }

/// Made, then undone by the inverse that the change names; the result of the move.
Gluings made_and_undone(const Gluings& before, const std::string& text) {
  Gluings gluings = before;
  const MoveChange change = apply(gluings, parse_move(text));
  Gluings undone = gluings;
  EXPECT_TRUE(change.inverse.has_value()) << text;
  if (change.inverse) {
    EXPECT_EQ(info(change.inverse->kind).inverse, parse_move(text).kind);
    apply(undone, *change.inverse);
    EXPECT_EQ(isosig(undone), isosig(before)) << text;
  }
  return gluings;
}

std::vector<std::size_t> valences(const Gluings& gluings) {
  const Triangulation triangulation(gluings);
  std::vector<std::size_t> found;
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e)
    found.push_back(triangulation.valence(e));
  std::ranges::sort(found);
  return found;
}

TEST(MoveTable, IsInTheOrderOfTheKindsAndInversesComeInPairs) {
  for (std::size_t i = 0; i < move_table().size(); ++i) {
    const MoveInfo& line = move_table()[i];
    EXPECT_EQ(static_cast<std::size_t>(line.kind), i) << line.name;
    EXPECT_EQ(find_move_kind(line.name), line.kind);
    EXPECT_EQ(info(line.inverse).inverse, line.kind) << line.name;
    EXPECT_EQ(info(line.inverse).tetrahedra, -line.tetrahedra) << line.name;
    EXPECT_EQ(info(line.inverse).finite_vertices, -line.finite_vertices) << line.name;
    EXPECT_FALSE(line.description.empty());
  }
  EXPECT_EQ(find_move_kind("5-7"), std::nullopt);
}

// The new edge has valence 3; the old one has the rest of the 18 corners.
TEST(Moves, TwoThreeMakesAnEdgeOfValenceThree) {
  const Gluings three = made_and_undone(knotted_y(), "2-3 at face 0 of tetrahedron 0");
  EXPECT_EQ(three.tetrahedron_count(), 3u);
  EXPECT_EQ(valences(three), (std::vector<std::size_t>{3, 15}));
  EXPECT_EQ(Triangulation(three).link(0).genus(), 2);
}

TEST(Moves, OneFourMakesAFiniteVertex) {
  const Gluings five = made_and_undone(knotted_y(), "1-4 at tetrahedron 1");
  const Triangulation triangulation(five);
  EXPECT_EQ(triangulation.tetrahedron_count(), 5u);
  ASSERT_EQ(triangulation.vertex_count(), 2u);
  EXPECT_EQ(triangulation.link(0).genus() + triangulation.link(1).genus(), 2);
  // Four edges from the new vertex, each in three of the four.
  EXPECT_EQ(valences(five), (std::vector<std::size_t>{3, 3, 3, 3, 18}));
}

TEST(Moves, ZeroTwoSplitsTheValenceAsTheStepsSay) {
  for (std::size_t steps = 0; steps < 12; ++steps)
    for (const int side : {0, 1}) {
      SCOPED_TRACE(steps);
      const Gluings four = made_and_undone(knotted_y(), "0-2 at edge 01 of tetrahedron 0, side " +
                                                            std::to_string(side) + ", steps " +
                                                            std::to_string(steps));
      const Triangulation triangulation(four);
      ASSERT_EQ(triangulation.edge_count(), 3u);
      // The new tetrahedra are 2 and 3, around their edge 01; the halves of the old one are 23.
      EXPECT_EQ(triangulation.valence(triangulation.edge_class(2, 0)), 2u);
      EXPECT_NE(triangulation.edge_class(2, 5), triangulation.edge_class(3, 5));
      EXPECT_TRUE(testing::is_oriented(four) || !testing::is_oriented(knotted_y()));
    }
}

TEST(Moves, ZeroTwoAtAFaceMakesAVertexOfValenceTwo) {
  const Gluings four = made_and_undone(knotted_y(), "0-2 at face 3 of tetrahedron 1");
  const Triangulation triangulation(four);
  EXPECT_EQ(triangulation.vertex_count(), 2u);
  EXPECT_EQ(triangulation.link(triangulation.vertex_class(2, 0)).triangle_count, 2u);
}

// The fold of the new tetrahedron is around the edge from the end that was kept.
TEST(Moves, TwoOneTakesAwayAnEdgeOfValenceOne) {
  constexpr std::array kGrowing{MoveKind::kTwoThree, MoveKind::kZeroTwoEdge};
  std::size_t count = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    Gluings gluings = knotted_y();
    randomize(gluings, {.count = 4, .seed = seed, .kinds = kGrowing});
    const Triangulation triangulation(gluings);
    for (const Move& move : all_moves(triangulation, std::array{MoveKind::kTwoOne})) {
      ++count;
      EXPECT_EQ(triangulation.valence(triangulation.edge_class(move.tetrahedron, move.place)), 1u);
      Gluings fewer = gluings;
      apply(fewer, move);
      EXPECT_EQ(fewer.tetrahedron_count(), gluings.tetrahedron_count() - 1);
      EXPECT_EQ(valences(fewer).front(), 1u);
      bool undone = false;
      for (const Move& back : all_moves(Triangulation(fewer), std::array{MoveKind::kOneTwo})) {
        const Gluings again = made_and_undone(fewer, to_string(back));
        undone = undone || isosig(again) == isosig(gluings);
      }
      EXPECT_TRUE(undone) << to_string(move);
    }
  }
  EXPECT_GT(count, 20u);
}

// A 2-3 beside an edge of valence 3, at a face off the edge, gives it valence 4.
TEST(Moves, FourFourTurnsTheAxisAndBack) {
  constexpr std::array kGrow{MoveKind::kTwoThree};
  std::size_t count = 0;
  const Gluings start = decode_isosig("eLAkbcbddmenur");
  for (const Move& first : all_moves(Triangulation(start), kGrow)) {
    Gluings five = start;
    apply(five, first);
    for (const Move& second : all_moves(Triangulation(five), kGrow)) {
      Gluings six = five;
      apply(six, second);
      const auto before = valences(six);
      for (const Move& move : all_moves(Triangulation(six), std::array{MoveKind::kFourFour})) {
        const Gluings turned = made_and_undone(six, to_string(move));
        EXPECT_EQ(turned.tetrahedron_count(), 6u);
        const auto after = valences(turned);
        EXPECT_TRUE(std::ranges::count(after, 4u) > 0);
        EXPECT_EQ(after.size(), before.size());
        ++count;
      }
    }
  }
  EXPECT_GT(count, 20u);
}

TEST(Moves, OrientedTablesStayOriented) {
  Gluings gluings(2);  // the knotted Y as the paper labels it
  gluings.glue(0, 0, 1, Perm4::from_images(1, 2, 3, 0));
  gluings.glue(0, 1, 1, Perm4::from_images(3, 0, 1, 2));
  gluings.glue(0, 2, 1, Perm4::from_images(0, 3, 2, 1));
  gluings.glue(0, 3, 1, Perm4::from_images(0, 2, 1, 3));
  ASSERT_TRUE(testing::is_oriented(gluings));
  std::vector<MoveKind> kinds;
  for (const MoveInfo& line : move_table()) kinds.push_back(line.kind);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Gluings walked = gluings;
    const auto made =
        randomize(walked, {.count = 100, .seed = seed, .kinds = kinds, .max_tetrahedra = 15});
    EXPECT_EQ(made.size(), 100u);
    EXPECT_TRUE(testing::is_oriented(walked));
    Gluings again = gluings;
    for (const Move& move : made) apply(again, move);
    EXPECT_EQ(again, walked);
  }
}

TEST(Moves, ChangeTellsTheNewNumbers) {
  Gluings gluings = decode_isosig("eLAkbcbddmenur");
  const MoveChange grown = apply(gluings, parse_move("1-4 at tetrahedron 1"));
  EXPECT_EQ(grown.removed.size(), 1u);
  ASSERT_EQ(grown.added.size(), 4u);
  EXPECT_EQ(grown.added[0], 1u);
  EXPECT_EQ(grown.added[3], 6u);
  EXPECT_TRUE(grown.renumbered.empty());
  const MoveChange shrunk = apply(gluings, *grown.inverse);
  ASSERT_EQ(shrunk.added.size(), 1u);
  EXPECT_EQ(shrunk.removed.size(), 4u);
  for (const auto& [from, to] : shrunk.renumbered) {
    EXPECT_GE(from, gluings.tetrahedron_count());
    EXPECT_LT(to, gluings.tetrahedron_count());
  }
  EXPECT_EQ(gluings.tetrahedron_count(), 4u);
}

struct Refused {
  const char* signature;
  const char* move;
  MoveRefusal reason;
};

TEST(Moves, RefusalsGiveTheirReasons) {
  const std::vector<Refused> rows{
      {"cPcbbbihq", "2-3 at face 0 of tetrahedron 7", MoveRefusal::kNoSuchPlace},
      {"cPcbbbihq", "3-2 at edge 01 of tetrahedron 0", MoveRefusal::kWrongValence},
      {"cPcbbbihq", "4-4 at edge 01 of tetrahedron 0, axis 1", MoveRefusal::kWrongValence},
      {"cPcbbbihq", "2-0 at edge 01 of tetrahedron 0", MoveRefusal::kWrongValence},
      {"cPcbbbihq", "2-1 at edge 01 of tetrahedron 0, end 0", MoveRefusal::kWrongValence},
      {"cPcbbbihq", "1-2 at edge 01 of tetrahedron 0, steps 0", MoveRefusal::kNotFolded},
      {"cPcbbbihq", "0-2 at edge 01 of tetrahedron 0, side 0, steps 12", MoveRefusal::kNoSuchPlace},
      // A sphere made of one tetrahedron.
      {"bkaagj", "2-3 at face 0 of tetrahedron 0", MoveRefusal::kNotDistinct},
  };
  for (const Refused& row : rows) {
    Gluings gluings = decode_isosig(row.signature);
    const Gluings before = gluings;
    EXPECT_EQ(refusal(gluings, parse_move(row.move)), row.reason) << row.move;
    EXPECT_THROW(apply(gluings, parse_move(row.move)), InvalidInput) << row.move;
    EXPECT_EQ(gluings, before);
  }
}

// Two tetrahedra glued to each other by the identity: a sphere with vertices of valence 2, edges
// of valence 2, and nothing outside any pillow.
TEST(Moves, NothingIsLeftOfTheDoubleOfATetrahedron) {
  Gluings gluings(2);
  for (int f = 0; f < 4; ++f) gluings.glue(0, f, 1, Perm4());
  for (std::uint8_t e = 0; e < 6; ++e)
    EXPECT_EQ(refusal(gluings, {.kind = MoveKind::kTwoZeroEdge, .place = e}),
              MoveRefusal::kSealedFace);
  for (std::uint8_t v = 0; v < 4; ++v)
    EXPECT_EQ(refusal(gluings, {.kind = MoveKind::kTwoZeroVertex, .place = v}),
              MoveRefusal::kSealedFace);
}

TEST(Moves, OpenFacesAreRefused) {
  Gluings gluings(2);
  gluings.glue(0, 0, 1, Perm4());
  for (const char* text :
       {"2-3 at face 0 of tetrahedron 0", "2-3 at face 1 of tetrahedron 0",
        "3-2 at edge 01 of tetrahedron 0", "4-4 at edge 01 of tetrahedron 0, axis 0",
        "2-0 at edge 23 of tetrahedron 0", "2-0 at vertex 0 of tetrahedron 0",
        "2-1 at edge 01 of tetrahedron 0, end 0", "1-4 at tetrahedron 0",
        "4-1 at vertex 0 of tetrahedron 0", "0-2 at face 1 of tetrahedron 0",
        "0-2 at edge 01 of tetrahedron 0, side 0, steps 0",
        "1-2 at edge 01 of tetrahedron 0, steps 0"})
    EXPECT_EQ(refusal(gluings, parse_move(text)), MoveRefusal::kOpenFace) << text;
}

TEST(MoveText, ReadsWhatItWrites) {
  for (const MoveInfo& line : move_table()) {
    Move move{.kind = line.kind, .tetrahedron = 12345};
    if (line.place != MovePlace::kTetrahedron) move.place = 3;
    if (!line.choice_name.empty()) move.choice = 1;
    if (line.has_steps) move.steps = 77;
    EXPECT_EQ(parse_move(to_string(move)), move) << to_string(move);
  }
  EXPECT_EQ(to_string(Move{.kind = MoveKind::kTwoThree, .tetrahedron = 5, .place = 2}),
            "2-3 at face 2 of tetrahedron 5");
  EXPECT_EQ(to_string(Move{.kind = MoveKind::kFourFour, .tetrahedron = 5, .place = 2, .choice = 1}),
            "4-4 at edge 03 of tetrahedron 5, axis 1");
}

TEST(MoveText, BrokenTextIsRefusedWithItsPlace) {
  for (const char* text :
       {"", "2-3", "2-3 at edge 01 of tetrahedron 0", "2-3 at face 4 of tetrahedron 0",
        "2-3 at face 0 of tetrahedron", "2-3 at face 0 of tetrahedron 99999999999",
        "2-3 at face 0 of tetrahedron 0 ", "4-4 at edge 10 of tetrahedron 0, axis 0",
        "4-4 at edge 01 of tetrahedron 0", "4-4 at edge 01 of tetrahedron 0, axis 2",
        "0-2 at edge 01 of tetrahedron 0, side 0, steps -1", "9-9 at face 1 of tetrahedron 0"})
    EXPECT_THROW(parse_move(text), InvalidInput) << text;
}

TEST(RandomMoves, StopWhereNothingIsLegal) {
  Gluings gluings = decode_isosig("bkaagj");
  const std::array kinds{MoveKind::kTwoThree};
  EXPECT_TRUE(randomize(gluings, {.count = 5, .seed = 1, .kinds = kinds}).empty());
  EXPECT_TRUE(randomize(gluings, {.count = 5, .seed = 1, .kinds = {}}).empty());
}

}  // namespace
}  // namespace tripus::topology
