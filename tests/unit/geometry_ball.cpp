#include <cfenv>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <acb.h>
#include <acb_hypgeom.h>
#include <arb.h>
#include <gtest/gtest.h>

#include "geometry/detail/ball_functions.hpp"
#include "geometry/enclosure.hpp"
#include "tests/support/ball_samples.hpp"

// Everything a ball claims is held against Arb at 200 bits, in every rounding mode.
namespace {

using tripus::testing::BallSample;
using tripus::testing::BallSamples;

constexpr long kTruthBits = 200;

/// Whether the ball (m, r) contains all of `truth`.
bool contains(double m, double r, arb_srcptr truth) {
  if (std::isnan(m) || std::isnan(r)) return true;  // claims nothing
  if (std::isinf(r)) return true;
  arb_t ball;
  arb_init(ball);
  arb_set_d(ball, m);
  mag_set_d_lower(arb_radref(ball), r);
  const bool result = arb_contains(ball, truth) != 0;
  arb_clear(ball);
  return result;
}

struct Truth {
  arb_t x, y, value;
  Truth() {
    arb_init(x);
    arb_init(y);
    arb_init(value);
  }
  ~Truth() {
    arb_clear(x);
    arb_clear(y);
    arb_clear(value);
  }
  Truth(const Truth&) = delete;
  Truth& operator=(const Truth&) = delete;

  void clausen() {
    acb_t z;
    acb_init(z);
    arb_sin_cos(acb_imagref(z), acb_realref(z), x, kTruthBits);
    acb_hypgeom_dilog(z, z, kTruthBits);
    arb_set(value, acb_imagref(z));
    acb_clear(z);
  }
};

/// `share`: of the claims that say something; logarithms and Clausen values next to their zeros do
/// not, and with directed rounding the least arguments of sinh.
void check_samples(const BallSamples& samples, const char* how, double share = 0.98) {
  Truth truth;
  std::size_t useful = 0;
  for (const BallSample& sample : samples) {
    arb_set_d(truth.x, sample.x);
    arb_set_d(truth.y, sample.y);
    const auto expect = [&](const char* what, const double(&ball)[2], double width) {
      EXPECT_TRUE(contains(ball[0], ball[1], truth.value))
          << how << ": " << what << " at " << sample.x << ", " << sample.y << ": " << ball[0]
          << " +- " << ball[1];
      useful += ball[1] <= width * (1e-300 + std::fabs(ball[0]));
    };
    arb_sinh(truth.value, truth.x, kTruthBits);
    expect("sinh", sample.sinh, 1e-14);
    arb_cosh(truth.value, truth.x, kTruthBits);
    expect("cosh", sample.cosh, 1e-14);
    arb_log(truth.value, truth.x, kTruthBits);
    expect("log", sample.log, 1);
    arb_atan2(truth.value, truth.y, truth.x, kTruthBits);
    expect("angle", sample.angle, 1);
    arb_div(truth.value, truth.y, truth.x, kTruthBits);
    expect("quotient", sample.quotient, 1e-15);
    arb_sqrt(truth.value, truth.x, kTruthBits);
    expect("root", sample.root, 1e-15);
    truth.clausen();
    expect("Clausen", sample.clausen, 1);
  }
  EXPECT_GT(static_cast<double>(useful), share * 7 * static_cast<double>(samples.size())) << how;
}

/// The arguments: all over the domain, and its ends.
std::vector<std::pair<double, double>> arguments(std::size_t count) {
  std::mt19937_64 random(20261129);
  std::uniform_real_distribution<double> uniform(0, 1), sign(-1, 1);
  std::vector<std::pair<double, double>> result;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = k % 2 == 0 ? std::ldexp(1 + uniform(random), -int(60 * uniform(random)))
                                : 40 * uniform(random);
    result.emplace_back(std::min(x, 40.0), std::ldexp(sign(random), int(40 * sign(random))));
  }
  for (const double x : {40.0, std::nextafter(40.0, 0), 1.0, 0.5, 2.0, 0x1p-500, 0x1p-60, 2.1,
                         std::nextafter(2.1, 3), 3.141592653589793, 3.1415926535897936,
                         6.283185307179586, 6.283185307179587, 0.6931471805599453,
                         0.34657359027997264, 1.4142135623730951, 31.4159265358979})
    for (const double y :
         {0.0, 1.0, -1.0, 0x1p-60, x, -x, 0.41421356237309503 * x, 2.414213562 * x})
      result.emplace_back(x, y);
  return result;
}

