// Proved canonical decompositions: tilt sums below 0 by enclosures, 0 by exact arithmetic.
#include <cstdio>

#include <gtest/gtest.h>

#include "canonical/census.hpp"
#include "canonical/census_proofs.hpp"
#include "canonical/proved.hpp"
#include "tests/support/data_files.hpp"
#include "topology/isomorphism.hpp"
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

std::size_t transparent_faces(const CanonicalManifold& manifold) {
  std::size_t sides = 0;
  for (const auto& faces : manifold.faces.kind)
    for (const FaceKind kind : faces) sides += kind == FaceKind::kTransparent;
  return sides / 2;
}

/// The checker reads what is written down, and agrees.
void expect_valid(const CanonicalManifold& manifold, const CanonicalProof& proof) {
  const auto text = structure::parse_canonical_proof(to_json(proof_text(proof)));
  EXPECT_EQ(to_json(text), to_json(proof_text(proof)));
  const auto check =
      structure::check_canonical_proof(manifold.triangulation, manifold.cone_angles, text);
  EXPECT_TRUE(check) << check.reason;
}

/// Every face is settled, and the transparent ones are those that lie inside cells.
void expect_proved(const CanonicalManifold& manifold, const std::string& name) {
  SCOPED_TRACE(name);
  const CanonicalProof proof = prove_canonical(manifold);
  EXPECT_TRUE(proof.metric.proved) << proof.metric.reason;
  EXPECT_TRUE(proof.proved) << proof.reason;
  EXPECT_TRUE(proof.unproved.empty());
  EXPECT_EQ(proof.inside.size(), transparent_faces(manifold));
  if (!proof.inside.empty()) {
    EXPECT_TRUE(proof.field);
  }
  expect_valid(manifold, proof);
}

TEST(CanonicalProofs, CoverDecompositionsIntoTetrahedra) {
  std::size_t tetrahedra = 0;
  for_each_manifold(37, [&](const CensusEntry& entry) {
    const CanonicalManifold manifold = canonized(entry.triangulations.front());
    expect_proved(manifold, entry.name);
    tetrahedra += transparent_faces(manifold) == 0;
  });
  EXPECT_GT(tetrahedra, 50u);
}

// All manifolds of the census with cells that are no tetrahedra, compact and with cusps.
TEST(CanonicalProofs, CoverAllOtherDecompositionsOfTheCensus) {
  std::size_t compact = 0, cusped = 0;
  for_each_manifold(1, [&](const CensusEntry& entry) {
    if (entry.cells.ends_with("tetrahedra") || entry.cells == "1 tetrahedron") return;
    expect_proved(canonized(entry.triangulations.front()), entry.name + ": " + entry.cells);
    ++(entry.boundary.find_first_of("TK") == std::string::npos ? compact : cusped);
  });
  EXPECT_EQ(compact, 82u);
  EXPECT_EQ(cusped, 6u);
}

// SnapPy's cusped census, and cusps beside geodesic boundary.
TEST(CanonicalProofs, CoverAllDecompositionsWithCusps) {
  std::vector<std::string> signatures = testing::data_lines("triangulations-cusped.txt");
  for (const auto& row : testing::data_table("cusped-census-5.tsv"))
    if (row.at("tetrahedra") != "5") signatures.push_back(row.at("isosig"));
  std::size_t all = 0, larger_cells = 0, several_cusps = 0;
  for (const std::string& signature : signatures) {
    const auto answer = canonize(topology::Triangulation(topology::decode_isosig(signature)));
    if (!answer.manifold) continue;
    expect_proved(*answer.manifold, signature);
    ++all;
    larger_cells += transparent_faces(*answer.manifold) > 0;
    several_cusps += answer.manifold->triangulation.vertex_count() > 1;
  }
  std::printf("%zu proved, %zu with larger cells, %zu with several links\n", all, larger_cells,
              several_cusps);
  EXPECT_EQ(all, 144u);
  EXPECT_EQ(larger_cells, 10u);
  EXPECT_GT(several_cusps, 5u);
}

// Without exact arithmetic the faces inside cells are left over, and they are named.
TEST(CanonicalProofs, EnclosuresAloneProveNoZero) {
  for (const char* signature : {"eLAkbccddelben", "eLMkbbddddhape"}) {
    const CanonicalManifold manifold = canonized(signature);
    structure::Proof metric =
        structure::prove(manifold.triangulation, manifold.report.edge_lengths);
    const auto tilts = structure::tilt_signs(manifold.triangulation, metric, {.exact = false});
    std::size_t unknown = 0;
    for (const auto& faces : tilts.sign)
      for (const structure::ProvedSign sign : faces)
        unknown += sign == structure::ProvedSign::kUnknown;
    EXPECT_EQ(unknown, 2 * transparent_faces(manifold));
    EXPECT_FALSE(tilts.field);
    // A degree that is too small finds nothing either.
    EXPECT_FALSE(structure::tilt_signs(manifold.triangulation, metric, {.most_degree = 1}).field);
  }
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
  EXPECT_TRUE(proof.proved) << proof.reason;
  expect_valid(*answer.manifold, proof);
}

// Numbers of a proof are those of the signature that it names, whatever the input's labels are.
TEST(CanonicalProofs, HoldForTheLabelsOfTheSignature) {
  const topology::Gluings gluings = topology::decode_isosig("eLMkbbddddhahu");
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    const auto answer =
        canonize(topology::Triangulation(topology::random_relabelling(gluings, seed)));
    ASSERT_TRUE(answer.manifold);
    const CanonicalProof proof = prove_canonical(*answer.manifold);
    EXPECT_EQ(proof.triangulation, topology::isosig(answer.manifold->triangulation.gluings()));
    EXPECT_TRUE(proof.proved) << proof.reason;
    expect_valid(*answer.manifold, proof);
  }
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
