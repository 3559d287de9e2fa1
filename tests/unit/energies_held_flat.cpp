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
    ASSERT_EQ(free_.at(kBoundary).flat_tetrahedra(), (std::vector<std::size_t>{2, 5, 6}));
  }

  const topology::Triangulation triangulation_{
      topology::decode_isosig("jLLLzQQcdffhggihilvhhnkkawn")};
  const CoVolume free_{triangulation_};
  const CoVolume held_{free_.at(kBoundary), {2, 5, 6}};
  std::mt19937_64 random_{11};
};

TEST_F(HeldFlat, IsNowhereAboveTheCoVolumeAndEqualWhereTheyAreFlat) {
  EXPECT_NEAR(held_.at(kBoundary).value(), free_.at(kBoundary).value(), 1e-12);
  std::uniform_real_distribution<double> length(-1, 15);
  bool strictly = false;
  for (int n = 0; n < 500; ++n) {
    std::vector<double> x(kBoundary.size());
    for (double& l : x) l = length(random_);
    const double free = free_.at(x).value(), held = held_.at(x).value();
    EXPECT_LE(held, free + 1e-11);
    strictly = strictly || held < free - 1;
  }
  EXPECT_TRUE(strictly);
}

TEST_F(HeldFlat, GradientAndHessianAreThoseOfItsValue) {
  std::uniform_real_distribution<double> length(0.5, 1.1), step(-1, 1);
  for (int n = 0; n < 20; ++n) {
    std::vector<double> x(kBoundary.size()), d(x.size()), above = x, below = x, Hd(x.size());
    for (double& l : x) l = length(random_);
    for (double& v : d) v = step(random_);
    const double h = 1e-5;
    for (std::size_t i = 0; i < x.size(); ++i)
      above[i] = x[i] + h * d[i], below[i] = x[i] - h * d[i];
    const CoVolumeAt high = held_.at(above), low = held_.at(below);
    const CoVolumeAt at = held_.at(x, solver::Order::kSecond);
    at.hessian_times(d, Hd);
    double slope = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      slope += at.gradient()[i] * d[i];
      EXPECT_NEAR(Hd[i], (high.gradient()[i] - low.gradient()[i]) / (2 * h), 1e-6);
    }
    EXPECT_NEAR(slope, (high.value() - low.value()) / (2 * h), 1e-7);
    EXPECT_GE(at.flat_count(), 3u);
  }
}

}  // namespace
}  // namespace tripus::energies
