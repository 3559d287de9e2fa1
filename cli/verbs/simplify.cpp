// tripus simplify: a small triangulation of the same manifold.
#include "topology/simplify/simplify.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "base/output_file.hpp"
#include "cli/answer.hpp"
#include "cli/arguments.hpp"
#include "cli/describe.hpp"
#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/verb.hpp"
#include "manifold/load.hpp"
#include "topology/cone.hpp"
#include "topology/drill.hpp"
#include "topology/orientation.hpp"

namespace tripus::cli {
namespace {

constexpr const char* kSimplifyHelp =
    "Open faces are coned off first: every boundary component becomes an ideal vertex, or is "
    "filled\n"
    "in if it is a sphere. Then edges are collapsed until only vertices are left whose links are "
    "no\n"
    "spheres (one vertex, if there are none), moves that make it smaller are made while there are\n"
    "any, and a random search looks for more. Ctrl-C ends the search with the best so far.\n"
    "\n"
    "--drill takes neighbourhoods of edges away first: an edge joins the boundary components at "
    "its\n"
    "ends by a tube. It undoes a 2-handle, such as `Cone[1,1]` fills in along a meridian of arc "
    "1.\n"
    "Edge classes are numbered as in `info`, from 0. \"singular\": all edges with a cone order.\n"
    "\n"
    "Exit status: 0 an answer (for --batch: the run finished), 1 interrupted (the answer is what\n"
    "there was), 2 bad usage or bad input, 3 a failure of the program itself.";

struct SimplifyCommand {
  CommonOptions common;
  topology::SimplifyOptions options;
  std::string output;
  std::vector<std::string> drill;
};

/// T after every stage, by name.
using Stages = std::vector<std::pair<std::string_view, std::size_t>>;

std::string message_of(const topology::Simplified& result, const Subject& subject) {
  std::string text = one_line(subject.triangulation);
  if (result.stopped)
    text += "; " + stop_text() + ", so this may not be the smallest that can be found";
  if (result.finite_vertices_left > 0)
    text += fmt::format("; {} left that should have gone: try another --seed or more --effort",
                        counted(result.finite_vertices_left, "finite vertex", "finite vertices"));
  return text + ".";
}

std::string as_json(const topology::Simplified& result, const Stages& stages,
                    const Subject& subject) {
  JsonText out;
  append_header(out, subject.input);
  append_subject(out, subject);
  append_oriented(out, subject);
  append(out, ", \"stages\": {");
  for (const auto& [name, count] : stages)
    fmt::format_to(std::back_inserter(out), "{}\"{}\": {}",
                   name == stages.front().first ? "" : ", ", name, count);
  fmt::format_to(std::back_inserter(out), "}}, \"finite_vertices_left\": {}, \"interrupted\": {}",
                 result.finite_vertices_left, result.stopped);
  append(out, ", \"message\": ");
  append_string(out, message_of(result, subject));
  out.push_back('}');
  return fmt::to_string(out);
}

std::string as_text(const topology::Simplified& result, const Stages& stages,
                    const Subject& subject) {
  std::string text = fmt::format("{}: {}\n", printable(subject.input), message_of(result, subject));
  for (const auto& [name, count] : stages)
    text += fmt::format("  {:<14}{}\n", name, counted(count, "tetrahedron", "tetrahedra"));
  text += fmt::format("  {:<14}{}\n", "signature", signature_text(subject.isosig));
  if (subject.oriented_isosig)
    text += fmt::format("  {:<14}{}\n", "oriented", signature_text(subject.oriented_isosig));
  return text;
}

/// The edges that are named, each by one of its places.
std::vector<topology::EdgePlace> edges_to_drill(const topology::NamedGluings& loaded,
                                                const std::vector<std::string>& names) {
  const topology::Triangulation triangulation(loaded.gluings);
  std::vector<bool> chosen(triangulation.edge_count(), false);
  for (const std::string& name : names) {
    if (name == "singular") {
      if (topology::all_full(loaded.cone_angles))
        throw InvalidInput("--drill singular: no edge has a cone order");
      for (std::size_t e = 0; e < chosen.size(); ++e)
        if (!loaded.cone_angles[e].is_full()) chosen[e] = true;
      continue;
    }
    const auto number = parse_number(name);
    if (!number || *number < 0 || *number >= double(chosen.size()) ||
        *number != std::floor(*number))
      throw InvalidInput(fmt::format("--drill {}: expected an edge class from 0 to {}, or singular",
                                     tripus::quoted(name), chosen.size() - 1));
    chosen[std::size_t(*number)] = true;
  }
  std::vector<std::size_t> classes;
  for (std::size_t e = 0; e < chosen.size(); ++e)
    if (chosen[e]) classes.push_back(e);
  return topology::places_to_drill(triangulation, classes, loaded.cone_angles);
}

/// The input, closed up, with what is to be drilled taken away.
topology::NamedGluings load_and_drill(const SimplifyCommand& command, const std::string& input,
                                      Stages& stages) {
  if (command.drill.empty()) {
    topology::NamedGluings loaded = load_unconed_input(input, interruptible());
    stages.emplace_back("given", loaded.gluings.tetrahedron_count());
    return loaded;
  }
  topology::NamedGluings loaded = load_labelled_input(input, Balls::kAllowed, interruptible());
  stages.emplace_back("given", loaded.gluings.tetrahedron_count());
  loaded.gluings = topology::cone_boundary(loaded.gluings);  // keeps the numbers of edges
  loaded.gluings = topology::drilled(loaded.gluings, edges_to_drill(loaded, command.drill));
  loaded.cone_angles.clear();
  stages.emplace_back("drilled", loaded.gluings.tetrahedron_count());
  return loaded;
}

Reply simplify_one(const SimplifyCommand& command, const std::string& input) {
  Stages stages;
  topology::NamedGluings loaded = load_and_drill(command, input, stages);
  const topology::Gluings coned = topology::oriented(topology::cone_boundary(loaded.gluings));
  if (coned.tetrahedron_count() != loaded.gluings.tetrahedron_count())
    stages.emplace_back("coned", coned.tetrahedron_count());
  loaded.gluings = {};

  Progress progress(!command.common.quiet && command.common.batch.empty());
  topology::SimplifyOptions options = command.options;
  options.stop = &stop_flag();
  options.progress = [&](std::string_view stage, std::size_t tetrahedra) {
    if (progress.due()) progress.show(fmt::format("{}: {} tetrahedra", stage, tetrahedra));
  };
  topology::Simplified result = topology::simplify(coned, options);
  stages.emplace_back("collapsed", result.collapsed);
  stages.emplace_back("reduced", result.reduced);
  stages.emplace_back("simplified", result.tetrahedron_count());

  loaded.gluings = std::move(result.gluings);
  const Subject subject = make_subject(input, std::move(loaded));
  if (!command.output.empty()) write_triangulation_file(command.output, subject);
  return {command.common.json ? as_json(result, stages, subject) : as_text(result, stages, subject),
          result.stopped ? kNoAnswer : kSuccess};
}

/// A factor of the search: 0 turns it off.
CLI::Validator effort_number() {
  return {[](std::string& text) {
            const auto number = parse_number(text);
            return number && *number >= 0 && *number <= 1e6
                       ? std::string()
                       : fmt::format("{} is not a number from 0 to 1e6", tripus::quoted(text));
          },
          ""};
}

void add_simplify(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<SimplifyCommand>();
  add_common_options(*verb, command->common);
  verb->add_option("--seed", command->options.seed,
                   "of the search; the same answer for the same seed (default: 0)")
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()));
  verb->add_option("--effort", command->options.effort,
                   "how long to search, a factor; 0: not at all (default: 1)")
      ->option_text("X")
      ->check(effort_number());
  verb->add_option("--drill", command->drill,
                   "edge classes to drill out first, or singular: all "
                   "with a cone order")
      ->option_text("N,N,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("-o,--output", command->output,
                   "write the triangulation: .json (gluing table), .sig (signature),\n"
                   ".rga (Regina) or .tri (SnapPea)")
      ->option_text("FILE")
      ->check(problem_of_name)
      ->excludes(verb->get_option("--batch"));
  verb->footer(std::string(kInputHelp) + "\n" + kSimplifyHelp);
  verb->final_callback([command, &chosen] {
    chosen = [command] {
      if (!command->output.empty()) {
        require_triangulation_name(command->output);
        declare_output("-o", command->output);
      }
      return answer_inputs(command->common,
                           [&](const std::string& input) { return simplify_one(*command, input); });
    };
  });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> simplify() {
  static constexpr Verb kRows[] = {
      {"simplify", "a small triangulation of the same manifold", add_simplify, 3}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
