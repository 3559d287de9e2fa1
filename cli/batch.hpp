#pragma once

#include <functional>
#include <string>

#include "cli/batch_output.hpp"
#include "topology/formats/formats.hpp"

namespace tripus::cli {

/// The answer to one line of a batch.
struct Answer {
  std::string text;     ///< for standard output, without the line end; may be empty
  std::string message;  ///< for standard error; may be empty
  int status = 0;       ///< the exit status that it deserves
};

struct BatchOptions {
  std::string file;      ///< one INPUT a line, `-` for standard input
  std::string resume;    ///< see BatchOutput
  std::string asked;     ///< see BatchOutput
  unsigned threads = 0;  ///< 0: all cores
  bool quiet = false;
  BatchOutput::Earlier earlier = {};
};

/// Answers every line, on all threads, and writes the answers in the order of the input.
/// `answer` must be safe to call from several threads.
/// Returns the exit status: success when the run finished, failure if the system failed for a line;
/// no answer when it was interrupted: then the answers to the first lines are out, without a gap,
/// and none of a line that the interruption may have cut short.
/// Throws InvalidInput if the file cannot be read, and what `answer` throws.
int run_batch(const BatchOptions& options,
              const std::function<Answer(const topology::BatchLine& line)>& answer);

}  // namespace tripus::cli
