#pragma once

#include <string>
#include <vector>

#include "canonical/census.hpp"

namespace tripus::cli {

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

}  // namespace tripus::cli
