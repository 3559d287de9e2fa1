#include "topology/diagrams/tables.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
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

/// A line of a table as it is shipped: reading all diagrams takes longer than solving one.
struct Row {
  std::string_view name;
  std::string_view code;
};

std::vector<Row> rows_in(std::string_view text) {
  std::vector<Row> rows;
  bool header = true;
  while (!text.empty()) {
    const std::string_view line = detail::take_line(text);
    if (line.empty() || line[0] == '#') continue;
    if (std::exchange(header, false)) continue;
    const std::size_t first = line.find('\t'), second = line.find('\t', first + 1);
    if (second == std::string_view::npos)
      throw InternalError("a table of diagrams has a broken line: " + std::string(line));
    rows.push_back({line.substr(0, first), line.substr(second + 1)});
  }
  return rows;
}

const std::vector<Row>& rows_of(DiagramTable table) {
  static const std::array<std::vector<Row>, 4> kRows = [] {
    std::array<std::vector<Row>, 4> all;
    for (const DiagramTable each : kDiagramTables)
      all[static_cast<std::size_t>(each)] = rows_in(detail::shipped_table_text(each));
    return all;
  }();
  return kRows[static_cast<std::size_t>(table)];
}

Table read_table(DiagramTable table) {
  Table diagrams;
  for (const Row& row : rows_of(table)) {
    TabledDiagram& entry = diagrams.emplace_back();
    entry.name = row.name;
    entry.diagram = read_diagram(row.code).diagram;
    entry.crossings = entry.diagram.crossing_count();
  }
  return diagrams;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// What people call the most famous ones, normalized.
constexpr std::array<std::pair<std::string_view, std::string_view>, 16> kNicknames{{
    {"unknot", "0_1"},
    {"trefoil", "3_1"},
    {"trefoilknot", "3_1"},
    {"figureeight", "4_1"},
    {"figureeightknot", "4_1"},
    {"figure8", "4_1"},
    {"figure8knot", "4_1"},
    {"cinquefoil", "5_1"},
    {"cinquefoilknot", "5_1"},
    {"stevedoreknot", "6_1"},
    {"hopflink", "l2a1"},
    {"whiteheadlink", "l5a1"},
    {"borromeanrings", "l6a4"},
    {"kinoshitatheta", "5_1theta"},
    {"trivialtheta", "0_1theta"},
    {"trivialhandcuff", "0_1handcuff"},
}};

/// Small letters, digits and signs; an underscore only where it keeps numbers apart.
std::string squeezed(std::string_view name) {
  std::string text;
  bool gap = false;
  int braces = 0;  // LinkInfo's L5a1{0}: the orientations of the components
  for (const char c : detail::trimmed(name)) {
    braces += c == '{' ? 1 : 0;
    if (braces > 0) {
      braces -= c == '}' ? 1 : 0;
      continue;
    }
    if (c == ' ' || c == '_' || c == '-') {
      gap = true;
      continue;
    }
    if (gap && !text.empty() && is_digit(text.back()) && is_digit(c)) text += '_';
    gap = false;
    text += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return braces == 0 ? text : std::string(name);
}

/// The kind behind the number, also for Moriuchi's T and H; nicknames as what they stand for.
std::string as_in_tables(std::string text) {
  for (const auto& [nickname, known] : kNicknames)
    if (text == nickname) return std::string(known);
  if (text.ends_with("thetacurve")) text.resize(text.size() - 5);
  if (text.ends_with("handcuffgraph")) text.resize(text.size() - 5);
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kKinds{
      {{"t", "theta"},
       {"h", "handcuff"},
       {"theta", "theta"},
       {"thetacurve", "theta"},
       {"handcuff", "handcuff"},
       {"handcuffgraph", "handcuff"}}};
  for (const auto& [before, behind] : kKinds)
    if (text.starts_with(before) && text.size() > before.size() && is_digit(text[before.size()]))
      return text.substr(before.size()) + std::string(behind);
  return text;
}

/// Takes away what says "the mirror image of", once; false if nothing does.
bool take_mirror(std::string& text) {
  for (const std::string_view before : {"mirrorimage(", "mirror(", "m("})
    if (text.starts_with(before) && text.ends_with(')')) {
      text = text.substr(before.size(), text.size() - before.size() - 1);
      return true;
    }
  for (const std::string_view before : {"mirrorimageof", "mirrorof", "mirrorimage", "mirror"})
    if (text.starts_with(before) && text.size() > before.size()) {
      text.erase(0, before.size());
      return true;
    }
  for (const std::string_view behind : {"mirrorimage", "mirror", "(m)", "*", "m"}) {
    // "5_1m theta" and "5_1 theta m".
    for (const std::string_view kind : {"", "theta", "handcuff", "thetacurve", "handcuffgraph"}) {
      const std::string end = std::string(behind) + std::string(kind);
      if (!text.ends_with(end) || text.size() == end.size()) continue;
      text.replace(text.size() - end.size(), end.size(), kind);
      return true;
    }
  }
  return false;
}

/// A name as in the tables, and whether it means the mirror image.
struct WantedName {
  std::string name;
  bool mirrored = false;
};
WantedName wanted_name(std::string_view name) {
  WantedName wanted{squeezed(name)};
  while (take_mirror(wanted.name)) wanted.mirrored = !wanted.mirrored;
  wanted.name = as_in_tables(std::move(wanted.name));
  return wanted;
}

/// Without regard to mirror images.
std::string normalized(std::string_view name) { return as_in_tables(squeezed(name)); }

/// Where a name stands.
struct Place {
  DiagramTable table;
  std::size_t index;
};

const std::map<std::string, Place, std::less<>>& by_name() {
  static const auto kMap = [] {
    std::map<std::string, Place, std::less<>> map;
    for (const DiagramTable table : kDiagramTables)
      for (std::size_t i = 0; i < rows_of(table).size(); ++i)
        map.emplace(normalized(rows_of(table)[i].name), Place{table, i});
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

/// Names of other tables, as names of these: K4a1 and 4a1 (Hoste and Thistlethwaite) are knots,
/// 4^2_1 (Rolfsen) links.
std::string as_known_shape(std::string name) {
  const std::string kind = shape(name);
  if (kind == "knot_") return name.substr(name.find('t') + 1);
  if (kind == "ka" || kind == "kn" || kind == "a" || kind == "n") {
    if (name[0] == 'k') name.erase(0, 1);
    const std::size_t letter = name.find_first_of("an");
    return name.substr(0, letter) + "_" + name.substr(letter + 1);
  }
  if (const std::size_t power = name.find('^'); power != std::string::npos && kind == "^_")
    return "l" + name.substr(0, power) + "a" + name.substr(name.find('_') + 1);
  return name;
}

/// A name that is not in the tables, in the form in which to look for near ones: of Knot[8,19]
/// (KnotTheory) 8_19.
std::string unknown_name(std::string_view given) {
  std::string spread(given);
  for (char& c : spread)
    if (std::string_view("[],;:!?'\"").find(c) != std::string_view::npos) c = ' ';
  return as_known_shape(wanted_name(spread).name);
}

}  // namespace

std::string_view table_name(DiagramTable table) { return kNames[static_cast<std::size_t>(table)]; }

std::optional<DiagramTable> find_table(std::string_view name) {
  for (const DiagramTable table : kDiagramTables)
    if (table_name(table) == name) return table;
  return std::nullopt;
}

std::span<const TabledDiagram> table_of(DiagramTable table) {
  static std::array<std::once_flag, 4> read;
  static std::array<Table, 4> diagrams;
  const auto number = static_cast<std::size_t>(table);
  std::call_once(read[number], [&] { diagrams[number] = read_table(table); });
  return diagrams[number];
}

const TabledDiagram* find_diagram(std::string_view name) {
  const auto& map = by_name();
  const auto found = map.find(normalized(name));
  if (found == map.end()) return nullptr;
  return &table_of(found->second.table)[found->second.index];
}

WantedDiagram find_diagram_up_to_mirror(std::string_view name) {
  if (const TabledDiagram* entry = find_diagram(name)) return {entry, false};
  const WantedName wanted = wanted_name(name);
  return {find_diagram(wanted.name), wanted.mirrored};
}

std::optional<NamedDiagram> find_diagram_or_mirror(std::string_view name) {
  const auto [entry, mirrored] = find_diagram_up_to_mirror(name);
  if (entry == nullptr) return std::nullopt;
  if (!mirrored) return NamedDiagram{.name = entry->name, .diagram = entry->diagram};
  return NamedDiagram{.name = "m(" + entry->name + ")", .diagram = entry->diagram.mirror_image()};
}

bool is_diagram_name(std::string_view text) {
  const std::string name = unknown_name(text);
  constexpr std::array<std::string_view, 6> kShapes{"_", "la", "ln", "_theta", "_handcuff", "hk_"};
  return std::ranges::find(kShapes, shape(name)) != kShapes.end() &&
         std::ranges::any_of(name, is_digit) && (name[0] != '_' && name.back() != '_');
}

bool is_nearly_diagram_name(std::string_view text) {
  constexpr std::size_t kLongest = 40;  // longer ones are near no name
  if (text.size() > kLongest) return false;
  const std::string name = unknown_name(text);
  return std::ranges::any_of(by_name(), [&](const auto& known) {
    const std::size_t changes = edit_distance(name, known.first);
    return changes <= 2 && 2 * changes < known.first.size();
  });
}

std::string nearest_diagram_names(std::string_view name, std::size_t count) {
  const std::string wanted = unknown_name(name);
  const auto crossings = [](std::string_view text) {
    const std::size_t from = std::min(text.find_first_of("0123456789"), text.size());
    return text.substr(from, text.find_first_not_of("0123456789", from) - from);
  };
  std::vector<std::pair<std::size_t, std::string_view>> ranked;
  for (const DiagramTable table : kDiagramTables)
    for (const Row& row : rows_of(table)) {
      const std::string other = normalized(row.name);
      const std::size_t kind = shape(other) == shape(wanted) ? 0 : 3;
      const std::size_t number = crossings(other) == crossings(wanted) ? 0 : 2;
      ranked.emplace_back(kind + number + edit_distance(wanted, other), row.name);
    }
  std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, std::string_view>::first);
  std::string names;
  for (std::size_t i = 0; i < std::min(count, ranked.size()); ++i)
    names.append(i == 0 ? "" : ", ").append(ranked[i].second);
  return names;
}

}  // namespace tripus::topology
