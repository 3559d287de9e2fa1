#pragma once

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

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

// Each adds its verb to the program and, when the verb is chosen, sets `chosen`.
// One verb, one file.
void add_info(CLI::App& program, Command& chosen);
void add_solve(CLI::App& program, Command& chosen);
void add_simplify(CLI::App& program, Command& chosen);
void add_cover(CLI::App& program, Command& chosen);
void add_canonize(CLI::App& program, Command& chosen);
void add_compare(CLI::App& program, Command& chosen);
void add_identify(CLI::App& program, Command& chosen);
void add_census(CLI::App& program, Command& chosen);
void add_enumerate(CLI::App& program, Command& chosen);
void add_prove(CLI::App& program, Command& chosen);
void add_check(CLI::App& program, Command& chosen);
void add_study(CLI::App& program, Command& chosen);
void add_mesh(CLI::App& program, Command& chosen);
void add_embed(CLI::App& program, Command& chosen);
void add_view(CLI::App& program, Command& chosen);
void add_tube(CLI::App& program, Command& chosen);
void add_hyperbolic(CLI::App& program, Command& chosen);
void add_orthospectrum(CLI::App& program, Command& chosen);
void add_methods(CLI::App& program, Command& chosen);

}  // namespace tripus::cli
