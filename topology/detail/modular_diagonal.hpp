#pragma once

#include <cstddef>
#include <vector>

#include "base/big_number.hpp"
#include "base/stop.hpp"
#include "topology/detail/integer_matrix.hpp"

namespace tripus::topology::detail {

/// The diagonal of a matrix brought to Smith's form modulo m > 0: the entries that are not 0 modulo
/// m, divisors of m, each dividing the next. Where the product of the invariant factors divides m
/// these are the invariant factors, but for those that are m. Polls `stop`; throws Stopped.
template <class Integer>
std::vector<BigInteger> diagonal_modulo(const std::vector<SparseRow<Integer>>& rows,
                                        std::size_t column_count, const BigInteger& m,
                                        const Stop& stop = {});

}  // namespace tripus::topology::detail
