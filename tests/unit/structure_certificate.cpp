#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "structure/certificate.hpp"
#include "structure/detail/existence_routes.hpp"
#include "structure/detail/rational_system.hpp"
#include "tests/support/triangulations.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

using ::testing::HasSubstr;

Certificate zero_certificate(const topology::Triangulation& triangulation, Certificate::Kind kind) {
  Certificate certificate;
  certificate.kind = kind;
  certificate.edge.resize(triangulation.edge_count());
  certificate.vertex.resize(triangulation.tetrahedron_count());
  return certificate;
}

/// docs/theory.md section 5: around an edge of valence 1 or 2, each corner counts at one of its
/// ends.
Certificate low_valence_certificate(const topology::Triangulation& triangulation, std::size_t e,
                                    Certificate::Kind kind) {
  Certificate certificate = zero_certificate(triangulation, kind);
  certificate.edge[e] = 1;
  for (const auto corner : triangulation.corners(e)) {
    const int end = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())][0];
    certificate.vertex[corner.tetrahedron()][static_cast<std::size_t>(end)] = 1;
  }
  return certificate;
}

// Valences 16, 2 (data/nongeometric-3.tsv).
TEST(CheckCertificate, AcceptsAnEdgeOfValenceTwoAsSemi) {
  const auto triangulation = testing::decode("dLQbcbcaekw");
  ASSERT_EQ(triangulation.valence(1), 2u);
  EXPECT_TRUE(
      check(triangulation, low_valence_certificate(triangulation, 1, Certificate::Kind::kSemi)));
  const auto result =
      check(triangulation, low_valence_certificate(triangulation, 1, Certificate::Kind::kNone));
  EXPECT_FALSE(result);
  EXPECT_THAT(result.reason, HasSubstr("is 0; kind \"none\" needs less than 0"));
}

TEST(CheckCertificate, AcceptsAnEdgeOfValenceOneAsNone) {
  const auto triangulation = testing::decode("dLQbcbcmebs");
  std::size_t lonely = 0;
  while (lonely < triangulation.edge_count() && triangulation.valence(lonely) != 1) ++lonely;
  ASSERT_LT(lonely, triangulation.edge_count());
  EXPECT_TRUE(check(triangulation,
                    low_valence_certificate(triangulation, lonely, Certificate::Kind::kNone)));
}

TEST(CheckCertificate, NamesWhatFails) {
  const auto triangulation = testing::decode("dLQbcbcaekw");
  const Certificate good = low_valence_certificate(triangulation, 1, Certificate::Kind::kSemi);
  const auto reason = [&](const Certificate& certificate) {
    const CheckResult result = check(triangulation, certificate);
    EXPECT_FALSE(result.valid);
    return result.reason;
  };
  Certificate bad = good;
  bad.edge.pop_back();
  EXPECT_THAT(reason(bad), HasSubstr("1 edge multipliers, the triangulation 2 edge classes"));
  bad = good;
  bad.vertex.emplace_back();
  EXPECT_THAT(reason(bad), HasSubstr("for 4 tetrahedra, the triangulation has 3"));
  bad = good;
  bad.vertex[2][3] = -7;
  EXPECT_THAT(reason(bad), HasSubstr("vertex 3 of tetrahedron 2 is -7, below 0"));
  bad = good;
  bad.edge[0] = 3;
  EXPECT_THAT(reason(bad), HasSubstr("(edge class 0), vertex + vertex - edge = "));
  bad = good;
  bad.edge[0] = -1;
  EXPECT_THAT(reason(bad), HasSubstr("is 2; kind \"semi\" needs 0"));
  bad = zero_certificate(triangulation, Certificate::Kind::kSemi);
  EXPECT_THAT(reason(bad), HasSubstr("all multipliers are 0"));
  bad.kind = Certificate::Kind::kNone;
  EXPECT_THAT(reason(bad), HasSubstr("is 0; kind \"none\" needs less than 0"));
}

// Beyond 64 bits nothing wraps round: a multiple of a certificate is one, and 1 more is none.
TEST(CheckCertificate, IsExactForLargeIntegers) {
  const auto triangulation = testing::decode("dLQbcbcaekw");
  Certificate certificate = low_valence_certificate(triangulation, 1, Certificate::Kind::kSemi);
  const Integer factor = big_integer("1" + std::string(400, '0'));
  for (Integer& u : certificate.edge) u *= factor;
  for (auto& four : certificate.vertex)
    for (Integer& w : four) w *= factor;
  EXPECT_TRUE(check(triangulation, certificate));
  EXPECT_EQ(parse_certificate(to_json(certificate)), certificate);
  certificate.vertex[0][0] += 1;
  EXPECT_FALSE(check(triangulation, certificate));
}

// One edge class of valence 12: the regular angles pi / 6.
TEST(CheckStrictAngles, AcceptsRegularAnglesAndNamesWhatFails) {
  const auto triangulation = testing::decode("cPcbbbihq");
  ASSERT_EQ(triangulation.edge_count(), 1u);
  StrictAngles good;
  good.denominator = 6;
  good.numerator.assign(2, {1, 1, 1, 1, 1, 1});
  EXPECT_TRUE(check(triangulation, good));

  const auto reason = [&](const StrictAngles& angles) {
    const CheckResult result = check(triangulation, angles);
    EXPECT_FALSE(result.valid);
    return result.reason;
  };
  StrictAngles bad = good;
  bad.numerator[1][5] = 0;
  bad.numerator[0][0] = 2;
  EXPECT_THAT(reason(bad), HasSubstr("edge 23 of tetrahedron 1 (edge class 0) is 0/6 pi"));
  bad = good;
  bad.numerator[1][5] = 2;
  EXPECT_THAT(reason(bad), HasSubstr("edge class 0 add up to 13/6 pi, not to 2 pi"));
  bad = good;
  bad.numerator[0][0] = 4;
  EXPECT_THAT(reason(bad), HasSubstr("vertex 0 of tetrahedron 0 add up to 6/6 pi"));
  bad = good;
  bad.numerator.pop_back();
  EXPECT_THAT(reason(bad), HasSubstr("angles for 1 tetrahedra, the triangulation has 2"));
  bad = good;
  bad.denominator = 0;
  EXPECT_THAT(reason(bad), HasSubstr("denominator is 0"));
}

