// tripus solve: find the metric.
#include "structure/solve.hpp"

#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "cli/answer.hpp"
#include "cli/arguments.hpp"
#include "cli/describe.hpp"
#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/metric.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/remedies.hpp"
#include "cli/solve_record.hpp"
#include "cli/texts.hpp"
#include "cli/verb.hpp"
#include "manifold/labels.hpp"
#include "manifold/load.hpp"
#include "manifold/prepared.hpp"
#include "structure/method.hpp"
#include "topology/components.hpp"
#include "topology/requirements.hpp"

namespace tripus::cli {
namespace {

struct SolveCommandOptions {
  CommonOptions common;
  structure::SolveOptions solve;
  std::string lengths_file;
  std::vector<std::string> cone_orders;  ///< EDGE=ORDER
  std::vector<std::string> cone_angles;  ///< EDGE=ANGLE
  std::string history;
  bool components = false;
  MetricSearch search;
  std::string output;
  bool prove = false;
  std::string format;
  std::string fields_list = "input,outcome,volume";
  std::vector<const RecordField*> fields;  ///< of a record; empty: no record
};

/// The triangulation that the metric is on, into a file.
void write_solved(const SolveCommandOptions& command, const Solved& solved) {
  const Subject& subject = solved.subject;
  if (command.output.empty()) return;
  if (!solved.is_geometric()) {
    write_message(
        fmt::format("tripus: note: {} was not written: there is no metric to go with it\n",
                    tripus::quoted(command.output)));
    return;
  }
  write_triangulation_file(command.output, subject);
}

/// The answer, with its proof if one is asked for.
Reply answer_of(const SolveCommandOptions& command, const Solved& solved) {
  if (!command.fields.empty())
    return {(command.common.batch.empty() ? record_header(command.fields) : "") +
                record(command.fields, solved),
            solved.is_geometric() ? kSuccess : kNoAnswer};
  std::optional<structure::ProofText> proof;
  if (command.prove) {
    proof = structure::prove_report(solved.subject.triangulation, solved.report,
                                    {.cone_angles = solved.subject.cone_angles}, interruptible());
  }
  const structure::ProofText* given = proof ? &*proof : nullptr;
  return {command.common.json
              ? report_as_json(solved.subject, solved.report, solved.search(), given)
              : report_as_text(solved.subject, solved.report, solved.search(), given),
          solved.is_geometric() ? kSuccess : kNoAnswer};
}

Reply solve_subject(const SolveCommandOptions& command, Subject subject) {
  structure::SolveOptions options = command.solve;
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
  Solved solved = find_metric(std::move(subject), options, command.search);
  if (history) history->close();
  write_solved(command, solved);
  return answer_of(command, solved);
}

/// A component as a subject of its own, its finite vertices removed.
Subject component_subject(const std::string& label, const topology::NamedGluings& whole,
                          topology::Gluings part) {
  topology::NamedGluings loaded{{}, std::move(part)};
  loaded.orientation_known = whole.orientation_known;
  make_ideal(loaded, topology::FiniteVertices::kRemove);
  return make_subject(label, std::move(loaded));
}

/// The same manifold without finite vertices, if it has others: with a note.
Subject without_finite_vertices(Subject subject) {
  topology::NamedGluings loaded{.name = subject.name,
                                .gluings = subject.triangulation.gluings(),
                                .notes = subject.notes,
                                .orientation_known = subject.orientation_known};
  make_ideal(loaded, topology::FiniteVertices::kRemove, &stop_flag());
  if (loaded.notes.size() == subject.notes.size()) return subject;
  write_message(
      fmt::format("tripus: note: {}: {}\n", tripus::quoted(subject.input), loaded.notes.back()));
  return make_subject(subject.input, std::move(loaded));
}

void assign_labels(const SolveCommandOptions& command, Subject& subject) {
  LabelAssignment labels(subject.cone_angles, subject.triangulation.edge_count());
  for (const std::string& list : command.cone_orders)
    labels.assign("--cone-order", list, "EDGE=ORDER, such as 0=3", topology::parse_cone_order);
  for (const std::string& list : command.cone_angles)
    labels.assign(
        "--cone-angle", list, "EDGE=ANGLE, such as 0=2pi/3",
        [](std::string_view text) -> topology::ConeAngle {
          const double angle = parse_angle(text);
          if (angle < 0)
            throw InvalidInput("a cone angle is not negative; 0 makes the edge parabolic");
          return angle;
        });
}

/// The labels of the command line come on top of those of the input.
Subject load_subject_with(const SolveCommandOptions& command, const std::string& input) {
  Subject subject = load_labelled_subject(input, Balls::kRefused, interruptible());
  assign_labels(command, subject);
  if (!command.output.empty()) require_format_for(command.output, subject.cone_angles);
  // Labels are by the edge classes of the triangulation as it was given.
  if (subject.cone_angles.empty()) subject = without_finite_vertices(std::move(subject));
  try {
    require_with_remedy(subject.triangulation, subject.cone_angles);
  } catch (const Unsupported& error) {
    throw Unsupported(fmt::format("{}: {}", tripus::quoted(input), error.what()));
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", tripus::quoted(input), error.what()));
  }
  return subject;
}

/// As solve_subject, but says which component could not be solved.
Reply solve_component(const SolveCommandOptions& command, const std::string& component,
                      Subject subject) {
  try {
    require_with_remedy(subject.triangulation, subject.cone_angles);
    return solve_subject(command, std::move(subject));
  } catch (const Unsupported& error) {
    throw Unsupported(component + ": " + error.what());
  } catch (const InvalidInput& error) {
    throw InvalidInput(component + ": " + error.what());
  }
}

/// Each connected component by itself, in the order of their first tetrahedra.
Reply solve_components(const SolveCommandOptions& command, const std::string& input) {
  topology::NamedGluings loaded = load_input(input, interruptible());
  Reply all;
  std::vector<std::string> answers;
  std::size_t number = 0;
  for (topology::Gluings& part : topology::components(loaded.gluings)) {
    const std::string component = fmt::format("component {}", number++);
    const std::string label = fmt::format("{} ({})", input, component);
    Subject subject = component_subject(label, loaded, std::move(part));
    assign_labels(command, subject);
    if (!command.output.empty()) require_format_for(command.output, subject.cone_angles);
    const Reply one = solve_component(command, component, std::move(subject));
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
  if (!command.output.empty()) {
    require_triangulation_name(command.output);
    declare_output("-o", command.output);
  }
  if (!command.history.empty()) declare_output("--history", command.history);
  if (!command.lengths_file.empty()) require_not_written(command.lengths_file);
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
  if (command.format == "tsv") command.fields = parse_fields(command.fields_list);
  FailedText failed;
  if (!command.fields.empty() && !command.common.batch.empty()) {
    write_output(record_header(command.fields));
    failed = [&](const std::string& input, const std::exception& error) {
      return failed_record(command.fields, input, error);
    };
  }
  return answer_inputs(
      command.common,
      [&](const std::string& input) {
        return command.components ? solve_components(command, input)
                                  : solve_subject(command, load_subject_with(command, input));
      },
      failed);
}

void add_solve(CLI::App* verb, Command& chosen) {
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
  verb->add_option("--cone-order", command->cone_orders,
                   "make an edge class singular of order N = 2, 3, ... or a fraction\n"
                   "such as 5/2 (cone angle 2pi/N), or parabolic (N = 0): 0=2,1=3;\n"
                   "may be repeated; `tripus info` numbers the edge classes from 0")
      ->option_text("EDGE=N")
      ->allow_extra_args(false);
  verb->add_option("--cone-angle", command->cone_angles,
                   "cone angle around an edge class instead of 2pi, such as 0=2pi/3;\n"
                   "may be repeated")
      ->option_text("EDGE=ANGLE")
      ->allow_extra_args(false);
  auto* history = verb->add_option("--history", command->history,
                                   "write a CSV file with a row for each iteration: iteration,\n"
                                   "evaluations, seconds, max|K|, energy H, volume, shortest and\n"
                                   "longest edge")
                      ->option_text("FILE");
  history->excludes(verb->get_option("--batch"));
  add_metric_search(*verb, command->search);
  verb->add_option("-o,--output", command->output,
                   "write the triangulation that carries the metric: .json (gluing table),\n"
                   ".sig (signature), .rga (Regina) or .tri (SnapPea)")
      ->option_text("FILE")
      ->check(problem_of_name)
      ->excludes(verb->get_option("--batch"));
  verb->add_flag("--angle-structure", solve.angle_structure,
                 "also print an exact rational strict angle structure, if there is one")
      ->option_text(" ");
  verb->add_flag("--prove", command->prove,
                 "also prove what was found, with every rounding accounted for; see\n"
                 "`tripus prove --help`")
      ->option_text(" ")
      ->excludes(verb->get_option("--cone-angle"));
  auto* format = verb->add_option("--format", command->format,
                                  "tsv: a short record of each INPUT, one a line, separated by\n"
                                  "tabs, under a line of names; for long lists")
                     ->option_text("FORMAT")
                     ->check(CLI::IsMember({"tsv"}).description(""))
                     ->excludes(verb->get_option("--json")->option_text(" "))
                     ->excludes(verb->get_option("--prove"))
                     ->excludes(verb->get_option("--angle-structure"));
  verb->add_option("--fields", command->fields_list,
                   "what is in the record (default: input,outcome,volume); see below")
      ->option_text("NAME,...")
      ->needs(format);
  auto* components = verb->add_flag("--components", command->components,
                                    "solve each connected component by itself")
                         ->option_text(" ");
  components->excludes(history);
  components->excludes(format);
  components->excludes(verb->get_option("--output"));
  verb->footer(std::string(kInputHelp) + "\nFields of a record:\n" + fields_help() + kOutcomeHelp +
               "\n" + kExitStatusHelp);
  verb->final_callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> solve() {
  static constexpr Verb kRows[] = {
      {"solve", "find the metric: volume, boundary area, edge lengths, dihedral angles", add_solve,
       2}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
