// tripus hyperbolic: hyperbolic or not, about the manifold. The Python package decides, with Regina
// for normal surfaces: this verb hands the command line over to it, or says how to install it.
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output.hpp"
#include "meshing/find_tetgen.hpp"

namespace tripus::cli {
namespace {

struct HyperbolicCommandOptions {
  std::string input, batch, check;
  double time_limit = 0;
  bool json = false;
  bool no_surfaces = false;
};

/// What Python runs. It ends with status 3, as for every failure of the system, where the package
/// is not installed.
constexpr const char* kProgram = R"py(
import json, sys
try:
    from tripus.hyperbolic.__main__ import main
except ImportError as error:
    message = ("`tripus hyperbolic` is part of the Python package, which " + sys.executable +
               " does not find: pip install 'tripus[regina]', or name another Python in "
               "TRIPUS_PYTHON (" + str(error) + ")")
    sys.stderr.write("tripus: " + message + "\n")
    if "--json" in sys.argv:
        print(json.dumps({"error": {"kind": "system", "message": message}}))
    sys.exit(3)
sys.exit(main(sys.argv[1:]))
)py";

std::vector<std::string> arguments_for_python(const HyperbolicCommandOptions& command) {
  const char* chosen = std::getenv("TRIPUS_PYTHON");
  const bool is_chosen = chosen != nullptr && *chosen != '\0';
  std::vector<std::string> arguments{is_chosen ? chosen : "python3", "-c", kProgram};
  const auto add = [&](const std::string& name, const std::string& value) {
    if (!value.empty()) arguments.push_back(name + "=" + value);
  };
  add("--batch", command.batch);
  add("--check", command.check);
  if (command.time_limit > 0) add("--time-limit", fmt::format("{}", command.time_limit));
  if (command.json) arguments.emplace_back("--json");
  if (command.no_surfaces) arguments.emplace_back("--no-surfaces");
  if (!command.input.empty()) {
    arguments.emplace_back("--");
    arguments.push_back(command.input);
  }
  return arguments;
}

int run(const HyperbolicCommandOptions& command) {
  std::vector<std::string> arguments = arguments_for_python(command);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  flush_output();
  // Python is another program, beside which there is no tripus-tetgen.
  try {
    setenv("TRIPUS_TETGEN", meshing::find_tetgen().c_str(), /*overwrite=*/0);
  } catch (const Unsupported&) {  // to be said where a solid is to be filled, and only there
  }
  execvp(pointers.front(), pointers.data());
  throw IoError(fmt::format(
      "`tripus hyperbolic` is part of the Python package, and {} cannot be started: install Python "
      "3.11 or newer, then pip install 'tripus[regina]'",
      tripus::quoted(arguments.front())));
}

}  // namespace

void add_hyperbolic(CLI::App& program, Command& chosen) {
  CLI::App* verb = program.add_subcommand(
      "hyperbolic", "hyperbolic or not, about the manifold, with a certificate");
  auto command = std::make_shared<HyperbolicCommandOptions>();
  verb->add_option("INPUT", command->input, "the manifold")->option_text(" ");
  auto* check =
      verb->add_option("--check", command->check,
                       "check the certificate in an answer of --json, with INPUT that it\n"
                       "is about this manifold")
          ->option_text("FILE");
  verb->add_option("--batch", command->batch, "one INPUT a line, one answer for each")
      ->option_text("FILE")
      ->excludes(check);
  verb->add_flag("--json", command->json, "one JSON object an INPUT")->option_text(" ");
  verb->add_flag("--no-surfaces", command->no_surfaces, "the quick tests only, without Regina")
      ->option_text(" ");
  verb->footer(
      std::string(kInputHelp) +
      "\nIt is a part of the Python package: pip install 'tripus[regina]'. TRIPUS_PYTHON names "
      "the\n"
      "Python to use (default: python3).\n\n"
      "The answer is \"hyperbolic\" (a metric), \"not hyperbolic\" (a surface, or the fundamental\n"
      "group) or \"not decided\" (with what was tried); docs/verdicts.md.\n\n"
      "Exit status: 0 decided (for --batch: the run finished), 1 not decided, 2 bad usage or bad\n"
      "input, 3 a failure of the program, or the Python package is not there.");
  verb->final_callback([command, verb, &chosen] {
    // Every verb has it; here Python keeps it, so that what was tried is told.
    if (const CLI::Option* limit = verb->get_option_no_throw("--time-limit");
        limit != nullptr && limit->count() > 0)
      command->time_limit = limit->as<double>();
    if (command->input.empty() && command->batch.empty() && command->check.empty())
      throw CLI::RequiredError("INPUT, --batch or --check");
    if (!command->input.empty() && !command->batch.empty())
      throw CLI::ExtrasError({command->input});
    chosen = [command] { return run(*command); };
  });
}

}  // namespace tripus::cli
