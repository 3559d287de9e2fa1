// What every registered energy must satisfy, on random lengths of random triangulations.
#include <algorithm>
#include <memory>
#include <random>
#include <span>

#include <gtest/gtest.h>

#include "energies/co_volume.hpp"
#include "energies/energies.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/printers.hpp"
#include "tests/support/ridders.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"

namespace tripus::energies {
namespace {

constexpr int kSamples = 60;

/// A random triangulation of up to four tetrahedra with random lengths that make all of them true.
struct Sample {
  std::unique_ptr<topology::Triangulation> triangulation;
  std::vector<double> lengths;
};

Sample random_sample(std::mt19937_64& random) {
  static const std::vector<std::string> kSignatures = [] {
    std::vector<std::string> all;
    for (const char* file :
         {"triangulations-2.txt", "triangulations-3.txt", "triangulations-4.txt"})
      for (const auto& line : testing::data_lines(file)) all.push_back(line);
    return all;
  }();
  Sample sample;
  const auto pick = std::uniform_int_distribution<std::size_t>(0, kSignatures.size() - 1)(random);
  sample.triangulation =
      std::make_unique<topology::Triangulation>(topology::decode_isosig(kSignatures[pick]));
  std::uniform_real_distribution<double> length(0.5, 1.1);
  sample.lengths.resize(sample.triangulation->edge_count());
  for (double& l : sample.lengths) l = length(random);
  return sample;
}

std::vector<double> direction(std::mt19937_64& random, std::size_t n) {
  std::normal_distribution<double> normal;
  std::vector<double> d(n);
  for (double& x : d) x = normal(random);
  return d;
}

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

std::vector<double> moved(const std::vector<double>& x, const std::vector<double>& d, double t) {
  std::vector<double> y = x;
  for (std::size_t i = 0; i < x.size(); ++i) y[i] += t * d[i];
  return y;
}

/// The functional on a triangulation whose tetrahedra are all true ones at these lengths x [E],
/// which become the point that they correspond to.
std::unique_ptr<Functional> at_lengths(const Energy& energy,
                                       const topology::Triangulation& triangulation,
                                       std::vector<double>& x) {
  const auto angles = [&]() -> std::optional<std::vector<double>> {
    const CoVolume co_volume(triangulation);
    const CoVolumeAt at = co_volume.at(x);
    std::vector<double> all;
    for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
      const auto theta = at.dihedral_angles(t);
      all.insert(all.end(), theta.begin(), theta.end());
    }
    return all;
  };
  return energy.begin(triangulation, {}, angles, x);
}

class EnergyContract : public ::testing::TestWithParam<Energy> {
 protected:
  /// The energy on the sample, and a point near the one of the sample's lengths: there all corners
  /// of an edge class have one length, which is critical for the volume in angles.
  const solver::Problem* make(const Sample& sample, std::vector<double>& x) {
    x = sample.lengths;
    functional_ = at_lengths(GetParam(), *sample.triangulation, x);
    x = moved(x, direction(random_, x.size()), 0.01);
    return &functional_->problem();
  }

  std::unique_ptr<Functional> functional_;  ///< the latest one made
  std::mt19937_64 random_{77};
};

TEST_P(EnergyContract, GradientIsTheDerivativeOfTheValueAndIsNotZero) {
  for (int n = 0; n < kSamples; ++n) {
    const Sample sample = random_sample(random_);
    std::vector<double> x;
    const auto energy = make(sample, x);
    const auto at = energy->at(x);
    ASSERT_TRUE(at);
    const auto d = direction(random_, x.size());
    const auto along = [&](double t) {
      const auto there = energy->at(moved(x, d, t));
      EXPECT_TRUE(there);
      return there->value();
    };
    const testing::Derivative derivative = testing::ridders(along, 0.01);
    EXPECT_NEAR(dot(at->gradient(), d), derivative.value, 1e-9 + 10 * derivative.error);
    EXPECT_LT(derivative.error, 1e-6);
    double largest = 0;
    for (const double g : at->gradient()) largest = std::max(largest, std::fabs(g));
    EXPECT_GT(largest, 1e-4);
  }
}

TEST_P(EnergyContract, HessianIsTheDerivativeOfTheGradient) {
  for (int n = 0; n < kSamples; ++n) {
    const Sample sample = random_sample(random_);
    std::vector<double> x;
    const auto energy = make(sample, x);
    std::vector<double> product(x.size());
    const auto d = direction(random_, x.size());
    std::vector<testing::Derivative> derivative(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      derivative[i] = testing::ridders(
          [&](double t) {
            const auto there = energy->at(moved(x, d, t));
            EXPECT_TRUE(there);
            return there->gradient()[i];
          },
          0.01);
    }
    const auto at = energy->at(x, solver::Order::kSecond);
    ASSERT_TRUE(at);
    at->hessian_times(d, product);
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_NEAR(product[i], derivative[i].value, 1e-8 + 10 * derivative[i].error);
      EXPECT_LT(derivative[i].error, 1e-6);
    }
  }
}

