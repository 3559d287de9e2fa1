#pragma once

#include <optional>
#include <string>

#include "base/stop.hpp"
#include "canonical/canonize.hpp"
#include "canonical/census.hpp"

namespace tripus::canonical {

/// How a manifold was found in a census, or that it is not there.
enum class IdentifiedBy {
  kNothing,        ///< unresolved: no canonical decomposition was found
  kTriangulation,  ///< the triangulation is listed, or a simplification of it
  kDecomposition,  ///< by the isometry signature; also if it is not in the census
};
/// "triangulation", "decomposition"; empty for nothing.
std::string_view to_string(IdentifiedBy by);

struct Identification {
  const CensusEntry* entry = nullptr;  ///< in the census; null if there is none
  IdentifiedBy by = IdentifiedBy::kNothing;
  std::optional<CanonizeAnswer> answer;  ///< if the decomposition was looked for
};

/// The entry that lists a simplification of the triangulation; null if there is none.
const CensusEntry* find_simplified(const topology::Triangulation& triangulation,
                                   const Census& census, const Stop& stop = {});

/// Looks a manifold up: by its triangulation, by a simplification of that, by its canonical
/// decomposition; with cone angles by the last alone. Throws what `require_canonizable` does, if
/// the triangulation is not listed.
Identification identify(const topology::Triangulation& triangulation, const Census& census,
                        const CanonizeOptions& options = {});

}  // namespace tripus::canonical
