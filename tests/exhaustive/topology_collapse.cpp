#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/data_files.hpp"
#include "tests/support/manifold_invariants.hpp"
#include "topology/isosig.hpp"
#include "topology/simplify/collapse.hpp"

// Laws M1, E1 and E2 of topology/README.md: edge collapse, and the moves on a MutableTriangulation,
// over the listed triangulations and some closed and non-orientable ones, shaken by random moves.

namespace tripus::topology {
namespace {

using testing::expect_kept;
using testing::ManifoldInvariants;

struct CollapseList {
  const char* file;
  std::size_t stride;
};

/// Spheres, lens spaces and bundles, orientable and not, closed and with cusps; signatures of
/// Regina's examples. An empty file name stands for them.
const std::vector<std::string> kOthers{
    "bkaagj",    "bkaagb", "dLQbcccajqs", "cMcabbjaj",         "cMcabbjak",
    "cMcabbjqs", "bkaaid", "cPcbbbiht",   "fvPQcdecedekrsnrs", "fvPQccdedeegovcfb"};

std::vector<std::string> signatures(const CollapseList& list) {
  const std::string file = list.file;
  const auto lines = file.empty() ? kOthers : testing::data_lines(file);
  std::vector<std::string> found;
  for (std::size_t i = 0; i < lines.size(); i += list.stride) found.push_back(lines[i]);
  return found;
}

std::vector<MoveKind> every_kind() {
  std::vector<MoveKind> kinds;
  for (const MoveInfo& line : move_table()) kinds.push_back(line.kind);
  return kinds;
}

/// Labels, valences and degrees are those of a skeleton made anew.
void expect_consistent(const MutableTriangulation& m) {
  const Triangulation anew(m.compacted());
  ASSERT_EQ(m.tetrahedron_count(), anew.tetrahedron_count());
  ASSERT_EQ(m.edge_count(), anew.edge_count());
  ASSERT_EQ(m.vertex_count(), anew.vertex_count());
  std::size_t finite = 0;
  for (std::size_t v = 0; v < anew.vertex_count(); ++v)
    finite += anew.link(v).euler_characteristic == 2;
  ASSERT_EQ(m.finite_vertex_count(), finite);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> vertices;
  std::uint32_t number = 0;
  for (std::uint32_t t = 0; t < m.slot_count(); ++t) {
    if (!m.is_live(t)) continue;
    for (int e = 0; e < 6; ++e) {
      edges.emplace_back(m.edge(t, e), anew.edge_class(number, e));
      ASSERT_EQ(m.valence(m.edge(t, e)), anew.valence(anew.edge_class(number, e)));
    }
    for (int v = 0; v < 4; ++v) {
      const VertexLink& link = anew.link(anew.vertex_class(number, v));
      vertices.emplace_back(m.vertex(t, v), anew.vertex_class(number, v));
      ASSERT_EQ(m.degree(m.vertex(t, v)), link.triangle_count);
      ASSERT_EQ(m.is_finite(m.vertex(t, v)), link.euler_characteristic == 2);
    }
    ++number;
  }
  for (auto* pairs : {&edges, &vertices}) {  // as many pairs as labels: one class, one label
    std::ranges::sort(*pairs);
    pairs->erase(std::unique(pairs->begin(), pairs->end()), pairs->end());
  }
  ASSERT_EQ(edges.size(), anew.edge_count());
  ASSERT_EQ(vertices.size(), anew.vertex_count());
}

class CollapseLists : public ::testing::TestWithParam<CollapseList> {
 protected:
  template <class Check>
  void for_each_shaken(std::size_t moves, std::size_t most, Check&& check) {
    const auto list = signatures(GetParam());
    ASSERT_FALSE(list.empty());
    const auto kinds = every_kind();
    std::uint64_t seed = 1;
    for (const std::string& signature : list) {
      SCOPED_TRACE(signature + ", seed " + std::to_string(seed));
      Gluings gluings = decode_isosig(signature);
      randomize(gluings, {.count = moves, .seed = seed, .kinds = kinds, .max_tetrahedra = most});
      check(gluings, seed++);
      if (HasFatalFailure()) return;
    }
  }
};

TEST_P(CollapseLists, EveryLegalCollapseKeepsTheManifold) {
  int legal = 0;
  int refused = 0;
  for_each_shaken(25, 12, [&](const Gluings& gluings, std::uint64_t) {
    const Triangulation triangulation(gluings);
    const ManifoldInvariants before(triangulation);
    const MutableTriangulation fresh(triangulation);
    for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
      const EdgeCorner corner = triangulation.corners(e)[0];
      const auto t = static_cast<TetrahedronIndex>(corner.tetrahedron());
      MutableTriangulation m = fresh;
      EdgeCollapse collapse(m);
      const CollapseRefusal reason = collapse.refusal(t, corner.edge());
      for (const EdgeCorner same : triangulation.corners(e))  // whatever corner it is named by
        ASSERT_EQ(collapse.refusal(static_cast<TetrahedronIndex>(same.tetrahedron()),
                                   same.edge()) == CollapseRefusal::kNone,
                  reason == CollapseRefusal::kNone);
      if (reason != CollapseRefusal::kNone) {
        ++refused;
        continue;
      }
      ++legal;
      collapse.apply(t, corner.edge());
      ASSERT_EQ(m.tetrahedron_count() + triangulation.valence(e), gluings.tetrahedron_count());
      expect_consistent(m);
      expect_kept(before, ManifoldInvariants(Triangulation(m.compacted())), -1);
      ASSERT_EQ(isosig(collapse_edge(gluings, t, corner.edge())), isosig(m.compacted()));
    }
  });
  EXPECT_GT(legal, 10);
  EXPECT_GT(refused, 10);
}

// Every move that is made on plain tables, and undone; where one is refused, so is the other.
TEST_P(CollapseLists, MovesAreThoseOfPlainTables) {
  constexpr std::array kKinds{MoveKind::kTwoThree,      MoveKind::kThreeTwo, MoveKind::kFourFour,
                              MoveKind::kTwoZeroEdge,   MoveKind::kTwoOne,   MoveKind::kOneFour,
                              MoveKind::kTwoZeroVertex, MoveKind::kFourOne};
  for_each_shaken(25, 9, [&](const Gluings& gluings, std::uint64_t) {
    MutableTriangulation m{Triangulation(gluings)};
    for (const MoveKind kind : kKinds)
      for (TetrahedronIndex t = 0; t < gluings.tetrahedron_count(); ++t)
        for (std::uint8_t place = 0; place < 6; ++place)
          for (std::uint8_t choice = 0; choice < 2; ++choice) {
            const Move move{.kind = kind, .tetrahedron = t, .place = place, .choice = choice};
            const MoveRefusal reason = refusal(gluings, move);
            if (reason == MoveRefusal::kNoSuchPlace) continue;
            ASSERT_EQ(m.refusal(move), reason) << to_string(move);
            if (reason != MoveRefusal::kNone) continue;
            Gluings plain = gluings;
            apply(plain, move);
            m.begin_trial();
            m.apply(move);
            ASSERT_EQ(isosig(m.compacted()), isosig(plain)) << to_string(move);
            expect_consistent(m);
            if (HasFatalFailure()) return;
            m.undo_trial();
            ASSERT_EQ(m.compacted(), gluings);
            expect_consistent(m);
          }
  });
}

// Long random runs of moves and collapses, with trials that are undone in between.
TEST_P(CollapseLists, RandomRunsKeepTheManifoldAndTheLabels) {
  int made = 0;
  for_each_shaken(5, 8, [&](const Gluings& gluings, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    const ManifoldInvariants before{Triangulation(gluings)};
    MutableTriangulation m{Triangulation(gluings)};
    EdgeCollapse collapse(m);
    std::ptrdiff_t finite = 0;
    const auto step = [&] {
      const auto t = static_cast<TetrahedronIndex>(engine() % m.slot_count());
      if (!m.is_live(t)) return;
      const auto place = static_cast<std::uint8_t>(engine() % 6);
      if (engine() % 3 == 0) {
        const bool collapsed = collapse.try_apply(t, place) == CollapseRefusal::kNone;
        finite -= collapsed;
        made += collapsed;
        return;
      }
      const MoveInfo& line = move_table()[engine() % move_table().size()];
      const bool grows = line.tetrahedra > 0;
      const auto choice = static_cast<std::uint8_t>(line.choice_name.empty() ? 0 : engine() % 2);
      if (grows && m.tetrahedron_count() > 10) return;
      const auto places = line.place == MovePlace::kEdge          ? 6
                          : line.place == MovePlace::kTetrahedron ? 1
                                                                  : 4;
      if (m.try_apply({.kind = line.kind,
                       .tetrahedron = t,
                       .place = static_cast<std::uint8_t>(place % places),
                       .choice = choice})) {
        finite += line.finite_vertices;
        ++made;
      }
    };
    for (int run = 0; run < 12; ++run) {
      for (int i = 0; i < 100; ++i) step();
      const Gluings table = m.compacted();
      const std::ptrdiff_t count = finite;
      m.begin_trial();
      for (int i = 0; i < 50; ++i) step();
      if (run % 2 == 0) {
        m.undo_trial();
        finite = count;
        ASSERT_EQ(m.compacted(), table);
      } else {
        m.keep_trial();
      }
      expect_consistent(m);
      if (HasFatalFailure()) return;
    }
    expect_kept(before, ManifoldInvariants(Triangulation(m.compacted())), finite);
  });
  EXPECT_GT(made, 500);
}

INSTANTIATE_TEST_SUITE_P(Data, CollapseLists,
                         ::testing::Values(CollapseList{"", 1},
                                           CollapseList{"triangulations-2.txt", 1},
                                           CollapseList{"triangulations-3.txt", 1},
                                           CollapseList{"triangulations-4.txt", 40},
                                           CollapseList{"triangulations-cusped.txt", 1}));

}  // namespace
}  // namespace tripus::topology
