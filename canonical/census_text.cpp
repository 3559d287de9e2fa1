// The census and its journal as text with tabs.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/checksum.hpp"
#include "base/error.hpp"
#include "canonical/census.hpp"
#include "canonical/detail/census_lines.hpp"
#include "structure/closed_bigon.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

constexpr std::string_view kColumns =
    "name\ttetrahedra\tboundary\tvolume\thomology\tcells\tkeeping\treversing\tsignature\t"
    "triangulations";

/// What a line of an unresolved triangulation begins with: a comment for other programs.
constexpr std::string_view kUnresolved = "# unresolved ";
/// What stands behind it where a surface is known that no hyperbolic manifold has.
constexpr std::string_view kNotHyperbolic = "\tnot hyperbolic: ";

/// The same of the line with the checksums of all others, in their order.
constexpr std::string_view kChecksums = "# checksums of the lines: ";
constexpr std::string_view kProvedBefore =
    "# All volumes are proved to half a unit of their last digit, which is digit ";
constexpr std::string_view kProvedAfter = " after the point.";
constexpr std::string_view kTitle =
    "# Hyperbolic manifolds with geodesic boundary, by tripus census: ";

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
constexpr std::size_t kVolumeColumn = 3;

std::string facts(const CensusEntry& entry, const std::string& volume) {
  return fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}", entry.boundary, volume, entry.homology,
                     entry.cells, entry.keeping, entry.reversing, entry.signature);
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

}  // namespace

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

std::string to_journal(const CensusLine& line) {
  if (line.resolved) {
    // All digits: a census that was interrupted must come out the same, byte for byte.
    return fmt::format("{}\t{}\t{}\t.", line.triangulation, line.own_metric ? "own" : "moved",
                       facts(line.entry, fmt::format("{}", line.entry.volume)));
  }
  std::string reason = line.reason;
  for (char& c : reason)
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  return fmt::format("{}\t{}\t{}\t.", line.triangulation, reason.empty() ? "unresolved" : "refused",
                     reason);
}

namespace detail {

std::string line_checksum(std::string_view line) { return checksum_text(line).substr(8); }

std::vector<std::string> census_lines(const Census& census, VolumeDigits digits) {
  std::vector<std::string> lines;
  for (const CensusEntry& entry : census.manifolds) {
    const std::string volume = digits == VolumeDigits::kAll ? fmt::format("{}", entry.volume)
                               : census.proved_digits > 0
                                   ? fmt::format("{:.{}f}", entry.volume, census.proved_digits)
                                   : fmt::format("{:.15g}", entry.volume);
    lines.push_back(fmt::format("{}\t{}\t{}\t{}", entry.name, entry.tetrahedra,
                                facts(entry, volume), fmt::join(entry.triangulations, " ")));
  }
  for (const std::string& triangulation : census.unresolved)
    lines.push_back(fmt::format("{}{}", kUnresolved, triangulation));
  return lines;
}

std::string surface_in(const std::string& isosig) {
  try {
    const auto bigon =
        structure::closed_bigon(topology::Triangulation(topology::decode_isosig(isosig)));
    if (bigon && bigon->decides()) return std::string(to_string(bigon->consequence));
  } catch (const InvalidInput&) {  // a census of another program's, or made by hand
  }
  return {};
}

std::string checksums_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : " ") + line_checksum(line);
  return text;
}

std::optional<std::size_t> first_damaged(const std::vector<std::string>& lines,
                                         std::string_view checksums) {
  const auto expected = split(checksums, ' ');
  if (expected.size() != std::max<std::size_t>(1, lines.size())) return lines.size();
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (expected[k] != line_checksum(lines[k])) return k;
  return std::nullopt;
}

}  // namespace detail

