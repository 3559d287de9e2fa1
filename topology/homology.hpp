#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/stop.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {

/// A finitely generated abelian group: Z^rank + Z_d1 + Z_d2 + ..., each factor dividing the next.
struct AbelianGroup {
  std::size_t rank = 0;
  /// The invariant factors > 1 in decimal, smallest first; they may be of any size.
  std::vector<std::string> invariant_factors;

  friend bool operator==(const AbelianGroup&, const AbelianGroup&) = default;
};

/// "0", "Z", "2 Z + Z_3", "Z + 2 Z_2 + Z_6": as Regina writes it.
std::string to_string(const AbelianGroup& group);

/// The group that a text means: "2 Z + Z_3", "2Z+Z_3", "Z^2+Z/3", "Z+Z+Z/3Z", "(Z/2)^2", "0".
/// Factors need not divide each other. Throws InvalidInput.
AbelianGroup parse_abelian_group(std::string_view text);

/// The first homology of the manifold: of the space without its vertices, which is that of the
/// compact manifold with boundary (and of a closed one where the links are spheres).
///
/// From the dual 2-complex: generators are the faces outside a spanning tree, relators the edge
/// classes. Unit pivots are eliminated sparsely, shortest relator first; what is left goes through
/// a dense Smith normal form. All integers grow as needed, so there is no overflow.
/// Cost: near linear in T where unit pivots keep the relators short, as in covers; the dense rest
/// costs its size cubed. Polls `stop`; throws Stopped.
AbelianGroup first_homology(const Triangulation& triangulation, const Stop& stop = {});

}  // namespace tripus::topology
