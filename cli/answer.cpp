#include "cli/answer.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/batch.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "manifold/json_text.hpp"
#include "topology/work_size.hpp"

namespace tripus::cli {
namespace {

constexpr int kMostThreads = 1024;
/// Options that say where answers come from and go to, and how fast, but not what they are.
constexpr std::string_view kNotAsked[] = {"--batch",  "--gallery", "--resume",     "--json", "-o",
                                          "--output", "--threads", "--time-limit", "--quiet"};

}  // namespace

const char* const kNoStandardInput =
    "a line of a batch cannot be standard input; give a signature or a file";

Answer error_answer(const std::string& input, bool json, const std::exception& error) {
  const std::string message = failure_text(error);
  Answer answer;
  answer.message = message;
  answer.status = status_of(error);
  if (json) {
    JsonText out;
    append_error(out, input, failure_kind(error), message);
    answer.text = fmt::to_string(out);
  }
  return answer;
}

namespace {

/// What is said of an answer that may have been cut short; empty if there is nothing.
std::string stop_message(const Reply& outcome) {
  return outcome.status == kNoAnswer && is_work_over() ? stop_text() : "";
}

int answer_one(const CommonOptions& options,
               const std::function<Reply(const std::string&)>& answer) {
  Reply outcome;
  std::string message;
  set_last_words("; there is no answer yet", [&](std::string_view why, bool is_time_over) {
    if (!options.json) return std::string();
    JsonText out;
    append_error(out, options.input, is_time_over ? "time-limit" : "interrupted", why);
    out.push_back('\n');
    return fmt::to_string(out);
  });
  try {
    require_not_written(options.input);
    outcome = answer(options.input);
    message = stop_message(outcome);
  } catch (const std::exception& error) {
    Answer failure = error_answer(options.input, options.json, error);
    outcome = {std::move(failure.text), status_of(error)};
    message = std::move(failure.message);
  }
  if (!message.empty()) write_message(fmt::format("tripus: {}\n", message));
  write_output(outcome.text);
  if (options.json) write_output("\n");
  flush_output();
  return outcome.status;
}

}  // namespace

std::string asked(const CommonOptions& options) {
  std::string text;
  if (options.verb == nullptr) return text;
  text = options.verb->get_name();
  for (const CLI::Option* option : options.verb->get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || std::ranges::find(kNotAsked, name) != std::end(kNotAsked)) continue;
    text += ' ' + name;
    for (const std::string& value : option->results()) text += ' ' + value;
  }
  return text + '\n';
}

void add_resume_option(CLI::App& verb, CommonOptions& options, CLI::Option* batch) {
  options.verb = &verb;
  verb.add_option("--resume", options.resume,
                  fmt::format("with {} and --json: write to this file, after the answers\n"
                              "that an interrupted run has left there",
                              batch->get_name()))
      ->option_text("FILE")
      ->check(problem_of_name)
      ->needs(batch);
}

void require_input(const CommonOptions& options, bool has_input, const CLI::Option& batch) {
  if (!has_input && batch.count() == 0)
    throw CLI::RequiredError("INPUT or " + batch.get_name() + " FILE");
  if (!options.resume.empty() && !options.json)
    throw CLI::RequiredError("--json, whose lines can be told apart, with --resume");
}

void add_input_options(CLI::App& verb, CommonOptions& options, const char* answers) {
  auto* input = verb.add_option("INPUT", options.input,
                                "an isomorphism signature, a file, or - for standard input")
                    ->option_text(" ")
                    ->transform(unshield());
  auto* batch = verb.add_option("--batch", options.batch,
                                fmt::format("a file with one INPUT a line and # comments, or - "
                                            "for standard\ninput; {}",
                                            answers))
                    ->option_text("FILE");
  input->excludes(batch);
  add_resume_option(verb, options, batch);
  verb.add_flag("--quiet", options.quiet, "no progress on standard error");
  verb.parse_complete_callback(
      [input, batch, &options] { require_input(options, input->count() > 0, *batch); });
}

void add_common_options(CLI::App& verb, CommonOptions& options) {
  add_input_options(verb, options, "one answer for each, in the same order");
  verb.add_flag("--json", options.json, "one JSON object for each INPUT, one a line");
  verb.add_option("--threads", options.threads, "threads for --batch (default: all cores)")
      ->option_text("N")
      ->check(whole_number(kMostThreads));
}

int answer_lines(const CommonOptions& options,
                 const std::function<Reply(const topology::BatchLine&)>& answer,
                 const BatchOutput::Earlier& earlier, const FailedText& failed) {
  const auto without_end = [](std::string text) {
    if (text.ends_with('\n')) text.pop_back();
    return text;
  };
  return run_batch(
      {options.batch, options.resume, asked(options), options.threads, options.quiet, earlier},
      [&](const topology::BatchLine& line) -> Answer {
        const LineLimit limit;
        topology::begin_work();
        try {
          require_not_written(line.text);
          Reply outcome = answer(line);
          return {without_end(std::move(outcome.text)), stop_message(outcome), kSuccess};
        } catch (const std::exception& error) {
          Answer failure = error_answer(line.text, options.json, error);
          if (failed) failure.text = without_end(failed(line.text, error));
          return failure;
        }
      });
}

int answer_inputs(const CommonOptions& options,
                  const std::function<Reply(const std::string&)>& answer,
                  const FailedText& failed) {
  if (options.batch.empty()) return answer_one(options, answer);
  return answer_lines(
      options,
      [&](const topology::BatchLine& line) {
        if (line.text == "-") throw InvalidInput(kNoStandardInput);
        return answer(line.text);
      },
      {}, failed);
}

}  // namespace tripus::cli
