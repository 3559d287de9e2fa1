#pragma once

#include <string>

#include "structure/solve.hpp"

namespace tripus::cli {

/// The history of a run as a CSV file, one row an iteration, written as it goes.
class HistoryFile {
 public:
  /// Throws InvalidInput if the file cannot be written.
  explicit HistoryFile(const std::string& path);
  ~HistoryFile();
  HistoryFile(const HistoryFile&) = delete;
  HistoryFile& operator=(const HistoryFile&) = delete;

  void add(const structure::HistoryRow& row);
  /// Throws Error if a row could not be written.
  void close();

 private:
  std::string path_;
  std::FILE* file_;
};

}  // namespace tripus::cli
