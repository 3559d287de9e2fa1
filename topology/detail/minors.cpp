#include "topology/detail/minors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "base/stopped.hpp"

namespace tripus::topology::detail {
namespace {

using Residue = std::uint64_t;  // below 2^31, so that products fit
using ResidueMatrix = std::vector<std::vector<Residue>>;

bool is_prime(std::uint32_t odd) {
  for (std::uint32_t d = 3; d <= odd / d; d += 2)
    if (odd % d == 0) return false;
  return true;
}

/// Primes whose product is above 2^bits, from 2^31 downwards.
std::vector<std::uint32_t> primes_for(double bits) {
  std::vector<std::uint32_t> primes;
  for (std::uint32_t candidate = 0x7fffffff; bits > 0; candidate -= 2)
    if (is_prime(candidate)) {
      primes.push_back(candidate);
      bits -= std::log2(candidate);
    }
  return primes;
}

Residue power(Residue base, std::uint32_t exponent, std::uint32_t p) {
  Residue result = 1;
  for (; exponent > 0; exponent >>= 1, base = base * base % p)
    if (exponent & 1) result = result * base % p;
  return result;
}
Residue inverse(Residue x, std::uint32_t p) { return power(x, p - 2, p); }

Residue residue(std::int64_t x, std::uint32_t p) {
  const auto signed_p = static_cast<std::int64_t>(p);
  return static_cast<Residue>((x % signed_p + signed_p) % signed_p);
}

/// Gauss's elimination modulo p.
struct Elimination {
  Residue determinant = 1;        ///< of a square matrix
  std::vector<std::size_t> rows;  ///< independent ones, as many as the rank
};

Elimination eliminate(ResidueMatrix matrix, std::uint32_t p) {
  Elimination found;
  std::vector<std::size_t> place(matrix.size());
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = i;
  const std::size_t width = matrix.empty() ? 0 : matrix[0].size();
  std::size_t top = 0;
  for (std::size_t column = 0; column < width && top < matrix.size(); ++column) {
    std::size_t pivot = top;
    while (pivot < matrix.size() && matrix[pivot][column] == 0) ++pivot;
    if (pivot == matrix.size()) continue;
    if (pivot != top) {
      std::swap(matrix[pivot], matrix[top]);
      std::swap(place[pivot], place[top]);
      found.determinant = (p - found.determinant) % p;
    }
    const Residue scale = inverse(matrix[top][column], p);
    found.determinant = found.determinant * matrix[top][column] % p;
    for (std::size_t i = top + 1; i < matrix.size(); ++i) {
      if (matrix[i][column] == 0) continue;
      const Residue factor = p - matrix[i][column] * scale % p;
      for (std::size_t j = column; j < width; ++j)
        matrix[i][j] = (matrix[i][j] + factor * matrix[top][j]) % p;
    }
    found.rows.push_back(place[top++]);
  }
  if (top < matrix.size()) found.determinant = 0;
  return found;
}

using Rows = std::vector<SparseRow<std::int64_t>>;

ResidueMatrix residues(const Rows& rows, std::size_t column_count, std::uint32_t p) {
  ResidueMatrix matrix(rows.size(), std::vector<Residue>(column_count, 0));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& entry : rows[i]) matrix[i][entry.column] = residue(entry.value, p);
  return matrix;
}

/// log2 of a bound on all minors: the product of the rows' lengths, in the sum of absolute values.
double bits_of_minors(const Rows& rows) {
  double bits = 2;  // the sign, and rounding
  for (const auto& row : rows) {
    double sum = 0;
    for (const auto& entry : row) sum += std::fabs(static_cast<double>(entry.value));
    bits += std::log2(std::max(sum, 1.0));
  }
  return bits;
}

/// A matrix of -1, 0 and 1 with few entries in a row.
class Signs {
 public:
  Signs(std::size_t height, std::size_t width, std::mt19937& random) : entries_(height) {
    for (auto& row : entries_)
      for (Entry& entry : row)
        entry = {static_cast<std::uint32_t>(random() % width), random() % 2 == 0};
  }

