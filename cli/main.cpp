// The program `tripus`: parses the command line and runs the chosen verb.
#include <algorithm>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/version.hpp"
#include "cli/commands.hpp"
#include "cli/exit_status.hpp"
#include "cli/json.hpp"
#include "cli/output.hpp"

namespace {

using namespace tripus::cli;

constexpr const char* kDescription =
    "Tripus finds the hyperbolic metric with totally geodesic boundary on a compact 3-manifold.";

constexpr const char* kFooter = R"(
INPUT is an isomorphism signature, a file (JSON gluing table, Regina or SnapPea), or - for
standard input.

Examples:
  tripus info cPcbbbihq                     what the triangulation is
  tripus solve cPcbbbihq                    its metric: volume, edge lengths, dihedral angles
  tripus solve --json FILE                  the same for a program to read
  tripus solve --batch LIST --json          one answer a line
  tripus solve cPcbbbihq --method flow:curvature/rk4 --initial 1 --history run.csv

Exit status: 0 a geometric answer (for --batch: the run finished), 1 a mathematical "no" or
"unresolved", 2 bad usage or bad input, 3 a failure of the program itself.)";

/// --json may stand anywhere on a command line that could not be parsed.
bool wants_json(int argc, char** argv) {
  return std::any_of(argv, argv + argc,
                     [](const char* a) { return std::string_view(a) == "--json"; });
}

void report_failure(bool json, std::string_view kind, std::string_view message) {
  if (json) {
    JsonText out;
    append_error(out, "", kind, message);
    write_output({out.data(), out.size()});
    write_output("\n");
  }
  write_message(fmt::format("tripus: {}\n", message));
}

int run(int argc, char** argv) {
  CLI::App program{kDescription, "tripus"};
  program.footer(kFooter);
  program.set_version_flag("--version", std::string("tripus ") + tripus::kVersion);
  program.require_subcommand(1);
  Command command;
  add_info(program, command);
  add_solve(program, command);
  add_check(program, command);
  add_methods(program, command);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
    report_failure(wants_json(argc, argv), "usage",
                   fmt::format("{}; `tripus --help` tells what there is", error.what()));
    return kBadInput;
  }
  try {
    const int status = command();
    flush_output();
    return status;
  } catch (const tripus::InvalidInput& error) {
    report_failure(wants_json(argc, argv), error_kind(error), error.what());
    return kBadInput;
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    write_message(fmt::format("tripus: {}\n", error.what()));
    return kInternalFailure;
  }
}
