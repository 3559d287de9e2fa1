#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "structure/proof/proof_text.hpp"
#include "structure/proof/tilt_signs.hpp"

namespace tripus::structure {

/// The key "kind" of such proofs.
inline constexpr std::string_view kCanonicalDecomposition = "canonical-decomposition";

/// What a proof of a canonical decomposition claims, as it is written down.
struct CanonicalProofText {
  bool proved = false;
  std::string reason;  ///< if not proved
  /// The signature of the triangulation that it is about, with labels if there are any. Numbers of
  /// tetrahedra, faces and classes are those of what it decodes to.
  std::string triangulation;
  std::vector<FaceOfTetrahedron> unproved;  ///< if not proved, from one side
  std::vector<FaceOfTetrahedron> inside;    ///< faces whose tilt sum is 0, from one side
  std::optional<ExactField> field;          ///< in which it is
  ProofText metric;
};

/// The object "proof" of an answer of canonize; docs/proof.md has its keys.
std::string to_json(const CanonicalProofText& proof);

/// Whether a text is a JSON object that has, or is, such a proof.
bool looks_like_canonical_proof(std::string_view json);
/// Reads such an object, or the member "proof" of an answer.
/// Throws InvalidInput, with the place, for anything else, and for a proof that is not proved.
CanonicalProofText parse_canonical_proof(std::string_view json);

/// Checks by other code than made it that this is the triangulation which the proof is about, in
/// any labelling, that it carries the metric, that the faces which the proof names have the tilt
/// sum 0, and all others a negative one: so that the tetrahedra, merged across the named faces, are
/// the canonical decomposition. Exact arithmetic for the zeros, Arb's balls for the signs.
///   labels  [E] cone angles of the triangulation; empty for 2 pi
/// Throws InvalidInput as `check_proof`. Source: docs/theory.md (99), (102) to (105).
ProofCheck check_canonical_proof(const topology::Triangulation& triangulation,
                                 std::span<const topology::ConeAngle> labels,
                                 const CanonicalProofText& proof, const Context& context = {});

}  // namespace tripus::structure
