#include "canonical/census_shard.hpp"

#include <cstdint>
#include <filesystem>
#include <unordered_map>

#include <fmt/format.h>

#include "base/checksum.hpp"
#include "base/error.hpp"
#include "base/journal.hpp"
#include "base/output_file.hpp"
#include "base/version.hpp"
#include "cli/census.hpp"
#include "cli/describe.hpp"
#include "cli/failure.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/shard.hpp"
#include "manifold/load.hpp"

namespace tripus::cli {
namespace {

using canonical::CensusLine;
using canonical::CensusShard;
using canonical::ShardWork;

/// The lines of this shard; fills `work` from all of them.
std::vector<std::string> lines_of_shard(const ShardCommand& command, ShardWork& work) {
  const Shard shard = parse_shard(command.shard);
  work.version = kVersion;
  work.budget = command.classify.canonize.retriangulation.budget;
  work.number = shard.number;
  work.count = shard.count;
  work.checksum = checksum("");
  std::vector<std::string> lines;
  for (const std::string& path : command.lists) {
    require_not_written(path);
    for (const topology::BatchLine& line : read_batch_file(path)) {
      work.checksum = checksum(line.text + '\n', work.checksum);
      if (shard.has(work.lines++)) lines.push_back(line.text);
    }
  }
  return lines;
}

/// Whether the file is this very shard, whole. Throws InvalidInput for a file of other work.
bool is_there(const std::string& path, const ShardWork& work) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return false;
  if (!std::filesystem::is_regular_file(path, error))
    throw InvalidInput(tripus::quoted(path) +
                       " is no ordinary file: name another one for the shard");
  const std::string text = read_file(path);
  try {
    if (canonical::parse_shard_work(text) == work) {
      try {
        canonical::parse_shard(text);
        return true;
      } catch (const InvalidInput& damage) {
        write_message(
            fmt::format("tripus: {}: {}; it is made anew\n", tripus::quoted(path), damage.what()));
        return false;
      }
    }
  } catch (const InvalidInput&) {  // said below
  }
  throw InvalidInput(tripus::quoted(path) +
                     " is there and is not this shard; name another file, or remove it");
}

/// A line of the list as a signature, or as refused.
CensusLine read_line(const std::string& text) {
  CensusLine line;
  try {
    line.triangulation = signature_of_line(text);
  } catch (const InvalidInput& error) {
    line.triangulation = printable(text);
    line.reason = error.what();
  }
  return line;
}

/// What earlier runs of the same shard have found, by triangulation.
std::unordered_map<std::string, CensusLine> known_from(const Journal& journal) {
  std::unordered_map<std::string, CensusLine> known;
  for (CensusLine& line : lines_of(journal)) {
    std::string triangulation = line.triangulation;
    known.emplace(std::move(triangulation), std::move(line));
  }
  return known;
}

}  // namespace

int make_shard(ShardCommand command) {
  CensusShard shard;
  const std::vector<std::string> texts = lines_of_shard(command, shard.work);
  const std::string name = fmt::format("shard {}/{}", shard.work.number, shard.work.count);
  if (is_there(command.output, shard.work)) {
    if (!command.quiet)
      write_message(fmt::format("{}: {} is there already\n", name, tripus::quoted(command.output)));
    return kSuccess;
  }
  Journal journal(command.output + ".journal", to_string(shard.work));
  auto known = known_from(journal);
  std::vector<std::string> todo;
  for (const std::string& text : texts) {
    CensusLine line = read_line(text);
    if (line.reason.empty() && !known.contains(line.triangulation)) {
      known.emplace(line.triangulation, line);
      todo.push_back(line.triangulation);
    }
    shard.lines.push_back(std::move(line));
  }
  Progress progress(!command.quiet);
  std::size_t count = 0;
  const auto rest = [&] {
    return fmt::format(" after {} of {} triangulations of {}; the same command goes on from there",
                       count, todo.size(), name);
  };
  set_last_words(rest());
  command.classify.stop = &interrupt_requested();
  command.classify.canonize.solve.stop = &interrupt_requested();
  command.classify.on_line = [&](const CensusLine& line) {
    journal.add(canonical::to_journal(line));
    ++count;
    set_last_words(rest());
    if (progress.due())
      progress.show(fmt::format("{}: {} of {} triangulations", name, count, todo.size()));
  };
  for (CensusLine& line : canonical::classify(todo, command.classify))
    known[line.triangulation] = std::move(line);
  if (count < todo.size()) {
    write_message("tripus: " + stop_text() + rest() + "\n");
    return kNoAnswer;
  }
  for (CensusLine& line : shard.lines)
    if (line.reason.empty()) line = known.at(line.triangulation);
  write_file(command.output, canonical::to_text(shard));
  journal.remove();
  const LineCounts counts = count_lines(shard.lines);
  if (!command.quiet)
    write_message(fmt::format(
        "{}: {} lines: {} carry their metric, {} after moves, {} unresolved, {} refused\n", name,
        shard.lines.size(), counts.own, counts.moved, counts.unresolved, counts.refused));
  return kSuccess;
}

std::vector<CensusLine> merged_lines(const std::vector<std::string>& paths) {
  canonical::ShardMerger merger;
  for (const std::string& path : paths) {
    require_not_written(path);
    try {
      merger.add(canonical::parse_shard(read_file(path)), path);
    } catch (const InvalidInput& error) {
      if (std::string_view(error.what()).find(tripus::quoted(path)) != std::string_view::npos)
        throw;
      throw InvalidInput(tripus::quoted(path) + ": " + error.what());
    }
  }
  std::vector<CensusLine> lines = merger.finish();
  for (const CensusLine& line : lines)
    if (!line.reason.empty())
      write_message(fmt::format("tripus: {}: {}\n", printable(line.triangulation), line.reason));
  return lines;
}

}  // namespace tripus::cli
