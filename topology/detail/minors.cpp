#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <type_traits>
#include <utility>

#include "base/stop.hpp"
#include "topology/detail/smith_form.hpp"

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
Residue residue(const BigInteger& x, std::uint32_t p) { return residue(to_int64(x % p), p); }

double bits_of(double x) { return std::log2(std::max(x, 1.0)); }
double bits_of(const BigInteger& x) { return static_cast<double>(binary_digits(x)); }

/// The determinant of a square matrix modulo p, by Gauss's elimination.
Residue determinant(ResidueMatrix matrix, std::uint32_t p) {
  Residue result = 1;
  for (std::size_t top = 0; top < matrix.size(); ++top) {
    std::size_t pivot = top;
    while (pivot < matrix.size() && matrix[pivot][top] == 0) ++pivot;
    if (pivot == matrix.size()) return 0;
    if (pivot != top) {
      std::swap(matrix[pivot], matrix[top]);
      result = (p - result) % p;
    }
    const Residue scale = inverse(matrix[top][top], p);
    result = result * matrix[top][top] % p;
    for (std::size_t i = top + 1; i < matrix.size(); ++i) {
      if (matrix[i][top] == 0) continue;
      const Residue factor = p - matrix[i][top] * scale % p;
      for (std::size_t j = top; j < matrix.size(); ++j)
        matrix[i][j] = (matrix[i][j] + factor * matrix[top][j]) % p;
    }
  }
  return result;
}

template <class Integer>
using Rows = std::vector<SparseRow<Integer>>;

/// The columns that are not 0, each as its entries by row.
template <class Integer>
struct Columns {
  Rows<Integer> entries;
  std::vector<std::size_t> index;
};

template <class Integer>
Columns<Integer> columns_of(const Rows<Integer>& rows, std::size_t column_count) {
  Rows<Integer> all(column_count);
  for (std::uint32_t r = 0; r < rows.size(); ++r)
    for (const auto& entry : rows[r]) all[entry.column].push_back({r, entry.value});
  Columns<Integer> columns;
  for (std::size_t j = 0; j < column_count; ++j) {
    if (all[j].empty()) continue;
    columns.index.push_back(j);
    columns.entries.push_back(std::move(all[j]));
  }
  return columns;
}

/// A minor that is not 0, as large as there is one: its rows and columns.
struct Regular {
  std::vector<std::size_t> rows, columns;
};

/// The same modulo p: columns are brought to echelon form one by one, until there are enough.
template <class Integer>
Regular regular_modulo(const Columns<Integer>& columns, std::size_t height, std::uint32_t p,
                       const Stop& stop) {
  Regular found;
  ResidueMatrix basis(height);  // by first place, where it is 1
  for (std::size_t j = 0; j < columns.index.size() && found.rows.size() < height; ++j) {
    throw_if_stopped(stop);
    std::vector<Residue> vector(height, 0);
    for (const auto& entry : columns.entries[j]) vector[entry.column] = residue(entry.value, p);
    for (std::size_t first = 0; first < height; ++first) {
      if (vector[first] == 0) continue;
      const bool is_new = basis[first].empty();
      const Residue factor = is_new ? inverse(vector[first], p) : p - vector[first];
      for (std::size_t i = first; i < height; ++i)
        vector[i] = is_new ? vector[i] * factor % p : (vector[i] + factor * basis[first][i]) % p;
      if (!is_new) continue;
      basis[first] = std::move(vector);
      found.rows.push_back(first);
      found.columns.push_back(columns.index[j]);
      break;
    }
  }
  return found;
}

/// log2 of a bound on all minors: the product of the rows' lengths, in the sum of absolute values.
template <class Integer>
double bits_of_minors(const Rows<Integer>& rows) {
  using Sum = std::conditional_t<std::is_same_v<Integer, BigInteger>, BigInteger, double>;
  using std::abs;   // of doubles: C's alone is for int
  double bits = 2;  // the sign, and rounding
  for (const auto& row : rows) {
    Sum sum = 0;
    for (const auto& entry : row) sum += abs(Sum(entry.value));
    bits += bits_of(sum);
  }
  return bits;
}

/// A matrix of -1, 0 and 1 with at most three entries in a row.
class Signs {
 public:
  struct Entry {
    std::uint32_t column = 0;
    int sign = 0;
  };
  using Row = std::array<Entry, 3>;

