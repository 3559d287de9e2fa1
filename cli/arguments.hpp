#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace tripus::cli {

// A signature of 63 tetrahedra or more begins with "-", as options do. A space before it makes it
// an INPUT to the parser of the command line, and is taken off again when INPUT is parsed.

/// Puts a space before every argument that begins with "-" and can only be a signature.
std::vector<std::string> shield_signatures(std::vector<std::string> arguments);

/// For INPUT options: takes the space of shield_signatures off.
CLI::Validator unshield();

/// What is wrong with the name of a file to write, as a check of an option: it must not be empty.
std::string problem_of_name(const std::string& name);

/// For an option: the name of a file with one of these endings, such as ".png", in any case.
CLI::Validator file_name(std::vector<std::string> endings);

}  // namespace tripus::cli
