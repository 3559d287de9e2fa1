// Dowker-Thistlethwaite codes of knots and links.
#include <algorithm>
#include <cstdlib>
#include <string>

#include "topology/diagrams/detail/forms.hpp"
#include "topology/diagrams/detail/scanner.hpp"

// Positions 1, 2, ... run along the components; crossing i has the odd position 2 i - 1 and the
// even one |code_i|, which passes above if the entry is negative. (All signs changed: the mirror
// image, which a code leaves open anyhow.)

namespace tripus::topology::detail {
namespace {

struct DtCode {
  std::vector<std::vector<std::int64_t>> components;
};

/// SnapPy's letters: crossings, components, entries in each, then the entries, b = 4, B = -4.
DtCode from_letters(std::string_view letters, const DiagramScanner& scan) {
  std::vector<std::int64_t> values;
  for (const char c : letters) values.push_back(c >= 'a' ? c - 'a' + 1 : -(c - 'A' + 1));
  std::size_t next = 2;
  DtCode code;
  const bool counts = values.size() >= 3 && values[0] > 0 && values[1] > 0;
  if (counts)
    for (std::int64_t k = 0; k < values[1] && next < values.size(); ++k)
      code.components.emplace_back(
          static_cast<std::size_t>(std::max<std::int64_t>(values[next++], 0)));
  for (auto& component : code.components)
    for (auto& entry : component)
      if (next < values.size()) entry = 2 * values[next++];
  std::size_t entries = 0;
  for (const auto& component : code.components) entries += component.size();
  if (!counts || entries != static_cast<std::size_t>(values[0]) ||
      values.size() != 2 + code.components.size() + entries)
    scan.fail(
        "the letters are no DT code: they count crossings, components and the entries of "
        "each, then give the entries, as in DT[cacbca] for the trefoil");
  return code;
}

DtCode parse_dt(std::string_view text) {
  DiagramScanner scan(text);
  scan.letters();  // DT, DTCode, or nothing
  scan.take(':');
  scan.take('=');
  Brackets brackets;
  DtCode code;
  bool fresh = true;
  while (!scan.at_end()) {
    const char c = scan.peek();
    if (is_opening(c)) {
      brackets.open(scan);
      fresh = true;
    } else if (is_closing(c)) {
      brackets.close(scan);
      fresh = true;
    } else if (DiagramScanner::is_letter(c)) {
      if (!code.components.empty()) scan.fail("letters and numbers are mixed");
      code = from_letters(scan.letters(), scan);
      if (scan.take('.')) (void)scan.until("])}");
    } else if (scan.at_number()) {
      if (fresh || code.components.empty()) code.components.emplace_back();
      fresh = false;
      code.components.back().push_back(scan.integer());
    } else if (!scan.take(',')) {
      scan.fail("expected the even numbers of a DT code" + scan.found());
    }
  }
  brackets.require_closed(scan);
  return code;
}

/// Crossing c has the positions 2 c and one that is odd, counted from 0.
Positions positions_of(const DtCode& code) {
  std::vector<std::int64_t> entries;
  Positions p;
  for (const auto& component : code.components) {
    const std::size_t first = p.following.size();
    for (std::size_t i = 0; i < 2 * component.size(); ++i) p.following.push_back(first + i + 1);
    if (!component.empty()) p.following.back() = first;
    entries.insert(entries.end(), component.begin(), component.end());
  }
  if (entries.empty()) throw InvalidInput("the DT code is empty; write DT: 4 6 8 2");
  const std::size_t count = 2 * entries.size();
  std::vector<bool> taken(count, false);
  p.above.assign(count, false);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string entry = "entry " + std::to_string(entries[i]) + " of the DT code";
    if (entries[i] % 2 != 0 || entries[i] == 0 || entries[i] > static_cast<std::int64_t>(count) ||
        entries[i] < -static_cast<std::int64_t>(count))
      throw InvalidInput(entry + ": expected the even numbers from 2 to " + std::to_string(count) +
                         ", each once, with signs");
    const auto even = static_cast<std::size_t>(std::abs(entries[i]));
    if (taken[even - 1]) throw InvalidInput(entry + " comes twice; each even number comes once");
    taken[even - 1] = true;
    p.crossings.emplace_back(2 * i, even - 1);
    p.above[entries[i] < 0 ? even - 1 : 2 * i] = true;
  }
  return p;
}

}  // namespace

NamedDiagram read_dt_code(std::string_view text) {
  const Positions p = positions_of(parse_dt(text));
  NamedDiagram result;
  result.diagram = Diagram(nodes_of(p, planar_choice(p)));
  result.orientation_known = false;
  result.notes.emplace_back(
      "a DT code leaves open which of two mirror images is meant, of a connected sum for each "
      "summand; one was taken");
  return result;
}

}  // namespace tripus::topology::detail
