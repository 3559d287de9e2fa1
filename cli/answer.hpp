#pragma once

#include <exception>
#include <functional>
#include <string>

#include "cli/batch.hpp"
#include "cli/failure.hpp"
#include "cli/verb.hpp"

namespace tripus::cli {

/// The text that answers one INPUT, and the exit status that it deserves by itself.
struct Reply {
  std::string text;  ///< text for people ends with a line end, JSON does not
  int status = kSuccess;
};

/// What stands in a batch for an INPUT whose answer has failed, where every line must have one.
using FailedText =
    std::function<std::string(const std::string& input, const std::exception& error)>;

/// Answers the one INPUT, or every line of the batch, and writes the answers. An exception that
/// `answer` throws becomes the error of that input: its JSON object or its message, and in a batch
/// the next line goes on.
int answer_inputs(const CommonOptions& options,
                  const std::function<Reply(const std::string& input)>& answer,
                  const FailedText& failed = {});

/// The same for every line of the file options.batch, with its number.
int answer_lines(const CommonOptions& options,
                 const std::function<Reply(const topology::BatchLine& line)>& answer,
                 const BatchOutput::Earlier& earlier = {}, const FailedText& failed = {});

/// An exception as an answer: a JSON object for standard output, a line for standard error.
Answer error_answer(const std::string& input, bool json, const std::exception& error);
/// What to say where a line of a batch is "-".
extern const char* const kNoStandardInput;

}  // namespace tripus::cli
