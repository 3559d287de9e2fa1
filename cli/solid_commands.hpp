#pragma once

#include "cli/commands.hpp"

namespace tripus::cli {

// Verbs about solids in space and their manifolds, as those in commands.hpp.
void add_parameterise(CLI::App& program, Command& chosen);

}  // namespace tripus::cli
