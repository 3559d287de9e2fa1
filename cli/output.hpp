#pragma once

#include <string_view>

namespace tripus::cli {

/// Writes to standard output. Throws Error when it cannot be written (a full disk).
void write_output(std::string_view text);

/// Flushes standard output; throws as write_output.
void flush_output();

/// Writes to standard error; does nothing for an empty text.
void write_message(std::string_view text);

}  // namespace tripus::cli
