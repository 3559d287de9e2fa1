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
  /// Whether all of them keep orientation: exactly for orientable manifolds. Otherwise some Moebius
  /// maps are of the conjugate, and the representation is not into PSL(2,C).
  bool orientable = true;
};

/// Throws InvalidInput if the triangulation is not connected.
/// Source: docs/theory.md (72).
Holonomy holonomy(const Embedding& embedding, const topology::Triangulation& triangulation);

/// The isometry of a word in the generators, read from left to right.
Matrix4 isometry_of(const Holonomy& holonomy, const topology::Word& word);

/// Largest entry of (isometry of the relator) - identity, for each relator.
std::vector<double> relator_defects(const Holonomy& holonomy);

}  // namespace tripus::embedding
