#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "cli/commands.hpp"
#include "cli/exit_status.hpp"
#include "topology/formats/formats.hpp"

namespace tripus::cli {

/// The text that answers one INPUT, and the exit status that it deserves by itself.
struct Outcome {
  std::string text;  ///< text for people ends with a line end, JSON does not
  int status = kSuccess;
};

/// Answers the one INPUT, or every line of the batch, and writes the answers. An exception that
/// `answer` throws becomes the error of that input: its JSON object or its message, and in a batch
/// the next line goes on.
int answer_inputs(const CommonOptions& options,
                  const std::function<Outcome(const std::string& input)>& answer);

/// The same for every line of the text of a batch file, with its number.
int answer_lines(const CommonOptions& options, std::string_view text,
                 const std::function<Outcome(const topology::BatchLine& line)>& answer);

}  // namespace tripus::cli
