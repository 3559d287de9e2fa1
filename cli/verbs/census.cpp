// tripus census: its options, and looking things up in tables of manifolds.
#include "canonical/census.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "canonical/census_proofs.hpp"
#include "cli/arguments.hpp"
#include "cli/canonize_options.hpp"
#include "cli/census.hpp"
#include "cli/describe.hpp"
#include "cli/failure.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/texts.hpp"
#include "cli/verb.hpp"
#include "manifold/load.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"

namespace tripus::cli {
namespace {

using canonical::Census;

struct CensusCommand {
  std::vector<std::string> names;  ///< manifolds to look up
  std::string in;
  canonical::CensusQuery query;
  std::string volume;
  bool has_boundary = false, has_homology = false, has_cells = false;  ///< also if empty
  CensusMaking making;               ///< also the files that what is found is written to
  std::optional<std::string> shard;  ///< "17/400"
  std::string output;                ///< of one shard; of a merged census
  bool json = false, check = false;
};

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
  part.proved_digits = census.proved_digits;
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
  if (command.making.prove || !command.making.database.empty() || !command.making.tsv.empty())
    return write_census(command.making, chosen_part(census, found));
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
  if (!command.making.proofs.empty())
    proofs = canonical::parse_census_proofs(read_file(command.making.proofs));
  Context context = interruptible();
  context.threads = command.making.classify.threads;
  const canonical::CensusCheck check = canonical::check_census(
      census, proofs ? *proofs : canonical::shipped_census_proofs(), context);
  if (check.stopped) write_message("tripus: " + stop_text() + " before all proofs were checked\n");
  for (const std::string& failure : check.failures) write_output(printable(failure) + "\n");
  write_output(
      fmt::format("{} of {} manifolds have a valid proof\n", check.valid, census.manifolds.size()));
  return check.failures.empty() && !check.stopped ? kSuccess : kNoAnswer;
}

/// Before the work, not after it.
void declare_all_outputs(const CensusCommand& command) {
  declare_outputs(command.making);
  if (command.shard) declare_output("-o", command.output);
  if (!command.in.empty()) require_not_written(command.in);
}

/// Which options go together, as far as CLI11 cannot say it.
void require_fitting(CensusCommand& command) {
  CensusMaking& making = command.making;
  const bool makes = !making.lists.empty() || !making.shards.empty();
  if (!making.proofs.empty() && !making.prove && !command.check)
    throw CLI::RequiredError("--prove or --check, with --proofs,");
  const bool has_file = !making.tsv.empty() || !making.database.empty() || !command.output.empty();
  if (making.prove && (making.proofs.empty() || making.proofs == "-") &&
      (making.tsv == "-" || (makes && !has_file)))
    throw CLI::RequiredError(
        "--proofs FILE, with --prove where the census itself goes to standard output,");
  if (command.shard && command.output.empty()) throw CLI::RequiredError("-o FILE, with --shard,");
  if (command.shard && making.prove) throw CLI::ExcludesError("--prove", "--shard");
  if (command.shard || command.output.empty()) return;
  if (making.shards.empty()) throw CLI::RequiredError("--shard or --merge, with -o,");
  if (!making.database.empty()) throw CLI::ExcludesError("-o", "--database");
  making.database = command.output;
  making.database_option = "-o";
}

int run(CensusCommand& command) {
  const CensusMaking& making = command.making;
  declare_all_outputs(command);
  if (command.shard)
    return make_shard(
        {making.lists, *command.shard, command.output, making.classify, making.quiet});
  if (!making.shards.empty()) return merge_census(making);
  if (command.check) return check_proofs(command);
  if (!making.lists.empty()) return make_census(making);
  return look_up(command);
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
  verb.add_flag("--json", command.json, "one JSON object for each manifold, one a line")
      ->option_text(" ");
}

void add_making_options(CLI::App& verb, CensusCommand& command) {
  verb.add_option("--from", command.making.lists,
                  "make a census: classify the triangulations of this list, one INPUT\n"
                  "a line; may be repeated")
      ->option_text("LIST")
      ->allow_extra_args(false);
  verb.add_option("--tsv", command.making.tsv, "write it, or what was found, as a table with tabs")
      ->option_text("FILE");
  verb.add_option("--database", command.making.database,
                  "write it, or what was found, as a SQLite database")
      ->option_text("FILE");
  verb.add_option("--journal", command.making.journal,
                  "keep what is done here, so that an interrupted run can go on\n"
                  "(default: beside the result, removed in the end)")
      ->option_text("FILE");
  verb.add_option("--threads", command.making.classify.threads, "threads (default: all cores)")
      ->option_text("N")
      ->check(whole_number(1024));
  verb.add_flag("--quiet", command.making.quiet, "no progress and no summary on standard error");
  verb.add_option("--shard", command.shard,
                  "of --from the I-th of M parts only, written to -o; the same\n"
                  "command again goes on where it was, or finds it done")
      ->option_text("I/M");
  verb.add_option("--merge", command.making.shards,
                  "make a census of shards: all of them, in any order")
      ->option_text("SHARD ...");
  verb.add_option("-o,--output", command.output,
                  "with --shard: the shard. With --merge: the census as a SQLite database")
      ->option_text("FILE")
      ->check(problem_of_name);
  add_canonize_options(verb, command.making.classify.canonize);
  CLI::Option* from = verb.get_option("--from");
  verb.get_option("--journal")->needs(from);
  CLI::Option* shard = verb.get_option("--shard")->needs(from);
  CLI::Option* merge = verb.get_option("--merge")->excludes(from);
  for (const char* result : {"--tsv", "--database", "--journal"})
    verb.get_option(result)->excludes(shard);
  for (const char* query : {"NAME", "--in", "--volume", "--boundary", "--homology", "--cells",
                            "--tetrahedra", "--check"})
    verb.get_option(query)->excludes(from)->excludes(merge);
  for (const char* search : {"--budget", "--threads"}) verb.get_option(search)->excludes(merge);
}

constexpr const char* kCensusHelp =
    "Without --from it looks in a census. Manifolds of the shipped census keep their names in any\n"
    "other; what is not in it is called by its signature. All names are INPUTs.\n"
    "\n"
    "Exit status: 0 found, or made; 1 nothing was found, or interrupted; 2 bad usage or bad "
    "input,\n"
    "3 a failure of the program itself.";

void add_census(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<CensusCommand>();
  command->making.classify.canonize.retriangulation.budget = canonical::kCensusBudget;
  add_query_options(*verb, *command);
  auto* check = verb->add_flag("--check", command->check,
                               "check the proof of every manifold by other code than made it")
                    ->option_text(" ");
  auto* prove = verb->add_flag("--prove", command->making.prove,
                               "prove the metrics of all manifolds, and write the proofs; with "
                               "--tsv\nor --database volumes are written to digits that are proved")
                    ->option_text(" ");
  check->excludes(prove);
  verb->add_option("--proofs", command->making.proofs,
                   "file of proofs that --check reads (default: the shipped one) or\n--prove "
                   "writes (default: standard output)")
      ->option_text("FILE");
  add_making_options(*verb, *command);
  for (const char* other : {"NAME", "--volume", "--boundary", "--homology", "--cells",
                            "--tetrahedra", "--json", "--tsv", "--database", "--budget"})
    check->excludes(verb->get_option(other));
  verb->footer(kCensusHelp);
  verb->final_callback([command, verb, &chosen] {
    command->has_boundary = verb->get_option("--boundary")->count() > 0;
    command->has_homology = verb->get_option("--homology")->count() > 0;
    command->has_cells = verb->get_option("--cells")->count() > 0;
    require_fitting(*command);
    chosen = [command] { return run(*command); };
  });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> census() {
  static constexpr Verb kRows[] = {
      {"census", "tables of manifolds: make one, or look in one", add_census, 10}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