namespace {

/// "5160 manifolds, 6381 triangulations of them, 4915 unresolved."
std::string counts_of(const Census& census) {
  std::size_t triangulations = 0;
  for (const CensusEntry& entry : census.manifolds) triangulations += entry.triangulations.size();
  return fmt::format("{} manifolds, {} triangulations of them, {} unresolved.",
                     census.manifolds.size(), triangulations, census.unresolved.size());
}

/// One line with the columns of a census. Throws InvalidInput.
CensusEntry parse_entry(std::string_view line, std::size_t number) {
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
  return entry;
}

/// What the comment says of which digit is the last that is proved. Throws InvalidInput.
int proved_digits_of(std::string_view line, std::size_t number) {
  line.remove_prefix(kProvedBefore.size());
  int digits = 0;
  if (line.ends_with(kProvedAfter)) {
    line.remove_suffix(kProvedAfter.size());
    if (!parse_number(line, digits) || digits < 1 || digits > detail::kMostProvedDigits) digits = 0;
  }
  if (digits == 0)
    throw InvalidInput(fmt::format("line {} of the census: the proved digits are 1 to {}", number,
                                   detail::kMostProvedDigits));
  return digits;
}

/// A volume that is said to be proved has the digits that are. Throws InvalidInput.
void require_digits(std::string_view line, std::size_t number, int digits) {
  if (digits == 0) return;
  const std::string_view volume = split(line, '\t')[kVolumeColumn];
  const std::size_t point = volume.find('.');
  if (point == std::string_view::npos ||
      volume.size() - point - 1 != static_cast<std::size_t>(digits) ||
      volume.find_first_not_of("0123456789.") != std::string_view::npos)
    throw InvalidInput(
        fmt::format("line {} of the census: the volume {} has not the {} digits after the point "
                    "that are said to be proved",
                    number, quoted(std::string(volume)), digits));
}

/// What the comments of a table say of its lines.
struct Claims {
  std::optional<std::string> counts, checksums;
  std::vector<std::string> lines;  ///< what was found
  std::vector<std::size_t> numbers;
  bool ends_with_line_end = true;

  void compare(const Census& census) const {
    if (checksums) {
      if (const auto k = detail::first_damaged(lines, *checksums)) {
        if (*k < lines.size())
          throw InvalidInput(fmt::format(
              "line {} of the census is damaged: it has not the checksum it was written with",
              numbers[*k]));
        throw InvalidInput(fmt::format(
            "the census has {} lines of manifolds and unresolved triangulations, and not as many "
            "as it was written with: it is cut off or was changed",
            lines.size()));
      }
    }
    if (counts && !checksums && !ends_with_line_end)
      throw InvalidInput(
          fmt::format("line {} of the census, its last, is cut off", numbers.back()));
    if (counts && *counts != counts_of(census))
      throw InvalidInput(fmt::format("line 1 of the census says {} and there are {}",
                                     quoted(*counts, 100), quoted(counts_of(census), 100)));
  }
};

}  // namespace

std::string to_tsv(const Census& census) {
  auto lines = detail::census_lines(census, detail::VolumeDigits::kShown);
  for (std::size_t k = 0; k < census.unresolved.size(); ++k)
    if (const std::string surface = detail::surface_in(census.unresolved[k]); !surface.empty())
      lines[census.manifolds.size() + k] += std::string(kNotHyperbolic) + surface;
  std::string text = fmt::format("{}{}\n", kTitle, counts_of(census));
  if (census.proved_digits > 0)
    text += fmt::format("{}{}{}\n", kProvedBefore, census.proved_digits, kProvedAfter);
  text += fmt::format("{}\n", kColumns);
  for (const std::string& line : lines) text += line + '\n';
  return text + fmt::format("{}{}\n", kChecksums, detail::checksums_of(lines));
}

Census parse_tsv(std::string_view text) {
  Census census;
  Claims claims;
  std::size_t number = 0;
  bool header = false;
  const auto found = [&](std::string_view line) {
    claims.lines.emplace_back(line);
    claims.numbers.push_back(number);
  };
  for (std::string_view line : split(text, '\n')) {
    ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with(kTitle)) claims.counts = line.substr(kTitle.size());
    if (line.starts_with(kProvedBefore)) census.proved_digits = proved_digits_of(line, number);
    if (line.starts_with(kChecksums)) claims.checksums = line.substr(kChecksums.size());
    if (line.starts_with(kUnresolved)) {
      const std::string_view signature = line.substr(kUnresolved.size());
      census.unresolved.emplace_back(signature.substr(0, signature.find('\t')));
      found(line);
    }
    if (line.empty() || line.front() == '#') continue;
    if (!header && line != kColumns) {
      throw InvalidInput(
          fmt::format("line {} of the census: expected the columns of a census", number));
    }
    if (!std::exchange(header, true)) continue;
    found(line);
    census.manifolds.push_back(parse_entry(line, number));
    require_digits(line, number, census.proved_digits);
  }
  if (!header) throw InvalidInput("the census has no line with the names of its columns");
  claims.ends_with_line_end = text.ends_with('\n') || claims.lines.empty();
  claims.compare(census);
  return census;
}

}  // namespace tripus::canonical
