// Hyperbolic space: models, isometries, Moebius maps.
#include <cmath>
#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "geometry/hyperbolic_space.hpp"
#include "geometry/moebius.hpp"

namespace tripus::geometry {
namespace {

constexpr unsigned kSeed = 20261122;

class HyperbolicSpace : public ::testing::Test {
 protected:
  double normal() { return normal_(random_); }
  Vector4 random_point(double spread) {
    return on_hyperboloid(spread * Vector4(normal(), normal(), normal(), 0));
  }
  MoebiusMap random_map() {
    const auto number = [&] { return Complex(normal(), normal()); };
    MoebiusMap map{number(), number(), number(), number(), normal() > 0};
    return normalised(map);
  }

  std::mt19937 random_{kSeed};
  std::normal_distribution<double> normal_;
};

TEST_F(HyperbolicSpace, ModelsAreBijections) {
  for (int n = 0; n < 300; ++n) {
    const Vector4 point = random_point(n % 3 == 0 ? 0.1 : 4);
    for (const Model model : kModels) {
      const Vector4 back = from_model(model, to_model(model, point));
      EXPECT_LT(hyperbolic_distance(point, back), 1e-11) << to_string(model);
    }
    EXPECT_GT(to_model(Model::kUpperHalfSpace, point)[2], 0);
    EXPECT_LT(to_model(Model::kPoincareBall, point).norm(), 1);
  }
  EXPECT_EQ(to_model(Model::kUpperHalfSpace, origin()), Vector3(0, 0, 1));
}

TEST_F(HyperbolicSpace, DistanceIsThatOfTheUpperHalfSpace) {
  // Up the z axis the distance is the logarithm of the ratio; near points keep their digits.
  const auto at = [](double z) { return from_model(Model::kUpperHalfSpace, {0, 0, z}); };
  EXPECT_NEAR(hyperbolic_distance(at(1), at(std::exp(3.0))), 3, 1e-13);
  EXPECT_NEAR(hyperbolic_distance(at(1), at(std::exp(1e-9))) / 1e-9, 1, 1e-6);
}

TEST_F(HyperbolicSpace, MatricesAndMoebiusMapsAreOneGroup) {
  for (int n = 0; n < 300; ++n) {
    const MoebiusMap f = random_map(), g = random_map();
    const Matrix4 a = to_matrix(f), b = to_matrix(g);
    EXPECT_LT(orthogonality_defect(a), 1e-12 * a.norm() * a.norm());
    EXPECT_EQ(a.determinant() < 0, f.reverses);
    EXPECT_LT((to_matrix(f * g) - a * b).norm(), 1e-13 * a.norm() * b.norm());
    EXPECT_LT((to_matrix(inverse(f)) - lorentz_inverse(a)).norm(), 1e-13 * a.norm());
    EXPECT_LT(difference(to_moebius(a), f), 1e-13 * a.norm());
    EXPECT_LT((image_of_origin(f) - a * origin()).norm(), 1e-14 * a.norm());
  }
}

TEST_F(HyperbolicSpace, HalfTurnsHaveTraceZeroAndAreConverted) {
  const MoebiusMap turn{0, -1, 1, 0};
  EXPECT_LT(difference(to_moebius(to_matrix(turn)), turn), 1e-15);
}

TEST_F(HyperbolicSpace, MapsActOnIdealPointsAsMatricesActOnNullVectors) {
  for (int n = 0; n < 200; ++n) {
    const MoebiusMap map = random_map();
    Vector3 direction(normal(), normal(), normal());
    direction.normalize();
    Vector4 null;
    null << direction, 1;
    const BoundaryPoint moved = apply(map, to_boundary(null));
    const BoundaryPoint expected = to_boundary(to_matrix(map) * null);
    const double size = std::hypot(std::abs(moved.x), std::abs(moved.y)) *
                        std::hypot(std::abs(expected.x), std::abs(expected.y));
    EXPECT_LT(std::abs(moved.x * expected.y - moved.y * expected.x), 1e-12 * size);
  }
}

TEST_F(HyperbolicSpace, ThreePointsDetermineAMap) {
  for (int n = 0; n < 200; ++n) {
    const MoebiusMap map = random_map();
    std::array<BoundaryPoint, 3> from, to;
    for (std::size_t i = 0; i < 3; ++i) {
      from[i] = {Complex(normal(), normal()), i == 2 && n % 2 == 0 ? 0.0 : 1.0};
      to[i] = apply(map, from[i]);
    }
    EXPECT_LT(difference(map_of_triples(from, to, map.reverses), map), 1e-10);
  }
}

TEST_F(HyperbolicSpace, ReorthogonalisingTakesDriftOff) {
  for (const double distance : {1.0, 5.0, 10.0}) {
    MoebiusMap far = random_map();
    far = far * MoebiusMap{std::exp(distance / 2), 0, 0, std::exp(-distance / 2)};
    Matrix4 drifted = to_matrix(far);
    for (int n = 0; n < 16; ++n) drifted(n / 4, n % 4) *= 1 + 1e-13 * normal();
    const Matrix4 mended = reorthogonalised(drifted);
    const double size = drifted.norm();
    // Far out the drifted matrix is off by 1e-13 of entries of size e^{2r}; what is left is the
    // rounding of those, and the drift of the size.
    EXPECT_LT(orthogonality_defect(mended), 1e-12 + 4e-16 * size * size);
    EXPECT_LT((mended - drifted).norm(), 2e-12 * size);
  }
}

}  // namespace
}  // namespace tripus::geometry
