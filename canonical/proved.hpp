#pragma once

#include <string>
#include <vector>

#include "canonical/compare.hpp"
#include "structure/proof/proof.hpp"

namespace tripus::canonical {

/// A face of a tetrahedron.
struct FaceOfTetrahedron {
  std::size_t tetrahedron = 0;
  int face = 0;
};

/// What is proved about a canonical decomposition. Proved: the metric is, and every face is true,
/// so that all cells are tetrahedra. Faces with the tilt sum 0, which lie inside larger cells, are
/// not proved by enclosures: they are named.
struct CanonicalProof {
  bool proved = false;
  std::string reason;                       ///< why not; empty if proved
  structure::Proof metric;                  ///< on CanonicalManifold::triangulation
  std::vector<FaceOfTetrahedron> unproved;  ///< faces whose sign is not proved, from one side
};

/// Source: docs/theory.md (99).
CanonicalProof prove_canonical(const CanonicalManifold& manifold, const Context& context = {});

/// Whether a comparison's verdict is a theorem.
struct ComparisonProof {
  bool proved = false;
  std::string by;      ///< "integers", "volume", "decomposition", "triangulation"
  std::string reason;  ///< why not; empty if proved
};
ComparisonProof prove_comparison(const Comparison& comparison, const Context& context = {});

/// One sentence for a person.
std::string proof_message(const CanonicalProof& proof);

}  // namespace tripus::canonical
