#include "topology/diagrams/tables.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "topology/detail/text.hpp"
#include "topology/diagrams/detail/shipped_tables.hpp"
#include "topology/diagrams/read_diagram.hpp"

namespace tripus::topology {
namespace {

constexpr std::array<std::string_view, 4> kNames{"knots", "links", "theta-curves",
                                                 "handlebody-knots"};

using Table = std::vector<TabledDiagram>;

Table parse(std::string_view text) {
  Table table;
  bool header = true;
  while (!text.empty()) {
    const std::string_view line = detail::take_line(text);
    if (line.empty() || line[0] == '#') continue;
    if (std::exchange(header, false)) continue;
    const std::size_t first = line.find('\t'), second = line.find('\t', first + 1);
    if (second == std::string_view::npos)
      throw InternalError("a table of diagrams has a broken line: " + std::string(line));
    TabledDiagram entry;
    entry.name = line.substr(0, first);
    entry.diagram = read_diagram(line.substr(second + 1)).diagram;
    entry.crossings = entry.diagram.crossing_count();
    table.push_back(std::move(entry));
  }
  return table;
}

const std::array<Table, 4>& tables() {
  static const std::array<Table, 4> kTables = [] {
    std::array<Table, 4> all;
    for (const DiagramTable table : kDiagramTables)
      all[static_cast<std::size_t>(table)] = parse(detail::shipped_table_text(table));
    return all;
  }();
  return kTables;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Small letters and digits alone; a number in front of "theta" for Moriuchi's T and H.
std::string normalized(std::string_view name) {
  std::string text;
  bool gap = false;  // an underscore keeps its numbers apart
  for (const char c : detail::trimmed(name)) {
    if (c == ' ' || c == '_' || c == '-') {
      gap = true;
      continue;
    }
    if (gap && !text.empty() && is_digit(text.back()) && is_digit(c)) text += '_';
    gap = false;
    text += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  for (const auto& [letter, word] : {std::pair('t', "theta"), std::pair('h', "handcuff")})
    if (text.size() > 1 && text[0] == letter && is_digit(text[1])) return text.substr(1) + word;
  if (text.ends_with("thetacurve")) text.resize(text.size() - 5);
  return text;
}

const std::map<std::string, const TabledDiagram*, std::less<>>& by_name() {
  static const auto kMap = [] {
    std::map<std::string, const TabledDiagram*, std::less<>> map;
    for (const Table& table : tables())
      for (const TabledDiagram& entry : table) map.emplace(normalized(entry.name), &entry);
    return map;
  }();
  return kMap;
}

/// Number of letters to change, put in or take away.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

/// The letters of a name, digits left out: "hk_", "_theta".
std::string shape(std::string_view normalized_name) {
  std::string text;
  for (const char c : normalized_name)
    if (!is_digit(c)) text += c;
  return text;
}

}  // namespace

std::string_view table_name(DiagramTable table) { return kNames[static_cast<std::size_t>(table)]; }

std::optional<DiagramTable> find_table(std::string_view name) {
  for (const DiagramTable table : kDiagramTables)
    if (table_name(table) == name) return table;
  return std::nullopt;
}

std::span<const TabledDiagram> table_of(DiagramTable table) {
  return tables()[static_cast<std::size_t>(table)];
}

const TabledDiagram* find_diagram(std::string_view name) {
  const auto& map = by_name();
  const auto found = map.find(normalized(name));
  return found == map.end() ? nullptr : found->second;
}

bool is_diagram_name(std::string_view text) {
  const std::string name = normalized(text);
  constexpr std::array<std::string_view, 6> kShapes{"_", "la", "ln", "_theta", "_handcuff", "hk_"};
  return std::ranges::find(kShapes, shape(name)) != kShapes.end() &&
         std::ranges::any_of(name, is_digit) && (name[0] != '_' && name.back() != '_');
}

std::string nearest_diagram_names(std::string_view name, std::size_t count) {
  const std::string wanted = normalized(name);
  std::vector<std::pair<std::size_t, const TabledDiagram*>> ranked;
  for (const Table& table : tables())
    for (const TabledDiagram& entry : table) {
      const std::string other = normalized(entry.name);
      const std::size_t kind = shape(other) == shape(wanted) ? 0 : 3;
      ranked.emplace_back(kind + edit_distance(wanted, other), &entry);
    }
  std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, const TabledDiagram*>::first);
  std::string names;
  for (std::size_t i = 0; i < std::min(count, ranked.size()); ++i)
    names += (i == 0 ? "" : ", ") + ranked[i].second->name;
  return names;
}

}  // namespace tripus::topology
