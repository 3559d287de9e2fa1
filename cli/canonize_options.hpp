#pragma once

#include <CLI/CLI.hpp>

#include "canonical/canonize.hpp"

namespace tripus::cli {

/// Adds what the verbs that look for canonical decompositions have in common.
void add_canonize_options(CLI::App& verb, canonical::CanonizeOptions& options);

/// The exit status of these verbs, for their help.
extern const char* const kCanonicalStatusHelp;

}  // namespace tripus::cli
