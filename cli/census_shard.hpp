#pragma once

#include <string>
#include <vector>

#include "canonical/census.hpp"

namespace tripus::cli {

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
