// tripus hyperbolic: hyperbolic or not, about the manifold. The Python package decides, with Regina
// for normal surfaces: this verb hands the command line over to it, or says how to install it.
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "cli/help.hpp"
#include "cli/output.hpp"
#include "cli/verb.hpp"
#include "meshing/find_tetgen.hpp"

namespace tripus::cli {
namespace {

struct HyperbolicCommandOptions {
  std::string input, batch, check, resume;
  double time_limit = 0;
  bool json = false;
  bool no_surfaces = false;
};

/// What Python runs. It ends with status 3, as for every failure of the system, where the package
/// is not installed.
constexpr const char* kPythonCode = R"py(
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

/// A status with which other programs do not end.
constexpr int kIsPython = 77;

/// The Python that TRIPUS_PYTHON names; empty if it names none.
std::string chosen_python() {
  const char* chosen = std::getenv("TRIPUS_PYTHON");
  return chosen == nullptr ? "" : chosen;
}

/// What ends at once, such as /bin/false, would leave no word of what is wrong.
/// Throws IoError, naming TRIPUS_PYTHON.
void require_python(const std::string& program) {
  std::array<std::string, 3> arguments{program, "-c",
                                       fmt::format("raise SystemExit({})", kIsPython)};
  std::array<char*, 4> pointers{arguments[0].data(), arguments[1].data(), arguments[2].data()};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (const int stream : {0, 1, 2})
    posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_RDWR, 0);
  pid_t process = 0;
  const int failure =
      posix_spawnp(&process, pointers[0], &files, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  int status = 0;
  while (failure == 0 && waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (failure == 0 && WIFEXITED(status) && WEXITSTATUS(status) == kIsPython) return;
  throw IoError(
      fmt::format("TRIPUS_PYTHON={} {}: name a Python 3.11 or newer that has tripus "
                  "(pip install 'tripus[regina]'), or unset it for python3",
                  tripus::quoted(program),
                  failure != 0 ? fmt::format("cannot be started ({})", std::strerror(failure))
                               : "is no Python"));
}

std::vector<std::string> arguments_for_python(const HyperbolicCommandOptions& command) {
  const std::string chosen = chosen_python();
  std::vector<std::string> arguments{chosen.empty() ? "python3" : chosen, "-c", kPythonCode};
  const auto add = [&](const std::string& name, const std::string& value) {
    if (!value.empty()) arguments.push_back(name + "=" + value);
  };
  add("--batch", command.batch);
  add("--resume", command.resume);
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
  if (const std::string chosen = chosen_python(); !chosen.empty()) require_python(chosen);
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

void add_hyperbolic(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<HyperbolicCommandOptions>();
  verb->add_option("INPUT", command->input, "the manifold")->option_text(" ");
  auto* check =
      verb->add_option("--check", command->check,
                       "check the certificate in an answer of --json, with INPUT that it\n"
                       "is about this manifold")
          ->option_text("FILE");
  auto* batch = verb->add_option("--batch", command->batch, "one INPUT a line, one answer for each")
                    ->option_text("FILE")
                    ->excludes(check);
  auto* json =
      verb->add_flag("--json", command->json, "one JSON object an INPUT")->option_text(" ");
  verb->add_option("--resume", command->resume,
                   "with --batch and --json: write to this file, after the answers\n"
                   "that an interrupted run has left there")
      ->option_text("FILE")
      ->needs(batch)
      ->needs(json);
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

}  // namespace

namespace registered_verbs {

std::span<const Verb> hyperbolic() {
  static constexpr Verb kRows[] = {{"hyperbolic",
                                    "hyperbolic or not, about the manifold, with a certificate",
                                    add_hyperbolic, 12}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
