// tripus census: makes tables of manifolds, and looks things up in them.
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <unordered_set>

#include <fmt/format.h>

#include "base/checksum.hpp"
#include "base/journal.hpp"
#include "base/output_file.hpp"
#include "base/version.hpp"
#include "canonical/census.hpp"
#include "canonical/census_proofs.hpp"
#include "cli/answer.hpp"
#include "cli/arguments.hpp"
#include "cli/canonize_options.hpp"
#include "cli/census_file.hpp"
#include "cli/census_shard_command.hpp"
#include "cli/commands.hpp"
#include "cli/describe.hpp"
#include "cli/exit_status.hpp"
#include "cli/interrupt.hpp"
#include "cli/manifold_text.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/output_names.hpp"
#include "cli/progress.hpp"
#include "manifold/load.hpp"
#include "topology/formats/formats.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"

namespace tripus::cli {
namespace {

using canonical::Census;
using canonical::CensusLine;

struct CensusCommand {
  std::vector<std::string> names;  ///< manifolds to look up
  std::vector<std::string> lists;
  std::string journal, tsv, database, in;
  canonical::ClassifyOptions classify;
  canonical::CensusQuery query;
  std::string volume;
  bool has_boundary = false, has_homology = false, has_cells = false;  ///< also if empty
  std::string proofs;                                                  ///< file to read or write
  std::vector<std::string> shards;                                     ///< files to merge
  std::string shard, output;  ///< of one shard; of a merged census
  bool json = false, quiet = false, check = false, prove = false;
};

/// What a census depends on besides its list, which is told apart by its checksum.
std::string work_of(const CensusCommand& command, const std::vector<std::string>& list) {
  std::uint64_t digest = checksum("");
  for (const std::string& text : list) digest = checksum(text + '\n', digest);
  return fmt::format("# tripus census: version {}, budget {}, {} triangulations, list {:016x}",
                     kVersion, command.classify.canonize.retriangulation.budget, list.size(),
                     digest);
}

/// The lines of an earlier run.
std::vector<CensusLine> lines_of(const Journal& journal) {
  std::vector<CensusLine> lines;
  for (std::size_t k = 0; k < journal.lines().size(); ++k) {
    auto line = canonical::parse_journal_line(journal.lines()[k]);
    if (!line) throw InvalidInput(journal.place(k) + " is not one of a census");
    lines.push_back(std::move(*line));
  }
  return lines;
}

/// What the lists name.
struct Inputs {
  std::vector<std::string> triangulations;  ///< by isomorphism signature
  std::size_t refused = 0;
};

/// Every line is an INPUT, as for the other batches. What cannot be read is named, and the rest
/// goes on.
Inputs read_lists(const std::vector<std::string>& paths) {
  Inputs inputs;
  for (const std::string& path : paths) {
    require_not_written(path);
    for (const auto& line : read_batch_file(path)) {
      try {
        if (line.text == "-") throw InvalidInput(kNoStandardInput);
        require_not_written(line.text);
        const topology::NamedGluings loaded = load_manifold_input(line.text);
        inputs.triangulations.push_back(topology::isosig(loaded.gluings));
      } catch (const InvalidInput& error) {
        ++inputs.refused;
        write_message(fmt::format("tripus: {}: line {}: {}\n", printable(path), line.line_number,
                                  error.what()));
      }
    }
  }
  return inputs;
}

void write_text(const std::string& path, const std::string& text) {
  if (path == "-") {
    write_output(text);
    return;
  }
  write_file(path, text);
}

void write_census(const CensusCommand& command, const Census& census) {
  if (!command.database.empty()) canonical::write_database(census, command.database);
  if (!command.tsv.empty()) write_text(command.tsv, canonical::to_tsv(census));
}

/// The journal's name if none was given: beside the result.
std::string journal_of(const CensusCommand& command) {
  if (!command.journal.empty()) return command.journal;
  if (!command.database.empty()) return command.database + ".journal";
  if (!command.tsv.empty() && command.tsv != "-") return command.tsv + ".journal";
  return {};
}

/// Before the work, not after it.
void declare_outputs(const CensusCommand& command) {
  if (!command.tsv.empty() && command.tsv != "-") declare_output("--tsv", command.tsv);
  if (!command.database.empty()) declare_output("--database", command.database);
  if (!command.shard.empty()) {
    declare_output("-o", command.output);
    return;
  }
  if (!command.lists.empty() && !journal_of(command).empty())
    declare_output("--journal", journal_of(command));
  if (command.prove && !command.proofs.empty()) declare_output("--proofs", command.proofs);
  if (!command.in.empty()) require_not_written(command.in);
}

int write_proofs(const CensusCommand& command, const Census& census) {
  const Context context = interruptible();
  const auto proofs = canonical::prove_census(census, context);
  if (context.stop_requested()) {
    write_message(fmt::format("tripus: {} after {} proofs; no proofs were written\n", stop_text(),
                              proofs.size()));
    return kNoAnswer;
  }
  write_text(command.proofs.empty() ? "-" : command.proofs, canonical::to_tsv(proofs));
  return kSuccess;
}

/// Writes the census of these lines, and says what it is.
int finish(const CensusCommand& command, const std::vector<CensusLine>& lines,
           std::size_t refused_before, std::size_t resumed) {
  std::size_t own = 0, moved = 0, refused = refused_before;
  for (const CensusLine& line : lines) {
    own += line.resolved && line.own_metric;
    moved += line.resolved && !line.own_metric;
    refused += !line.reason.empty();
  }
  const Census census = canonical::make_census(lines);
  const std::size_t total = lines.size() + refused_before;
  if (census.manifolds.empty() && census.unresolved.empty())
    throw InvalidInput(fmt::format("all of the {} were refused: no census was made",
                                   counted(total, "triangulation", "triangulations")));
  write_census(command, census);
  if (command.prove && write_proofs(command, census) != kSuccess) return kNoAnswer;
  const std::string summary = fmt::format(
      "{} triangulations: {} manifolds; {} carry their metric, {} after moves, {} unresolved, {} "
      "refused{}\n",
      total, census.manifolds.size(), own, moved, census.unresolved.size(), refused,
      resumed == 0 ? "" : fmt::format(" ({} known from an earlier run)", resumed));
  write_message(command.quiet ? "" : summary);
  if (command.tsv.empty() && command.database.empty()) write_text("-", canonical::to_tsv(census));
  return kSuccess;
}

int make(CensusCommand& command) {
  const std::string path = journal_of(command);
  const auto rest = [&](std::size_t done, std::size_t of) {
    return fmt::format(" after {} of {} triangulations{}", done, of,
                       path.empty() ? "" : "; the same command goes on from there");
  };
  const Inputs inputs = read_lists(command.lists);
  const std::vector<std::string>& list = inputs.triangulations;
  if (list.empty()) {
    throw InvalidInput(inputs.refused == 0
                           ? "the list is empty: there is nothing to make a census of"
                           : fmt::format("none of its {} could be read: no census was made",
                                         inputs.refused == 1
                                             ? "lines"
                                             : std::to_string(inputs.refused) + " lines"));
  }
  std::optional<Journal> journal;
  if (!path.empty()) journal.emplace(path, work_of(command, list));
  std::vector<CensusLine> lines;
  std::unordered_set<std::string> listed(list.begin(), list.end()), done;
  if (journal) {
    for (CensusLine& line : lines_of(*journal))
      if (listed.contains(line.triangulation) && done.insert(line.triangulation).second)
        lines.push_back(std::move(line));
  }
  std::vector<std::string> todo;
  for (const std::string& text : list)
    if (done.insert(text).second) todo.push_back(text);
  const std::size_t total = lines.size() + todo.size(), resumed = lines.size();
  Progress progress(!command.quiet);
  std::size_t count = resumed;
  set_last_words(rest(count, total));
  command.classify.stop_requested = &interrupt_requested();
  command.classify.canonize.solve.stop_requested = &interrupt_requested();
  command.classify.on_line = [&](const CensusLine& line) {
    if (journal) journal->add(canonical::to_journal(line));
    ++count;
    set_last_words(rest(count, total));
    if (progress.due()) progress.show(fmt::format("{} of {} triangulations", count, total));
  };
  for (CensusLine& line : canonical::classify(todo, command.classify))
    lines.push_back(std::move(line));
  if (lines.size() < total) {
    write_message("tripus: " + stop_text() + rest(lines.size(), total) + "\n");
    return kNoAnswer;
  }
  for (const CensusLine& line : lines)
    if (!line.reason.empty())
      write_message(fmt::format("tripus: {}: {}\n", printable(line.triangulation), line.reason));
  if (const int status = finish(command, lines, inputs.refused, resumed); status != kSuccess)
    return status;
  if (journal && command.journal.empty()) journal->remove();
  return kSuccess;
}

/// A census from the shards that others have made.
int merge(const CensusCommand& command) {
  return finish(command, merged_lines(command.shards), 0, 0);
}

/// "6.4:7" or "6.4:" or ":7".
void parse_volumes(const std::string& text, canonical::CensusQuery& query) {
  const std::size_t colon = text.find(':');
  const auto bound = [&](std::string_view part, double& value) {
    if (part.empty()) return;
    const auto number = parse_number(part);
    if (!number || std::isnan(*number))
      throw InvalidInput("--volume " + tripus::quoted(text) + ": write FROM:TO, such as 6.4:7");
    value = *number;
  };
  if (colon == std::string::npos)
    throw InvalidInput("--volume " + tripus::quoted(text) + ": write FROM:TO, such as 6.4:7");
  bound(std::string_view(text).substr(0, colon), query.least_volume);
  bound(std::string_view(text).substr(colon + 1), query.greatest_volume);
  if (!(query.least_volume <= query.greatest_volume) || std::isinf(query.least_volume))
    throw InvalidInput("--volume " + tripus::quoted(text) +
                       ": no volume is in this range; write FROM:TO with FROM no larger than TO");
}

/// What was found as a census of its own; with what is unresolved if nothing was left out.
Census chosen_part(const Census& census, const std::vector<const canonical::CensusEntry*>& found) {
  Census part;
  for (const canonical::CensusEntry* entry : found) part.manifolds.push_back(*entry);
  if (found.size() == census.manifolds.size()) part.unresolved = census.unresolved;
  return part;
}

/// The manifolds with these names, signatures or triangulations.
/// Throws InvalidInput for one that is not there.
std::vector<const canonical::CensusEntry*> find_names(const CensusCommand& command,
                                                      const Census& census) {
  std::vector<const canonical::CensusEntry*> found;
  for (const std::string& name : command.names) {
    const canonical::CensusEntry* entry = census.find(name);
    if (entry == nullptr && !canonical::is_census_name(name))
      entry = census.find(topology::isosig(load_manifold_input(name).gluings));
    if (entry == nullptr) {
      throw InvalidInput(
          fmt::format("{} is not in the census; tripus identify looks for the manifold "
                      "and not the triangulation",
                      tripus::quoted(name)));
    }
    found.push_back(entry);
  }
  return found;
}

/// What --boundary and the like ask for, each refused by its name if it is nothing.
std::vector<const canonical::CensusEntry*> select(CensusCommand& command, const Census& census) {
  if (!command.volume.empty()) parse_volumes(command.volume, command.query);
  const auto named = [](const char* option, auto&& part) {
    try {
      part();
    } catch (const InvalidInput& error) {
      throw InvalidInput(fmt::format("{}: {}", option, error.what()));
    }
  };
  const canonical::CensusQuery& query = command.query;
  if (command.has_boundary) named("--boundary", [&] { canonical::parse_boundary(query.boundary); });
  if (command.has_homology)
    named("--homology", [&] { topology::parse_abelian_group(query.homology); });
  if (command.has_cells) named("--cells", [&] { canonical::require_cells(query.cells); });
  return canonical::select(census, query);
}

int look_up(CensusCommand& command) {
  const ChosenCensus chosen(command.in);
  const Census& census = chosen.get();
  const auto found = command.names.empty() ? select(command, census) : find_names(command, census);
  if (found.empty()) {
    write_message(fmt::format("tripus: nothing found: {}\n", canonical::describe(census)));
    return kNoAnswer;
  }
  if (!command.database.empty() || !command.tsv.empty()) {
    write_census(command, chosen_part(census, found));
    return kSuccess;
  }
  for (const canonical::CensusEntry* entry : found) {
    if (!command.json) {
      write_output(entry_as_text(*entry));
      continue;
    }
    JsonText out;
    append_entry(out, *entry);
    out.push_back('\n');
    write_output({out.data(), out.size()});
  }
  return kSuccess;
}

/// Every proof again, by other code than made it.
int check_proofs(const CensusCommand& command) {
  const ChosenCensus chosen(command.in);
  const Census& census = chosen.get();
  std::optional<std::vector<canonical::CensusProof>> proofs;
  if (!command.proofs.empty()) proofs = canonical::parse_census_proofs(read_file(command.proofs));
  Context context = interruptible();
  context.threads = command.classify.threads;
  const canonical::CensusCheck check = canonical::check_census(
      census, proofs ? *proofs : canonical::shipped_census_proofs(), context);
  if (check.stopped) write_message("tripus: " + stop_text() + " before all proofs were checked\n");
  for (const std::string& failure : check.failures) write_output(printable(failure) + "\n");
  write_output(
      fmt::format("{} of {} manifolds have a valid proof\n", check.valid, census.manifolds.size()));
  return check.failures.empty() && !check.stopped ? kSuccess : kNoAnswer;
}

void add_query_options(CLI::App& verb, CensusCommand& command) {
  CLI::Option* names =
      verb.add_option("NAME", command.names,
                      "manifolds to look up: a name (t3g2.13), a signature, a triangulation")
          ->option_text(" ")
          ->transform(unshield());
  verb.add_option("--in", command.in,
                  "census to look in, TSV, .tsv.gz or SQLite (default: the shipped one)")
      ->option_text("FILE");
  verb.add_option("--volume", command.volume, "only volumes in this range")->option_text("FROM:TO");
  verb.add_option("--boundary", command.query.boundary, "only this boundary, such as g2 or g2+g3")
      ->option_text("GENERA");
  verb.add_option("--homology", command.query.homology, "only this H1, such as 2Z+Z_3")
      ->option_text("GROUP");
  verb.add_option("--cells", command.query.cells, "only these cells, such as \"1 octahedron\"")
      ->option_text("CELLS");
  verb.add_option("--tetrahedra", command.query.tetrahedra, "only manifolds of N tetrahedra")
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()));
  for (const char* query : {"--volume", "--boundary", "--homology", "--cells", "--tetrahedra"})
    verb.get_option(query)->excludes(names);
  verb.add_flag("--json", command.json, "one JSON object for each manifold, one a line");
}

