// Every compact manifold with up to four tetrahedra: the published counts, cells and signatures.
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "canonical/census.hpp"
#include "tests/support/data_files.hpp"
#include "topology/enumerate.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

/// All lists classified, once for the whole program. One move is enough to find the metric wherever
/// the search is known to find it, so that the budget is small.
const std::vector<CensusLine>& all_lines() {
  static const std::vector<CensusLine> kLines = [] {
    std::vector<std::string> list;
    for (const char* file :
         {"triangulations-2.txt", "triangulations-3.txt", "triangulations-4.txt"})
      for (const auto& signature : testing::data_lines(file)) list.push_back(signature);
    ClassifyOptions options;
    options.canonize.retriangulation.budget = 2;
    return classify(list, options);
  }();
  return kLines;
}

const Census& whole_census() {
  static const Census kCensus = make_census(all_lines(), CensusNames::kNumbered);
  return kCensus;
}

TEST(Census, HasExactlyThePublishedNumbersOfManifolds) {
  std::map<std::string, std::size_t> found;
  for (const CensusEntry& entry : whole_census().manifolds)
    ++found[std::to_string(entry.tetrahedra) + " " + entry.boundary];
  std::map<std::string, std::size_t> published;
  for (const auto& row : testing::data_table("published-counts.tsv"))
    if (row.at("boundary").find('T') == std::string::npos)
      published[row.at("n") + " " + row.at("boundary")] = std::stoul(row.at("manifolds"));
  EXPECT_EQ(found, published);
}

// As counted independently before this code was written.
TEST(Census, HasTheKnownCells) {
  std::map<std::string, std::size_t> found;
  for (const CensusEntry& entry : whole_census().manifolds)
    ++found[std::to_string(entry.tetrahedra) + " " + entry.boundary + " " + entry.cells];
  const std::map<std::string, std::size_t> expected{
      {"2 g2 2 tetrahedra", 8},  {"3 g3 3 tetrahedra", 74},   {"3 g2 3 tetrahedra", 73},
      {"3 g2 4 tetrahedra", 3},  {"4 g4 4 tetrahedra", 2340}, {"4 g3 4 tetrahedra", 1936},
      {"4 g3 5 tetrahedra", 42}, {"4 g3 1 octahedron", 56},   {"4 g2 4 tetrahedra", 555},
      {"4 g2 5 tetrahedra", 41}, {"4 g2 6 tetrahedra", 3},    {"4 g2 8 tetrahedra", 3},
      {"4 g2 1 octahedron", 22}, {"4 g2 2 pyramids", 4},
  };
  EXPECT_EQ(found, expected);
}

TEST(Census, TriangulationsWithoutAMetricBelongToManifoldsThatHaveOneElsewhere) {
  std::set<std::string> own;
  std::size_t own_metric = 0, moved = 0, unresolved = 0;
  for (const CensusLine& line : all_lines()) {
    if (line.resolved && line.own_metric) own.insert(line.entry.signature);
    own_metric += line.own_metric;
    moved += line.resolved && !line.own_metric;
    unresolved += !line.resolved;
    EXPECT_TRUE(line.reason.empty()) << line.triangulation << ": " << line.reason;
  }
  for (const CensusLine& line : all_lines()) {
    if (line.resolved) {
      EXPECT_TRUE(own.contains(line.entry.signature)) << line.triangulation;
    }
  }
  // Of the 11,048 with four tetrahedra: 5,820 and 387 and 4,841.
  EXPECT_EQ(own_metric, 8u + 166u + 5820u);
  EXPECT_EQ(own_metric + moved + unresolved, 8u + 240u + 11048u);
  EXPECT_EQ(unresolved, whole_census().unresolved.size());
  EXPECT_GE(moved, 387u);
  RecordProperty("moved", static_cast<int>(moved));
  RecordProperty("unresolved", static_cast<int>(unresolved));
}

TEST(Census, SignaturesAreTheCanonicalTriangulationsOfTheTable) {
  std::map<std::string, const CensusEntry*> by_triangulation;
  for (const CensusEntry& entry : whole_census().manifolds)
    for (const auto& isosig : entry.triangulations) by_triangulation[isosig] = &entry;
  for (const auto& row : testing::compact_manifolds()) {
    SCOPED_TRACE(row.at("isosig"));
    const CensusEntry* entry = by_triangulation.at(row.at("isosig"));
    EXPECT_TRUE(topology::is_isomorphic(topology::decode_isosig(entry->signature),
                                        topology::decode_isosig(row.at("canonical_isosig"))));
    EXPECT_NEAR(entry->volume, std::stod(row.at("volume")), 1e-12);
    EXPECT_EQ(entry->homology, row.at("H1"));
    EXPECT_EQ(entry->boundary, row.at("boundary"));
    EXPECT_EQ(std::to_string(entry->tetrahedra), row.at("n_tets"));
  }
}

