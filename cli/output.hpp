#pragma once

#include <string>
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

// Which files a run writes, kept for the whole run: nothing that it reads may be one of them.

/// To be said of every file before the work: `path` will be written. Tries whether it can be.
/// Throws InvalidInput, naming `option`, if another output has the same name, and what OutputFile
/// throws.
void declare_output(const std::string& option, const std::string& path);
/// The same of files in a folder whose names begin with `prefix`.
void declare_output_folder(const std::string& path, const std::string& prefix);

/// Throws InvalidInput if an INPUT (a file, FILE#LABEL or `-`) or another file that is read is one
/// that this run writes.
void require_not_written(const std::string& input);

}  // namespace tripus::cli
