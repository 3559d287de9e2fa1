#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/bignum.hpp"

namespace tripus::structure::detail {

/// A square sparse system of linear equations over the rationals: row r says that the sum of
/// coefficient * unknown over its entries is right_side[r].
struct RationalSystem {
  std::vector<std::vector<std::pair<std::size_t, long>>> rows;  ///< (unknown, coefficient != 0)
  std::vector<Rational> right_side;
};

/// The solution, or nothing if the matrix is singular. Elimination with the pivot that fills least.
std::optional<std::vector<Rational>> solve(const RationalSystem& system);

}  // namespace tripus::structure::detail
