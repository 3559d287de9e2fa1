#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/journal.hpp"
#include "canonical/census.hpp"

namespace tripus::cli {

/// The census of a file, TSV (also compressed by gzip) or SQLite, recognised by its content; the
/// shipped one if the name is empty. Throws InvalidInput, naming the file.
class ChosenCensus {
 public:
  explicit ChosenCensus(const std::string& path);
  const canonical::Census& get() const { return loaded_ ? *loaded_ : canonical::shipped_census(); }

 private:
  std::optional<canonical::Census> loaded_;
};

/// The isomorphism signature of what a line of a list, an INPUT, names. Throws InvalidInput.
std::string signature_of_line(const std::string& text);

/// The lines of earlier runs. Throws InvalidInput with the place of what is none.
std::vector<canonical::CensusLine> lines_of(const Journal& journal);

/// How many lines of a census ended how.
struct LineCounts {
  std::size_t own = 0, moved = 0, unresolved = 0, refused = 0;
};
LineCounts count_lines(const std::vector<canonical::CensusLine>& lines);

/// A census to be made: what `tripus census --from` and `--merge` ask for.
struct CensusMaking {
  std::vector<std::string> lists;      ///< files of INPUTs, or
  std::vector<std::string> shards;     ///< files that are merged
  std::string journal, tsv, database;  ///< files to write, empty for none; tsv "-": to the output
  const char* database_option = "--database";  ///< that named it, for messages
  std::string proofs;  ///< file of proofs, with `prove`; empty: to the output
  canonical::ClassifyOptions classify;
  bool prove = false, quiet = false;
};

/// Says which files will be written. Throws InvalidInput for those that cannot be, before any work.
void declare_outputs(const CensusMaking& command);

/// Classifies what the lists name and writes the census; the exit status. What is done so far is
/// kept in the journal, and an interrupted run goes on from there.
int make_census(CensusMaking command);
/// The census of the shards.
int merge_census(const CensusMaking& command);

/// Writes a census to the files that are named; with `prove` its metrics are proved first, the
/// volumes rounded to digits that are proved where all are, and the proofs written. The exit
/// status.
int write_census(const CensusMaking& command, canonical::Census census);

/// One part of a census: what `tripus census --from LIST --shard I/M -o FILE` asks for.
struct ShardCommand {
  std::vector<std::string> lists;
  std::string shard;  ///< "17/400"
  std::string output;
  canonical::ClassifyOptions classify;
  bool quiet = false;
};

/// Makes the shard, unless the file is there already; the exit status. What is done so far is kept
/// in FILE.journal, and an interrupted run goes on from there.
int make_shard(ShardCommand command);

/// The lines of all shards of one census; says what was refused in them. Throws InvalidInput,
/// naming the file, for what does not fit together.
std::vector<canonical::CensusLine> merged_lines(const std::vector<std::string>& paths);

}  // namespace tripus::cli
