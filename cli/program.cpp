// The program `tripus`: parses the command line and runs the chosen verb.
#include "cli/program.hpp"

#include <algorithm>
#include <exception>
#include <sstream>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/version.hpp"
#include "cli/arguments.hpp"
#include "cli/failure.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/streams.hpp"
#include "cli/verb.hpp"
#include "geometry/batch.hpp"
#include "manifold/json_text.hpp"

namespace tripus::cli {
namespace {

constexpr const char* kDescription =
    "Tripus finds the hyperbolic metric with totally geodesic boundary on a compact 3-manifold,\n"
    "given by an ideal triangulation, or says with evidence why this one carries none. Cusps, "
    "cone\n"
    "angles and finite vertices are known to the verbs that say so.";

constexpr const char* kExamples = R"(
Examples:
  tripus info cPcbbbihq                     what the triangulation is
  tripus solve cPcbbbihq                    its metric: volume, edge lengths, dihedral angles
  tripus solve cPcbbbihq --json             the same as one JSON object
  tripus solve --batch list.txt --json      one INPUT a line, one JSON object a line
  tripus solve cPcbbbihq --method flow:curvature/rk4 --initial 1 --history run.csv
  tripus help solve                         the options of a verb, as tripus solve --help
)";

/// --json may stand anywhere on a command line that could not be parsed.
bool wants_json(const std::vector<std::string>& arguments) {
  return std::ranges::find(arguments, "--json") != arguments.end();
}

void report_failure(bool json, std::string_view kind, std::string_view message) {
  write_message(fmt::format("tripus: {}\n", message));
  if (!json) return;
  tripus::JsonText out;
  tripus::append_error(out, "", kind, message);
  write_output({out.data(), out.size()});
  write_output("\n");
  flush_output();
}

/// What was wrong with a command line, in our words where the parser's would mislead.
std::string usage_message(const CLI::App& program, const CLI::ParseError& error) {
  const auto chosen = program.get_subcommands();
  if (!chosen.empty()) {
    // "--batch: 1 required TEXT missing", with the parser's name of a type
    std::string what = error.what();
    const std::size_t missing = what.find(": 1 required ");
    if (missing != std::string::npos && what.ends_with(" missing"))
      what = what.substr(0, missing) + ": its value is missing";
    return fmt::format("{}; `tripus {} --help` tells what there is", what,
                       chosen.front()->get_name());
  }
  std::vector<std::string> verbs;
  for (const CLI::App* verb : program.get_subcommands(nullptr)) verbs.push_back(verb->get_name());
  const auto extras = program.remaining();
  const std::string what = extras.empty() || extras.front().starts_with('-')
                               ? std::string(error.what())
                               : "there is no verb " + tripus::quoted(extras.front());
  return fmt::format("{}; the verbs are {}, and `tripus --help` tells more", what,
                     fmt::join(verbs, ", "));
}

void add_verbs(CLI::App& program, Command& command) {
  program.formatter(std::make_shared<HelpFormatter>());
  program.set_help_flag("-h,--help", "print this text");
  program.set_version_flag("--version", std::string("tripus ") + tripus::kVersion,
                           "print the version");
  program.require_subcommand(0, 1);
  for (const Verb& verb : verbs())
    verb.add(program.add_subcommand(std::string(verb.name), std::string(verb.summary)), command);
  program.add_subcommand("help", "the options of a verb: tripus help VERB");
  for (CLI::App* verb : program.get_subcommands(nullptr)) verb->group("Verbs");
  program.footer(std::string(kInputHelp) + kExamples + "\n" + kExitStatusHelp);
}

/// All verbs but those that are done in no time end when they are told to.
void add_time_limit(CLI::App& program, double& seconds) {
  for (CLI::App* verb : program.get_subcommands(nullptr)) {
    if (verb->get_name() == "help" || verb->get_name() == "methods") continue;
    verb->add_option("--time-limit", seconds,
                     verb->get_option_no_throw("INPUT") != nullptr
                         ? "end after S seconds, in a batch for each INPUT, with what is known"
                         : "end after S seconds, with what is known")
        ->option_text("S")
        ->check(positive_number());
  }
}

/// The verb's options are known.
void start_time_limit(const CLI::App& verb, double seconds) {
  const auto is_given = [&](const char* name) {
    const CLI::Option* option = verb.get_option_no_throw(name);
    return option != nullptr && option->count() > 0;
  };
  if (is_given("--time-limit"))
    set_time_limit(seconds, is_given("--batch") || is_given("--gallery"));
}

/// Throws ExtrasError for `tripus help banana`.
void require_verb_to_help(const CLI::App& program, const std::vector<std::string>& given) {
  if (given.size() < 2 || given.front() != "help" || given[1].starts_with("-")) return;
  for (const CLI::App* verb : program.get_subcommands(nullptr))
    if (verb->get_name() == given[1]) return;
  throw CLI::ExtrasError({given[1]});
}

/// `tripus help VERB` is `tripus VERB --help`, and `tripus help` is `tripus --help`.
std::vector<std::string> without_help_verb(std::vector<std::string> arguments) {
  if (arguments.empty() || arguments.front() != "help") return arguments;
  arguments.erase(arguments.begin());
  arguments.emplace_back("--help");
  return arguments;
}

int run(const std::vector<std::string>& given) {
  const std::vector<std::string> arguments = without_help_verb(given);
  CLI::App program{kDescription, "tripus"};
  Command command;
  add_verbs(program, command);
  double time_limit = 0;
  add_time_limit(program, time_limit);
  if (arguments.empty()) {
    write_message(program.help());
    return kBadInput;
  }
  try {
    require_verb_to_help(program, given);
    auto reversed = shield_signatures(arguments);
    std::ranges::reverse(reversed);
    program.parse(std::move(reversed));
    if (!command) throw CLI::RequiredError("a verb");
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help, --version
      std::ostringstream text;
      program.exit(error, text, text);
      write_output(text.str());
      flush_output();
      return kSuccess;
    }
    report_failure(wants_json(arguments), "usage", usage_message(program, error));
    return kBadInput;
  }
  geometry::batch_kernels();  // says at once, and once, what is wrong with TRIPUS_SIMD
  start_time_limit(*program.get_subcommands().front(), time_limit);
  const int status = command();
  flush_output();
  return status;
}

}  // namespace

int run_program(const std::vector<std::string>& arguments) {
  secure_standard_streams();
  catch_interrupts();
  try {
    return run(arguments);
  } catch (const OutputError& error) {
    write_message(fmt::format("tripus: {}\n", error.what()));
  } catch (const std::exception& error) {
    try {
      report_failure(wants_json(arguments), failure_kind(error), failure_text(error));
    } catch (const OutputError&) {
      return kInternalFailure;
    }
    return status_of(error);
  }
  return kInternalFailure;
}

}  // namespace tripus::cli
