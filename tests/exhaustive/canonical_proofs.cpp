// Proved canonical decompositions: exactly those whose cells are tetrahedra.
#include <cstdio>

#include <gtest/gtest.h>

#include "canonical/census.hpp"
#include "canonical/census_proofs.hpp"
#include "canonical/proved.hpp"
#include "tests/support/data_files.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

CanonicalManifold canonized(const std::string& signature) {
  auto answer = canonize(topology::Triangulation(topology::decode_isosig(signature)));
  EXPECT_TRUE(answer.manifold) << signature;
  return std::move(*answer.manifold);
}

/// Every `step`th manifold of the census.
template <class Visit>
void for_each_manifold(std::size_t step, Visit visit) {
  const auto& manifolds = shipped_census().manifolds;
  for (std::size_t k = 0; k < manifolds.size(); k += step) visit(manifolds[k]);
}

TEST(CanonicalProofs, CoverAllDecompositionsIntoTetrahedra) {
  std::size_t tetrahedra = 0, others = 0;
  for_each_manifold(37, [&](const CensusEntry& entry) {
    const CanonicalManifold manifold = canonized(entry.triangulations.front());
    const CanonicalProof proof = prove_canonical(manifold);
    EXPECT_TRUE(proof.metric.proved) << entry.name;
    std::size_t transparent = 0;
    for (const auto& faces : manifold.faces.kind)
      for (const FaceKind kind : faces) transparent += kind == FaceKind::kTransparent;
    EXPECT_EQ(proof.proved, transparent == 0) << entry.name << ": " << proof.reason;
    // Faces are named once, from one side.
    EXPECT_EQ(2 * proof.unproved.size(), transparent) << entry.name;
    (transparent == 0 ? tetrahedra : others) += 1;
  });
  std::printf("%zu proved, %zu with larger cells\n", tetrahedra, others);
  EXPECT_GT(tetrahedra, 50u);
  EXPECT_GT(others, 0u);
}

// SnapPy's cusped census, and cusps beside geodesic boundary: the same rule.
TEST(CanonicalProofs, CoverDecompositionsIntoTetrahedraWithCusps) {
  std::vector<std::string> signatures = testing::data_lines("triangulations-cusped.txt");
  for (const auto& row : testing::data_table("cusped-census-5.tsv"))
    if (row.at("tetrahedra") != "5") signatures.push_back(row.at("isosig"));
  std::size_t tetrahedra = 0, others = 0, several_cusps = 0, bent_by_cusps = 0;
  for (const std::string& signature : signatures) {
    const auto answer = canonize(topology::Triangulation(topology::decode_isosig(signature)));
    if (!answer.manifold) continue;
    const CanonicalManifold& manifold = *answer.manifold;
    const CanonicalProof proof = prove_canonical(manifold);
    EXPECT_TRUE(proof.metric.proved) << signature << ": " << proof.metric.reason;
    std::size_t transparent = 0;
    for (const auto& faces : manifold.faces.kind)
      for (const FaceKind kind : faces) transparent += kind == FaceKind::kTransparent;
    // A face that only the horospheres bend is true, but 0 in its first term, which is not proved.
    EXPECT_GE(2 * proof.unproved.size(), transparent) << signature;
    EXPECT_EQ(proof.proved, proof.unproved.empty()) << signature;
    bent_by_cusps += 2 * proof.unproved.size() > transparent;
    (proof.proved ? tetrahedra : others) += 1;
    several_cusps += proof.proved && manifold.triangulation.vertex_count() > 1;
  }
  std::printf("%zu proved (%zu with several links), %zu with larger cells\n", tetrahedra,
              several_cusps, others);
  EXPECT_GT(tetrahedra, 50u);
  EXPECT_GT(others, 0u);
  EXPECT_GT(several_cusps, 5u);
  EXPECT_LE(bent_by_cusps, 2u);
}

TEST(CanonicalProofs, OfOrbifolds) {
  const topology::Triangulation m(topology::decode_isosig("cPcbbbiht"));
  const auto order = [](std::int64_t n) { return topology::ConeAngle::rational(2, n); };
  CanonizeOptions options;
  options.solve.cone_angles = {order(3), order(2)};
  const auto answer = canonize(m, options);
  ASSERT_TRUE(answer.manifold) << answer.message;
  const CanonicalProof proof = prove_canonical(*answer.manifold);
  EXPECT_TRUE(proof.metric.proved) << proof.metric.reason;
  EXPECT_EQ(proof.metric.cone_angles.size(), answer.manifold->triangulation.edge_count());
}

TEST(CanonicalProofs, DecideComparisons) {
  const auto verdict = [](const char* a, const char* b) {
    const Comparison comparison = compare(topology::Triangulation(topology::decode_isosig(a)),
                                          topology::Triangulation(topology::decode_isosig(b)));
    return std::pair(comparison.verdict, prove_comparison(comparison));
  };
  const auto [same, same_proof] = verdict("cPcbbbihq", "cPcbbbihq");
  EXPECT_EQ(same, Verdict::kHomeomorphic);
  EXPECT_TRUE(same_proof.proved) << same_proof.reason;
  const auto [different, different_proof] = verdict("cPcbbbihq", "cMcabbjds");
  EXPECT_EQ(different, Verdict::kDifferent);
  EXPECT_TRUE(different_proof.proved) << different_proof.reason;
  EXPECT_EQ(different_proof.by, "decomposition");
}

TEST(CanonicalProofs, OfTheCensusAreValidAndOnlyThen) {
  Census part;
  for_each_manifold(211, [&](const CensusEntry& entry) { part.manifolds.push_back(entry); });
  const CensusCheck check = check_census(part, shipped_census_proofs());
  EXPECT_EQ(check.valid, part.manifolds.size());
  EXPECT_TRUE(check.failures.empty());
  EXPECT_EQ(shipped_census_proofs().size(), shipped_census().manifolds.size());

  Census wrong = part;
  wrong.manifolds[0].volume += 1e-11;
  std::swap(wrong.manifolds[1].triangulations, wrong.manifolds[2].triangulations);
  wrong.manifolds[3].name = "t9g9.1";
  EXPECT_EQ(check_census(wrong, shipped_census_proofs()).failures.size(), 4u);
  EXPECT_EQ(to_tsv(parse_census_proofs(to_tsv(shipped_census_proofs()))),
            to_tsv(shipped_census_proofs()));
}

}  // namespace
}  // namespace tripus::canonical
