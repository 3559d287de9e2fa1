#pragma once

#include <cstddef>
#include <string>

namespace tripus::cli {

/// One of several equal parts of a piece of work: "17/400" is the 17th of 400, counted from 1.
struct Shard {
  std::size_t number = 1, count = 1;

  bool is_all() const { return count == 1; }
  /// The k-th of a list, from 0, belongs to shard k % count + 1.
  bool has(std::size_t k) const { return k % count == number - 1; }
};

/// Throws InvalidInput, naming --shard.
Shard parse_shard(const std::string& text);

}  // namespace tripus::cli
