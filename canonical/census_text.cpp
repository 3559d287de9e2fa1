// The census and its journal as text with tabs.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "canonical/census.hpp"

namespace tripus::canonical {
namespace {

constexpr std::string_view kColumns =
    "name\ttetrahedra\tboundary\tvolume\thomology\tcells\tkeeping\treversing\tsignature\t"
    "triangulations";

/// What a line of an unresolved triangulation begins with: a comment for other programs.
constexpr std::string_view kUnresolved = "# unresolved ";

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

template <class Number>
bool parse_number(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// boundary, volume, homology, cells, keeping, reversing, signature: the shared columns.
constexpr std::size_t kFacts = 7;

std::string facts(const CensusEntry& entry) {
  return fmt::format("{}\t{:.15g}\t{}\t{}\t{}\t{}\t{}", entry.boundary, entry.volume,
                     entry.homology, entry.cells, entry.keeping, entry.reversing, entry.signature);
}

bool parse_facts(std::span<const std::string_view> cells, CensusEntry& entry) {
  entry.boundary = cells[0];
  entry.homology = cells[2];
  entry.cells = cells[3];
  entry.signature = cells[6];
  return parse_number(cells[1], entry.volume) && std::isfinite(entry.volume) &&
         parse_number(cells[4], entry.keeping) && parse_number(cells[5], entry.reversing) &&
         !entry.signature.empty();
}

bool has_control(const std::vector<std::string_view>& cells) {
  return std::ranges::any_of(cells, [](std::string_view cell) {
    return std::ranges::any_of(cell, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  });
}

/// Nothing if it is not a line of a journal.
std::optional<CensusLine> parse_journal_line(std::string_view text) {
  const auto cells = split(text, '\t');
  if (cells.size() < 4 || cells.back() != "." || cells[0].empty()) return std::nullopt;
  CensusLine line;
  line.triangulation = cells[0];
  if (cells[1] == "own" || cells[1] == "moved") {
    line.resolved = true;
    line.own_metric = cells[1] == "own";
    if (cells.size() != kFacts + 3 || !parse_facts(std::span(cells).subspan(2), line.entry))
      return std::nullopt;
    return line;
  }
  line.reason = cells[2];
  const bool reads =
      cells.size() == 4 && cells[1] == (line.reason.empty() ? "unresolved" : "refused");
  return reads ? std::optional(line) : std::nullopt;
}

}  // namespace

std::string to_journal(const CensusLine& line) {
  if (line.resolved) {
    return fmt::format("{}\t{}\t{}\t.", line.triangulation, line.own_metric ? "own" : "moved",
                       facts(line.entry));
  }
  std::string reason = line.reason;
  for (char& c : reason)
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  return fmt::format("{}\t{}\t{}\t.", line.triangulation, reason.empty() ? "unresolved" : "refused",
                     reason);
}

JournalText parse_journal(std::string_view text) {
  JournalText journal;
  std::size_t number = 1;
  for (std::size_t end; (end = text.find('\n', journal.complete)) != std::string_view::npos;
       ++number) {
    auto line = parse_journal_line(text.substr(journal.complete, end - journal.complete));
    if (!line) throw InvalidInput(fmt::format("line {} is not one of a census's journal", number));
    journal.lines.push_back(std::move(*line));
    journal.complete = end + 1;
  }
  if (journal.lines.empty() && !text.empty())
    throw InvalidInput("it has no complete line of a census's journal");
  return journal;
}

std::string to_tsv(const Census& census) {
  std::string text = fmt::format(
      "# Hyperbolic manifolds with geodesic boundary, by tripus census: {} manifolds, {} "
      "triangulations of them, {} unresolved.\n{}\n",
      census.manifolds.size(),
      [&] {
        std::size_t count = 0;
        for (const CensusEntry& entry : census.manifolds) count += entry.triangulations.size();
        return count;
      }(),
      census.unresolved.size(), kColumns);
  for (const CensusEntry& entry : census.manifolds) {
    text += fmt::format("{}\t{}\t{}\t{}\n", entry.name, entry.tetrahedra, facts(entry),
                        fmt::join(entry.triangulations, " "));
  }
  for (const std::string& triangulation : census.unresolved)
    text += fmt::format("{}{}\n", kUnresolved, triangulation);
  return text;
}

Census parse_tsv(std::string_view text) {
  Census census;
  std::size_t number = 0;
  bool header = false;
  for (std::string_view line : split(text, '\n')) {
    ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with(kUnresolved))
      census.unresolved.emplace_back(line.substr(kUnresolved.size()));
    if (line.empty() || line.front() == '#') continue;
    if (!header && line != kColumns) {
      throw InvalidInput(
          fmt::format("line {} of the census: expected the columns of a census", number));
    }
    if (!std::exchange(header, true)) continue;
    const auto cells = split(line, '\t');
    CensusEntry entry;
    if (cells.size() != kFacts + 3 || cells[0].empty() || has_control(cells) ||
        !parse_number(cells[1], entry.tetrahedra) ||
        !parse_facts(std::span(cells).subspan(2), entry)) {
      throw InvalidInput(fmt::format("line {} of the census: not {} columns with their numbers",
                                     number, kFacts + 3));
    }
    entry.name = cells[0];
    for (const std::string_view triangulation : split(cells[kFacts + 2], ' ')) {
      if (triangulation.empty())
        throw InvalidInput(fmt::format(
            "line {} of the census: its triangulations are not parted by single spaces", number));
      entry.triangulations.emplace_back(triangulation);
    }
    census.manifolds.push_back(std::move(entry));
  }
  if (!header) throw InvalidInput("the census has no line with the names of its columns");
  return census;
}

}  // namespace tripus::canonical