void add_making_options(CLI::App& verb, CensusCommand& command) {
  verb.add_option("--from", command.lists,
                  "make a census: classify the triangulations of this list, one INPUT\n"
                  "a line; may be repeated")
      ->option_text("LIST")
      ->allow_extra_args(false);
  verb.add_option("--tsv", command.tsv, "write it, or what was found, as a table with tabs")
      ->option_text("FILE");
  verb.add_option("--database", command.database,
                  "write it, or what was found, as a SQLite database")
      ->option_text("FILE");
  verb.add_option("--journal", command.journal,
                  "keep what is done here, so that an interrupted run can go on\n"
                  "(default: beside the result, removed in the end)")
      ->option_text("FILE");
  verb.add_option("--threads", command.classify.threads, "threads (default: all cores)")
      ->option_text("N")
      ->check(whole_number(1024));
  verb.add_flag("--quiet", command.quiet, "no progress and no summary on standard error");
  verb.add_option("--shard", command.shard,
                  "of --from the I-th of M parts only, written to -o; the same\n"
                  "command again goes on where it was, or finds it done")
      ->option_text("I/M");
  verb.add_option("--merge", command.shards, "make a census of shards: all of them, in any order")
      ->option_text("SHARD ...");
  verb.add_option("-o,--output", command.output,
                  "with --shard: the shard. With --merge: the census as a SQLite database")
      ->option_text("FILE")
      ->check(problem_of_name);
  add_canonize_options(verb, command.classify.canonize);
  CLI::Option* from = verb.get_option("--from");
  verb.get_option("--journal")->needs(from);
  CLI::Option* shard = verb.get_option("--shard")->needs(from);
  CLI::Option* merge = verb.get_option("--merge")->excludes(from);
  for (const char* result : {"--tsv", "--database", "--journal"})
    verb.get_option(result)->excludes(shard);
  for (const char* query :
       {"NAME", "--in", "--volume", "--boundary", "--homology", "--cells", "--tetrahedra"})
    verb.get_option(query)->excludes(from)->excludes(merge);
}

