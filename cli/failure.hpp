#pragma once

#include <exception>
#include <string>

namespace tripus::cli {

/// What an exception says to a person; for memory that has run out, whichever way that was noticed,
/// one text with the size of the work.
std::string failure_text(const std::exception& error);

/// The exit status that an exception deserves.
int status_of(const std::exception& error);

}  // namespace tripus::cli
