#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/data_folder.hpp"
#include "tests/support/manifold_invariants.hpp"
#include "tests/support/triangulations.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"

// Laws M1 to M5 of topology/README.md over the listed triangulations.

namespace tripus::topology {
namespace {

using testing::expect_kept;
using testing::ManifoldInvariants;

std::vector<std::string> signatures(const std::string& file, std::size_t stride) {
  std::ifstream in(testing::data_folder() + "/" + file);
  std::vector<std::string> found;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line[0] != '#' && number++ % stride == 0) found.push_back(line);
  return found;
}

/// The change accounts for every number, and faces between tetrahedra that stay are glued as they
/// were, or cut open for new ones.
void expect_told(const Gluings& before, const Gluings& after, const MoveChange& change) {
  std::vector<TetrahedronIndex> number(before.tetrahedron_count());
  std::iota(number.begin(), number.end(), TetrahedronIndex{0});
  for (const auto& [from, to] : change.renumbered) number.at(from) = to;
  for (const TetrahedronIndex t : change.removed) number.at(t) = kNoTetrahedron;
  std::vector<TetrahedronIndex> all(change.added.begin(), change.added.end());
  std::ranges::copy_if(number, std::back_inserter(all),
                       [](TetrahedronIndex t) { return t != kNoTetrahedron; });
  std::ranges::sort(all);
  ASSERT_EQ(all.size(), after.tetrahedron_count());
  for (std::size_t t = 0; t < all.size(); ++t) ASSERT_EQ(all[t], t);
  for (std::size_t t = 0; t < number.size(); ++t)
    for (int f = 0; f < 4 && number[t] != kNoTetrahedron; ++f) {
      const TetrahedronIndex behind = number[before.neighbour(t, f)];
      const TetrahedronIndex now = after.neighbour(number[t], f);
      if (behind == kNoTetrahedron || std::ranges::count(change.added, now) > 0) continue;
      ASSERT_EQ(now, behind);
      ASSERT_EQ(after.gluing(number[t], f), before.gluing(t, f));
    }
}

/// Whether some move of the inverse kind brings the signature back.
bool is_undone(const Gluings& gluings, MoveKind inverse, const std::string& signature) {
  for (const Move& move : all_moves(Triangulation(gluings), std::array{inverse})) {
    Gluings undone = gluings;
    apply(undone, move);
    if (isosig(undone) == signature) return true;
  }
  return false;
}

void check_every_move(const Gluings& gluings, bool search_for_inverses) {
  const Triangulation triangulation(gluings);
  const ManifoldInvariants before(triangulation);
  const std::string signature = isosig(gluings);
  for (const Move& move : all_moves(triangulation, testing::every_kind_of_move())) {
    SCOPED_TRACE(signature + ": " + to_string(move));
    const MoveInfo& line = info(move.kind);
    Gluings moved = gluings;
    const MoveChange change = apply(moved, move);
    ASSERT_EQ(static_cast<std::ptrdiff_t>(moved.tetrahedron_count()),
              static_cast<std::ptrdiff_t>(gluings.tetrahedron_count()) + line.tetrahedra);
    expect_told(gluings, moved, change);
    ASSERT_NO_THROW(
        expect_kept(before, ManifoldInvariants(Triangulation(moved)), line.finite_vertices));
    if (::testing::Test::HasFatalFailure()) return;
    if (change.inverse) {
      ASSERT_EQ(change.inverse->kind, line.inverse);
      Gluings undone = moved;
      apply(undone, *change.inverse);
      ASSERT_EQ(isosig(undone), signature);
    } else if (search_for_inverses) {
      ASSERT_TRUE(is_undone(moved, line.inverse, signature));
    }
  }
}

struct ThinnedList {
  const char* file;
  std::size_t stride;
};

class MoveLists : public ::testing::TestWithParam<ThinnedList> {};

TEST_P(MoveLists, EveryLegalMoveKeepsTheManifoldAndIsUndone) {
  const auto list = signatures(GetParam().file, GetParam().stride);
  ASSERT_FALSE(list.empty());
  for (const std::string& signature : list) {
    check_every_move(decode_isosig(signature), true);
    if (HasFatalFailure()) return;
  }
}

// Away from the lists: edges of every small valence, finite vertices, many faces of one
// tetrahedron glued to each other.
TEST_P(MoveLists, RandomWalksKeepTheManifold) {
  const auto list = signatures(GetParam().file, GetParam().stride);
  const auto kinds = testing::every_kind_of_move();
  std::uint64_t seed = 1;
  for (const std::string& signature : list) {
    SCOPED_TRACE(signature + ", seed " + std::to_string(seed));
    Gluings gluings = decode_isosig(signature);
    const ManifoldInvariants before{Triangulation(gluings)};
    const auto made =
        randomize(gluings, {.count = 30, .seed = seed++, .kinds = kinds, .max_tetrahedra = 9});
    ASSERT_EQ(made.size(), 30u);
    int finite_vertices = 0;
    for (const Move& move : made) finite_vertices += info(move.kind).finite_vertices;
    expect_kept(before, ManifoldInvariants(Triangulation(gluings)), finite_vertices);
    if (HasFatalFailure()) return;
  }
}

TEST_P(MoveLists, EveryLegalMoveAfterAWalkKeepsTheManifold) {
  const auto list = signatures(GetParam().file, 10 * GetParam().stride);
  const auto kinds = testing::every_kind_of_move();
  std::uint64_t seed = 1;
  for (const std::string& signature : list) {
    Gluings gluings = decode_isosig(signature);
    randomize(gluings, {.count = 20, .seed = seed++, .kinds = kinds, .max_tetrahedra = 7});
    check_every_move(gluings, true);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Data, MoveLists,
                         ::testing::Values(ThinnedList{"triangulations-2.txt", 1},
                                           ThinnedList{"triangulations-3.txt", 1},
                                           ThinnedList{"triangulations-4.txt", 22},
                                           ThinnedList{"triangulations-cusped.txt", 1}));

}  // namespace
}  // namespace tripus::topology
