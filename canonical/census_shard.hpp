#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "canonical/census.hpp"

namespace tripus::canonical {

/// What the lines of a shard depend on: shards of one census agree in all but `number`.
struct ShardWork {
  std::string version;         ///< of the program
  std::size_t budget = 0;      ///< of retriangulation
  std::size_t lines = 0;       ///< of the whole list, comments and empty lines not counted
  std::uint64_t checksum = 0;  ///< of its lines
  std::size_t number = 1, count = 1;

  /// Line k of the list, from 0, belongs to shard k % count + 1.
  std::size_t lines_here() const { return lines / count + (lines % count >= number ? 1 : 0); }
  bool is_of_one_census(const ShardWork& other) const;
  friend bool operator==(const ShardWork&, const ShardWork&) = default;
};
/// "# tripus census shard: version 0.1.0, budget 20, 579113 lines, list 0123456789abcdef, shard
/// 17/400"
std::string to_string(const ShardWork& work);

/// One part of a census: every line of it, those that were refused with the reason.
struct CensusShard {
  ShardWork work;
  std::vector<CensusLine> lines;  ///< [lines_here] in the order of the list
};

/// The text of a shard file: the work, a line each, and the end with a checksum of all.
std::string to_text(const CensusShard& shard);
/// Throws InvalidInput with the place for what is no shard, damaged or cut off.
CensusShard parse_shard(std::string_view text);
/// What the first line of such a text says. Throws InvalidInput.
ShardWork parse_shard_work(std::string_view text);

/// Puts the shards of a census together, one after the other, in any order.
class ShardMerger {
 public:
  /// `name` is for messages. Throws InvalidInput for a shard of another census (version, budget,
  /// list, count) and for one whose number was there before.
  void add(CensusShard shard, const std::string& name);
  /// All lines. Throws InvalidInput, with the numbers of the shards that are missing.
  std::vector<CensusLine> finish();

 private:
  ShardWork work_;
  std::map<std::size_t, std::string> names_;  ///< by the number of the shard
  std::vector<CensusLine> lines_;
};

}  // namespace tripus::canonical
