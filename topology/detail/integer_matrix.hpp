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

}  // namespace tripus::topology::detail
