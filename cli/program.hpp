#pragma once

#include <string>
#include <vector>

namespace tripus::cli {

/// The whole program: arguments without its own name; what is said goes to the standard streams.
/// Takes over SIGINT and the standard streams, so that it is for a process of its own, be it the
/// program or `python -m tripus`. Returns the exit status.
int run_program(const std::vector<std::string>& arguments);

}  // namespace tripus::cli
