#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace tripus::cli {

/// What an exception says to a person; for work that was stopped, why; for memory that has run out,
/// whichever way that was noticed, one text with the size of the work.
std::string failure_text(const std::exception& error);

/// Its kind for JSON: tripus::error_kind, or "time-limit" for work that --time-limit has ended.
std::string_view failure_kind(const std::exception& error);

/// The exit status that an exception deserves.
int status_of(const std::exception& error);

/// What the program returns to the shell.
enum ExitStatus : int {
  kSuccess = 0,   ///< a geometric answer; for --batch: the run finished
  kNoAnswer = 1,  ///< a mathematical "no", "unresolved", or an interrupted run
  kBadInput = 2,  ///< bad usage or bad input
  kInternalFailure = 3,
};

}  // namespace tripus::cli
