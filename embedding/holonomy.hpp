#pragma once

#include <vector>

#include "embedding/embedding.hpp"
#include "geometry/moebius.hpp"
#include "topology/covers/presentation.hpp"

namespace tripus::embedding {

/// The holonomy representation of the fundamental group, in the frame of tetrahedron 0: each
/// generator of `group` (a face of the fundamental domain that is glued to another one) as the
/// isometry that carries the domain to its copy across that face.
struct Holonomy {
  topology::FundamentalGroup group;
  std::vector<Matrix4> isometries;            ///< [generators] in O+(3,1)
  std::vector<geometry::MoebiusMap> moebius;  ///< [generators] in PSL(2,C), or its other half
  /// [generators] bound on the rounding errors of the Moebius coefficients (norm of the four).
  std::vector<double> rounding;
  /// Each relator is the way around an edge, or a power of it. The largest entry of (product of the
  /// pairings around it) - identity, in the frame of a tetrahedron at the edge, over all edges ...
  double local_defect = 0;
  /// ... and what that may become in the frame of tetrahedron 0, |D|^2 times as much.
  double carried_defect = 0;
  /// Whether all of them keep orientation: exactly for orientable manifolds. Otherwise some Moebius
  /// maps are of the conjugate, and the representation is not into PSL(2,C).
  bool orientable = true;
};

/// With singular edges the group is topology::orbifold_group. A cusp's own subgroup consists of
/// parabolic isometries: the embedding's lengths are of the complete metric.
/// Throws InvalidInput if the triangulation is not connected.
/// Source: docs/theory.md (72).
Holonomy holonomy(const Embedding& embedding, const topology::Triangulation& triangulation);

/// The isometry of a word in the generators, read from left to right: a Lorentz matrix to rounding
/// of its entries, however far the word goes on its way. O(length) in a hundred digits.
Matrix4 isometry_of(const Holonomy& holonomy, const topology::Word& word);
/// The same as a Moebius map, a d - b c = 1 to rounding of its coefficients.
geometry::MoebiusMap moebius_of(const Holonomy& holonomy, const topology::Word& word);

/// How far the relator's product of Moebius maps is from the identity, for each relator: the
/// largest difference of coefficients, up to sign. Infinity where numbers overflow. In the frame of
/// tetrahedron 0 this grows like the exponential of the size of the fundamental domain, though the
/// space closes up around its edges as well as `local_defect` says: where it exceeds
/// tolerance::kRelator, double precision cannot hold the representation.
std::vector<double> relator_defects(const Holonomy& holonomy);

/// Bounds on these, to first order, for each relator. Source: docs/theory.md (72).
std::vector<double> relator_bounds(const Holonomy& holonomy);

/// How well the relators hold in the frame of tetrahedron 0.
struct RelatorDefect {
  double defect = 0;  ///< largest of relator_defects
  double bound = 0;   ///< largest of relator_bounds
  /// Within tolerance::kRelator: double precision holds the representation.
  bool holds() const;
};
RelatorDefect relator_defect(const Holonomy& holonomy);

}  // namespace tripus::embedding
