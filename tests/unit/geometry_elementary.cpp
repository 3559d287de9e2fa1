// The kernels' own elementary functions against many digits: below 2.5 ulp.
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "geometry/clausen.hpp"
#include "geometry/detail/elementary.hpp"
#include "tests/support/reference_tetrahedron.hpp"

namespace tripus::geometry {
namespace {

using testing::Digits;

double ulps(double computed, const Digits& exact) {
  const double rounded = exact.convert_to<double>();
  const double ulp = std::nextafter(std::fabs(rounded), std::numeric_limits<double>::infinity()) -
                     std::fabs(rounded);
  return std::fabs(((Digits(computed) - exact) / ulp).convert_to<double>());
}

TEST(Elementary, SinhAndCoshAreNearlyRounded) {
  std::mt19937_64 random(1);
  double worst = 0;
  for (const double high : {1e-200, 1e-3, 1.0, 64.0, 600.0}) {
    std::uniform_real_distribution<double> sample(0, high);
    for (int n = 0; n < 3000; ++n) {
      const double x = sample(random);
      const auto h = sinh_cosh(x);
      worst = std::max({worst, ulps(h.sinh, sinh(Digits(x))), ulps(h.cosh, cosh(Digits(x)))});
    }
  }
  EXPECT_LT(worst, 2.5);
}

TEST(Elementary, SinhOfTheSmallestNumbersIsExact) {
  for (const double x : {0.0, 5e-324, 1e-300, 1e-160, 1e-20}) {
    EXPECT_EQ(sinh_cosh(x).sinh, x);
    EXPECT_EQ(sinh_cosh(x).cosh, 1.0);
  }
}

TEST(Elementary, AtanIsNearlyRoundedInEveryOctant) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> exponent(-30, 30);
  double worst = 0;
  for (int n = 0; n < 10000; ++n) {
    const double y = std::exp(exponent(random));
    const double x = (n % 2 == 0 ? 1 : -1) * y * std::exp(exponent(random) / (1 + n % 30));
    worst = std::max(worst, ulps(upper_atan2(y, x), atan2(Digits(y), Digits(x))));
  }
  EXPECT_LT(worst, 2.5);
}

TEST(Elementary, LogarithmIsNearlyRounded) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-690, 690), near_one(0.5, 2.5);
  double worst = 0;
  for (int n = 0; n < 10000; ++n) {
    const double x = n % 2 == 0 ? std::exp(exponent(random)) : near_one(random);
    const double error = abs(Digits(natural_log(x)) - log(Digits(x))).convert_to<double>();
    worst = std::max(worst, error / (std::max(1.0, std::fabs(std::log(x))) * 0x1p-52));
  }
  EXPECT_LT(worst, 1);
  EXPECT_EQ(natural_log(1.0), 0);
}

TEST(Elementary, AtanOnTheAxes) {
  EXPECT_EQ(upper_atan2(0.0, 1.0), 0.0);
  EXPECT_EQ(upper_atan2(0.0, 0.0), 0.0);
  EXPECT_EQ(upper_atan2(0.0, -1.0), std::acos(-1.0));
  EXPECT_EQ(upper_atan2(1.0, 0.0), std::acos(0.0));
  EXPECT_EQ(upper_atan2(1.0, 1.0), std::atan(1.0));
}

TEST(Elementary, PacksGiveTheBitsOfScalars) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> sample(0, 40), sign(-1, 1);
  for (int n = 0; n < 1000; ++n) {
    Pack<4> x, y;
    for (int i = 0; i < 4; ++i) {
      x[i] = sample(random) * sign(random);
      y[i] = sample(random);
    }
    const auto h = sinh_cosh(y);
    const auto a = upper_atan2(y, x);
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(h.sinh[i], sinh_cosh(double(y[i])).sinh);
      EXPECT_EQ(h.cosh[i], sinh_cosh(double(y[i])).cosh);
      EXPECT_EQ(a[i], upper_atan2(double(y[i]), double(x[i])));
    }
  }
}

/// Cl2 from its definition as an integral, halved until stable, in long double.
double clausen_by_series(double x) {
  // sum_{n <= N} sin(n x)/n^2 with the Euler-Maclaurin-free tail bound 1/(N |sin(x/2)|): slow but
  // independent of the expansions in clausen.cpp.
  long double sum = 0;
  const int terms = 4000000;
  for (int n = terms; n >= 1; --n)
    sum += std::sin(static_cast<long double>(n) * x) / (static_cast<long double>(n) * n);
  return static_cast<double>(sum);
}

TEST(Clausen, AgreesWithItsFourierSeries) {
  for (const double x : {0.3, 1.0, 2.0, 2.2, 3.0})
    EXPECT_NEAR(clausen2(x), clausen_by_series(x), 1e-12);
}

TEST(Clausen, KnownValues) {
  // Catalan's constant, and the maximum Cl2(pi/3), to all digits.
  EXPECT_NEAR(clausen2(std::acos(0.0)), 0.91596559417721901505, 4e-16);
  EXPECT_NEAR(clausen2(std::acos(-1.0) / 3), 1.01494160640965362502, 4e-16);
  EXPECT_EQ(clausen2(0.0), 0.0);
  EXPECT_NEAR(clausen2(std::acos(-1.0)), 0.0, 4e-16);
}

TEST(Clausen, OddPeriodicAndDuplication) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> sample(-3, 3);
  const double pi = std::acos(-1.0);
  for (int n = 0; n < 1000; ++n) {
    const double x = sample(random);
    EXPECT_EQ(clausen2(-x), -clausen2(x));
    EXPECT_NEAR(clausen2(x + 2 * pi), clausen2(x), 5e-15);
    EXPECT_NEAR(clausen2(2 * x), 2 * clausen2(x) - 2 * clausen2(pi - x), 3e-15);
  }
}

}  // namespace
}  // namespace tripus::geometry
