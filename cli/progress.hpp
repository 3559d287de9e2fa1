#pragma once

#include <chrono>
#include <string>

namespace tripus::cli {

/// A status line on standard error, rewritten in place; silent unless standard error is a terminal
/// and the work has taken half a second.
class Progress {
 public:
  explicit Progress(bool wanted);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Whether a line would be shown now: ask before formatting one. At most ten times a second.
  bool due();
  void show(const std::string& line);

 private:
  bool enabled_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace tripus::cli