/// The assembled Hessian as a full matrix.
std::vector<std::vector<double>> assembled(const solver::Problem& energy,
                                           const solver::Evaluation& at) {
  const auto& pattern = energy.hessian_pattern();
  std::vector<double> values(pattern.row.size());
  at.hessian_values(values);
  const std::size_t n = energy.dimension();
  std::vector<std::vector<double>> full(n, std::vector<double>(n));
  for (std::size_t column = 0; column < n; ++column) {
    const auto begin = static_cast<std::size_t>(pattern.column_start[column]);
    const auto end = static_cast<std::size_t>(pattern.column_start[column + 1]);
    EXPECT_EQ(pattern.row[begin], static_cast<int>(column)) << "the diagonal comes first";
    EXPECT_TRUE(std::is_sorted(pattern.row.begin() + std::ptrdiff_t(begin),
                               pattern.row.begin() + std::ptrdiff_t(end)));
    for (std::size_t k = begin; k < end; ++k) {
      const auto row = static_cast<std::size_t>(pattern.row[k]);
      full[row][column] = full[column][row] = values[k];
    }
  }
  return full;
}

TEST_P(EnergyContract, AssembledHessianProductAndBlocksAgreeAndThePatternCoversAll) {
  for (int n = 0; n < kSamples; ++n) {
    const Sample sample = random_sample(random_);
    std::vector<double> x;
    const auto energy = make(sample, x);
    const std::size_t size = x.size();
    std::vector<double> product(size);
    const auto at = energy->at(x, solver::Order::kSecond);
    ASSERT_TRUE(at);
    const auto full = assembled(*energy, *at);
    for (std::size_t j = 0; j < size; ++j) {
      std::vector<double> unit(size);
      unit[j] = 1;
      at->hessian_times(unit, product);
      for (std::size_t i = 0; i < size; ++i)
        EXPECT_NEAR(product[i], full[i][j], 1e-12 * (1 + std::fabs(full[i][j])));
    }
    for (const std::size_t width : {std::size_t{1}, std::size_t{3}, std::size_t{8}}) {
      std::vector<double> blocks((size + width - 1) / width * width * width, -1.0);
      at->hessian_diagonal_blocks(width, blocks);
      for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = i / width * width; j < std::min(size, (i / width + 1) * width); ++j) {
          EXPECT_NEAR(blocks[(i / width * width + i % width) * width + j % width], full[i][j],
                      1e-12 * (1 + std::fabs(full[i][j])));
        }
      }
    }
  }
}

// An evaluation answers for its own point, whatever has been evaluated since, also into the same
// memory: that gives the same bits as fresh memory does.
TEST_P(EnergyContract, EvaluationsAreValues) {
  for (int n = 0; n < kSamples; ++n) {
    const Sample sample = random_sample(random_);
    std::vector<double> x;
    const auto energy = make(sample, x);
    const std::vector<double> y = moved(x, direction(random_, x.size()), 0.01);
    const auto numbers_of = [&](const solver::Evaluation& at) {
      std::vector<double> all(at.gradient().begin(), at.gradient().end());
      all.push_back(at.value());
      const std::size_t nnz = energy->hessian_pattern().row.size();
      all.resize(all.size() + nnz);
      at.hessian_values(std::span(all).last(nnz));
      return all;
    };
    const auto here = energy->at(x, solver::Order::kSecond);
    ASSERT_TRUE(here);
    const std::vector<double> before = numbers_of(*here);
    auto there = energy->at(y, solver::Order::kSecond);
    ASSERT_TRUE(there);
    EXPECT_NE(numbers_of(*there), before);
    EXPECT_EQ(numbers_of(*here), before);
    const solver::Evaluation* memory = there.get();
    ASSERT_TRUE(energy->evaluate(x, solver::Order::kFirst, there));
    ASSERT_TRUE(energy->evaluate(x, solver::Order::kSecond, there));
    EXPECT_EQ(there.get(), memory);
    EXPECT_EQ(numbers_of(*there), before);
    std::vector<double> other = sample.lengths;
    const auto another = at_lengths(GetParam(), *sample.triangulation, other);
    ASSERT_TRUE(another->problem().evaluate(x, solver::Order::kSecond, there));
    EXPECT_NE(there.get(), memory) << "not an evaluation of this problem";
    EXPECT_EQ(numbers_of(*there), before);
  }
}

