#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/stop.hpp"
#include "topology/detail/integer_matrix.hpp"

namespace tripus::topology::detail {

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
