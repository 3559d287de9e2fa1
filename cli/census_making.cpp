#include <cstdint>
#include <optional>
#include <unordered_set>

#include <fmt/format.h>

#include "base/checksum.hpp"
#include "base/error.hpp"
#include "base/journal.hpp"
#include "base/output_file.hpp"
#include "base/version.hpp"
#include "canonical/census_proofs.hpp"
#include "cli/census.hpp"
#include "cli/describe.hpp"
#include "cli/failure.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "manifold/load.hpp"

namespace tripus::cli {
namespace {

using canonical::Census;
using canonical::CensusLine;

/// What a census depends on besides its list, which is told apart by its checksum.
std::string work_of(const CensusMaking& command, const std::vector<std::string>& list) {
  std::uint64_t digest = checksum("");
  for (const std::string& text : list) digest = checksum(text + '\n', digest);
  return fmt::format("# tripus census: version {}, budget {}, {} triangulations, list {:016x}",
                     kVersion, command.classify.canonize.retriangulation.budget, list.size(),
                     digest);
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
        inputs.triangulations.push_back(signature_of_line(line.text));
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

/// The journal's name if none was given: beside the result.
std::string journal_of(const CensusMaking& command) {
  if (!command.journal.empty()) return command.journal;
  if (!command.database.empty()) return command.database + ".journal";
  if (!command.tsv.empty() && command.tsv != "-") return command.tsv + ".journal";
  return {};
}

/// Rounds the volumes to what the proofs prove, or says why not; the exit status.
int round_volumes(Census& census, const std::vector<canonical::CensusProof>& proofs) {
  const std::vector<std::string> without = canonical::round_to_proved(census, proofs);
  if (without.empty()) return kSuccess;
  write_message(fmt::format(
      "tripus: the volumes stay as they came out in floating point: {} of {} are not proved, that "
      "of {} and so on\n",
      without.size(), census.manifolds.size(), without.front()));
  return kNoAnswer;
}

/// Writes the census of these lines, and says what it is.
int finish(const CensusMaking& command, const std::vector<CensusLine>& lines,
           std::size_t refused_before, std::size_t resumed) {
  const LineCounts counts = count_lines(lines);
  const Census census = canonical::make_census(lines);
  const std::size_t total = lines.size() + refused_before;
  if (total == 0) throw InvalidInput("there is no INPUT in the list: no census was made");
  if (census.manifolds.empty() && census.unresolved.empty())
    throw InvalidInput(fmt::format("all of the {} were refused: no census was made",
                                   counted(total, "triangulation", "triangulations")));
  CensusMaking outputs = command;
  if (command.tsv.empty() && command.database.empty()) outputs.tsv = "-";
  const int status = write_census(outputs, census);
  if (interrupt_requested()) return status;
  const std::string summary = fmt::format(
      "{} triangulations: {} manifolds; {} carry their metric, {} after moves, {} unresolved, {} "
      "refused{}\n",
      total, census.manifolds.size(), counts.own, counts.moved, census.unresolved.size(),
      counts.refused + refused_before,
      resumed == 0 ? "" : fmt::format(" ({} known from an earlier run)", resumed));
  write_message(command.quiet ? "" : summary);
  return status;
}

}  // namespace

void declare_outputs(const CensusMaking& command) {
  if (!command.tsv.empty() && command.tsv != "-") declare_output("--tsv", command.tsv);
  if (!command.database.empty()) declare_output(command.database_option, command.database);
  if (!command.lists.empty() && !journal_of(command).empty())
    declare_output("--journal", journal_of(command));
  if (command.prove && !command.proofs.empty()) declare_output("--proofs", command.proofs);
}

int write_census(const CensusMaking& command, Census census) {
  const bool writes = !command.database.empty() || !command.tsv.empty();
  int status = kSuccess;
  if (command.prove) {
    Context context = interruptible();
    context.threads = command.classify.threads;
    const auto proofs = canonical::prove_census(census, {.volumes = writes}, context);
    if (context.stop_requested() || context.expired()) {
      write_message(fmt::format("tripus: {} after {} proofs; nothing was written\n", stop_text(),
                                proofs.size()));
      return kNoAnswer;
    }
    if (writes) status = round_volumes(census, proofs);
    write_text(command.proofs.empty() ? "-" : command.proofs, canonical::to_tsv(proofs));
  }
  if (!command.database.empty()) canonical::write_database(census, command.database);
  if (!command.tsv.empty()) write_text(command.tsv, canonical::to_tsv(census));
  return status;
}

int make_census(CensusMaking command) {
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
  command.classify.stop = &interrupt_requested();
  command.classify.canonize.solve.stop = &interrupt_requested();
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
  const int status = finish(command, lines, inputs.refused, resumed);
  if (journal && command.journal.empty() && !interrupt_requested()) journal->remove();
  return status;
}

int merge_census(const CensusMaking& command) {
  return finish(command, merged_lines(command.shards), 0, 0);
}

}  // namespace tripus::cli