constexpr const char* kCensusHelp =
    "Without --from it looks in a census. Manifolds of the shipped census keep their names in any\n"
    "other; what is not in it is called by its signature. All names are INPUTs.\n"
    "\n"
    "Exit status: 0 found, or made; 1 nothing was found, or interrupted; 2 bad usage or bad "
    "input,\n"
    "3 a failure of the program itself.";

}  // namespace

void add_census(CLI::App& program, Command& chosen) {
  CLI::App* verb =
      program.add_subcommand("census", "tables of manifolds: make one, or look in one");
  auto command = std::make_shared<CensusCommand>();
  command->classify.canonize.retriangulation.budget = canonical::kCensusBudget;
  add_query_options(*verb, *command);
  auto* check = verb->add_flag("--check", command->check,
                               "check the proof of every manifold by other code than made it")
                    ->option_text(" ");
  auto* prove = verb->add_flag("--prove", command->prove,
                               "prove the metrics of all manifolds (with --from: of the "
                               "new\ncensus), and write the proofs")
                    ->option_text(" ");
  check->excludes(prove);
  verb->add_option("--proofs", command->proofs,
                   "file of proofs that --check reads (default: the shipped one) or\n--prove "
                   "writes (default: standard output)")
      ->option_text("FILE");
  add_making_options(*verb, *command);
  check->excludes(verb->get_option("--from"));
  verb->footer(kCensusHelp);
  verb->final_callback([command, verb, &chosen] {
    command->has_boundary = verb->get_option("--boundary")->count() > 0;
    command->has_homology = verb->get_option("--homology")->count() > 0;
    command->has_cells = verb->get_option("--cells")->count() > 0;
    if (!command->proofs.empty() && !command->prove && !command->check)
      throw CLI::RequiredError("--prove or --check, with --proofs,");
    if (command->prove && !command->lists.empty() && command->proofs.empty() &&
        (command->tsv.empty() || command->tsv == "-") && command->database.empty())
      throw CLI::RequiredError(
          "--proofs FILE, with --from and --prove where the census itself goes to standard "
          "output,");
    if (!command->shard.empty() && command->output.empty())
      throw CLI::RequiredError("-o FILE, with --shard,");
    if (!command->shard.empty() && command->prove) throw CLI::ExcludesError("--prove", "--shard");
    if (command->shard.empty() && command->shards.empty() && !command->output.empty())
      throw CLI::RequiredError("--shard or --merge, with -o,");
    if (!command->shards.empty() && !command->output.empty()) {
      if (!command->database.empty()) throw CLI::ExcludesError("-o", "--database");
      command->database = command->output;
    }
    chosen = [command] {
      declare_outputs(*command);
      if (!command->shard.empty())
        return make_shard(
            {command->lists, command->shard, command->output, command->classify, command->quiet});
      if (!command->shards.empty()) return merge(*command);
      if (command->check) return check_proofs(*command);
      if (!command->lists.empty()) return make(*command);
      if (command->prove) return write_proofs(*command, ChosenCensus(command->in).get());
      return look_up(*command);
    };
  });
}

}  // namespace tripus::cli
