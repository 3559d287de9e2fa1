#pragma once

namespace tripus::cli {

/// What the program returns to the shell.
enum ExitStatus : int {
  kSuccess = 0,   ///< a geometric answer; for --batch: the run finished
  kNoAnswer = 1,  ///< a mathematical "no", "unresolved", or an interrupted run
  kBadInput = 2,  ///< bad usage or bad input
  kInternalFailure = 3,
};

}  // namespace tripus::cli
