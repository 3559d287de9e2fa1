#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "structure/proof/digits.hpp"
#include "structure/proof/proof.hpp"

namespace tripus::structure {

/// What a proof claims, as it is written down: every number is a text with one exact meaning, a
/// decimal number such as "0.25e-3" or a binary one such as "0x1.3p-1".
struct ProofText {
  bool proved = false;
  std::string reason;  ///< if not proved
  Proof::Claim claim = Proof::Claim::kMetric;
  bool interval_newton = false;  ///< by theory 9.8, not by convexity
  long bits = 53;
  std::size_t escalated = 0;
  std::vector<topology::ConeAngle> cone_angles;  ///< [E]; empty for 2 pi
  std::vector<std::string> lengths, radii;       ///< [E]
  std::optional<DecimalInterval> volume;
  std::vector<std::array<DecimalInterval, 6>> dihedral_angles;  ///< [T] or empty
  std::vector<std::size_t> flat;
};

/// The key "kind": "strong-convexity" or "interval-newton".
std::string_view kind_of(const ProofText& proof);

/// A proof in doubles; with digits, these instead of its numbers.
ProofText proof_text(const Proof& proof, const Digits* digits = nullptr);

/// The object "proof" of an answer; docs/proof.md has its keys.
std::string to_json(const ProofText& proof);

/// Reads such an object, or the member "proof" of an answer.
/// Throws InvalidInput, with the place, for anything else, and for a proof that is not proved.
ProofText parse_proof(std::string_view json);
/// Whether a text is a JSON object that has, or is, a proof rather than a certificate.
bool looks_like_proof(std::string_view json);

struct ProofCheck {
  bool valid = false;
  std::string reason;  ///< the inequality that fails, with its numbers; empty if valid
  explicit operator bool() const { return valid; }
};

/// Checks a proof by other code than made it: Arb alone, formulae as they stand in the theory, no
/// solver. Everything the text claims is checked: lengths, volume, angles, flat tetrahedra.
/// Throws InvalidInput for a triangulation outside the domain and numbers that cannot be read.
/// Source: docs/theory.md section 9.
ProofCheck check_proof(const topology::Triangulation& triangulation, const ProofText& proof,
                       const Context& context = {});

}  // namespace tripus::structure
