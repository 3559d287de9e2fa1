// tripus solve: find the metric.
#include <charconv>
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "cli/answer.hpp"
#include "cli/commands.hpp"
#include "cli/describe.hpp"
#include "cli/help.hpp"
#include "cli/history_file.hpp"
#include "cli/interrupt.hpp"
#include "cli/lengths_file.hpp"
#include "cli/numbers.hpp"
#include "cli/progress.hpp"
#include "cli/report_text.hpp"
#include "manifold/load.hpp"
#include "structure/method.hpp"
#include "structure/retriangulate.hpp"
#include "structure/solve.hpp"
#include "topology/components.hpp"

namespace tripus::cli {
namespace {

struct SolveCommandOptions {
  CommonOptions common;
  structure::SolveOptions solve;
  std::string lengths_file;
  std::vector<std::string> cone_angles;  ///< EDGE=ANGLE
  std::string history;
  bool components = false;
  bool retriangulate = false;
  bool prove = false;
  structure::RetriangulateOptions search;
};

/// Cone angles [E] with the ones that were asked for changed; empty if none were.
std::vector<double> cone_angles_of(const std::vector<std::string>& assignments,
                                   std::size_t edge_count) {
  std::vector<double> angles;
  if (!assignments.empty()) angles.assign(edge_count, parse_angle("2pi"));
  for (const std::string& assignment : assignments) {
    const std::size_t equals = assignment.find('=');
    const std::string_view number = std::string_view(assignment).substr(0, equals);
    std::size_t edge = 0;
    const auto [end, code] = std::from_chars(number.data(), number.data() + number.size(), edge);
    if (equals == std::string::npos || code != std::errc() ||
        end != number.data() + number.size()) {
      throw InvalidInput("--cone-angle " + tripus::quoted(assignment) +
                         ": write EDGE=ANGLE, such as 0=2pi/3");
    }
    if (edge >= edge_count) {
      throw InvalidInput(fmt::format("--cone-angle {}: there are only the edge classes 0 to {}",
                                     tripus::quoted(assignment), edge_count - 1));
    }
    try {
      angles[edge] = parse_angle(std::string_view(assignment).substr(equals + 1));
    } catch (const InvalidInput& error) {
      throw InvalidInput("--cone-angle " + tripus::quoted(assignment) + ": " + error.what());
    }
  }
  return angles;
}

/// The answer, with its proof if one is asked for.
Outcome answer_of(const SolveCommandOptions& command, const Subject& subject,
                  const structure::Report& report,
                  const structure::Retriangulation* found = nullptr) {
  std::optional<structure::ProofText> proof;
  if (command.prove) {
    proof = structure::prove_report(subject.triangulation, report, 0, interruptible());
  }
  const structure::ProofText* given = proof ? &*proof : nullptr;
  return {command.common.json ? report_as_json(subject, report, found, given)
                              : report_as_text(subject, report, found, given),
          report.outcome == structure::Outcome::kGeometric ? kSuccess : kNoAnswer};
}

/// Goes on from a report without a metric; the answer is about the triangulation found.
Outcome retriangulate_subject(const SolveCommandOptions& command, structure::SolveOptions options,
                              const Subject& subject, structure::Report report) {
  options.time_limit -= report.seconds;
  structure::Retriangulation found =
      structure::retriangulate(subject.triangulation, std::move(report), options, command.search);
  const Subject result = make_subject(subject.input, subject.name, found.gluings);
  return answer_of(command, result, found.report, &found);
}

Outcome solve_subject(const SolveCommandOptions& command, const Subject& subject) {
  structure::SolveOptions options = command.solve;
  options.cone_angles = cone_angles_of(command.cone_angles, subject.triangulation.edge_count());
  catch_interrupts();
  options.stop_requested = &interrupt_requested();
  std::optional<HistoryFile> history;
  if (!command.history.empty()) history.emplace(command.history);
  const bool single = command.common.batch.empty();
  Progress progress(single && !command.common.quiet);
  // A history row costs an evaluation: without a file it is computed only for a terminal, and then
  // only for long runs, which the iteration itself dominates.
  if (history) options.history = [&](const structure::HistoryRow& row) { history->add(row); };
  if (single && !command.common.quiet) {
    options.on_iteration = [&](int iteration, double max_curvature) {
      if (progress.due())
        progress.show(fmt::format("iteration {}, max|K| {:.3g}", iteration, max_curvature));
    };
  }
  structure::Report report = structure::solve(subject.triangulation, options);
  if (history) history->close();
  const bool geometric = report.outcome == structure::Outcome::kGeometric;
  const bool has_time = options.time_limit > report.seconds;
  if (geometric || !command.retriangulate || !has_time || interrupt_requested())
    return answer_of(command, subject, report);
  return retriangulate_subject(command, options, subject, std::move(report));
}

/// As solve_subject, but says which component could not be solved.
Outcome solve_component(const SolveCommandOptions& command, const std::string& component,
                        const Subject& subject) {
  try {
    return solve_subject(command, subject);
  } catch (const Unsupported& error) {
    throw Unsupported(component + ": " + error.what());
  } catch (const InvalidInput& error) {
    throw InvalidInput(component + ": " + error.what());
  }
}

/// Each connected component by itself, in the order of their first tetrahedra.
Outcome solve_components(const SolveCommandOptions& command, const std::string& input) {
  topology::NamedGluings loaded = load_input(input, interruptible());
  Outcome all;
  std::vector<std::string> answers;
  std::size_t number = 0;
  for (topology::Gluings& part : topology::components(loaded.gluings)) {
    const std::string component = fmt::format("component {}", number++);
    const std::string label = fmt::format("{} ({})", input, component);
    const Outcome one =
        solve_component(command, component, make_subject(label, {}, std::move(part)));
    all.status = std::max(all.status, one.status);
    answers.push_back(one.text);
  }
  if (!command.common.json) {
    for (const std::string& answer : answers) all.text += answer;
    return all;
  }
  JsonText out;
  append_header(out, input);
  append(out, ", \"components\": ");
  append_array(out, answers, [](JsonText& to, const std::string& text) { append(to, text); });
  out.push_back('}');
  all.text = fmt::to_string(out);
  return all;
}

int run(SolveCommandOptions& command) {
  if (command.lengths_file == "-" && (command.common.input == "-" || command.common.batch == "-"))
    throw InvalidInput("standard input cannot be both the input and --initial-lengths");
  if (!command.lengths_file.empty()) {
    try {
      command.solve.initial_lengths = parse_lengths(read_file(command.lengths_file));
    } catch (const InvalidInput& error) {
      throw InvalidInput("--initial-lengths " + tripus::quoted(command.lengths_file) + ": " +
                         error.what());
    }
    if (command.solve.initial_lengths.empty())
      throw InvalidInput("--initial-lengths " + tripus::quoted(command.lengths_file) +
                         " holds no numbers");
  }
  structure::find_solve_method(command.solve.method, 1);  // a wrong name is wrong for all inputs
  return answer_inputs(command.common, [&](const std::string& input) {
    return command.components
               ? solve_components(command, input)
               : solve_subject(command, load_solvable_subject(input, interruptible()));
  });
}

}  // namespace

void add_solve(CLI::App& program, Command& chosen) {
  CLI::App* verb = program.add_subcommand(
      "solve", "find the metric: volume, boundary area, edge lengths, dihedral angles");
  auto command = std::make_shared<SolveCommandOptions>();
  add_common_options(*verb, command->common);
  structure::SolveOptions& solve = command->solve;
  verb->add_option("--method", solve.method,
                   "how, by name (default: auto); `tripus methods` lists them")
      ->option_text("NAME");
  auto* initial =
      verb->add_option("--initial", solve.initial_length, "start from this length on every edge")
          ->option_text("X")
          ->check(positive_number());
  verb->add_option("--initial-lengths", command->lengths_file,
                   "start from a length for each edge class: a file of numbers,\n"
                   "or an answer of solve --json")
      ->option_text("FILE")
      ->excludes(initial);
  verb->add_option("--tolerance", solve.tolerance,
                   fmt::format("largest edge curvature |K| (radians) of a geometric answer\n"
                               "(default: {})",
                               solve.tolerance))
      ->option_text("X")
      ->check(positive_number());
  verb->add_option("--max-iterations", solve.max_iterations,
                   "stop after N iterations; 0: the method's own limit")
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()));
  verb->add_option("--time-limit", solve.time_limit, "stop after so many seconds for one INPUT")
      ->option_text("S")
      ->check(positive_number());
  verb->add_option("--cone-angle", command->cone_angles,
                   "cone angle around an edge class instead of 2pi, such as 0=2pi/3;\n"
                   "may be repeated; `tripus info` numbers the edge classes from 0")
      ->option_text("EDGE=ANGLE")
      ->allow_extra_args(false);
  auto* history = verb->add_option("--history", command->history,
                                   "write a CSV file with a row for each iteration: iteration,\n"
                                   "evaluations, seconds, max|K|, energy H, volume, shortest and\n"
                                   "longest edge")
                      ->option_text("FILE");
  history->excludes(verb->get_option("--batch"));
  auto* retriangulate =
      verb->add_flag("--retriangulate", command->retriangulate,
                     "where the triangulation carries no metric, look for one of the same\n"
                     "manifold that does, by moves")
          ->option_text(" ");
  verb->add_option("--budget", command->search.budget,
                   fmt::format("triangulations that --retriangulate may try (default: {})",
                               command->search.budget))
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()))
      ->needs(retriangulate);
  verb->add_option("--seed", command->search.seed,
                   "orders the moves of --retriangulate that look equally good\n"
                   "(default: 0)")
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()))
      ->needs(retriangulate);
  verb->get_option("--cone-angle")->excludes(retriangulate);
  verb->add_flag("--angle-structure", solve.angle_structure,
                 "also print an exact rational strict angle structure, if there is one")
      ->option_text(" ");
  verb->add_flag("--prove", command->prove,
                 "also prove what was found, with every rounding accounted for; see\n"
                 "`tripus prove --help`")
      ->option_text(" ")
      ->excludes(verb->get_option("--cone-angle"));
  auto* components = verb->add_flag("--components", command->components,
                                    "solve each connected component by itself")
                         ->option_text(" ");
  components->excludes(history);
  verb->footer(std::string(kInputHelp) + "\n" + kOutcomeHelp + "\n" + kExitStatusHelp);
  verb->final_callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace tripus::cli
