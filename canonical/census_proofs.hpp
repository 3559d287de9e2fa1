#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/context.hpp"
#include "canonical/census.hpp"
#include "structure/proof/digits.hpp"

namespace tripus::canonical {

/// A proof of one manifold's metric in short: all radii are the same.
struct CensusProof {
  std::string name;                  ///< of the manifold
  std::string triangulation;         ///< one of those that the census lists for it
  std::vector<std::string> lengths;  ///< [E] exact binary numbers
  std::string radius;
  structure::DecimalInterval volume = {};  ///< if it was asked for; no part of the table
};

struct ProveCensusOptions {
  bool volumes = false;  ///< to some 20 digits after the point
};

/// Proofs for the manifolds of a census, in its order, each on the first of its triangulations on
/// which there is one; those without are left out. On context.threads threads; their number does
/// not matter.
std::vector<CensusProof> prove_census(const Census& census, const ProveCensusOptions& options = {},
                                      const Context& context = {});

/// Rounds the volumes of a census to digits that proofs with volumes prove (Census::proved_digits):
/// 13 after the point, or as many as doubles hold. Where some are not proved so, it changes nothing
/// and returns the names of these manifolds.
std::vector<std::string> round_to_proved(Census& census, const std::vector<CensusProof>& proofs);

/// A table with tabs: name, triangulation, lengths (by commas), radius.
std::string to_tsv(const std::vector<CensusProof>& proofs);
/// Throws InvalidInput, with the line.
std::vector<CensusProof> parse_census_proofs(std::string_view text);
/// data/census-proofs.tsv, as it was built in.
const std::vector<CensusProof>& shipped_census_proofs();

struct CensusCheck {
  std::size_t valid = 0;
  std::vector<std::string> failures;  ///< manifold and reason, in the order of the census
  bool stopped = false;
};

/// Checks by structure::check_proof that every manifold of the census has a valid proof on one of
/// its triangulations, and that its volume is the one that the census says: within half a unit of
/// the last digit if these are said to be proved, else within 1e-13.
CensusCheck check_census(const Census& census, const std::vector<CensusProof>& proofs,
                         const Context& context = {});

}  // namespace tripus::canonical