  struct Entry {
    std::uint32_t column;
    bool positive;
  };
  const std::array<Entry, 3>& row(std::size_t i) const { return entries_[i]; }

 private:
  std::vector<std::array<Entry, 3>> entries_;
};

/// Elimination on rows * signs.
Elimination eliminate_product(const Rows& rows, const Signs& signs, std::uint32_t p) {
  ResidueMatrix product(rows.size(), std::vector<Residue>(rows.size(), 0));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& entry : rows[i]) {
      const Residue plus = residue(entry.value, p), minus = (p - plus) % p;
      for (const auto& [j, positive] : signs.row(entry.column))
        product[i][j] = (product[i][j] + (positive ? plus : minus)) % p;
    }
  return eliminate(std::move(product), p);
}

/// Rows that are independent over the rationals, as many as the rank. Fewer modulo each of the
/// primes, whose product is above every minor, would mean that all the larger minors are 0.
std::vector<std::size_t> independent_rows(const Rows& rows, std::size_t column_count,
                                          const std::vector<std::uint32_t>& primes,
                                          const std::atomic<bool>* stop_requested) {
  std::mt19937 random(1);
  const Signs signs(column_count, rows.size(), random);
  std::vector<std::size_t> best = eliminate_product(rows, signs, primes[0]).rows;
  for (const std::uint32_t p : primes) {
    if (best.size() == rows.size()) break;
    throw_if_stopped(stop_requested);
    auto found = eliminate(residues(rows, column_count, p), p).rows;
    if (found.size() > best.size()) best = std::move(found);
  }
  return best;
}

/// |x| for the x of least absolute value with these residues (Chinese remainders).
BigInteger least_absolute_value(const std::vector<Residue>& residues_of_x,
                                const std::vector<std::uint32_t>& primes) {
  BigInteger x = 0, modulus = 1;
  for (std::size_t i = 0; i < primes.size(); ++i) {
    const std::uint32_t p = primes[i];
    const auto at = static_cast<Residue>(x % p), step = static_cast<Residue>(modulus % p);
    const Residue times = (residues_of_x[i] + p - at) % p * inverse(step, p) % p;
    x += modulus * times;
    modulus *= p;
  }
  const BigInteger other = modulus - x;
  return x < other ? x : other;
}

}  // namespace

Minors minors(const Rows& rows, std::size_t column_count, const std::atomic<bool>* stop_requested) {
  constexpr int kMost = 8;
  Minors result;
  if (rows.empty()) return result;
  // Entries of rows * signs are sums of at most three times a row's absolute values, and there are
  // as many in a row as there are rows.
  const auto count = static_cast<double>(rows.size());
  const auto primes = primes_for(bits_of_minors(rows) + count * std::log2(3 * std::sqrt(count)));
  const auto chosen = independent_rows(rows, column_count, primes, stop_requested);
  result.rank = chosen.size();
  if (chosen.empty()) return result;
  Rows independent;
  for (const std::size_t r : chosen) independent.push_back(rows[r]);
  // Each determinant is a sum of minors with the minors of the signs as factors (Cauchy and Binet),
  // so that the product of the invariant factors divides it.
  result.multiple = 0;
  std::mt19937 random(1);
  for (int tried = 0; (tried < kMost || result.multiple == 0) && result.multiple != 1; ++tried) {
    const Signs signs(column_count, chosen.size(), random);
    std::vector<Residue> determinants;
    for (const std::uint32_t p : primes) {
      throw_if_stopped(stop_requested);
      determinants.push_back(eliminate_product(independent, signs, p).determinant);
    }
    result.multiple = gcd(result.multiple, least_absolute_value(determinants, primes));
  }
  return result;
}

}  // namespace tripus::topology::detail