TEST(Ball, ContainsTheTruthInEveryRoundingMode) {
  const auto points = arguments(5000);
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const BallSamples samples = tripus::testing::ball_samples(points);
    std::fesetround(FE_TONEAREST);
    check_samples(samples, ("rounding mode " + std::to_string(mode)).c_str(),
                  mode == FE_TONEAREST ? 0.98 : 0.9);
  }
}

TEST(Ball, ContainsTheTruthWhereProductsAndSumsAreFused) {
#ifdef TRIPUS_FUSED_BALLS
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no fused operations";
  check_samples(tripus::testing::fused_ball_samples(arguments(5000)), "fused");
#else
  GTEST_SKIP() << "no fused operations in this build";
#endif
}

TEST(Ball, ClaimsNothingOutsideOfItsDomain) {
  using B = tripus::geometry::Ball<double>;
  const auto nothing = [](const B& ball) { return !(ball.r < 1e300); };
  EXPECT_TRUE(nothing(B{1, 0} / B{0, 0}));
  EXPECT_TRUE(nothing(B{1, 0} / B{0.5, 0.5}));
  EXPECT_TRUE(nothing(square_root(B{-1, 0.5})));
  EXPECT_TRUE(nothing(ball_log(B{1, 1})));
  EXPECT_TRUE(nothing(ball_log(B{0, 0})));
  EXPECT_TRUE(nothing(angle_of(B{0, 0}, B{0, 0})));
  EXPECT_TRUE(nothing(angle_of(B{0.1, 0.2}, B{0.1, 0.2})));
  EXPECT_TRUE(nothing(clausen(B{1, 2})));
  EXPECT_TRUE(nothing(B{std::numeric_limits<double>::quiet_NaN(), 0} + B{1, 0}));
  EXPECT_FALSE(nothing(angle_of(B{1, 0.2}, B{0.1, 0.2})));
}

TEST(Ball, WidensClausenByItsSlopeAlsoAtItsZeros) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Truth truth;
  for (int k = 0; k < 5000; ++k) {
    const double radius = std::ldexp(1.0, -2 - int(50 * std::fabs(uniform(random))));
    const double centre = k % 3 == 0 ? radius * 3 * uniform(random) : 7 * uniform(random);
    const auto ball = clausen(tripus::geometry::Ball<double>{centre, radius});
    const double inside = centre + radius * uniform(random);
    if (inside == 0 || std::fabs(inside - centre) > radius) continue;
    arb_set_d(truth.x, inside);
    truth.clausen();
    EXPECT_TRUE(contains(ball.m, ball.r, truth.value)) << centre << " +- " << radius;
  }
}

TEST(EnclosureKernels, GiveTheSameBitsInEveryInstructionSet) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0.01, 3);
  std::vector<double> lengths(4 * 48), radii(lengths.size(), 1e-9);
  for (double& l : lengths) l = uniform(random);
  std::vector<double> expected(4 * 8 * tripus::geometry::kEnclosed), found(expected.size());
  tripus::geometry::all_enclosure_kernels().front().enclose(4, lengths.data(), radii.data(),
                                                            expected.data(), true);
  for (const auto& kernels : tripus::geometry::all_enclosure_kernels()) {
    kernels.enclose(4, lengths.data(), radii.data(), found.data(), true);
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_TRUE(found[k] == expected[k] || (std::isnan(found[k]) && std::isnan(expected[k])))
          << kernels.name << " " << k;
  }
}

}  // namespace