TEST(CertificateJson, IsWrittenAsDocumented) {
  Certificate certificate;
  certificate.kind = Certificate::Kind::kSemi;
  certificate.edge = {0, -1};
  certificate.vertex = {{1, 2, 3, big_integer("123456789012345678901234567890")}};
  const std::string json =
      R"({"kind": "semi", "edge": [0, -1], "vertex": [[1, 2, 3, 123456789012345678901234567890]]})";
  EXPECT_EQ(to_json(certificate), json);
  EXPECT_EQ(parse_certificate(json), certificate);
  EXPECT_EQ(parse_certificate(R"({"tripus": "0.1.0", "volume": 1.5e-3, "certificate": )" + json +
                              R"(, "message": "No."})"),
            certificate);
}

TEST(CertificateJson, RefusesWithThePlace) {
  const auto message = [](const std::string& json) -> std::string {
    try {
      parse_certificate(json);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "accepted";
  };
  const auto with = [](const std::string& edge, const std::string& vertex) {
    return R"({"kind": "none", "edge": )" + edge + R"(, "vertex": )" + vertex + "}";
  };
  EXPECT_THAT(message(""), HasSubstr("syntax error at byte"));
  EXPECT_THAT(message("{\"kind\": "), HasSubstr("syntax error at byte"));
  EXPECT_THAT(message("[1]"), HasSubstr("the document: expected an object, found an array of 1"));
  EXPECT_THAT(message("{}"), HasSubstr("\"kind\" is missing"));
  EXPECT_THAT(message(R"({"outcome": "geometric", "certificate": null})"),
              HasSubstr("the answer carries none; its outcome is"));
  EXPECT_THAT(message(R"({"certificate": 3})"), HasSubstr("expected an object, found"));
  EXPECT_THAT(message(R"({"kind": "some", "edge": [], "vertex": []})"),
              HasSubstr(R"("kind": expected "none" or "semi", found)"));
  EXPECT_THAT(message(R"({"kind": "none", "vertex": []})"), HasSubstr("\"edge\" is missing"));
  EXPECT_THAT(message(with("7", "[]")), HasSubstr("\"edge\": expected an array of integers"));
  EXPECT_THAT(message(with("[1, 2.0]", "[]")), HasSubstr("multiplier of edge class 1"));
  EXPECT_THAT(message(with("[1e3]", "[]")), HasSubstr("without fraction and exponent"));
  EXPECT_THAT(message(with("[\"1\"]", "[]")), HasSubstr("found the string"));
  EXPECT_THAT(message(with("[1]", "[[1, 2, 3]]")),
              HasSubstr("tetrahedron 0: expected an array of 4"));
  EXPECT_THAT(message(with("[1]", "[[1, 2, 3, null]]")), HasSubstr("vertex 3 of tetrahedron 0"));
  EXPECT_THAT(message(R"({"kind": "none", "kind": "semi"})"), HasSubstr("occurs twice"));
  EXPECT_THAT(message(std::string(100'000, '[')), HasSubstr("levels deep"));
  EXPECT_THAT(message(with("[" + std::string(6000, '9') + "]", "[]")), HasSubstr("too large"));
}

TEST(CertificateFrom, TakesTheLargestEdgeMultipliers) {
  const auto triangulation = testing::decode("dLQbcbcaekw");
  const Certificate expected = low_valence_certificate(triangulation, 1, Certificate::Kind::kSemi);
  const detail::AngleConstraints constraints(triangulation);
  auto w = expected.vertex;
  for (auto& four : w)
    for (Integer& each : four) each *= 12;
  EXPECT_EQ(detail::certificate_from(triangulation, constraints, w), expected);
  EXPECT_EQ(
      detail::certificate_from(triangulation, constraints, std::vector<std::array<Integer, 4>>(3)),
      std::nullopt);
  w[0][0] += 24;
  w[1][1] += 24;
  w[2][2] += 24;
  EXPECT_EQ(detail::certificate_from(triangulation, constraints, w), std::nullopt);
}

TEST(RationalSystem, SolvesAndFindsSingularMatrices) {
  detail::RationalSystem system;
  system.rows = {{{0, 2}, {1, 1}, {2, 3}}, {{0, 1}, {1, -1}}, {{1, 5}, {2, 7}}};
  system.right_side = {1, 2, 3};
  const auto solution = detail::solve(system);
  ASSERT_TRUE(solution);
  for (std::size_t r = 0; r < 3; ++r) {
    detail::Rational sum = 0;
    for (const auto& [unknown, coefficient] : system.rows[r])
      sum += detail::Rational(coefficient) * (*solution)[unknown];
    EXPECT_EQ(sum, system.right_side[r]);
  }
  system.rows[2] = {{0, 4}, {1, -1}, {2, 3}};  // the first row + 2 times the second
  EXPECT_FALSE(detail::solve(system));
  system.rows[2] = {};
  EXPECT_FALSE(detail::solve(system));
}

}  // namespace
}  // namespace tripus::structure
