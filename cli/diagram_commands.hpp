#pragma once

#include "cli/commands.hpp"

namespace tripus::cli {

// The verbs about planar diagrams: see cli/commands.hpp.
void add_draw(CLI::App& program, Command& chosen);
void add_table(CLI::App& program, Command& chosen);

}  // namespace tripus::cli
