#pragma once

#include <string>

namespace tripus::meshing {

/// The program tripus-tetgen: what the environment variable TRIPUS_TETGEN names; or that beside the
/// running program, in libexec/tripus next to its folder, or where it was installed.
/// Throws Unsupported, saying where it was looked for.
std::string find_tetgen();

}  // namespace tripus::meshing
