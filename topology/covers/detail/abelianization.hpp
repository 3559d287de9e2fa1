#pragma once

#include <cstddef>
#include <vector>

#include "topology/covers/presentation.hpp"
#include "topology/detail/smith_form.hpp"

namespace tripus::topology::detail {

/// A group made abelian, with a basis: r Z + Z_d1 + Z_d2 + ..., each factor dividing the next.
struct Abelianization {
  std::size_t rank = 0;
  std::vector<BigInteger> factors;  ///< > 1
  /// [generators x (rank + factors)] each generator in the basis, free part first.
  std::vector<std::vector<BigInteger>> coordinates;
};

/// Exact. Reduces the presentation first; what is left is dense and of cubic cost.
/// Throws Unsupported beyond 1000 generators that are left.
Abelianization abelianization(const Presentation& presentation);

}  // namespace tripus::topology::detail
