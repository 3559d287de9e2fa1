#pragma once

#include <string>

namespace tripus::studies {

/// What timings depend on.
struct Machine {
  std::string processor;  ///< model name, "unknown" where the system does not tell
  unsigned cores = 1;
  std::string compiler;
};

Machine this_machine();

}  // namespace tripus::studies
