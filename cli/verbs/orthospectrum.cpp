// tripus orthospectrum: the arcs that meet the boundary at right angles at both ends.
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "base/output_file.hpp"
#include "canonical/canonize.hpp"
#include "cli/answer.hpp"
#include "cli/arguments.hpp"
#include "cli/canonize_options.hpp"
#include "cli/describe.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/remedies.hpp"
#include "cli/texts.hpp"
#include "cli/verb.hpp"
#include "manifold/report_json.hpp"
#include "orthospectrum/export/spots_svg.hpp"
#include "structure/solve.hpp"

namespace tripus::cli {
namespace {

constexpr std::size_t kDefaultCount = 100;

struct OrthospectrumCommand {
  CommonOptions common;
  orthospectrum::SpectrumOptions spectrum;
  canonical::CanonizeOptions canonize;
  bool words = false, summary = false, canonical = false, force = false, prove = false;
  std::string table, picture, plot;
};

orthospectrum::SpectrumOptions options_for(const OrthospectrumCommand& command) {
  orthospectrum::SpectrumOptions options = command.spectrum;
  if (options.length == 0 && options.count == 0) options.count = kDefaultCount;
  options.keep_arcs = !command.summary;
  options.keep_faces =
      !command.summary && (command.words || command.prove || !command.table.empty());
  if (command.force) options.most_arcs = std::numeric_limits<double>::infinity();
  return options;
}

Context context_for(const OrthospectrumCommand& command, Progress& progress) {
  Context context = interruptible();
  context.threads = command.common.batch.empty() ? command.common.threads : 1;
  context.progress = [&progress](std::string_view activity, std::size_t) {
    if (progress.due()) progress.show(std::string(activity));
  };
  return context;
}

/// In the words of the command line.
orthospectrum::Spectrum spectrum_of(const OrthospectrumCommand& command, const Subject& subject,
                                    const structure::Report& report) {
  Progress progress(!command.common.quiet && command.common.batch.empty());
  try {
    return orthospectrum::orthospectrum(subject.triangulation, report.edge_lengths,
                                        options_for(command), context_for(command, progress));
  } catch (const orthospectrum::TooManyArcs& error) {
    throw InvalidInput(
        fmt::format("{}: {}; ask for fewer, or for all of them with --force (--summary keeps sums "
                    "alone, in little memory)",
                    printable(subject.input), error.what()));
  }
}

std::optional<std::vector<double>> canonical_edges_of(const OrthospectrumCommand& command,
                                                      const Subject& subject) {
  canonical::CanonizeOptions options = command.canonize;
  limit_work(options);
  const canonical::CanonizeAnswer answer = canonical::canonize(subject.triangulation, options);
  if (!answer.manifold) return std::nullopt;
  return canonical::cell_edge_lengths(*answer.manifold);
}

void write_text(std::optional<OutputFile>& file, const std::string& text) {
  if (!file) return;
  file->open() << text;
  file->close();
}

Reply spectrum_one(const OrthospectrumCommand& command, const std::string& input) {
  std::optional<OutputFile> table, picture, plot;
  if (!command.table.empty()) table.emplace(command.table);
  if (!command.picture.empty()) picture.emplace(command.picture);
  if (!command.plot.empty()) plot.emplace(command.plot);
  const Subject subject =
      load_solvable_subject(input, interruptible(), require_boundary_beside_cusps_with_remedy);
  structure::SolveOptions solve;
  solve.stop = &stop_flag();
  solve.time_limit = seconds_left();
  const structure::Report report = structure::solve(subject.triangulation, solve);
  if (report.outcome != structure::Outcome::kGeometric) {
    return {command.common.json
                ? report_as_json(subject, report)
                : report_as_text(subject, report) + "  without a metric there are no arcs\n",
            kNoAnswer};
  }
  SpectrumAnswer answer{subject, spectrum_of(command, subject, report), {}, {}, {}, command.words};
  double area = 0;
  for (const structure::VertexReport& vertex : report.vertices)
    if (vertex.kind == topology::VertexKind::kHyperideal) area += vertex.area;
  answer.identities = orthospectrum::identities_of(answer.spectrum.sums, answer.spectrum.length,
                                                   area, report.volume);
  answer.grouping = orthospectrum::group_arcs(answer.spectrum, subject.triangulation);
  if (command.prove)
    answer.proved = orthospectrum::prove_lengths(subject.triangulation, report.edge_lengths,
                                                 answer.spectrum, interruptible());
  if (command.canonical) answer.canonical_edges = canonical_edges_of(command, subject);
  if (table) {
    write_arc_table(table->open(), answer);
    table->close();
  }
  if (picture)
    write_text(picture, orthospectrum::spots_as_svg(
                            subject.triangulation, report.edge_lengths, answer.spectrum,
                            fmt::format("orthospectrum of {}, arcs up to length {:.6g}",
                                        printable(input), answer.spectrum.length)));
  if (plot)
    write_text(plot,
               orthospectrum::counting_as_svg(
                   answer.spectrum, answer.identities,
                   fmt::format("counting function of the orthospectrum of {}", printable(input))));
  const bool is_complete = answer.spectrum.end == orthospectrum::SpectrumEnd::kComplete;
  const int status =
      is_complete && (!answer.proved || answer.proved->proved) ? kSuccess : kNoAnswer;
  return {command.common.json ? spectrum_as_json(answer) : spectrum_as_text(answer), status};
}

void add_bounds(CLI::App& verb, OrthospectrumCommand& command) {
  auto* length = verb.add_option("--length", command.spectrum.length,
                                 fmt::format("all arcs up to the length L (at most {})",
                                             orthospectrum::kLongestArc))
                     ->option_text("L")
                     ->check(positive_number());
  verb.add_option("--count", command.spectrum.count,
                  fmt::format("the N shortest arcs, and those as long as the last of them\n"
                              "(default: {})",
                              kDefaultCount))
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()))
      ->check(positive_number())
      ->excludes(length);
  verb.add_flag("--force", command.force, "also where there would be more than 10^9 arcs");
}

