#pragma once

#include <string>

#include "manifold/canonical_json.hpp"

namespace tripus::cli {

/// A canonical manifold for people, over several indented lines.
std::string manifold_as_text(const canonical::CanonicalManifold& manifold);

/// "cell 0 -> 1 (0 1 2 3 -> 1 0 2 3)", one a cell.
std::string cell_map_as_text(const canonical::CellMap& map);

/// An entry of a census.
std::string entry_as_text(const canonical::CensusEntry& entry);

}  // namespace tripus::cli
