// tripus census: makes tables of manifolds, and looks things up in them.
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <unordered_set>

#include <fmt/format.h>

#include "base/output_file.hpp"
#include "canonical/census.hpp"
#include "canonical/census_proofs.hpp"
#include "cli/canonize_options.hpp"
#include "cli/commands.hpp"
#include "cli/describe.hpp"
#include "cli/exit_status.hpp"
#include "cli/interrupt.hpp"
#include "cli/manifold_text.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "manifold/load.hpp"
#include "topology/formats/formats.hpp"

namespace tripus::cli {
namespace {

using canonical::Census;
using canonical::CensusLine;

struct CensusCommand {
  std::vector<std::string> lists;
  std::string journal, tsv, database, in;
  canonical::ClassifyOptions classify;
  canonical::CensusQuery query;
  std::string volume;
  std::string proofs;  ///< file to read or write
  bool json = false, quiet = false, check = false, prove = false;
};

/// The journal of an earlier run and the stream that goes on with it.
class Journal {
 public:
  /// Reads what is there; a torn last line is cut off.
  explicit Journal(const std::string& path) : path_(path) {
    std::error_code error;
    if (std::filesystem::exists(path, error)) read();
    out_.open(path, std::ios::app | std::ios::binary);
    require_written();
  }

  void add(const CensusLine& line) {
    out_ << canonical::to_journal(line) << '\n' << std::flush;
    require_written();
  }
  std::vector<CensusLine>& lines() { return lines_; }

 private:
  void require_written() const {
    if (!out_)
      throw InvalidInput("cannot write the journal " + tripus::quoted(path_) + ": " +
                         std::strerror(errno));
  }
  void read() {
    canonical::JournalText journal;
    const std::string text = read_file(path_);
    try {
      journal = canonical::parse_journal(text);
    } catch (const InvalidInput& error) {
      throw InvalidInput("the journal " + tripus::quoted(path_) + ": " + error.what() +
                         "; name another file, or remove it to begin anew");
    }
    lines_ = std::move(journal.lines);
    if (journal.complete != text.size()) std::filesystem::resize_file(path_, journal.complete);
  }

