#pragma once

#include <string>

#include "base/output_file.hpp"
#include "structure/solve.hpp"

namespace tripus::cli {

/// The history of a run as a CSV file, one row an iteration. Like every other file it comes to its
/// name when the run ends, interrupted or not; through a pipe the rows come as they are made.
class HistoryFile {
 public:
  /// Throws what OutputFile throws.
  explicit HistoryFile(const std::string& path);

  /// Throws IoError.
  void add(const structure::HistoryRow& row);
  /// Throws IoError if a row could not be written.
  void close() { file_.close(); }

 private:
  OutputFile file_;
  std::ostream& out_;
};

}  // namespace tripus::cli