void add_outputs(CLI::App& verb, OrthospectrumCommand& command) {
  auto* summary = verb.add_flag("--summary", command.summary,
                                "counts, sums and estimates only, in memory that does not grow")
                      ->option_text(" ");
  verb.add_flag("--words", command.words,
                "each arc by itself: its feet, and the faces that it crosses")
      ->option_text(" ")
      ->excludes(summary);
  verb.add_flag("--prove", command.prove,
                "prove the metric and the length of each arc, every rounding\n"
                "accounted for, but not that there are no others")
      ->option_text(" ")
      ->excludes(summary);
  auto* canonical =
      verb.add_flag("--canonical", command.canonical,
                    "say how many edges of the canonical decomposition have each length");
  add_canonize_options(verb, command.canonize);
  verb.get_option("--budget")->needs(canonical);
  CLI::Option* batch = verb.get_option("--batch");
  verb.add_option("--tsv", command.table, "write a table with a line for each arc")
      ->option_text("FILE")
      ->check(CLI::Validator([](std::string& name) { return problem_of_name(name); }, ""))
      ->excludes(batch)
      ->excludes(summary);
  verb.add_option("--picture", command.picture,
                  "draw the boundary, covered by the discs of the arcs")
      ->option_text("FILE.svg")
      ->check(file_name({".svg"}))
      ->excludes(batch)
      ->excludes(summary);
  verb.add_option("--plot", command.plot, "draw the number of arcs by length")
      ->option_text("FILE.svg")
      ->check(file_name({".svg"}))
      ->excludes(batch);
}

void add_orthospectrum(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<OrthospectrumCommand>();
  add_common_options(*verb, command->common);
  verb->get_option("--threads")->description("threads (default: all cores)");
  add_bounds(*verb, *command);
  add_outputs(*verb, *command);
  verb->footer(
      std::string("Arcs are unoriented. The sums of Basmajian (area of the boundary) and of\n"
                  "Bridgeman and Kahn (volume) are checked against what the metric says; see\n"
                  "docs/orthospectrum.md. A word such as 0.3 21 1.0 begins at the truncation of\n"
                  "vertex 3 of tetrahedron 0, crosses face 2 of it and face 1 of the next, and\n"
                  "ends at vertex 0 of tetrahedron 1.\n\n") +
      kInputHelp + "\n" + kExitStatusHelp);
  verb->final_callback([command, &chosen] {
    chosen = [command] {
      for (const auto& [option, path] :
           {std::pair("--tsv", command->table), std::pair("--picture", command->picture),
            std::pair("--plot", command->plot)})
        if (!path.empty()) declare_output(option, path);
      return answer_inputs(command->common,
                           [&](const std::string& input) { return spectrum_one(*command, input); });
    };
  });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> orthospectrum() {
  static constexpr Verb kRows[] = {
      {"orthospectrum", "geodesic arcs orthogonal to the boundary at both ends, by length",
       add_orthospectrum, 16}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
