// tripus solve: find the metric.
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "cli/answer.hpp"
#include "cli/commands.hpp"
#include "cli/describe.hpp"
#include "cli/history_file.hpp"
#include "cli/input.hpp"
#include "cli/interrupt.hpp"
#include "cli/lengths_file.hpp"
#include "cli/progress.hpp"
#include "cli/report_text.hpp"
#include "structure/method.hpp"
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
};

/// Cone angles [E] with the ones that were asked for changed; empty if none were.
std::vector<double> cone_angles_of(const std::vector<std::string>& assignments,
                                   std::size_t edge_count) {
  std::vector<double> angles;
  if (!assignments.empty()) angles.assign(edge_count, parse_angle("2pi"));
  for (const std::string& assignment : assignments) {
    const std::size_t equals = assignment.find('=');
    std::size_t edge = edge_count, used = 0;
    try {
      edge = std::stoul(assignment, &used);
    } catch (const std::exception&) {
      used = 0;
    }
    if (equals == std::string::npos || used != equals || assignment.front() == '-') {
      throw InvalidInput("--cone-angle " + tripus::quoted(assignment) +
                         ": write EDGE=ANGLE, such as 0=2pi/3");
    }
    if (edge >= edge_count) {
      throw InvalidInput(fmt::format("--cone-angle {}: there are only the edge classes 0 to {}",
                                     tripus::quoted(assignment), edge_count - 1));
    }
    angles[edge] = parse_angle(std::string_view(assignment).substr(equals + 1));
  }
  return angles;
}

Outcome solve_subject(const SolveCommandOptions& command, const Subject& subject) {
  structure::SolveOptions options = command.solve;
  options.cone_angles = cone_angles_of(command.cone_angles, subject.triangulation.edge_count());
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
  const structure::Report report = structure::solve(subject.triangulation, options);
  if (history) history->close();
  const int status = report.outcome == structure::Outcome::kGeometric ? kSuccess : kNoAnswer;
  return {command.common.json ? report_as_json(subject, report) : report_as_text(subject, report),
          status};
}

/// Each connected component by itself, in the order of their first tetrahedra.
Outcome solve_components(const SolveCommandOptions& command, const std::string& input) {
  topology::NamedGluings loaded = load_input(input);
  Outcome all;
  std::vector<std::string> answers;
  std::size_t number = 0;
  for (topology::Gluings& part : topology::components(loaded.gluings)) {
    const std::string label = fmt::format("{} (component {})", input, number++);
    const Outcome one = solve_subject(command, make_subject(label, {}, std::move(part)));
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
  catch_interrupts();
  return answer_inputs(command.common, [&](const std::string& input) {
    return command.components ? solve_components(command, input)
                              : solve_subject(command, load_subject(input));
  });
}

}  // namespace

void add_solve(CLI::App& program, Command& chosen) {
  CLI::App* verb = program.add_subcommand("solve", "find the metric");
  auto command = std::make_shared<SolveCommandOptions>();
  add_common_options(*verb, command->common);
  structure::SolveOptions& solve = command->solve;
  verb->add_option("--method", solve.method, "how, by name; `tripus methods` lists them")
      ->capture_default_str();
  auto* initial =
      verb->add_option("--initial", solve.initial_length, "one length to start from, for all edges")
          ->check(CLI::PositiveNumber);
  verb->add_option("--initial-lengths", command->lengths_file,
                   "a file with a length for each edge class, or an answer of solve --json")
      ->excludes(initial);
  verb->add_option("--tolerance", solve.tolerance, "on max|K|, the largest edge curvature")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb->add_option("--max-iterations", solve.max_iterations, "0: the method's own limit")
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--time-limit", solve.time_limit, "seconds for one input")
      ->check(CLI::PositiveNumber);
  verb->add_option("--cone-angle", command->cone_angles,
                   "EDGE=ANGLE, instead of 2pi around that edge class; may be repeated")
      ->allow_extra_args(false);
  auto* history = verb->add_option("--history", command->history,
                                   "write iteration, evaluations, seconds, max|K|, H, volume, "
                                   "shortest and longest edge to this CSV file");
  history->excludes(verb->get_option("--batch"));
  verb->add_flag("--angle-structure", solve.angle_structure,
                 "also print an exact rational strict angle structure, where there is one");
  auto* components = verb->add_flag("--components", command->components,
                                    "solve each connected component by itself");
  components->excludes(history);
  verb->final_callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace tripus::cli
