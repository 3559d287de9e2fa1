// tripus study: the studies of docs/studies.md, each as one command.
#include "studies/study.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/threads.hpp"
#include "canonical/census.hpp"
#include "cli/arguments.hpp"
#include "cli/describe.hpp"
#include "cli/failure.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/verb.hpp"
#include "manifold/json_text.hpp"
#include "manifold/load.hpp"
#include "topology/isosig.hpp"

namespace tripus::cli {
namespace {

struct StudyCommandOptions {
  std::string name;
  std::vector<std::string> inputs;
  std::string folder;
  std::size_t census = 0;
  studies::StudyOptions study;
  unsigned threads = 0;
  bool json = false;
  bool quiet = false;
};

/// The triangulations of one INPUT: a file of signatures is taken as a whole.
void load(const std::string& input, std::vector<studies::StudyInput>& out) {
  std::error_code status;
  if (std::filesystem::is_regular_file(input, status)) {
    const auto lines = read_batch_file(input);
    const bool list = lines.size() > 1 && std::ranges::all_of(lines, [](const auto& line) {
                        return topology::looks_like_isosig(line.text);
                      });
    if (list) {
      for (const auto& line : lines) out.push_back({line.text, topology::decode_isosig(line.text)});
      return;
    }
  }
  auto gluings = load_input(input, interruptible());
  out.push_back({gluings.name.empty() ? input : gluings.name, std::move(gluings.gluings)});
}

/// The paper's example, when no INPUT is given.
constexpr const char* kDefaultInput = "cPcbbbihq";

/// Every triangulation with up to `tetrahedra` tetrahedra of a manifold in the census that has
/// compact boundary: studies compare methods that do not all know cusps.
void load_census(std::size_t tetrahedra, std::vector<studies::StudyInput>& out) {
  for (const auto& manifold : canonical::shipped_census().manifolds) {
    if (manifold.boundary.find_first_of("TK") != std::string::npos) continue;
    for (const std::string& signature : manifold.triangulations) {
      topology::Gluings gluings = topology::decode_isosig(signature);
      if (gluings.tetrahedron_count() <= tetrahedra) out.push_back({signature, std::move(gluings)});
    }
  }
}

std::vector<studies::StudyInput> load_inputs(const std::vector<std::string>& inputs,
                                             std::size_t census) {
  std::vector<studies::StudyInput> loaded;
  for (const std::string& input : inputs) load(input, loaded);
  if (inputs.empty()) load(kDefaultInput, loaded);
  load_census(census, loaded);
  std::set<std::string> names;
  std::erase_if(loaded, [&](const auto& input) { return !names.insert(input.name).second; });
  return loaded;
}

std::string result_json(const StudyCommandOptions& command, const studies::RunResult& result) {
  JsonText out;
  append_header(out, command.name);
  append(out, fmt::format(", \"finished\": {}, \"items_done\": {}, \"items\": {}, \"folder\": ",
                          result.finished(), result.done, result.total));
  append_string(out, command.folder);
  append(out, ", \"files\": ");
  append_array(out, result.files,
               [](JsonText& to, const std::string& file) { append_string(to, file); });
  append(out, ", \"findings\": ");
  append_string(out, result.paragraph);
  append(out, "}\n");
  return fmt::to_string(out);
}

std::string result_text(const StudyCommandOptions& command, const studies::RunResult& result) {
  return fmt::format("{}\n\nWritten to {}: {}\n", result.paragraph, printable(command.folder),
                     fmt::join(result.files, ", "));
}

int run(StudyCommandOptions command) {
  const studies::Study& study = studies::find_study(command.name);
  command.study.inputs = load_inputs(command.inputs, command.census);
  if (command.census > 0 && command.study.samples == 0)
    command.study.samples = command.study.inputs.size();
  Progress progress(!command.quiet);
  studies::RunOptions options;
  options.folder = command.folder;
  options.threads = thread_count(command.threads);
  options.stop = &interrupt_requested();
  const auto rest = [](std::size_t done, std::size_t total) {
    return fmt::format(
        ": {}; the same command goes on from there",
        total == 0 ? "before any item was begun" : fmt::format("{} of {} items done", done, total));
  };
  set_last_words(rest(0, 0));
  options.on_progress = [&](std::size_t done, std::size_t total) {
    set_last_words(rest(done, total));
    if (progress.due()) progress.show(fmt::format("{} of {} items", done, total));
  };
  const studies::RunResult result = studies::run_study(study, command.study, options);
  if (command.json) {
    write_output(result_json(command, result));
  } else if (result.finished()) {
    write_output(result_text(command, result));
  }
  flush_output();
  if (result.finished()) return kSuccess;
  write_message("tripus: " + stop_text() + rest(result.done, result.total) + "\n");
  return kNoAnswer;
}

std::string study_list() {
  std::string text = "The studies are\n";
  for (const studies::Study& study : studies::studies())
    text += fmt::format("  {:<16}{}\n                  --samples: {} (default {})\n", study.name,
                        study.description, study.samples, study.default_samples);
  return text +
         "An INPUT is a signature, a file, or a file with a signature a line; without one it is "
         "the\n"
         "paper's example, cPcbbbihq. FOLDER gets one CSV a table, summary.json, the figures and\n"
         "report.html. A run that was interrupted goes on when the same command is given again; "
         "the\n"
         "CSV files are the same for any number of threads, timing columns aside.\n\n";
}

void add_study(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<StudyCommandOptions>();
  verb->add_option("NAME", command->name, "which study")->option_text(" ")->required();
  verb->add_option("INPUT", command->inputs, "what to study")
      ->option_text("...")
      ->transform(unshield());
  verb->add_option("-o,--output", command->folder, "where the results go")
      ->option_text("FOLDER")
      ->required();
  verb->add_option("--seed", command->study.seed, "of everything random (default 1)")
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()));
  verb->add_option("--samples", command->study.samples, "how much, see below")
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()));
  verb->add_option("--census", command->census,
                   "add all triangulations with up to N tetrahedra in the census,\n"
                   "and take all inputs unless --samples says otherwise")
      ->option_text("N")
      ->check(CLI::Range(2, 4));
  verb->add_option("--methods", command->study.methods, "methods to compare, with commas")
      ->option_text("NAME,...")
      ->delimiter(',');
  verb->add_option("--covers", command->study.covers,
                   "convergence: degrees of cyclic covers of the first INPUT")
      ->option_text("N,...")
      ->delimiter(',')
      ->check(whole_number(1000000));
  verb->add_option("--threads", command->threads, "threads (default: one a core)")
      ->option_text("N")
      ->check(whole_number(1024));
  verb->add_flag("--json", command->json, "one JSON object on standard output");
  verb->add_flag("--quiet", command->quiet, "no progress on standard error");
  verb->footer(study_list() +
               "Exit status: 0 finished, 1 interrupted, 2 bad usage or bad input, 3 a failure of "
               "the\nprogram itself.");
  verb->final_callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> study() {
  static constexpr Verb kRows[] = {
      {"study", "a comparison of methods, triangulations or starts, with a report", add_study, 14}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
