// What one arc contributes to the identities, against formulae and quadrature.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "orthospectrum/identities.hpp"
#include "orthospectrum/sums.hpp"

namespace tripus::orthospectrum {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(OrthospectrumSums, TheDiscsOfAnArcHaveTheAreaOfBasmajiansIdentity) {
  for (const double l : {0.01, 0.3, 1.0, 2.5, 9.0}) {
    const double r = disc_radius(l);
    EXPECT_NEAR(std::cosh(r), 1 / std::tanh(l), 1e-13 / std::tanh(l));
    const double area = 2 * kPi * 2 * std::pow(std::sinh(r / 2), 2);
    EXPECT_NEAR(boundary_area_of(l) / (2 * area), 1, 1e-12);
    EXPECT_NEAR(volume_of(l), 2 * kPi * (l + 1) / (std::exp(2 * l) - 1), 1e-12 * volume_of(l));
  }
}

/// 2 * 2 pi coth l * integral of t^k / cosh^2 t from l on, by the midpoint rule in u = e^{-t}.
double by_quadrature(double l, int k) {
  constexpr int kPieces = 200000;
  double sum = 0;
  const double top = std::exp(-l);
  for (int n = 0; n < kPieces; ++n) {
    const double u = top * (n + 0.5) / kPieces;
    const double sech = 2 * u / (1 + u * u);
    sum += std::pow(-std::log(u), k) * sech * sech / u * top / kPieces;
  }
  return 4 * kPi / std::tanh(l) * sum;
}

TEST(OrthospectrumSums, ReturnTimesAgreeWithQuadrature) {
  for (const int k : {1, 2})
    for (const double l : {0.02, 0.3, 0.49, 0.51, 1.0, 3.0, 8.0})
      EXPECT_NEAR(return_time_of(l, k) / by_quadrature(l, k), 1, 1e-8) << l << " " << k;
}

TEST(OrthospectrumSums, TheMeanReturnTimeHasItsClosedForm) {
  for (const double l : {0.001, 0.2, 1.0, 4.0}) {
    const double closed = std::log(2 * std::cosh(l)) - l * std::tanh(l);
    EXPECT_NEAR(return_time_of(l, 1), 4 * kPi / std::tanh(l) * closed,
                1e-12 * return_time_of(l, 1) + 1e-12);
  }
}

TEST(OrthospectrumSums, SumsOfPartsAreThoseOfTheWhole) {
  Sums whole, first, second;
  for (int n = 1; n <= 40; ++n) {
    whole.add(0.1 * n);
    (n % 3 == 0 ? first : second).add(0.1 * n);
  }
  first.add(second);
  EXPECT_EQ(first.oriented_count(), 40u);
  EXPECT_EQ(first.shortest(), 0.1);
  EXPECT_EQ(Sums().shortest(), std::nullopt);
  EXPECT_EQ(first.histogram(), whole.histogram());
  EXPECT_NEAR(first.area(), whole.area(), 1e-12);
  EXPECT_NEAR(first.volume(), whole.volume(), 1e-12);
  EXPECT_NEAR(first.return_time(2), whole.return_time(2), 1e-12);
}

/// Arcs that grow exactly like e^(delta l), dense enough to have no noise.
TEST(OrthospectrumIdentities, ExactGrowthGivesItsExponentAndTheTails) {
  constexpr double kDelta = 1.4, kLength = 9;
  Sums all, part;
  for (int n = 1; n < 3'000'000; ++n) {
    const double l = std::log(static_cast<double>(n)) / kDelta + 0.5;
    all.add(l);
    all.add(l);
    if (l <= kLength) {
      part.add(l);
      part.add(l);
    }
  }
  // The arcs beyond these carry little, but not nothing.
  const double last = std::log(3e6) / kDelta + 0.5;
  const double beyond = 8 * kPi * 3e6 * std::exp(-2 * last) * kDelta / (2 - kDelta);
  const double area = all.area() + beyond;
  const double volume = all.volume() + beyond * (last + 1 + 1 / (2 - kDelta)) / 4;
  const Identities found = identities_of(part, kLength, area, volume);
  ASSERT_TRUE(found.dimension && found.area.tail && found.volume.tail && found.volume_from_area);
  EXPECT_NEAR(found.dimension->value, kDelta, 1e-2);
  EXPECT_NEAR(found.area.tail->value / (area - part.area()), 1, 0.02);
  EXPECT_NEAR(found.volume.tail->value / (volume - part.volume()), 1, 0.02);
  EXPECT_NEAR(found.volume_from_area->value, volume, 0.01 * (volume - part.volume()));
}

TEST(OrthospectrumIdentities, FewArcsGiveNoEstimates) {
  Sums few;
  for (int n = 0; n < 100; ++n) few.add(1 + 0.05 * n);
  const Identities found = identities_of(few, 6, 100, 30);
  EXPECT_FALSE(found.dimension || found.area.tail || found.volume.tail || found.volume_from_area ||
               found.return_time[0]);
  EXPECT_EQ(found.area.counted, few.area());
}

}  // namespace
}  // namespace tripus::orthospectrum
