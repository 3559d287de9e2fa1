// Canonical decompositions with cusps: SnapPy's symmetry groups and signatures, published counts.
#include <map>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "canonical/canonize.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/frigerio.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

using topology::Triangulation;

CanonizeAnswer canonized(const std::string& isosig) {
  CanonizeOptions options;
  options.solve.evidence = false;
  return canonize(Triangulation(topology::decode_isosig(isosig)), options);
}

std::size_t tetrahedron_cells(const CanonicalManifold& manifold) {
  const Decomposition& cells = manifold.decomposition;
  for (std::size_t c = 0; c < cells.cell_count(); ++c)
    if (cell_type(cells, c).name != "tetrahedron") return 0;
  return cells.cell_count();
}

// Cusps only, with several cusps also: of one volume, as SnapPy has them.
TEST(CanonicalCusps, SymmetriesAndSignaturesOfSnapPysCensus) {
  std::map<std::string, std::string> isosig;
  for (const auto& row : testing::data_table("cusped-census-5.tsv"))
    isosig[row.at("name")] = row.at("isosig");
  std::set<std::string> signatures;
  const auto rows = testing::data_table("cusped-symmetries-5.tsv");
  ASSERT_EQ(rows.size(), 415u);
  for (const auto& row : rows) {
    SCOPED_TRACE(row.at("name") + " " + isosig.at(row.at("name")));
    const CanonizeAnswer answer = canonized(isosig.at(row.at("name")));
    ASSERT_TRUE(answer.manifold) << answer.message;
    const CanonicalManifold& manifold = *answer.manifold;
    EXPECT_EQ(std::to_string(manifold.isometries.order), row.at("symmetries"));
    EXPECT_EQ(manifold.decomposition.is_orientable(), row.at("amphicheiral") != "-");
    EXPECT_EQ(manifold.isometries.is_amphicheiral, row.at("amphicheiral") == "yes");
    EXPECT_EQ(tetrahedron_cells(manifold) != 0, row.at("signature") != "-") << manifold.cells;
    if (row.at("signature") != "-") {
      EXPECT_EQ(manifold.signature.unoriented, row.at("signature"));
    }
    // No two manifolds of the census are one.
    EXPECT_TRUE(signatures.insert(manifold.signature.unoriented).second);
  }
  EXPECT_EQ(signatures.size(), rows.size());
}

// Their triangulations are canonical, for any genus (arXiv math/0301114).
TEST(CanonicalCusps, CellsOfFrigerioMartelliPetronio) {
  std::mt19937_64 random(20261130);
  for (const auto& row : testing::data_table("volumes-mgk.tsv")) {
    const auto g = std::stoul(row.at("g")), k = std::stoul(row.at("k"));
    if (g == k && g % 2 == 1) continue;
    const Triangulation m = testing::random_frigerio(g, k, random);
    const std::string isosig = topology::isosig(m.gluings());
    SCOPED_TRACE(isosig);
    const CanonizeAnswer answer = canonized(isosig);
    ASSERT_TRUE(answer.manifold) << answer.message;
    EXPECT_EQ(answer.manifold->signature.unoriented, isosig);
    EXPECT_EQ(tetrahedron_cells(*answer.manifold), m.tetrahedron_count());
  }
}

// Geodesic boundary and cusps: arXiv math/0211425 counts 1 manifold with three tetrahedra, and
// 12 + 18 + 1 with four and no fewer.
TEST(CanonicalCusps, PublishedCounts) {
  using Boundary = std::pair<int, int>;  // genus of the geodesic boundary, number of cusps
  std::map<std::size_t, std::map<Boundary, std::set<std::string>>> found;
  for (const std::string& isosig : testing::data_lines("triangulations-cusped.txt")) {
    SCOPED_TRACE(isosig);
    const CanonizeAnswer answer = canonized(isosig);
    if (!answer.manifold) continue;
    const Triangulation triangulation(topology::decode_isosig(isosig));
    Boundary boundary{0, 0};
    for (std::size_t v = 0; v < triangulation.vertex_count(); ++v) {
      const int genus = triangulation.link(v).genus();
      (genus == 1 ? boundary.second : boundary.first) += genus;
    }
    found[triangulation.tetrahedron_count()][boundary].insert(
        answer.manifold->signature.unoriented);
    // M_{g,k}, of g + k tetrahedra: that triangulation is canonical (arXiv math/0301114).
    if (static_cast<std::size_t>(boundary.first + boundary.second) ==
        triangulation.tetrahedron_count()) {
      EXPECT_EQ(answer.manifold->signature.unoriented, isosig);
      EXPECT_EQ(tetrahedron_cells(*answer.manifold), triangulation.tetrahedron_count());
    }
  }
  // What has three tetrahedra is met again with four.
  for (auto& [boundary, signatures] : found[4])
    for (const std::string& known : found[3][boundary]) signatures.erase(known);
  std::map<std::pair<std::string, std::string>, std::size_t> counted;
  for (const auto& [tetrahedra, by_boundary] : found) {
    for (const auto& [boundary, signatures] : by_boundary) {
      std::string name = "g" + std::to_string(boundary.first);
      for (int cusp = 0; cusp < boundary.second; ++cusp) name += "+T";
      if (!signatures.empty()) counted[{std::to_string(tetrahedra), name}] = signatures.size();
    }
  }
  std::map<std::pair<std::string, std::string>, std::size_t> published;
  for (const auto& row : testing::data_table("published-counts.tsv"))
    if (row.at("boundary").find('T') != std::string::npos)
      published[{row.at("n"), row.at("boundary")}] = std::stoul(row.at("manifolds"));
  EXPECT_EQ(counted, published);
}

}  // namespace
}  // namespace tripus::canonical
