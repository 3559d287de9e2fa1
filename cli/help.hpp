#pragma once

#include <CLI/CLI.hpp>

namespace tripus::cli {

/// The layout of the program's help: verbs and INPUT as the documentation calls them. Options say
/// what they take by `option_text`.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App* app, std::string name) const override;
};

/// Describes INPUT, the outcomes and the exit status: below the help of the verbs that solve.
extern const char* const kInputHelp;
extern const char* const kOutcomeHelp;
extern const char* const kExitStatusHelp;

}  // namespace tripus::cli
