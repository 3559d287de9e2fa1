// Reidemeister moves and IH-moves: the exterior of the handlebody does not change.
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "canonical/canonize.hpp"
#include "topology/covers/cover_homology.hpp"
#include "topology/diagrams/exterior.hpp"
#include "topology/diagrams/moves.hpp"
#include "topology/diagrams/read_diagram.hpp"
#include "topology/diagrams/small_exterior.hpp"
#include "topology/diagrams/tables.hpp"
#include "topology/diagrams/wirtinger.hpp"

namespace tripus::topology {
namespace {

/// What tells manifolds apart, from the Wirtinger presentation alone: homology of the covers with
/// one, two and three sheets.
std::vector<CoverHomology> invariants(const Diagram& diagram) {
  const ReducedPresentation few = reduced(wirtinger_group(diagram).presentation);
  std::vector<CoverHomology> all(3);
  for (std::size_t degree = 1; degree <= 3; ++degree)
    for_each_transitive_action(few.presentation, degree, [&](const TransitiveAction& action) {
      ++all[degree - 1][to_string(first_homology(few.presentation, action))];
      return true;
    });
  return all;
}

/// The first place at which the move can be made.
std::optional<Diagram> moved(const Diagram& diagram, DiagramMove move, bool over = true) {
  for (Dart at = 0; at < diagram.dart_count(); ++at)
    for (Dart other = 0; other < diagram.dart_count(); ++other) {
      DiagramEditor editor(diagram);
      if (try_move(editor, move, at, other, over)) return editor.finished();
    }
  return std::nullopt;
}

TEST(DiagramMoves, ThoseThatAddCrossingsAreUndoneByTheirInverses) {
  const Diagram start = find_diagram("5_1 theta")->diagram;
  for (const auto& [move, inverse] : {std::pair(DiagramMove::kKink, DiagramMove::kUnkink),
                                      std::pair(DiagramMove::kPush, DiagramMove::kPull),
                                      std::pair(DiagramMove::kTwist, DiagramMove::kUntwist),
                                      std::pair(DiagramMove::kSurround, DiagramMove::kRelease)})
    for (const bool over : {false, true}) {
      SCOPED_TRACE(std::string(to_string(move)) + (over ? " over" : " under"));
      const auto larger = moved(start, move, over);
      ASSERT_TRUE(larger);
      const std::size_t more = move == DiagramMove::kPush       ? 2
                               : move == DiagramMove::kSurround ? 3
                                                                : 1;
      EXPECT_EQ(larger->crossing_count(), start.crossing_count() + more);
      EXPECT_EQ(invariants(*larger), invariants(start));
      const auto back = moved(*larger, inverse);
      ASSERT_TRUE(back);
      EXPECT_EQ(back->crossing_count(), start.crossing_count());
      EXPECT_EQ(invariants(*back), invariants(start));
    }
}

TEST(DiagramMoves, AStandardTrefoilHasNoPlaceForWhatWouldChangeIt) {
  const Diagram trefoil = find_diagram("3_1")->diagram;
  for (const DiagramMove move :
       {DiagramMove::kUnkink, DiagramMove::kPull, DiagramMove::kSlide, DiagramMove::kSurround,
        DiagramMove::kRelease, DiagramMove::kTwist, DiagramMove::kUntwist, DiagramMove::kIh})
    EXPECT_FALSE(moved(trefoil, move)) << to_string(move);
}

TEST(DiagramMoves, AStrandSlidesAcrossACrossingAndBack) {
  // The braid relation 1 2 1 = 2 1 2, closed up with one letter more.
  const Diagram start = read_diagram("Braid: 1 2 1 2 2").diagram;
  const auto once = moved(start, DiagramMove::kSlide);
  ASSERT_TRUE(once);
  EXPECT_EQ(once->crossing_count(), start.crossing_count());
  EXPECT_EQ(invariants(*once), invariants(start));
}

TEST(DiagramMoves, IhTurnsATrivialThetaIntoATrivialHandcuff) {
  const auto handcuff = moved(find_diagram("0_1 theta")->diagram, DiagramMove::kIh);
  ASSERT_TRUE(handcuff);
  std::size_t loops = 0;
  for (Dart d = 0; d < handcuff->dart_count(); ++d)
    loops += handcuff->node(d) == handcuff->node(handcuff->mate(d));
  EXPECT_EQ(loops, 4u);  // two loops, two ends each
}

/// The signature of the canonical decomposition with its orientation; empty if none was found.
std::string canonical_signature(const Diagram& diagram) {
  const auto answer =
      canonical::canonize(Triangulation(small_exterior({.name = {}, .diagram = diagram}).gluings));
  return answer.manifold ? answer.manifold->signature.oriented : "";
}

// 1,000 sequences of 60 moves on knots, links, theta curves and handlebody-knots. For those that
// are hyperbolic the manifolds are the same, orientation included, and those of the mirror images
// are the mirror's.
TEST(DiagramMoves, AThousandRandomSequencesKeepTheExterior) {
  std::map<DiagramMove, std::size_t> made;
  std::uint64_t seed = 1;
  std::size_t hyperbolic = 0;
  for (const char* name : {"4_1", "L5a1", "5_1 theta", "2_1 handcuff", "hk5_3"}) {
    const Diagram start = find_diagram(name)->diagram;
    const auto expected = invariants(start);
    const std::string signature = canonical_signature(start);
    const std::string mirrored = canonical_signature(start.mirror_image());
    for (int sequence = 0; sequence < 200; ++sequence, ++seed) {
      SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
      const MovedDiagram end =
          random_moves(start, {.count = 60, .seed = seed, .max_crossings = 14});
      for (const DiagramMove move : kDiagramMoves) made[move] += end.made[std::size_t(move)];
      ASSERT_EQ(invariants(end.diagram), expected);
      ASSERT_EQ(first_homology(Triangulation(exterior(end.diagram).gluings)),
                first_homology(Triangulation(exterior(start).gluings)));
      if (signature.empty()) continue;
      ++hyperbolic;
      ASSERT_EQ(canonical_signature(end.diagram), signature);
      if (sequence % 4 == 0) {
        ASSERT_EQ(canonical_signature(end.diagram.mirror_image()), mirrored);
      }
    }
  }
  EXPECT_EQ(hyperbolic, 800u);
  for (const DiagramMove move : kDiagramMoves) EXPECT_GT(made[move], 100u) << to_string(move);
}

TEST(DiagramMoves, TheSameSeedGivesTheSameDiagram) {
  const Diagram start = find_diagram("hk4_1")->diagram;
  EXPECT_EQ(random_moves(start, {.seed = 7}).diagram, random_moves(start, {.seed = 7}).diagram);
}

}  // namespace
}  // namespace tripus::topology
