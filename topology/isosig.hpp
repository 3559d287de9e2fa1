#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "topology/gluings.hpp"
#include "topology/isomorphism.hpp"

namespace tripus::topology {

/// The isomorphism signature, byte for byte that of Regina 7 (`isoSig()`, classic and printable).
/// Two gluing tables have the same signature exactly when they are isomorphic. Components are
/// encoded one by one, sorted and concatenated; the empty table gives "a". Open faces are allowed.
///
/// Cost: the 24 T starting frames are tried, each abandoned at its first character that is larger
/// than the best so far; frames related by a symmetry that was already found are skipped. So the
/// time is near linear in T in practice, including regular covers, but quadratic at worst.
/// The table must be consistent (see require_consistent).
/// Source: B. A. Burton, The Pachner graph and the simplification of 3-sphere triangulations,
/// SoCG 2011; the encoding is Regina's.
std::string isosig(const Gluings& gluings);

/// The same, or nullopt once more than `work_limit` faces have been visited. One starting frame
/// visits at most 4 T faces; 1e8 is about a second.
std::optional<std::string> isosig(const Gluings& gluings, std::size_t work_limit);

/// A connected table in its canonical labelling.
struct CanonicalLabelling {
  std::string signature;
  /// Carries the table to decode_isosig(signature).
  Isomorphism isomorphism;
};

/// The signature together with the relabelling that it stands for.
/// Throws InvalidInput if the table is empty or not connected.
CanonicalLabelling canonical_labelling(const Gluings& gluings);

/// The gluing table of a signature, with the labelling that Regina's fromIsoSig gives it. White
/// space around the signature is ignored.
/// Throws InvalidInput, naming the position of the character (from 1) and what was expected there.
/// Memory is bounded by a constant times the length of the text, whatever its header claims.
/// Open faces are allowed; so is the empty table.
Gluings decode_isosig(std::string_view text);

/// Whether the text, but for white space around it, consists of signature characters only.
bool looks_like_isosig(std::string_view text);

}  // namespace tripus::topology
