#include "cli/answer.hpp"

#include <new>

#include "cli/batch.hpp"
#include "cli/json.hpp"
#include "cli/output.hpp"

namespace tripus::cli {
namespace {

/// An exception as an answer: a JSON object for standard output, a line for standard error.
Answer error_answer(const std::string& input, bool json, const std::exception& error) {
  const bool out_of_memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  const std::string message =
      out_of_memory ? "out of memory: the input is too large for this machine" : error.what();
  Answer answer;
  answer.message = fmt::format("tripus: {}", message);
  if (json) {
    JsonText out;
    append_error(out, input, error_kind(error), message);
    answer.text = fmt::to_string(out);
  }
  return answer;
}

int status_of(const std::exception& error) {
  return dynamic_cast<const InvalidInput*>(&error) != nullptr ? kBadInput : kInternalFailure;
}

int answer_one(const CommonOptions& options,
               const std::function<Outcome(const std::string&)>& answer) {
  try {
    const Outcome outcome = answer(options.input);
    write_output(outcome.text);
    if (options.json) write_output("\n");
    flush_output();
    return outcome.status;
  } catch (const std::exception& error) {
    const Answer failure = error_answer(options.input, options.json, error);
    if (!failure.text.empty()) write_output(failure.text + "\n");
    write_message(failure.message + "\n");
    return status_of(error);
  }
}

}  // namespace

void add_common_options(CLI::App& verb, CommonOptions& options) {
  auto* input = verb.add_option("INPUT", options.input,
                                "an isomorphism signature, a file, or - for standard input");
  auto* batch = verb.add_option("--batch", options.batch,
                                "a file with one INPUT a line, or - for standard input");
  input->excludes(batch);
  verb.add_flag("--json", options.json, "one JSON object an input on standard output");
  verb.add_option("--threads", options.threads, "threads for --batch; 0, the default: all cores")
      ->check(CLI::Range(0u, 1024u));
  verb.add_flag("--quiet", options.quiet, "no progress on standard error");
  verb.parse_complete_callback([input, batch] {
    if (input->count() == 0 && batch->count() == 0)
      throw CLI::RequiredError("INPUT or --batch FILE");
  });
}

int answer_inputs(const CommonOptions& options,
                  const std::function<Outcome(const std::string&)>& answer) {
  if (options.batch.empty()) return answer_one(options, answer);
  return run_batch({options.batch, options.threads, options.quiet},
                   [&](const std::string& input) -> Answer {
                     try {
                       std::string text = answer(input).text;
                       if (!text.empty() && text.back() == '\n') text.pop_back();
                       return {std::move(text), {}};
                     } catch (const std::exception& error) {
                       return error_answer(input, options.json, error);
                     }
                   });
}

}  // namespace tripus::cli
