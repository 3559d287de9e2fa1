#pragma once

#include <string>

#include "topology/formats/formats.hpp"

namespace tripus::cli {

/// Reads an INPUT as typed: a file, `-` for standard input, or an isomorphism signature.
/// Throws InvalidInput if it is none of them or its content cannot be read.
topology::NamedGluings load_input(const std::string& input);

/// The whole of a file, or of standard input for `-`.
/// Throws InvalidInput, naming the file and the system's reason.
std::string read_file(const std::string& path);

}  // namespace tripus::cli
