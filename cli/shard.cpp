#include "cli/shard.hpp"

#include <charconv>
#include <string_view>

#include "base/error.hpp"

namespace tripus::cli {
namespace {

constexpr std::size_t kMostShards = 1'000'000'000;

/// A whole number above 0, or 0 for anything else.
std::size_t parse_count(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && value <= kMostShards ? value : 0;
}

}  // namespace

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const Shard shard{parse_count(std::string_view(text).substr(0, slash)),
                      parse_count(std::string_view(text).substr(slash + 1))};
    if (shard.number > 0 && shard.number <= shard.count) return shard;
  }
  throw InvalidInput("--shard " + quoted(text) +
                     ": write NUMBER/COUNT, from 1/COUNT to COUNT/COUNT");
}

}  // namespace tripus::cli
