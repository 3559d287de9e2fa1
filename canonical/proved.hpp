#pragma once

#include <optional>
#include <string>
#include <vector>

#include "canonical/compare.hpp"
#include "structure/proof/canonical_proof_text.hpp"
#include "structure/proof/proof.hpp"
#include "structure/proof/tilt_signs.hpp"

namespace tripus::canonical {

using structure::FaceOfTetrahedron;

/// What is proved about a canonical decomposition. Proved: the metric is, the tilt sum of every
/// face of the decomposition is negative, and that of every face inside a cell is exactly 0.
struct CanonicalProof {
  bool proved = false;
  std::string reason;  ///< why not; empty if proved
  /// The signature of CanonicalManifold::triangulation with its labels. All that follows is about
  /// the triangulation that this decodes to: its tetrahedra, faces and edge classes.
  std::string triangulation;
  structure::Proof metric;
  std::vector<FaceOfTetrahedron> inside;       ///< faces whose sum is proved to be 0, from one side
  std::vector<FaceOfTetrahedron> unproved;     ///< faces whose sign is not proved, from one side
  std::optional<structure::ExactField> field;  ///< in which sums were shown to be 0
};

/// Source: docs/theory.md (99), (103).
CanonicalProof prove_canonical(const CanonicalManifold& manifold, const Context& context = {});
/// The same for structure::check_canonical_proof, as it is written down.
structure::CanonicalProofText proof_text(const CanonicalProof& proof);

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
