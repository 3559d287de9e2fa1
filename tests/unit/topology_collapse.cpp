#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/support/cube_meshes.hpp"
#include "topology/cone.hpp"
#include "topology/isosig.hpp"
#include "topology/simplify/collapse.hpp"

namespace tripus::topology {
namespace {

CollapseRefusal refusal_at(const Gluings& gluings, TetrahedronIndex t, int edge) {
  MutableTriangulation m{Triangulation(gluings)};
  return EdgeCollapse(m).refusal(t, edge);
}

/// Two tetrahedra glued along all four faces by the identity: a sphere with four vertices.
Gluings doubled_tetrahedron() {
  Gluings gluings(2);
  for (int f = 0; f < 4; ++f) gluings.glue(0, f, 1, Perm4());
  return gluings;
}

// An edge from the new vertex of a 1-4 leads back to where the move came from.
TEST(Collapse, UndoesAOneFour) {
  const Gluings tripus = decode_isosig("cPcbbbihq");
  Gluings gluings = tripus;
  const MoveChange change = apply(gluings, parse_move("1-4 at tetrahedron 1"));
  // The first new tetrahedron lacks vertex 0 of the old one; the new vertex is in its place.
  for (const int edge : {0, 1, 2})
    EXPECT_EQ(isosig(collapse_edge(gluings, change.added[0], edge)), isosig(tripus));
}

TEST(Collapse, NamesItsRefusals) {
  const Gluings tripus = decode_isosig("cPcbbbihq");
  EXPECT_EQ(refusal_at(tripus, 0, 0), CollapseRefusal::kSameEnds);
  EXPECT_EQ(refusal_at(tripus, 2, 0), CollapseRefusal::kNoSuchPlace);
  EXPECT_EQ(refusal_at(tripus, 0, 6), CollapseRefusal::kNoSuchPlace);
  // Nothing would be left of a sphere whose tetrahedra are all around the edge.
  for (int edge = 0; edge < 6; ++edge)
    EXPECT_EQ(refusal_at(doubled_tetrahedron(), 1, edge), CollapseRefusal::kFaceCycle);
}

// A tunnel through a ball of cubes, and a ring-shaped cavity around it: two boundary tori, whose
// cone points are left and must not be merged.
TEST(Collapse, KeepsConePointsApart) {
  const auto mesh = testing::cube_mesh(7, [](int x, int y, int z) {
    const bool tunnel = x == 3 && y == 3;
    const bool ring = z == 3 && std::max(std::abs(x - 3), std::abs(y - 3)) == 2;
    return !tunnel && !ring;
  });
  MutableTriangulation m{Triangulation(cone_boundary(mesh))};
  EdgeCollapse collapse(m);
  for (bool again = true; again;) {
    again = false;
    for (TetrahedronIndex t = 0; t < m.slot_count(); ++t)
      for (int edge = 0; edge < 6; ++edge)
        again = collapse.try_apply(t, edge) == CollapseRefusal::kNone || again;
  }
  EXPECT_EQ(m.finite_vertex_count(), 0u);
  ASSERT_EQ(m.vertex_count(), 2u);
  int kept_apart = 0;
  for (TetrahedronIndex t = 0; t < m.slot_count(); ++t)
    for (int edge = 0; edge < 6; ++edge)
      kept_apart += collapse.refusal(t, edge) == CollapseRefusal::kNoFiniteEnd;
  EXPECT_GT(kept_apart, 0);
}

TEST(Collapse, ThrowsWithPlaceAndReason) {
  try {
    collapse_edge(decode_isosig("cPcbbbihq"), 1, 5);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "no collapse of edge 23 of tetrahedron 1: both ends of the edge are one vertex");
  }
  EXPECT_THROW(collapse_edge(Gluings(1), 0, 0), InvalidInput);
}

// A solid ball of cubes, coned, becomes a sphere with as few vertices as collapse can do, in any
// case with fewer tetrahedra than any mesh of it.
TEST(Collapse, ShrinksABallToAHandfulOfTetrahedra) {
  const auto ball = cone_boundary(testing::cube_mesh(6, [](int, int, int) { return true; }));
  MutableTriangulation m{Triangulation(ball)};
  EdgeCollapse collapse(m);
  std::size_t collapses = 0;
  for (TetrahedronIndex t = 0; t < m.slot_count(); ++t)
    for (int edge = 0; edge < 6; ++edge)
      collapses += collapse.try_apply(t, edge) == CollapseRefusal::kNone;
  EXPECT_EQ(collapses + m.finite_vertex_count(), 7u * 7u * 7u + 1u);
  EXPECT_LT(m.tetrahedron_count(), 20u);
}

TEST(Collapse, EveryRefusalHasItsWords) {
  std::vector<std::string_view> words;
  for (const auto reason :
       {CollapseRefusal::kNone, CollapseRefusal::kNoSuchPlace, CollapseRefusal::kSameEnds,
        CollapseRefusal::kNoFiniteEnd, CollapseRefusal::kMeetsItself, CollapseRefusal::kEdgeCycle,
        CollapseRefusal::kFaceCycle})
    words.push_back(to_string(reason));
  for (std::size_t i = 0; i < words.size(); ++i) {
    EXPECT_FALSE(words[i].empty());
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(words[i], words[j]);
  }
}

}  // namespace
}  // namespace tripus::topology
