// Existence of strict angle structures, decided exactly for every triangulation of the lists.
#include <array>
#include <cstdlib>
#include <map>

#include <gtest/gtest.h>

#include "structure/angle_structure.hpp"
#include "structure/detail/angle_programme.hpp"
#include "structure/detail/existence_routes.hpp"
#include "structure/existence.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/triangulations.hpp"
#include "topology/cyclic_cover.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

std::string kind_of(const Existence& existence) {
  if (std::holds_alternative<StrictAngles>(existence)) return "strict";
  return std::string(to_string(std::get<Certificate>(existence).kind));
}
std::string kind_of(const std::optional<Existence>& existence) {
  return existence ? kind_of(*existence) : "undecided";
}

void expect_proof(const topology::Triangulation& triangulation, const Existence& existence) {
  const CheckResult result =
      std::visit([&](const auto& proof) { return check(triangulation, proof); }, existence);
  ASSERT_TRUE(result) << result.reason;
  if (const auto* certificate = std::get_if<Certificate>(&existence)) {
    ASSERT_EQ(parse_certificate(to_json(*certificate)), *certificate);
  }
}

struct Counts {
  int strict = 0, semi = 0, none = 0;
};

Counts count_certificates(const std::string& file) {
  std::map<std::string, int> counts;
  for (const auto& signature : testing::data_lines(file)) {
    SCOPED_TRACE(signature);
    const auto triangulation = testing::decode(signature);
    const Existence found = existence(triangulation);
    expect_proof(triangulation, found);
    ++counts[kind_of(found)];
  }
  return {counts["strict"], counts["semi"], counts["none"]};
}

// An earlier floating-point classification of all four lists together: 6,035 geometric and 14 flat
// minimisers with a strict structure; 213 + 1,463 with semi-angle structures only; 3,633 with none.
TEST(Lists, HaveTheCountsOfTheFloatingPointClassification) {
  const Counts two = count_certificates("triangulations-2.txt");
  const Counts three = count_certificates("triangulations-3.txt");
  const Counts four = count_certificates("triangulations-4.txt");
  const Counts cusped = count_certificates("triangulations-cusped.txt");
  EXPECT_EQ(two.strict, 8);
  EXPECT_EQ(three.strict, 166);
  EXPECT_EQ(three.semi, 24);
  EXPECT_EQ(three.none, 50);
  EXPECT_EQ(cusped.strict, 41);
  EXPECT_EQ(cusped.semi, 9);
  EXPECT_EQ(two.strict + three.strict + four.strict + cusped.strict, 6035 + 14);
  EXPECT_EQ(two.semi + three.semi + four.semi + cusped.semi, 213 + 1463);
  EXPECT_EQ(two.none + three.none + four.none + cusped.none, 3633);
}

// The margins were computed elsewhere in floating point; six decimals are listed.
void expect_margins(const std::string& file) {
  for (const auto& row : testing::data_table(file)) {
    SCOPED_TRACE(row.at("isosig"));
    const auto triangulation = testing::decode(row.at("isosig"));
    const double listed = std::strtod(row.at("angle_margin").c_str(), nullptr);
    EXPECT_NEAR(deepest_angle_structure(triangulation).margin, listed, 1e-5);
    EXPECT_EQ(kind_of(existence(triangulation)),
              listed > 1e-5 ? "strict" : (listed < -1e-5 ? "none" : "semi"));
  }
}
TEST(Tables, AgreeWithTheMarginAndTheKind) {
  expect_margins("nongeometric-3.tsv");
  expect_margins("boundary-case-4.tsv");
}

// Rounding, the rational linear algebra of the floating-point basis, and the rational simplex
// method find the same kind. (`existence` uses the first that succeeds.)
TEST(Routes, Agree) {
  const auto signatures = testing::data_lines("triangulations-4.txt");
  for (std::size_t k = 0; k < signatures.size(); k += 7) {
    SCOPED_TRACE(signatures[k]);
    const auto triangulation = testing::decode(signatures[k]);
    detail::AngleProgramme programme(triangulation);
    ASSERT_TRUE(programme.solve());
    const auto rounded = detail::by_rounding(triangulation, programme);
    const auto basis = detail::by_exact_basis(triangulation, programme);
    ASSERT_TRUE(programme.solve_exactly());
    const auto exact = detail::by_exact_basis(triangulation, programme);
    ASSERT_TRUE(basis && exact);
    expect_proof(triangulation, *basis);
    expect_proof(triangulation, *exact);
    ASSERT_EQ(kind_of(basis), kind_of(exact));
    if (rounded) {
      ASSERT_EQ(kind_of(rounded), kind_of(exact));
    }
  }
}

TEST(Routes, TheRationalSimplexMethodNeedsNoStart) {
  const auto signatures = testing::data_lines("triangulations-4.txt");
  for (std::size_t k = 0; k < signatures.size(); k += 97) {
    SCOPED_TRACE(signatures[k]);
    const auto triangulation = testing::decode(signatures[k]);
    detail::AngleProgramme programme(triangulation);
    ASSERT_TRUE(programme.solve_exactly());
    const auto exact = detail::by_exact_basis(triangulation, programme);
    ASSERT_EQ(kind_of(exact), kind_of(existence(triangulation)));
  }
}

