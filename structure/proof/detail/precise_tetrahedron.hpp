#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/enclosure_formulae.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "structure/proof/detail/arb_number.hpp"
#include "topology/triangulation.hpp"

/// What geometry/enclosure.hpp finds in doubles, at the thread's precision in Arb.
namespace tripus::structure::detail {

/// What each vertex is: 1 hyperideal, 0 ideal, -1 finite.
using Diagonal = std::array<int, 4>;
inline constexpr Diagonal kHyperideal = {1, 1, 1, 1};

geometry::GramDiagonal gram_diagonal(const Diagonal& diagonal);

/// The lengths of tetrahedron t out of those of the edge classes [E].
std::array<Arb, 6> lengths_of(const topology::Triangulation& triangulation,
                              const std::vector<Arb>& lengths, std::size_t t);

/// -G_ij and its slope at the edges of a tetrahedron, theory (77).
struct GramEntries {
  Arb c[6], s[6];
};
GramEntries gram_entries(const std::array<Arb, 6>& l, const Diagonal& diagonal);

struct PreciseTetrahedron {
  std::array<Arb, 6> angles;
  Arb volume;
};

/// Dihedral angles at l, and the volume if wanted; nothing unless -det G is proved > 0, and with
/// finite vertices the minors too (10.2).
std::optional<PreciseTetrahedron> precise_tetrahedron(const std::array<Arb, 6>& l, bool with_volume,
                                                      const Diagonal& diagonal = kHyperideal);

/// The Jacobian of theory (17) to (19), packed [21]; nothing unless -det G is proved > 0.
std::optional<std::array<Arb, 21>> precise_jacobian(const std::array<Arb, 6>& l,
                                                    const Diagonal& diagonal = kHyperideal);

/// Weights w > 0 with J >= diag(w) over the box `l` of positive lengths; nothing where the
/// precision does not prove it. Source: docs/theory.md section 9.
std::optional<std::array<double, 6>> precise_weights(const std::array<Arb, 6>& l);

/// How a box of lengths, positive between hyperideal vertices, is flat, if -det G is proved < 0 on
/// it: every member then has the angle pi at the same pair of opposite edges. Source: docs/theory.md
/// (15) and 10.3.
std::optional<geometry::TetrahedronKind> proved_flat(const std::array<Arb, 6>& l,
                                                     const Diagonal& diagonal = kHyperideal);

}  // namespace tripus::structure::detail
