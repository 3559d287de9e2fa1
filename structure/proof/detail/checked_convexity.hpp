#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "structure/proof/detail/arb_number.hpp"
#include "topology/triangulation.hpp"
#include "topology/vertex_kinds.hpp"

/// What the checker of proofs shows of all tetrahedra together, by no code of the prover.
namespace tripus::structure::detail {

/// A symmetric matrix [n x n] with few entries, in balls; entry (i, j) at [i][j] and at [j][i].
using CheckedMatrix = std::vector<std::map<std::size_t, Arb>>;

/// A share s > 0 with A >= s diag(A) for every member, or 0 where none was shown: the midpoints,
/// less what the radii can do, are eliminated in balls whose precision grows until every pivot has
/// a sign.
double checked_share(const CheckedMatrix& matrix);

/// Edge classes, one for each ideal vertex, whose numbers of ends at these vertices have a
/// determinant that is not 0: with their lengths held no horosphere can move.
/// Fewer where the edges that are not excluded [E] do not suffice.
std::vector<std::size_t> checked_pins(const topology::Triangulation& triangulation,
                                      std::span<const topology::OrbifoldLink> links,
                                      const std::vector<bool>& excluded = {});

}  // namespace tripus::structure::detail