/// The definition once more, for small entries.
bool holds(const topology::Triangulation& triangulation, const Certificate& certificate) {
  long r = 0;
  bool something = false, allowed = true;
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    for (int i = 0; i < 4; ++i) {
      const long wi = certificate.vertex[t][static_cast<std::size_t>(i)].get_si();
      r += wi;
      allowed = allowed && wi >= 0;
      something = something || wi > 0;
      for (int j = i + 1; j < 4; ++j) {
        const int e =
            topology::kEdgeNumber[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        const long a = wi + certificate.vertex[t][static_cast<std::size_t>(j)].get_si() -
                       certificate.edge[triangulation.edge_class(t, e)].get_si();
        allowed = allowed && a >= 0;
        something = something || a > 0;
      }
    }
  }
  for (const Integer& u : certificate.edge) r -= 2 * u.get_si();
  return allowed && (certificate.kind == Certificate::Kind::kNone ? r < 0 : r == 0 && something);
}

// Every entry, one up and one down. A changed "semi" is never one, and an edge multiplier is never
// too small by accident; the rest is judged by the definition.
TEST(TamperedCertificates, AreRejected) {
  const auto signatures = testing::data_lines("triangulations-4.txt");
  int rejected = 0;
  for (std::size_t k = 0; k < signatures.size(); k += 11) {
    SCOPED_TRACE(signatures[k]);
    const auto triangulation = testing::decode(signatures[k]);
    Existence found = existence(triangulation);
    auto* certificate = std::get_if<Certificate>(&found);
    if (certificate == nullptr) continue;
    const bool semi = certificate->kind == Certificate::Kind::kSemi;
    const auto try_both = [&](Integer& entry, bool is_edge) {
      for (const int change : {-1, 1}) {
        entry += change;
        const bool valid = check(triangulation, *certificate).valid;
        ASSERT_EQ(valid, holds(triangulation, *certificate));
        if (semi || (is_edge && change > 0)) {
          ASSERT_FALSE(valid);
        }
        rejected += !valid;
        entry -= change;
      }
    };
    for (Integer& u : certificate->edge) try_both(u, true);
    for (auto& four : certificate->vertex)
      for (Integer& w : four) try_both(w, false);

    Certificate other = *certificate;
    other.kind = semi ? Certificate::Kind::kNone : Certificate::Kind::kSemi;
    EXPECT_FALSE(check(triangulation, other));
    other = *certificate;
    other.edge.emplace_back(0);
    EXPECT_FALSE(check(triangulation, other));
    other = *certificate;
    other.vertex.pop_back();
    EXPECT_FALSE(check(triangulation, other));
  }
  EXPECT_GT(rejected, 1000);
}

TEST(TamperedAngles, AreRejected) {
  for (const auto& signature : testing::data_lines("triangulations-3.txt")) {
    SCOPED_TRACE(signature);
    const auto triangulation = testing::decode(signature);
    Existence found = existence(triangulation);
    auto* angles = std::get_if<StrictAngles>(&found);
    if (angles == nullptr) continue;
    for (auto& six : angles->numerator) {
      for (Integer& angle : six) {
        angle += 1;
        EXPECT_FALSE(check(triangulation, *angles));
        angle -= 1;
      }
    }
    angles->denominator += 1;
    EXPECT_FALSE(check(triangulation, *angles));
  }
}

TEST(Kind, IsThatOfTheRelabelledTriangulation) {
  const auto signatures = testing::data_lines("triangulations-4.txt");
  for (std::size_t k = 0; k < signatures.size(); k += 3) {
    SCOPED_TRACE(signatures[k]);
    const auto original = testing::decode(signatures[k]);
    const topology::Triangulation shuffled(
        topology::random_relabelling(original.gluings(), 1000 + k));
    ASSERT_EQ(kind_of(existence(original)), kind_of(existence(shuffled)));
  }
}

// Angles lift to a cover, and the mean over the deck transformations brings them down.
TEST(Kind, IsThatOfEveryRegularCover) {
  for (const std::size_t degree : {2u, 7u}) {
    for (const auto& signature : testing::data_lines("triangulations-3.txt")) {
      SCOPED_TRACE(signature);
      const auto base = testing::decode(signature);
      const auto shifts = topology::primitive_class(base);
      if (!shifts) continue;
      const topology::Triangulation cover(topology::random_relabelling(
          topology::cyclic_cover(base.gluings(), *shifts, degree), degree));
      ASSERT_EQ(kind_of(existence(cover)), kind_of(existence(base)));
    }
  }
}

// One of each kind with a thousand tetrahedra.
TEST(Kind, OfLargeCovers) {
  const std::array<std::pair<const char*, const char*>, 3> examples{
      {{"dLQbcbcmens", "strict"}, {"dLQbcbcaekw", "semi"}, {"dLQbcbcmebs", "none"}}};
  for (const auto& [signature, kind] : examples) {
    SCOPED_TRACE(signature);
    const auto base = testing::decode(signature);
    const auto shifts = topology::primitive_class(base);
    ASSERT_TRUE(shifts);
    const topology::Triangulation cover(
        topology::random_relabelling(topology::cyclic_cover(base.gluings(), *shifts, 334), 20));
    const Existence found = existence(cover);
    EXPECT_EQ(kind_of(found), kind);
    expect_proof(cover, found);
  }
}

}  // namespace
}  // namespace tripus::structure