/// Those with cusps: SnapPy's, those with geodesic boundary too, and the other triangulations that
/// the table lists.
TEST(Census, TheShippedCuspedOnesAreWhatTheListsGive) {
  std::vector<std::string> list = testing::data_lines("triangulations-cusped.txt");
  for (const auto& row : testing::data_table("cusped-census-5.tsv"))
    if (std::stoul(row.at("tetrahedra")) <= 4) list.push_back(row.at("isosig"));
  const auto& shipped = shipped_census().manifolds;
  const auto first = std::ranges::find_if(shipped, [](const CensusEntry& entry) {
    return entry.boundary.find_first_of("TK") != std::string::npos;
  });
  for (auto entry = first; entry != shipped.end(); ++entry)
    for (const std::string& isosig : entry->triangulations) list.push_back(isosig);
  std::ranges::sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end());
  const Census made = make_census(classify(list), CensusNames::kNumbered);
  ASSERT_EQ(static_cast<std::size_t>(shipped.end() - first), made.manifolds.size());
  std::map<std::string, std::size_t> found;
  for (std::size_t k = 0; k < made.manifolds.size(); ++k) {
    const CensusEntry &a = first[static_cast<std::ptrdiff_t>(k)], &b = made.manifolds[k];
    SCOPED_TRACE(b.name);
    // The table has proved digits (canonical_proofs.cpp); what is computed here has curvatures up
    // to 1e-12, which shift a volume by that times the sum of the lengths.
    EXPECT_NEAR(a.volume, b.volume, 1e-11);
    CensusEntry same = b;
    same.volume = a.volume;
    EXPECT_EQ(a, same);
    if (a.boundary.starts_with('g')) ++found[std::to_string(a.tetrahedra) + " " + a.boundary];
  }
  std::map<std::string, std::size_t> published;
  for (const auto& row : testing::data_table("published-counts.tsv"))
    if (row.at("boundary").find('T') != std::string::npos)
      published[row.at("n") + " " + row.at("boundary")] = std::stoul(row.at("manifolds"));
  EXPECT_EQ(found, published);
  EXPECT_EQ(made.manifolds.size(), 103u + 1 + 12 + 18 + 1);  // 103 of SnapPy's
}

// SnapPy's census of those that are not orientable has no more and no less than all triangulations
// with tori and Klein bottles give.
TEST(Census, CuspedOnesThatAreNotOrientableAreThoseOfSnapPy) {
  std::vector<std::string> list, known;
  for (const std::size_t tetrahedra : {1u, 2u, 3u, 4u}) {
    const topology::EnumerationChoice choice(topology::LinkChoice::kCusped,
                                             topology::Orientability::kNonOrientable);
    for (const auto& piece : topology::enumeration_pieces(tetrahedra, choice))
      topology::enumerate(tetrahedra, choice, piece,
                          [&](const topology::Gluings& gluings, unsigned) {
                            list.push_back(topology::isosig(gluings));
                          });
  }
  for (const auto& row : testing::data_table("cusped-census-5.tsv"))
    if (row.at("orientable") == "no" && std::stoul(row.at("tetrahedra")) <= 4)
      known.push_back(row.at("isosig"));
  ClassifyOptions options;
  options.canonize.retriangulation.budget = 2;
  const Census made = make_census(classify(list, options), CensusNames::kNumbered);
  const Census snappys = make_census(classify(known), CensusNames::kNumbered);
  std::set<std::string> found, expected;
  std::map<std::size_t, int> by_tetrahedra;
  for (const CensusEntry& entry : made.manifolds) {
    found.insert(entry.signature);
    ++by_tetrahedra[entry.tetrahedra];
  }
  for (const CensusEntry& entry : snappys.manifolds) expected.insert(entry.signature);
  EXPECT_EQ(found, expected);
  EXPECT_EQ(by_tetrahedra, (std::map<std::size_t, int>{{1, 1}, {2, 2}, {3, 7}, {4, 26}}));
  EXPECT_GT(list.size(), 1000u);
}

TEST(Census, TheShippedOneIsWhatTheListsGive) {
  const Census& shipped = shipped_census();
  const Census& made = whole_census();
  ASSERT_EQ(shipped.manifolds.size(), made.manifolds.size() + 135);
  for (std::size_t k = 0; k < made.manifolds.size(); ++k) {
    const CensusEntry &a = shipped.manifolds[k], &b = made.manifolds[k];
    SCOPED_TRACE(b.name);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.signature, b.signature);
    EXPECT_EQ(a.triangulations, b.triangulations);
    EXPECT_EQ(a.homology, b.homology);
    EXPECT_EQ(a.cells, b.cells);
    EXPECT_EQ(a.keeping, b.keeping);
    EXPECT_EQ(a.reversing, b.reversing);
    EXPECT_NEAR(a.volume, b.volume, 1e-12);
  }
  EXPECT_EQ(shipped.unresolved, made.unresolved);
}

// Signatures decode to triangulations of the manifold: canonizing them gives them back.
TEST(Signatures, DecodeToTheManifold) {
  for (const CensusEntry& entry : whole_census().manifolds) {
    if (entry.tetrahedra == 4 && entry.cells == "4 tetrahedra") continue;
    SCOPED_TRACE(entry.signature);
    const topology::Triangulation decoded(topology::decode_isosig(entry.signature));
    const CanonizeAnswer answer = canonize(decoded);
    ASSERT_TRUE(answer.manifold);
    EXPECT_EQ(answer.report.outcome, structure::Outcome::kGeometric);
    // A larger one may be simplified first, and the moves lead back.
    EXPECT_TRUE(answer.manifold->path.empty() || !answer.manifold->simplified.empty());
    EXPECT_EQ(answer.manifold->signature.unoriented, entry.signature);
    EXPECT_EQ(answer.manifold->cells, entry.cells);
    // The sign is that of the decoded triangulation by definition.
    if (!answer.manifold->isometries.is_amphicheiral) {
      EXPECT_EQ(answer.manifold->signature.oriented, entry.signature + "+");
    }
  }
}

}  // namespace
}  // namespace tripus::canonical
