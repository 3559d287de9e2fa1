#pragma once

#include <string>

#include "canonical/canonize.hpp"
#include "canonical/census.hpp"
#include "cli/json.hpp"

namespace tripus::cli {

/// The keys of a canonical manifold, from "volume" to "path"; each with a comma before it.
void append_manifold(JsonText& out, const canonical::CanonicalManifold& manifold);

/// The same for people, over several indented lines.
std::string manifold_as_text(const canonical::CanonicalManifold& manifold);

/// {"cells": [...], "vertices": [[...], ...]}
void append_cell_map(JsonText& out, const canonical::CellMap& map);
/// "cell 0 -> 1 (0 1 2 3 -> 1 0 2 3)", one a cell.
std::string cell_map_as_text(const canonical::CellMap& map);

/// An entry of a census as a JSON object, and for people.
void append_entry(JsonText& out, const canonical::CensusEntry& entry);
std::string entry_as_text(const canonical::CensusEntry& entry);

}  // namespace tripus::cli
