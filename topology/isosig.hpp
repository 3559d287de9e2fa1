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

/// An isomorphism signature with what it takes to keep the orientation. A connected orientable
/// table and its mirror image have the same isomorphism signature; the sign tells them apart. `+`:
/// an isomorphism that keeps the orientation carries decode_isosig(isosig) to the table; `-`: it
/// carries its mirror image there. Where both do, the sign is `+`. (The orientation of a table is
/// that of the labels 0123 of tetrahedron 0, see orientation.hpp.)
struct Isosig {
  std::string isosig;
  char sign = 0;                 ///< '+' or '-'; 0 if not orientable or not connected
  bool is_amphicheiral = false;  ///< the table is isomorphic to its mirror image

  /// "cPcbbbihq+"; without a sign where there is none.
  std::string oriented() const { return sign == 0 ? isosig : isosig + sign; }
};

/// The isomorphism signature with its sign; the same cost. Two orientable connected tables have the
/// same `oriented()` exactly when an isomorphism carries one to the other, with its orientation.
Isosig full_isosig(const Gluings& gluings);
std::optional<Isosig> full_isosig(const Gluings& gluings, std::size_t work_limit);

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
///
/// A sign at the end keeps the orientation: with `+` the table is the same, made `oriented`; with
/// `-` it is the mirror image of that. Throws InvalidInput for a sign where the table is not
/// orientable or not connected. Without a sign nothing is meant about the orientation.
Gluings decode_isosig(std::string_view text);

/// The sign at the end of a signature, '+' or '-', or 0. No signature ends with these characters by
/// itself.
char isosig_sign(std::string_view text);
/// The text without white space around it and without a sign.
std::string_view without_sign(std::string_view text);

/// Whether the text, but for white space around it, consists of signature characters only.
bool looks_like_isosig(std::string_view text);

}  // namespace tripus::topology