TEST_P(EnergyContract, IsStrictlyConvexWhereNothingIsFlat) {
  for (int n = 0; n < kSamples; ++n) {
    const Sample sample = random_sample(random_);
    std::vector<double> x;
    const auto energy = make(sample, x);
    std::vector<double> product(x.size());
    const auto at = energy->at(x, solver::Order::kSecond);
    ASSERT_TRUE(at);
    for (int k = 0; k < 20; ++k) {
      const auto d = direction(random_, x.size());
      at->hessian_times(d, product);
      EXPECT_GT(dot(d, product), 0);
    }
  }
}

TEST_P(EnergyContract, RelabellingChangesNoValue) {
  for (int n = 0; n < kSamples; ++n) {
    const Sample sample = random_sample(random_);
    const std::vector<double> uniform(sample.lengths.size(), 0.8);
    const topology::Triangulation shuffled(topology::random_relabelling(
        sample.triangulation->gluings(), 5 + static_cast<unsigned>(n)));
    double value[2] = {};
    int k = 0;
    for (const topology::Triangulation* triangulation :
         {static_cast<const topology::Triangulation*>(sample.triangulation.get()), &shuffled}) {
      std::vector<double> x = uniform;
      const auto functional = at_lengths(GetParam(), *triangulation, x);
      const auto at = functional->problem().at(x);
      ASSERT_TRUE(at);
      value[k++] = at->value();
    }
    EXPECT_NEAR(value[0], value[1], 1e-12);
  }
}

std::string energy_test_name(const ::testing::TestParamInfo<Energy>& parameter) {
  return testing::test_name(parameter.param.name);
}

INSTANTIATE_TEST_SUITE_P(All, EnergyContract,
                         ::testing::ValuesIn(energies().begin(), energies().end()),
                         energy_test_name);

// The extended co-volume is convex and C1 on all of R^E: along random lines, through flat
// tetrahedra and lengths <= 0, the gradient is monotone and the value is its integral.
TEST(CoVolume, IsConvexAndC1EverywhereOnRE) {
  std::mt19937_64 random(78);
  std::uniform_real_distribution<double> far(-1, 6);
  for (int n = 0; n < 40; ++n) {
    const Sample sample = random_sample(random);
    const CoVolume energy(*sample.triangulation);
    const std::size_t size = sample.lengths.size();
    std::vector<double> a(size), b(size), d(size);
    for (double& x : a) x = far(random);
    for (double& x : b) x = far(random);
    for (std::size_t i = 0; i < size; ++i) d[i] = b[i] - a[i];
    const int steps = 2000;
    double first = 0, last = 0, integral = 0, previous = 0;
    for (int k = 0; k <= steps; ++k) {
      const CoVolumeAt at = energy.at(moved(a, d, double(k) / steps));
      ASSERT_TRUE(at.is_defined());
      const double value = at.value();
      const double slope = dot(at.gradient(), d);
      if (k == 0) first = value;
      if (k > 0) {
        EXPECT_GE(slope, previous - 1e-11) << "the gradient is monotone along a line";
        integral += (slope + previous) / 2 / steps;
      }
      previous = slope;
      last = value;
    }
    // The slope has square-root corners where tetrahedra go flat: the trapezoidal rule is of order
    // 3/2 there.
    EXPECT_NEAR(last - first, integral, 2e-3);
  }
}

TEST(CoVolume, ConvexityBoundIsBelowTheRayleighQuotients) {
  std::mt19937_64 random(79);
  for (int n = 0; n < kSamples; ++n) {
    const Sample sample = random_sample(random);
    const CoVolume energy(*sample.triangulation);
    std::vector<double> product(sample.lengths.size());
    const CoVolumeAt at = energy.at(sample.lengths, solver::Order::kSecond);
    const double bound = at.convexity_bound();
    EXPECT_GT(bound, 0);
    for (int k = 0; k < 20; ++k) {
      const auto d = direction(random, sample.lengths.size());
      at.hessian_times(d, product);
      EXPECT_GE(dot(d, product), bound * dot(d, d) * (1 - 1e-12));
    }
  }
}

}  // namespace
}  // namespace tripus::energies