  std::string path_;
  std::vector<CensusLine> lines_;
  std::ofstream out_;
};

std::vector<std::string> read_lists(const std::vector<std::string>& paths) {
  std::vector<std::string> result;
  for (const std::string& path : paths)
    for (auto& line : topology::read_batch(read_file(path))) result.push_back(std::move(line.text));
  return result;
}

void write_text(const std::string& path, const std::string& text) {
  if (path == "-") {
    write_output(text);
    return;
  }
  write_file(path, text);
}

/// Before the work, not after it.
void require_outputs(const CensusCommand& command) {
  for (const std::string& path : {command.tsv, command.database})
    if (!path.empty() && path != "-") OutputFile can_be_written(path);
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

int make(CensusCommand& command) {
  require_outputs(command);
  const std::vector<std::string> list = read_lists(command.lists);
  const std::string path = journal_of(command);
  std::optional<Journal> journal;
  if (!path.empty()) journal.emplace(path);
  std::vector<CensusLine> lines;
  std::unordered_set<std::string> listed(list.begin(), list.end()), done;
  if (journal) {
    for (CensusLine& line : journal->lines())
      if (listed.contains(line.triangulation) && done.insert(line.triangulation).second)
        lines.push_back(std::move(line));
  }
  std::vector<std::string> todo;
  for (const std::string& text : list)
    if (done.insert(text).second) todo.push_back(text);
  const std::size_t total = lines.size() + todo.size(), resumed = lines.size();
  catch_interrupts();
  Progress progress(!command.quiet);
  std::size_t count = resumed;
  command.classify.stop_requested = &interrupt_requested();
  command.classify.canonize.solve.stop_requested = &interrupt_requested();
  command.classify.on_line = [&](const CensusLine& line) {
    if (journal) journal->add(line);
    ++count;
    if (progress.due()) progress.show(fmt::format("{} of {} triangulations", count, total));
  };
  for (CensusLine& line : canonical::classify(todo, command.classify))
    lines.push_back(std::move(line));
  if (lines.size() < total) {
    write_message(fmt::format("tripus: interrupted after {} of {} triangulations{}\n", lines.size(),
                              total, path.empty() ? "" : "; the same command goes on from there"));
    return kNoAnswer;
  }
  std::size_t own = 0, moved = 0, refused = 0;
  for (const CensusLine& line : lines) {
    own += line.resolved && line.own_metric;
    moved += line.resolved && !line.own_metric;
    refused += !line.reason.empty();
    if (!line.reason.empty())
      write_message(fmt::format("tripus: {}: {}\n", printable(line.triangulation), line.reason));
  }
  const Census census = canonical::make_census(lines);
  write_census(command, census);
  if (!path.empty() && command.journal.empty()) std::filesystem::remove(path);
  const std::string summary = fmt::format(
      "{} triangulations: {} manifolds; {} carry their metric, {} after moves, {} unresolved, {} "
      "refused{}\n",
      total, census.manifolds.size(), own, moved, census.unresolved.size(), refused,
      resumed == 0 ? "" : fmt::format(" ({} known from an earlier run)", resumed));
  write_message(command.quiet ? "" : summary);
  if (command.tsv.empty() && command.database.empty()) write_text("-", canonical::to_tsv(census));
  return kSuccess;
}

/// Recognised by content: SQLite files begin with their name.
Census load_census(const std::string& path) {
  const std::string text = read_file(path);
  if (text.starts_with("SQLite format 3")) return canonical::read_database(path);
  try {
    return canonical::parse_tsv(text);
  } catch (const InvalidInput& error) {
    throw InvalidInput(tripus::quoted(path) + ": " + error.what());
  }
}

/// "6.4:7" or "6.4:" or ":7".
void parse_volumes(const std::string& text, canonical::CensusQuery& query) {
  const std::size_t colon = text.find(':');
  const auto bound = [&](std::string_view part, double& value) {
    if (part.empty()) return;
    const auto number = parse_number(part);
    if (!number)
      throw InvalidInput("--volume " + tripus::quoted(text) + ": write FROM:TO, such as 6.4:7");
    value = *number;
  };
  if (colon == std::string::npos)
    throw InvalidInput("--volume " + tripus::quoted(text) + ": write FROM:TO, such as 6.4:7");
  bound(std::string_view(text).substr(0, colon), query.least_volume);
  bound(std::string_view(text).substr(colon + 1), query.greatest_volume);
}

/// What was found as a census of its own; with what is unresolved if nothing was left out.
Census chosen_part(const Census& census, const std::vector<const canonical::CensusEntry*>& found) {
  Census part;
  for (const canonical::CensusEntry* entry : found) part.manifolds.push_back(*entry);
  if (found.size() == census.manifolds.size()) part.unresolved = census.unresolved;
  return part;
}

int look_up(CensusCommand& command) {
  if (!command.volume.empty()) parse_volumes(command.volume, command.query);
  std::optional<Census> loaded;
  if (!command.in.empty()) loaded = load_census(command.in);
  const Census& census = loaded ? *loaded : canonical::shipped_census();
  const auto found = canonical::select(census, command.query);
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
  std::optional<Census> loaded;
  if (!command.in.empty()) loaded = load_census(command.in);
  const Census& census = loaded ? *loaded : canonical::shipped_census();
  std::optional<std::vector<canonical::CensusProof>> proofs;
  if (!command.proofs.empty()) proofs = canonical::parse_census_proofs(read_file(command.proofs));
  Context context = interruptible();
  context.threads = command.classify.threads;
  const canonical::CensusCheck check = canonical::check_census(
      census, proofs ? *proofs : canonical::shipped_census_proofs(), context);
  if (check.stopped) write_message("tripus: interrupted before all proofs were checked\n");
  for (const std::string& failure : check.failures) write_output(printable(failure) + "\n");
  write_output(
      fmt::format("{} of {} manifolds have a valid proof\n", check.valid, census.manifolds.size()));
  return check.failures.empty() && !check.stopped ? kSuccess : kNoAnswer;
}

int write_proofs(const CensusCommand& command) {
  std::optional<Census> loaded;
  if (!command.in.empty()) loaded = load_census(command.in);
  const Context context = interruptible();
  const auto proofs =
      canonical::prove_census(loaded ? *loaded : canonical::shipped_census(), context);
  write_text(command.proofs.empty() ? "-" : command.proofs, canonical::to_tsv(proofs));
  return context.stop_requested() ? kNoAnswer : kSuccess;
}

void add_query_options(CLI::App& verb, CensusCommand& command) {
  verb.add_option("--in", command.in, "census to look in, TSV or SQLite (default: the shipped one)")
      ->option_text("FILE");
  verb.add_option("--volume", command.volume, "only volumes in this range")->option_text("FROM:TO");
  verb.add_option("--boundary", command.query.boundary, "only this boundary, such as g2")
      ->option_text("GENERA");
  verb.add_option("--homology", command.query.homology, "only this H1, such as \"2 Z + Z_3\"")
      ->option_text("GROUP");
  verb.add_option("--cells", command.query.cells, "only these cells, such as \"1 octahedron\"")
      ->option_text("CELLS");
  verb.add_option("--tetrahedra", command.query.tetrahedra, "only manifolds of N tetrahedra")
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()));
  verb.add_flag("--json", command.json, "one JSON object for each manifold, one a line");
}

void add_making_options(CLI::App& verb, CensusCommand& command) {
  verb.add_option("--from", command.lists,
                  "make a census: classify the triangulations of this list,\n"
                  "one signature a line; may be repeated")
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
  add_canonize_options(verb, command.classify.canonize);
  CLI::Option* from = verb.get_option("--from");
  verb.get_option("--journal")->needs(from);
  for (const char* query :
       {"--in", "--volume", "--boundary", "--homology", "--cells", "--tetrahedra"})
    verb.get_option(query)->excludes(from);
}

}  // namespace

void add_census(CLI::App& program, Command& chosen) {
  CLI::App* verb =
      program.add_subcommand("census", "tables of manifolds: make one, or look in one");
  auto command = std::make_shared<CensusCommand>();
  command->classify.canonize.retriangulation.budget = canonical::kCensusBudget;
  add_query_options(*verb, *command);
  auto* check = verb->add_flag("--check", command->check,
                               "check the proof of every manifold by other code than made it");
  auto* prove = verb->add_flag("--prove", command->prove,
                               "prove the metrics of all manifolds, and write the proofs");
  check->excludes(prove);
  verb->add_option("--proofs", command->proofs,
                   "file of proofs that --check reads (default: the shipped one) or --prove\n"
                   "writes (default: standard output)")
      ->option_text("FILE");
  add_making_options(*verb, *command);
  verb->footer(kCanonicalStatusHelp);
  verb->final_callback([command, &chosen] {
    chosen = [command] {
      if (command->check) return check_proofs(*command);
      if (command->prove) return write_proofs(*command);
      return command->lists.empty() ? look_up(*command) : make(*command);
    };
  });
}

}  // namespace tripus::cli
