#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/big_number.hpp"
#include "base/stop.hpp"

namespace tripus::topology::detail {

template <class Integer>
struct Entry {
  std::uint32_t column;
  Integer value;  // not 0
};

/// A sparse row, columns ascending.
template <class Integer>
using SparseRow = std::vector<Entry<Integer>>;

/// The row that summands in any order add up to.
SparseRow<std::int64_t> collected(SparseRow<std::int64_t> summands);

/// What is known of a matrix after its diagonalisation over the integers.
struct SmithForm {
  std::size_t rank = 0;
  std::vector<BigInteger> factors;  ///< the diagonal entries > 1, each dividing the next
};

/// The Smith normal form of a sparse integer matrix. Any size of number; no overflow. Polls
/// `stop`; throws Stopped.
SmithForm smith_form(std::vector<SparseRow<std::int64_t>> rows, std::size_t column_count,
                     const Stop& stop = {});

/// The diagonal of a matrix brought to Smith's form modulo m > 0: the entries that are not 0 modulo
/// m, divisors of m, each dividing the next. Where the product of the invariant factors divides m
/// these are the invariant factors, but for those that are m. Polls `stop`; throws Stopped.
template <class Integer>
std::vector<BigInteger> diagonal_modulo(const std::vector<SparseRow<Integer>>& rows,
                                        std::size_t column_count, const BigInteger& m,
                                        const Stop& stop = {});

/// What the minors of an integer matrix say of its Smith form.
struct Minors {
  std::size_t rank = 0;
  /// A multiple of the product of the invariant factors, > 0; mostly the product itself.
  BigInteger multiple = 1;
};

/// The rank, and the greatest common divisor of a minor of that size that is not 0 and of some that
/// are combined from all by fixed pseudo-random numbers. Calculated modulo as many primes as
/// Hadamard's bound asks for, so that numbers do not grow. Exact, whatever the pseudo-random
/// numbers are; takes (k^2 n) times the number of digits of the largest minor for k rows and n
/// columns. Polls `stop`; throws Stopped.
template <class Integer>
Minors minors(const std::vector<SparseRow<Integer>>& rows, std::size_t column_count,
              const Stop& stop);
extern template Minors minors(const std::vector<SparseRow<std::int64_t>>&, std::size_t,
                              const Stop&);
extern template Minors minors(const std::vector<SparseRow<BigInteger>>&, std::size_t, const Stop&);

}  // namespace tripus::topology::detail
