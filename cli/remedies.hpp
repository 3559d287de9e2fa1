#pragma once

#include <string>

#include "structure/report.hpp"
#include "topology/triangulation.hpp"

namespace tripus::cli {

/// topology::require_solvable, with the command that helps where there is one.
void require_with_remedy(const topology::Triangulation& triangulation);

/// What to do, by the options of this program; empty for Advice::kNone.
std::string advice_text(structure::Advice advice);

}  // namespace tripus::cli
