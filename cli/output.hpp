#pragma once

#include <string_view>

#include "base/error.hpp"

namespace tripus::cli {

/// Standard output cannot be written (a full disk): there is no point in writing about it there.
class OutputError : public IoError {
 public:
  using IoError::IoError;
};

/// Writes to standard output. Throws OutputError.
void write_output(std::string_view text);

/// Flushes standard output. Throws OutputError.
void flush_output();

/// Writes to standard error; does nothing for an empty text.
void write_message(std::string_view text);

}  // namespace tripus::cli
