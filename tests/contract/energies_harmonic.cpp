// What the harmonic energy must satisfy: on random graphs with random isometries, some points held
// to planes.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "energies/harmonic.hpp"
#include "geometry/moebius.hpp"
#include "solver/method.hpp"
#include "tests/support/ridders.hpp"

namespace tripus::energies {
namespace {

using geometry::Matrix4;
using geometry::Vector4;

struct Sample {
  std::vector<HarmonicEdge> edges;
  std::vector<Matrix4> isometries;
  std::vector<Vector4> points, poles;
  HarmonicEnergy energy() const { return {edges, isometries, points, poles}; }
};

class HarmonicContract : public ::testing::Test {
 protected:
  double normal() { return normal_(random_); }

  Matrix4 isometry(double size) {
    geometry::MoebiusMap map{{1 + size * normal(), size * normal()},
                             {size * normal(), size * normal()},
                             {size * normal(), size * normal()},
                             {1 + size * normal(), size * normal()}};
    return geometry::to_matrix(geometry::normalised(map));
  }

  Sample sample(std::size_t count = 12) {
    Sample s;
    s.isometries = {Matrix4::Identity(), isometry(0.5), isometry(0.5), isometry(1)};
    for (std::size_t v = 0; v < count; ++v) {
      s.points.push_back(geometry::on_hyperboloid(Vector4(normal(), normal(), normal(), 0)));
      s.poles.push_back(v % 3 == 2 ? Vector4(isometry(0.5).col(2)) : Vector4(Vector4::Zero()));
    }
    for (std::uint32_t a = 0; a < count; ++a)
      for (std::uint32_t b = a + 1; b < count; ++b)
        if (b == a + 1 || random_() % 3 == 0)
          s.edges.push_back(
              {a, b, static_cast<std::uint32_t>(random_() % 4), 0.1 + std::abs(normal())});
    return s;
  }

  std::vector<double> direction(std::size_t n, double size = 1) {
    std::vector<double> d(n);
    for (double& x : d) x = size * normal();
    return d;
  }

