#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "base/registry.hpp"

namespace tripus::cli {

/// What every verb that takes an INPUT understands.
struct CommonOptions {
  std::string input;
  std::string batch;   ///< file, empty without --batch
  std::string resume;  ///< file that answers of a batch are added to, empty for standard output
  unsigned threads = 0;
  bool json = false;
  bool quiet = false;
  const CLI::App* verb = nullptr;  ///< of a batch that can be resumed
};

/// The verb and those of its options that answers depend on, as they were given.
std::string asked(const CommonOptions& options);

/// Adds INPUT, --batch (`answers` says what comes for each line) and --quiet to a verb.
void add_input_options(CLI::App& verb, CommonOptions& options, const char* answers);
/// Adds --resume to a verb whose batch is given by the option `batch`.
void add_resume_option(CLI::App& verb, CommonOptions& options, CLI::Option* batch);
/// To be called when the options are known: INPUT or the batch is there, and --resume has its JSON.
/// Throws CLI::RequiredError.
void require_input(const CommonOptions& options, bool has_input, const CLI::Option& batch);
/// Adds INPUT and all the common options to a verb.
void add_common_options(CLI::App& verb, CommonOptions& options);

/// A verb, ready to run once the command line is parsed; returns the exit status.
using Command = std::function<int()>;

/// One line of the table of verbs.
struct Verb {
  std::string_view name;
  std::string_view summary;  ///< one line of the help
  /// Gives the verb its arguments and options and, when it is chosen, sets `chosen`.
  void (*add)(CLI::App* verb, Command& chosen);
  int place = kAnyPlace;  ///< in the help
};

/// Every verb, one file in cli/verbs each, in the order of the help.
std::span<const Verb> verbs();

}  // namespace tripus::cli
