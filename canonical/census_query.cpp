// Looking things up in a census: what a query means, and what is not one.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "canonical/census.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

constexpr int kLargestGenus = 1'000'000;

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Parts between separators, in lower case, without white space at their ends.
std::vector<std::string> parts_of(std::string_view text, std::string_view separators) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (separators.find(c) != std::string_view::npos) {
      parts.emplace_back();
    } else if (c != ' ' || !parts.back().empty()) {
      parts.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  for (std::string& part : parts)
    while (!part.empty() && part.back() == ' ') part.pop_back();
  return parts;
}

bool take_word(std::string& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.erase(0, word.size());
  while (text.starts_with(' ')) text.erase(0, 1);
  return true;
}

/// "tetrahedra" and "tetrahedron" are one word, so are "pyramids" and "pyramid".
std::string singular(std::string word) {
  if (word.ends_with("hedra")) return word.substr(0, word.size() - 1) + "on";
  if (word.size() > 1 && word.back() == 's') word.pop_back();
  return word;
}

/// "2 tetrahedra + 1 pyramid" as pieces with their numbers, in any order.
std::multiset<std::pair<std::string, std::size_t>> cells_of(std::string_view text) {
  std::multiset<std::pair<std::string, std::size_t>> cells;
  for (std::string part : parts_of(text, "+,")) {
    std::size_t digits = 0;
    while (digits < part.size() && part[digits] >= '0' && part[digits] <= '9') ++digits;
    const auto count = digits == 0 ? std::size_t{1} : whole_number(part.substr(0, digits));
    part.erase(0, digits);
    while (part.starts_with(' ')) part.erase(0, 1);
    part = singular(part);
    if (!count || *count == 0 || !is_cell_type_name(part)) {
      throw InvalidInput(quoted(std::string(text)) +
                         " are no cells; write them as \"1 octahedron\" or \"2 tetrahedra + 1 "
                         "pyramid\"; the names are " +
                         known_cell_names());
    }
    cells.emplace(part, *count);
  }
  return cells;
}

}  // namespace

std::string to_string(BoundaryComponents boundary) {
  std::ranges::sort(boundary.genera);
  std::ranges::sort(boundary.crosscaps);
  std::vector<std::string> names;
  for (const std::size_t genus : boundary.genera) names.push_back(fmt::format("g{}", genus));
  for (const std::size_t genus : boundary.crosscaps) names.push_back(fmt::format("n{}", genus));
  names.insert(names.end(), boundary.tori, "T");
  names.insert(names.end(), boundary.klein_bottles, "K");
  return fmt::format("{}", fmt::join(names, "+"));
}

std::string parse_boundary(std::string_view text) {
  BoundaryComponents boundary;
  for (std::string part : parts_of(text, "+,")) {
    if (part == "t" || part == "torus") {
      ++boundary.tori;
      continue;
    }
    if (part == "k" || part == "klein bottle") {
      ++boundary.klein_bottles;
      continue;
    }
    const bool is_orientable = !take_word(part, "n");
    if (is_orientable && !take_word(part, "genus")) take_word(part, "g");
    const auto genus = whole_number(part);
    if (!genus || *genus < (is_orientable ? 2 : 3) || *genus > kLargestGenus) {
      throw InvalidInput(quoted(std::string(text)) +
                         " is no boundary; write the genera of its components, 2 or more, as g2 or "
                         "g2+g3, of non-orientable ones as n3, and cusps as T (torus) or K (Klein "
                         "bottle): g2+T");
    }
    (is_orientable ? boundary.genera : boundary.crosscaps).push_back(*genus);
  }
  return to_string(std::move(boundary));
}

void require_cells(std::string_view text) { (void)cells_of(text); }

bool is_census_name(std::string_view text) {
  const auto number = [&] {
    const std::size_t before = text.size();
    while (!text.empty() && text.front() >= '0' && text.front() <= '9') text.remove_prefix(1);
    return text.size() < before;
  };
  const auto letter = [&](char c) {
    if (!text.starts_with(c)) return false;
    text.remove_prefix(1);
    return true;
  };
  if (!letter('t') || !number()) return false;
  do {
    if (letter('T') || letter('K')) continue;
    if ((!letter('g') && !letter('n')) || !number()) return false;
  } while (letter('+'));
  return letter('.') && number() && text.empty();
}

const CensusEntry* Census::find(std::string_view text) const {
  const std::string_view unsigned_text = topology::without_sign(text);
  const auto found = std::ranges::find_if(manifolds, [&](const CensusEntry& entry) {
    return entry.signature == unsigned_text || entry.name == text ||
           std::ranges::find(entry.triangulations, unsigned_text) != entry.triangulations.end();
  });
  return found == manifolds.end() ? nullptr : &*found;
}

std::vector<const CensusEntry*> select(const Census& census, const CensusQuery& query) {
  if (!(query.least_volume <= query.greatest_volume)) {
    throw InvalidInput(
        fmt::format("there is no volume from {} to {}", query.least_volume, query.greatest_volume));
  }
  const std::string boundary = query.boundary.empty() ? "" : parse_boundary(query.boundary);
  const std::string homology =
      query.homology.empty() ? ""
                             : topology::to_string(topology::parse_abelian_group(query.homology));
  std::multiset<std::pair<std::string, std::size_t>> cells;
  if (!query.cells.empty()) cells = cells_of(query.cells);
  std::vector<const CensusEntry*> result;
  for (const CensusEntry& entry : census.manifolds) {
    const bool fits = entry.volume >= query.least_volume && entry.volume <= query.greatest_volume &&
                      (boundary.empty() || entry.boundary == boundary) &&
                      (homology.empty() || entry.homology == homology) &&
                      (cells.empty() || cells_of(entry.cells) == cells) &&
                      (!query.tetrahedra || entry.tetrahedra == *query.tetrahedra);
    if (fits) result.push_back(&entry);
  }
  return result;
}

std::string describe(const Census& census) {
  std::set<std::string> boundaries, cells;
  std::set<std::size_t> tetrahedra;
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (const CensusEntry& entry : census.manifolds) {
    boundaries.insert(entry.boundary);
    cells.insert(entry.cells);
    tetrahedra.insert(entry.tetrahedra);
    least = std::min(least, entry.volume);
    greatest = std::max(greatest, entry.volume);
  }
  if (census.manifolds.empty()) return "the census is empty";
  return fmt::format(
      "the census has {} manifolds with {} tetrahedra, boundary {}, volumes from {:.6g} to {:.6g}, "
      "cells {}",
      census.manifolds.size(), fmt::join(tetrahedra, ", "), fmt::join(boundaries, ", "), least,
      greatest, fmt::join(cells, ", "));
}

}  // namespace tripus::canonical
