#pragma once

#include <span>
#include <string>
#include <vector>

#include "structure/proof/detail/checked_tetrahedron.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"
#include "topology/vertex_kinds.hpp"

/// What the checker of proofs shows where vertices are finite, by no code of the prover: interval
/// Newton by elimination in balls, and links unfolded from Gram matrices. docs/theory.md 9.8.
namespace tripus::structure::detail {

struct FiniteClaim {
  const topology::Triangulation& triangulation;
  std::span<const topology::ConeAngle> cone_angles;   // [E]
  std::span<const topology::OrbifoldLink> links;      // [V]
  std::vector<CheckedGram> around;                    // [T] over the box
  std::vector<CheckedGram> within;                    // [T] over the radii that are claimed
  std::vector<Arb> K;                                 // [E] at the lengths
  std::vector<Arb> K_within;                          // [E] over the radii
  const std::vector<Arb>& box;                        // [E] larger than radii that are > 0
  const std::vector<Arb>& radius;                     // [E] 0: the length is held
};

/// Why the metric is not shown to be within the radii; empty if it is.
std::string finite_refusal(const FiniteClaim& claim);

}  // namespace tripus::structure::detail