  std::mt19937_64 random_{24};
  std::normal_distribution<double> normal_;
};

std::vector<double> moved(const std::vector<double>& x, const std::vector<double>& d, double t) {
  std::vector<double> y = x;
  for (std::size_t i = 0; i < x.size(); ++i) y[i] += t * d[i];
  return y;
}

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

TEST_F(HarmonicContract, ValueIsTheSumOfTheSquaredDistances) {
  for (int n = 0; n < 20; ++n) {
    const Sample s = sample();
    HarmonicEnergy energy = s.energy();
    const std::vector<double> x = direction(energy.dimension(), 0.5);
    const auto at = energy.at(x);
    ASSERT_TRUE(at);
    const double value = at->value();
    const std::vector<Vector4> f = energy.points(x);
    double sum = 0;
    for (const HarmonicEdge& e : s.edges) {
      const double d = std::acosh(
          -geometry::lorentz_product(f[e.a], Vector4(s.isometries[e.isometry] * f[e.b])));
      sum += e.weight * d * d / 2;
    }
    EXPECT_NEAR(value, sum, 1e-9 * sum);
    for (std::size_t v = 0; v < f.size(); ++v)
      EXPECT_NEAR(geometry::lorentz_product(f[v], s.poles[v]), 0, 1e-12 * f[v][3] * f[v][3]);
  }
}

TEST_F(HarmonicContract, GradientAndHessianAreTheDerivatives) {
  for (int n = 0; n < 12; ++n) {
    HarmonicEnergy energy = sample().energy();
    const std::vector<double> x = direction(energy.dimension(), n % 2 == 0 ? 0.0 : 0.5);
    std::vector<double> product(x.size());
    const auto at = energy.at(x, solver::Order::kSecond);
    ASSERT_TRUE(at);
    const auto d = direction(x.size());
    const testing::Derivative slope = testing::ridders(
        [&](double t) {
          const auto there = energy.at(moved(x, d, t));
          EXPECT_TRUE(there);
          return there->value();
        },
        0.01);
    EXPECT_NEAR(dot(at->gradient(), d), slope.value, 1e-8 * (1 + std::abs(slope.value)));
    EXPECT_GT(std::abs(slope.value), 1e-4);
    std::vector<testing::Derivative> second(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      second[i] = testing::ridders(
          [&](double t) {
            const auto there = energy.at(moved(x, d, t));
            EXPECT_TRUE(there);
            return there->gradient()[i];
          },
          0.01);
    at->hessian_times(d, product);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_NEAR(product[i], second[i].value, 1e-7 * (1 + std::abs(product[i])));
  }
}

TEST_F(HarmonicContract, AssembledHessianProductAndBlocksAgree) {
  for (int n = 0; n < 8; ++n) {
    HarmonicEnergy energy = sample().energy();
    const std::size_t size = energy.dimension();
    const std::vector<double> x = direction(size, 0.3);
    std::vector<double> product(size);
    const auto at = energy.at(x, solver::Order::kSecond);
    ASSERT_TRUE(at);
    const solver::SparsityPattern& pattern = energy.hessian_pattern();
    std::vector<double> values(pattern.row.size());
    at->hessian_values(values);
    std::vector<std::vector<double>> full(size, std::vector<double>(size));
    for (std::size_t column = 0; column < size; ++column)
      for (auto k = pattern.column_start[column]; k < pattern.column_start[column + 1]; ++k) {
        const auto row = static_cast<std::size_t>(pattern.row[static_cast<std::size_t>(k)]);
        full[row][column] = full[column][row] = values[static_cast<std::size_t>(k)];
      }
    for (std::size_t j = 0; j < size; ++j) {
      std::vector<double> unit(size);
      unit[j] = 1;
      at->hessian_times(unit, product);
      for (std::size_t i = 0; i < size; ++i)
        EXPECT_NEAR(product[i], full[i][j], 1e-12 * (1 + std::abs(full[i][j])));
    }
    for (const std::size_t width : {std::size_t{1}, std::size_t{3}, std::size_t{8}}) {
      std::vector<double> blocks((size + width - 1) / width * width * width, -1.0);
      at->hessian_diagonal_blocks(width, blocks);
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = i / width * width; j < std::min(size, (i / width + 1) * width); ++j)
          EXPECT_NEAR(blocks[(i / width * width + i % width) * width + j % width], full[i][j],
                      1e-12 * (1 + std::abs(full[i][j])));
    }
  }
}

// At the base points the chart's Hessian is the hyperbolic one. The energy is convex there whatever
// the points are.
TEST_F(HarmonicContract, IsConvexAtTheBasePoints) {
  for (int n = 0; n < 30; ++n) {
    HarmonicEnergy energy = sample().energy();
    energy.recentre(direction(energy.dimension(), 1));
    const std::vector<double> x(energy.dimension(), 0.0);
    std::vector<double> product(x.size());
    const auto at = energy.at(x, solver::Order::kSecond);
    ASSERT_TRUE(at);
    for (int k = 0; k < 20; ++k) {
      const auto d = direction(x.size());
      at->hessian_times(d, product);
      EXPECT_GT(dot(d, product), 0);
    }
  }
}

// One edge: the eigenvalues of the Hessian in one of its ends are 1 along and d coth d across.
TEST_F(HarmonicContract, OneEdgeHasTheEigenvaluesOfTheSquareOfTheDistance) {
  for (const double d : {0.0, 1e-6, 1e-3, 0.1, 0.1414, 0.1415, 1.0, 5.0}) {
    const std::vector<Vector4> points{geometry::origin(),
                                      Vector4(std::sinh(d), 0, 0, std::cosh(d))};
    const std::vector<Vector4> poles(2, Vector4::Zero());
    HarmonicEnergy energy({{0, 1, 0, 1}}, {Matrix4::Identity()}, points, poles);
    const std::vector<double> x(6, 0.0);
    const auto at = energy.at(x, solver::Order::kSecond);
    ASSERT_TRUE(at);
    std::vector<double> blocks(2 * 9);
    at->hessian_diagonal_blocks(3, blocks);
    const double across = d == 0 ? 1 : d / std::tanh(d);
    EXPECT_NEAR(blocks[0], 1, 1e-12);
    EXPECT_NEAR(blocks[4], across, 1e-12 * across);
    EXPECT_NEAR(blocks[8], across, 1e-12 * across);
    EXPECT_NEAR(at->gradient()[0], -d, 1e-12 * (1 + d));
  }
}

TEST_F(HarmonicContract, RecentringChangesNoPointAndNoValue) {
  for (int n = 0; n < 20; ++n) {
    HarmonicEnergy energy = sample().energy();
    std::vector<double> x = direction(energy.dimension(), 0.7);
    const double before = energy.at(x)->value();
    const std::vector<Vector4> f = energy.points(x);
    energy.recentre(x);
    std::fill(x.begin(), x.end(), 0.0);
    const double after = energy.at(x)->value();
    EXPECT_NEAR(before, after, 1e-11 * before);
    const std::vector<Vector4> same = energy.points(x);
    for (std::size_t v = 0; v < f.size(); ++v)
      EXPECT_LT((f[v] - same[v]).norm(), 1e-12 * f[v].squaredNorm());
  }
}

TEST_F(HarmonicContract, RefusesWhatIsNoEnergy) {
  const Sample good = sample();
  for (const auto& spoil : std::vector<void (*)(Sample&)>{
           [](Sample& s) { s.edges[0].weight = INFINITY; },
           [](Sample& s) { s.edges[0].weight = NAN; }, [](Sample& s) { s.edges[1].a = 99; },
           [](Sample& s) { s.edges[1].isometry = 9; },
           [](Sample& s) { s.edges[2].b = s.edges[2].a; }, [](Sample& s) { s.poles.pop_back(); }}) {
    Sample bad = good;
    spoil(bad);
    EXPECT_THROW(bad.energy(), InvalidInput);
  }
}

}  // namespace
}  // namespace tripus::energies
