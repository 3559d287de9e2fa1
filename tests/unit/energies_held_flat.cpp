// The co-volume with tetrahedra held flat, theory (54').
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "energies/co_volume.hpp"
#include "topology/isosig.hpp"

namespace tripus::energies {
namespace {

// Tetrahedra 2, 5 and 6 are flat at these lengths (with a margin), the others are not.
const std::vector<double> kBoundary = {0.611602812689677,  9.739231867212784, 5.103547623180673,
                                       10.363718798947069, 9.47356625593969,  13.584200258001813,
                                       3.1151003547950773, 6.726599906974571};

class HeldFlat : public ::testing::Test {
 protected:
  void SetUp() override {
    std::vector<double> gradient(kBoundary.size());
    held_.evaluate(kBoundary, gradient, {});
    ASSERT_EQ(held_.flat_tetrahedra(), (std::vector<std::size_t>{2, 5, 6}));
    held_.hold_flat(held_.flat_tetrahedra());
  }

  topology::Triangulation triangulation_{topology::decode_isosig("jLLLzQQcdffhggihilvhhnkkawn")};
  CoVolume free_{triangulation_}, held_{triangulation_};
  std::mt19937_64 random_{11};
};

TEST_F(HeldFlat, IsNowhereAboveTheCoVolumeAndEqualWhereTheyAreFlat) {
  std::vector<double> gradient(kBoundary.size());
  double free = 0, held = 0;
  free_.evaluate(kBoundary, gradient, {.value = &free});
  held_.evaluate(kBoundary, gradient, {.value = &held});
  EXPECT_NEAR(held, free, 1e-12);
  std::uniform_real_distribution<double> length(-1, 15);
  bool strictly = false;
  for (int n = 0; n < 500; ++n) {
    std::vector<double> x(kBoundary.size());
    for (double& l : x) l = length(random_);
    free_.evaluate(x, gradient, {.value = &free});
    held_.evaluate(x, gradient, {.value = &held});
    EXPECT_LE(held, free + 1e-11);
    strictly = strictly || held < free - 1;
  }
  EXPECT_TRUE(strictly);
}

TEST_F(HeldFlat, GradientAndHessianAreThoseOfItsValue) {
  std::uniform_real_distribution<double> length(0.5, 1.1), step(-1, 1);
  for (int n = 0; n < 20; ++n) {
    std::vector<double> x(kBoundary.size()), d(x.size()), above = x, below = x, g(x.size());
    for (double& l : x) l = length(random_);
    for (double& v : d) v = step(random_);
    const double h = 1e-5;
    for (std::size_t i = 0; i < x.size(); ++i)
      above[i] = x[i] + h * d[i], below[i] = x[i] - h * d[i];
    double high = 0, low = 0;
    std::vector<double> g_high(x.size()), g_low(x.size()), Hd(x.size());
    held_.evaluate(above, g_high, {.value = &high});
    held_.evaluate(below, g_low, {.value = &low});
    held_.evaluate(x, g, {.value = nullptr, .second_derivatives = true});
    held_.hessian_times(d, Hd);
    double slope = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      slope += g[i] * d[i];
      EXPECT_NEAR(Hd[i], (g_high[i] - g_low[i]) / (2 * h), 1e-6);
    }
    EXPECT_NEAR(slope, (high - low) / (2 * h), 1e-7);
    EXPECT_GE(held_.flat_count(), 3u);
  }
}

}  // namespace
}  // namespace tripus::energies
