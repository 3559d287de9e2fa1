// Numbers in a number field, and metrics that are known exactly: wrong guesses are refused.
#include <cmath>

#include <gtest/gtest.h>

#include "structure/proof/detail/arb_number.hpp"
#include "structure/proof/detail/exact_metric.hpp"
#include "structure/proof/digits.hpp"
#include "structure/solve.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

using detail::Algebraic;
using detail::Arb;
using detail::ConeMetric;
using detail::ExactMetric;
using detail::NumberField;

constexpr long kBits = 300;

Arb root_of(double x) { return square_root(Arb(x)); }

TEST(NumberField, FindsWhatIsThere) {
  const detail::Precision precision(kBits);
  // sqrt 2 + sqrt 3 has degree 4; its field contains both roots.
  const auto field = NumberField::guess(root_of(2) + root_of(3), 6);
  ASSERT_TRUE(field);
  EXPECT_EQ(field->polynomial(), "x^4 - 10*x^2 + 1");
  const auto two = field->guess_member(root_of(2)), six = field->guess_member(root_of(6));
  ASSERT_TRUE(two && six);
  EXPECT_TRUE(*two * *two == Algebraic(2));
  EXPECT_TRUE(*two * *two * Algebraic(3) == *six * *six);
  EXPECT_FALSE(*two == *six);
  const auto inverse = two->inverse();
  ASSERT_TRUE(inverse);
  EXPECT_TRUE(*inverse * *two == Algebraic(1));
  EXPECT_NEAR(field->value(*six).mid(), std::sqrt(6.0), 1e-15);
  EXPECT_FALSE(field->guess_member(root_of(5)));
  EXPECT_FALSE(Algebraic().inverse());
}

TEST(NumberField, OfARationalNumber) {
  const detail::Precision precision(kBits);
  const auto field = NumberField::guess(Arb(2.75), 5);
  ASSERT_TRUE(field);
  EXPECT_EQ(field->polynomial(), "4*x-11");
  EXPECT_EQ(field->degree(), 1);
  EXPECT_TRUE(field->guess_member(Arb(0.5)));
}

TEST(NumberField, FindsNothingOfATranscendentalNumber) {
  const detail::Precision precision(kBits);
  EXPECT_FALSE(NumberField::guess(number_pi(Arb()), 6));
}

struct Solved {
  topology::Triangulation triangulation;
  std::vector<Arb> lengths;
};
Solved solved(const char* signature) {
  topology::Triangulation m(topology::decode_isosig(signature));
  const Proof proof = prove(m, solve(m).edge_lengths);
  const Digits digits = prove_digits(m, proof, 100);
  EXPECT_TRUE(digits.proved) << digits.reason;
  std::vector<Arb> lengths;
  for (std::size_t e = 0; e < digits.lengths.size(); ++e)
    lengths.push_back(
        detail::from_decimal(digits.lengths[e]).widened_by(detail::from_decimal(digits.radii[e])));
  return {std::move(m), std::move(lengths)};
}

// (26): cosh l = (3 + sqrt 3) / 4.
TEST(ExactMetric, OfTheTripus) {
  const detail::Precision precision(kBits);
  const Solved tripus = solved("cPcbbbihq");
  const ConeMetric metric(tripus.triangulation, {});
  const auto exact = ExactMetric::find(metric, tripus.lengths, 4);
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->field().polynomial(), "8*x^2 - 12*x + 3");
  EXPECT_EQ(exact->gram().at(0).text(), "x");
  EXPECT_FALSE(exact->geodesic_sum_is_zero(0, 0));  // its faces are true
}

// The figure-eight knot: all entries are equal for horospheres of one choice.
TEST(ExactMetric, OfACusp) {
  const detail::Precision precision(kBits);
  const Solved figure_eight = solved("cPcbbbiht");
  const ConeMetric metric(figure_eight.triangulation, {});
  const auto exact = ExactMetric::find(metric, figure_eight.lengths, 4);
  ASSERT_TRUE(exact);
  EXPECT_TRUE(exact->gram().at(0) == exact->gram().at(1));
  EXPECT_FALSE(exact->cusp_sum_is_zero(0, 0));
}

// Algebraic numbers that are no metric, and the metric for other cone angles, are refused.
TEST(ExactMetric, OfWrongLengthsIsNone) {
  const detail::Precision precision(kBits);
  const topology::Triangulation m(topology::decode_isosig("cPcbbbihq"));
  const ConeMetric metric(m, {});
  for (const double cosh : {1.1875, 1.25, 2.0}) {
    Arb length;
    arb_acosh(length.get(), Arb(cosh).get(), detail::Precision::bits());
    EXPECT_FALSE(ExactMetric::find(metric, {length}, 4)) << cosh;
  }
  const Solved tripus = solved("cPcbbbihq");
  using topology::ConeAngle;
  for (const auto& angle : {ConeAngle::rational(2, 3), ConeAngle::rational(1, 1),
                            ConeAngle::rational(3, 1), ConeAngle(6.28)}) {
    const ConeMetric other(m, {angle});
    EXPECT_FALSE(ExactMetric::find(other, tripus.lengths, 4)) << angle.radians();
  }
}

}  // namespace
}  // namespace tripus::structure