  /// The unit matrix in the rows `own`; the others are 0.
  Signs(std::size_t height, const std::vector<std::size_t>& own)
      : rows_(height), is_own_(height), width_(own.size()) {
    for (std::uint32_t j = 0; j < own.size(); ++j) {
      rows_[own[j]][0] = {j, 1};
      is_own_[own[j]] = true;
    }
  }

  /// Beside the unit matrix, signs at pseudo-random places. Without it a column would be empty now
  /// and then, and all minors 0 where there are many columns.
  void scatter(std::mt19937& random) {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (std::size_t k = is_own_[i] ? 1 : 0; k < rows_[i].size(); ++k)
        rows_[i][k] = {static_cast<std::uint32_t>(random() % width_), random() % 2 == 0 ? 1 : -1};
  }

  const Row& row(std::size_t i) const { return rows_[i]; }

 private:
  std::vector<Row> rows_;
  std::vector<bool> is_own_;
  std::size_t width_;
};

/// The determinant of rows * signs modulo p.
template <class Integer>
Residue determinant_of_product(const Rows<Integer>& rows, const Signs& signs, std::uint32_t p) {
  ResidueMatrix product(rows.size(), std::vector<Residue>(rows.size(), 0));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& entry : rows[i]) {
      const Residue plus = residue(entry.value, p), minus = (p - plus) % p;
      for (const auto& [j, sign] : signs.row(entry.column))
        if (sign != 0) product[i][j] = (product[i][j] + (sign > 0 ? plus : minus)) % p;
    }
  return determinant(std::move(product), p);
}

/// A minor of the size of the rank. Were it smaller modulo each of the primes, whose product is
/// above every minor, then all the larger minors would be 0.
template <class Integer>
Regular regular_part(const Rows<Integer>& rows, std::size_t column_count,
                     const std::vector<std::uint32_t>& primes, const Stop& stop) {
  const Columns<Integer> columns = columns_of(rows, column_count);
  const std::size_t most = std::min(rows.size(), columns.index.size());
  Regular best;
  for (const std::uint32_t p : primes) {
    if (best.rows.size() == most) break;
    Regular found = regular_modulo(columns, rows.size(), p, stop);
    if (found.rows.size() > best.rows.size()) best = std::move(found);
  }
  return best;
}

/// |x| for the x of least absolute value with these residues (Chinese remainders).
BigInteger least_absolute_value(const std::vector<Residue>& residues_of_x,
                                const std::vector<std::uint32_t>& primes) {
  BigInteger x = 0, modulus = 1;
  for (std::size_t i = 0; i < primes.size(); ++i) {
    const std::uint32_t p = primes[i];
    const auto at = static_cast<Residue>(to_int64(x % p));
    const auto step = static_cast<Residue>(to_int64(modulus % p));
    const Residue times = (residues_of_x[i] + p - at) % p * inverse(step, p) % p;
    x += modulus * times;
    modulus *= p;
  }
  const BigInteger other = modulus - x;
  return x < other ? x : other;
}

}  // namespace

template <class Integer>
Minors minors(const std::vector<SparseRow<Integer>>& rows, std::size_t column_count,
              const Stop& stop) {
  constexpr int kMost = 8;
  Minors result;
  if (rows.empty()) return result;
  // In rows * signs the sum of a row's absolute values is at most three times what it was.
  const auto primes =
      primes_for(bits_of_minors(rows) + static_cast<double>(rows.size()) * std::log2(3));
  const Regular regular = regular_part(rows, column_count, primes, stop);
  result.rank = regular.rows.size();
  if (result.rank == 0) return result;
  Rows<Integer> independent;
  for (const std::size_t r : regular.rows) independent.push_back(rows[r]);
  // Each determinant is a sum of minors with the minors of the signs as factors (Cauchy and Binet),
  // so that the product of the invariant factors divides it. The first is a minor that is not 0.
  result.multiple = 0;
  Signs signs(column_count, regular.columns);
  std::mt19937 random(1);
  for (int tried = 0; tried < kMost && result.multiple != 1; ++tried) {
    if (tried > 0) signs.scatter(random);
    std::vector<Residue> determinants;
    for (const std::uint32_t p : primes) {
      throw_if_stopped(stop);
      determinants.push_back(determinant_of_product(independent, signs, p));
    }
    result.multiple = gcd(result.multiple, least_absolute_value(determinants, primes));
  }
  return result;
}

template Minors minors(const std::vector<SparseRow<std::int64_t>>&, std::size_t, const Stop&);
template Minors minors(const std::vector<SparseRow<BigInteger>>&, std::size_t, const Stop&);

}  // namespace tripus::topology::detail
