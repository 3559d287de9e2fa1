#pragma once

#include "canonical/canonize.hpp"
#include "canonical/census.hpp"
#include "manifold/json_text.hpp"

namespace tripus {

/// The keys of a canonical manifold, from "volume" to "path"; each with a comma before it.
void append_manifold(JsonText& out, const canonical::CanonicalManifold& manifold);

/// {"cells": [...], "vertices": [[...], ...]}
void append_cell_map(JsonText& out, const canonical::CellMap& map);

/// An entry of a census as a JSON object.
void append_entry(JsonText& out, const canonical::CensusEntry& entry);

}  // namespace tripus
