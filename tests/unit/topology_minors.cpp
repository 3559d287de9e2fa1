// Rank and minors of integer matrices against all their minors, each expanded by Laplace's rule.
#include <algorithm>
#include <bit>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "topology/detail/smith_form.hpp"

namespace tripus::topology {
namespace {

using Dense = std::vector<std::vector<std::int64_t>>;

/// The determinant of the rows and columns whose bits are set, by the first of these rows.
BigInteger minor(const Dense& matrix, unsigned rows, unsigned columns) {
  if (rows == 0) return 1;
  const auto top = static_cast<std::size_t>(std::countr_zero(rows));
  BigInteger sum = 0;
  int sign = 1;
  for (std::size_t j = 0; j < matrix[top].size(); ++j) {
    if ((columns >> j & 1u) == 0) continue;
    if (matrix[top][j] != 0)
      sum += sign * matrix[top][j] * minor(matrix, rows & (rows - 1), columns & ~(1u << j));
    sign = -sign;
  }
  return sum;
}

struct AllMinors {
  std::size_t rank = 0;
  BigInteger divisor = 1;  // the greatest common one of those of this size
};

AllMinors all_minors(const Dense& matrix) {
  AllMinors found;
  for (std::size_t size = 1; size <= std::min(matrix.size(), matrix[0].size()); ++size) {
    BigInteger divisor = 0;
    for (unsigned rows = 0; rows < 1u << matrix.size(); ++rows)
      for (unsigned columns = 0; columns < 1u << matrix[0].size(); ++columns)
        if (std::popcount(rows) == static_cast<int>(size) &&
            std::popcount(columns) == static_cast<int>(size))
          divisor = gcd(divisor, minor(matrix, rows, columns));
    if (divisor == 0) break;
    found = {size, divisor};
  }
  return found;
}

detail::Minors minors_of(const Dense& matrix) {
  std::vector<detail::SparseRow<std::int64_t>> rows(matrix.size());
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::uint32_t j = 0; j < matrix[i].size(); ++j)
      if (matrix[i][j] != 0) rows[i].push_back({j, matrix[i][j]});
  const detail::Minors found = detail::minors(rows, matrix[0].size(), nullptr);
  // The same with long integers.
  std::vector<detail::SparseRow<BigInteger>> longer(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& entry : rows[i]) longer[i].push_back({entry.column, entry.value});
  const detail::Minors again = detail::minors(longer, matrix[0].size(), nullptr);
  EXPECT_EQ(again.rank, found.rank);
  EXPECT_EQ(again.multiple, found.multiple);
  return found;
}

void expect_multiple_of_all(const Dense& matrix) {
  const AllMinors all = all_minors(matrix);
  const detail::Minors found = minors_of(matrix);
  EXPECT_EQ(found.rank, all.rank);
  EXPECT_GT(found.multiple, 0);
  EXPECT_EQ(found.multiple % all.divisor, 0);
}

// Every size up to 5 x 5, every share of zeros, small entries, and the largest that there are.
TEST(Minors, AreThoseOfRandomMatrices) {
  std::mt19937_64 random(20261130);
  int exact = 0, trials = 0;
  for (std::size_t height = 1; height <= 5; ++height)
    for (std::size_t width = 1; width <= 5; ++width)
      for (int trial = 0; trial < 60; ++trial) {
        SCOPED_TRACE(::testing::Message() << height << " x " << width << ", trial " << trial);
        const std::int64_t largest[] = {1, 3, 12, std::numeric_limits<std::int64_t>::max() / 4};
        std::uniform_int_distribution<std::int64_t> entry(-largest[trial % 4], largest[trial % 4]);
        Dense matrix(height, std::vector<std::int64_t>(width, 0));
        for (auto& row : matrix)
          for (auto& x : row)
            if (random() % 5 >= static_cast<unsigned>(trial % 5)) x = entry(random);
        // Dependent rows and columns.
        if (trial % 3 == 0) matrix[random() % height] = matrix[random() % height];
        if (trial % 4 == 1)
          for (auto& row : matrix) row[width - 1] = 2 * row[0];
        expect_multiple_of_all(matrix);
        exact += minors_of(matrix).multiple == all_minors(matrix).divisor;
        ++trials;
      }
  EXPECT_GT(2 * exact, trials);  // "mostly the product itself"
}

// Products of a tall and a wide matrix: their rank is small, all larger minors are 0.
TEST(Minors, OfLowRank) {
  std::mt19937 random(5);
  const auto entry = [&] { return static_cast<std::int64_t>(random() % 7) - 3; };
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    const std::size_t height = 3 + random() % 3, width = 3 + random() % 4, rank = random() % 3;
    Dense matrix(height, std::vector<std::int64_t>(width, 0));
    for (std::size_t k = 0; k < rank; ++k) {
      std::vector<std::int64_t> column(height), row(width);
      std::ranges::generate(column, entry);
      std::ranges::generate(row, entry);
      for (std::size_t i = 0; i < height; ++i)
        for (std::size_t j = 0; j < width; ++j) matrix[i][j] += column[i] * row[j];
    }
    expect_multiple_of_all(matrix);
  }
}

// A number that is 0 modulo the first primes that are tried.
TEST(Minors, OfMultiplesOfTheFirstPrimes) {
  constexpr std::int64_t p = 2147483647, q = 2147483629;
  EXPECT_EQ(minors_of({{p}}).multiple, p);
  EXPECT_EQ(minors_of({{p * q}}).multiple, p * q);
  for (const Dense& matrix : {Dense{{p, 0}, {0, q}}, Dense{{p, q}, {q, p}}, Dense{{p, p}, {p, p}},
                              Dense{{p, 1}, {0, p}, {p, p}}, Dense{{p, q, p * q}, {0, p, 0}}})
    expect_multiple_of_all(matrix);
}

TEST(Minors, OfNothing) {
  using Rows = std::vector<detail::SparseRow<std::int64_t>>;
  EXPECT_EQ(detail::minors(Rows{}, 3, nullptr).rank, 0u);
  EXPECT_EQ(detail::minors(Rows{{}, {}}, 3, nullptr).rank, 0u);
  EXPECT_EQ(detail::minors(Rows{{}, {}}, 3, nullptr).multiple, 1);
}

}  // namespace
}  // namespace tripus::topology
