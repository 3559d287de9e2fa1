#include "canonical/census_shard.hpp"

#include <charconv>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/checksum.hpp"
#include "base/error.hpp"

namespace tripus::canonical {
namespace {

constexpr std::string_view kBegin = "# tripus census shard: version ";
constexpr std::string_view kEnd = "# end of the shard: checksum ";
constexpr std::size_t kMostShards = 1'000'000'000;

/// Reads texts and numbers off the front of a line.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}
  bool skip(std::string_view expected) {
    if (!text_.starts_with(expected)) return false;
    text_.remove_prefix(expected.size());
    return true;
  }
  template <class Number>
  bool number(Number& value, int base = 10) {
    const auto [end, error] =
        std::from_chars(text_.data(), text_.data() + text_.size(), value, base);
    if (error != std::errc()) return false;
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return true;
  }
  std::string until(char end) {
    const std::size_t place = std::min(text_.find(end), text_.size());
    std::string found(text_.substr(0, place));
    text_.remove_prefix(place);
    return found;
  }
  bool done() const { return text_.empty(); }

 private:
  std::string_view text_;
};

std::optional<ShardWork> read_work(std::string_view line) {
  ShardWork work;
  Scanner scan(line);
  if (!scan.skip(kBegin)) return std::nullopt;
  work.version = scan.until(',');
  const bool reads = scan.skip(", budget ") && scan.number(work.budget) && scan.skip(", ") &&
                     scan.number(work.lines) && scan.skip(" lines, list ") &&
                     scan.number(work.checksum, 16) && scan.skip(", shard ") &&
                     scan.number(work.number) && scan.skip("/") && scan.number(work.count) &&
                     scan.done();
  const bool fits = work.number >= 1 && work.number <= work.count && work.count <= kMostShards;
  return reads && fits ? std::optional(work) : std::nullopt;
}

/// Which of the numbers 1 to `count` are no keys: "3, 7, 9 to 12 and 400 more". There may be very
/// many.
std::string missing_numbers(const std::map<std::size_t, std::string>& present, std::size_t count) {
  constexpr std::size_t kShown = 10;
  std::vector<std::string> parts;
  std::size_t first = 1, rest = count - present.size();
  const auto add_up_to = [&](std::size_t end) {
    if (first < end && parts.size() < kShown) {
      parts.push_back(first + 1 == end ? fmt::format("{}", first)
                                       : fmt::format("{} to {}", first, end - 1));
      rest -= end - first;
    }
    first = end + 1;
  };
  for (const auto& [number, name] : present) add_up_to(number);
  add_up_to(count + 1);
  return fmt::format("{}{}", fmt::join(parts, ", "),
                     rest > 0 ? fmt::format(" and {} more", rest) : "");
}

}  // namespace

bool ShardWork::is_of_one_census(const ShardWork& other) const {
  ShardWork same = other;
  same.number = number;
  return *this == same;
}

std::string to_string(const ShardWork& work) {
  return fmt::format("{}{}, budget {}, {} lines, list {:016x}, shard {}/{}", kBegin, work.version,
                     work.budget, work.lines, work.checksum, work.number, work.count);
}

std::string to_text(const CensusShard& shard) {
  std::string text = to_string(shard.work) + '\n';
  for (const CensusLine& line : shard.lines) text += to_journal(line) + '\n';
  return text + std::string(kEnd) + checksum_text(text) + '\n';
}

ShardWork parse_shard_work(std::string_view text) {
  const auto work = read_work(text.substr(0, text.find('\n')));
  if (!work)
    throw InvalidInput(fmt::format("line 1 is not the first of a shard (\"{}...\")", kBegin));
  return *work;
}

CensusShard parse_shard(std::string_view text) {
  CensusShard shard{.work = parse_shard_work(text), .lines = {}};
  const std::size_t end = text.rfind(kEnd);
  if (end == std::string_view::npos || end == 0 || text[end - 1] != '\n')
    throw InvalidInput("the shard is cut off: its last line is missing");
  if (text.substr(end) != std::string(kEnd) + checksum_text(text.substr(0, end)) + '\n')
    throw InvalidInput("the shard is damaged: its checksum is another one");
  std::size_t number = 1;
  for (std::size_t at = text.find('\n') + 1; at < end;) {
    const std::size_t stop = text.find('\n', at);
    ++number;
    auto line = parse_journal_line(text.substr(at, stop - at));
    if (!line) throw InvalidInput(fmt::format("line {} is not one of a census", number));
    shard.lines.push_back(std::move(*line));
    at = stop + 1;
  }
  if (shard.lines.size() != shard.work.lines_here())
    throw InvalidInput(fmt::format("the shard has {} lines instead of {}", shard.lines.size(),
                                   shard.work.lines_here()));
  return shard;
}

void ShardMerger::add(CensusShard shard, const std::string& name) {
  if (names_.empty()) {
    work_ = shard.work;
  } else if (!work_.is_of_one_census(shard.work)) {
    throw InvalidInput(fmt::format("{} is not of the same census as the others: \"{}\", not \"{}\"",
                                   quoted(name), to_string(shard.work), to_string(work_)));
  }
  const auto [place, is_new] = names_.emplace(shard.work.number, name);
  if (!is_new)
    throw InvalidInput(fmt::format("{} and {} are both shard {}/{}; leave one of them out",
                                   quoted(place->second), quoted(name), shard.work.number,
                                   work_.count));
  for (CensusLine& line : shard.lines) lines_.push_back(std::move(line));
}

std::vector<CensusLine> ShardMerger::finish() {
  if (names_.size() < work_.count)
    throw InvalidInput(fmt::format("{} of {} shards are missing: {}; make them, and merge again",
                                   work_.count - names_.size(), work_.count,
                                   missing_numbers(names_, work_.count)));
  return std::move(lines_);
}

}  // namespace tripus::canonical
