// Gauss codes of knots and links, with the signs of the crossings or without.
#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "topology/diagrams/detail/forms.hpp"
#include "topology/diagrams/detail/scanner.hpp"

// Along each component the crossings are named, with a plus sign where the strand passes above and
// a minus sign where it passes below. Written so by KnotTheory, SageMath and appcontour; what
// virtual knots are written in, O1-U2-..., has the signs of the crossings too.

namespace tripus::topology::detail {
namespace {

struct Passage {
  std::int64_t crossing;
  bool above;
};
struct GaussCode {
  std::vector<std::vector<Passage>> components;
  std::map<std::int64_t, int> signs;  ///< of the crossings; empty: not said
};

/// O1-U2-O3-U1-...: over or under, crossing, its sign.
GaussCode from_letters(DiagramScanner& scan) {
  GaussCode code;
  code.components.emplace_back();
  while (!scan.at_end()) {
    if (scan.take(',')) continue;
    if (scan.take('/') || scan.take(';') || scan.take('|')) {
      code.components.emplace_back();
      continue;
    }
    const std::size_t at = scan.position();
    const char letter = scan.take_any();
    const bool above = letter == 'O' || letter == 'o';
    if ((!above && letter != 'U' && letter != 'u') || !is_digit(scan.peek_raw()))
      scan.fail("expected O or U, a crossing and its sign, as in O1+U2+", at);
    const std::int64_t crossing = scan.integer();
    const char sign = scan.peek_raw();
    if (sign != '+' && sign != '-') scan.fail("expected the sign of the crossing" + scan.found());
    scan.take_any();
    const auto [known, fresh] = code.signs.emplace(crossing, sign == '+' ? 1 : -1);
    if (!fresh && known->second != (sign == '+' ? 1 : -1))
      scan.fail("crossing " + std::to_string(crossing) + " has both signs", at);
    code.components.back().push_back({crossing, above});
  }
  return code;
}

/// Lists of numbers, by the bracket in which they stand.
struct Lists {
  std::vector<std::vector<std::int64_t>> all;
  std::vector<std::size_t> depth;
};

Lists read_lists(DiagramScanner& scan) {
  Lists lists;
  Brackets brackets;
  bool fresh = true;
  while (!scan.at_end()) {
    const char c = scan.peek();
    if (is_opening(c)) {
      brackets.open(scan);
      fresh = true;
      if (is_closing(scan.peek())) {  // a circle that meets nothing
        lists.all.emplace_back();
        lists.depth.push_back(brackets.depth());
      }
    } else if (is_closing(c)) {
      brackets.close(scan);
      fresh = true;
    } else if (c == '/' || c == ';' || c == '|') {
      scan.take_any();
      fresh = true;
    } else if (scan.at_number()) {
      if (fresh) {
        lists.all.emplace_back();
        lists.depth.push_back(brackets.depth());
      }
      fresh = false;
      const std::size_t at = scan.position();
      lists.all.back().push_back(scan.integer());
      if (lists.all.back().back() == 0 || lists.all.back().back() == INT64_MIN)
        scan.fail("the crossing 0 has no sign for above or below; number them from 1 on", at);
    } else if (!scan.take(',')) {
      scan.fail("expected the numbers of a Gauss code, such as 1 -2 3 -1 2 -3" + scan.found());
    }
  }
  brackets.require_closed(scan);
  return lists;
}

/// SageMath's [[[-1,2,...]], [1,1,...]]: the last list stands one bracket further out, and has the
/// signs of the crossings in the order of their numbers.
GaussCode from_lists(Lists lists) {
  GaussCode code;
  std::optional<std::vector<std::int64_t>> signs;
  if (lists.all.size() > 1 && lists.depth.back() + 1 == lists.depth.front()) {
    signs = std::move(lists.all.back());
    lists.all.pop_back();
  }
  std::map<std::int64_t, int> numbers;
  for (const auto& list : lists.all) {
    code.components.emplace_back();
    for (const std::int64_t entry : list) {
      code.components.back().push_back({std::abs(entry), entry > 0});
      numbers.emplace(std::abs(entry), 0);
    }
  }
  if (!signs) return code;
  if (signs->size() != numbers.size())
    throw InvalidInput("the Gauss code has " + std::to_string(numbers.size()) + " crossings and " +
                       std::to_string(signs->size()) + " signs");
  std::size_t next = 0;
  for (auto& [crossing, sign] : numbers) {
    const std::int64_t value = (*signs)[next++];
    if (value != 1 && value != -1)
      throw InvalidInput("the sign " + std::to_string(value) + " of crossing " +
                         std::to_string(crossing) + " is neither 1 nor -1");
    sign = static_cast<int>(value);
  }
  code.signs = std::move(numbers);
  return code;
}

GaussCode parse_gauss(std::string_view text) {
  DiagramScanner scan(text);
  const std::string_view word = scan.letters();
  if (DiagramScanner::same_word(word, "Gauss")) (void)scan.take_whole_word("code");
  if (word.size() == 1) scan.go_to(0);  // O1+U2+...
  scan.take(':');
  scan.take('=');
  if (scan.at_end()) throw InvalidInput("the Gauss code is empty; write Gauss: 1 -2 3 -1 2 -3");
  return DiagramScanner::is_letter(scan.peek()) ? from_letters(scan) : from_lists(read_lists(scan));
}

/// The positions, and for each crossing its name.
Positions positions_of(const GaussCode& code, std::vector<std::int64_t>& names) {
  Positions p;
  std::map<std::int64_t, std::vector<std::size_t>> places;
  for (const auto& component : code.components) {
    const std::size_t first = p.following.size();
    for (const Passage& passage : component) {
      places[passage.crossing].push_back(p.following.size());
      p.following.push_back(p.following.size() + 1);
      p.above.push_back(passage.above);
    }
    if (!component.empty()) p.following.back() = first;
  }
  for (const auto& [crossing, at] : places) {
    const std::string name = "crossing " + std::to_string(crossing) + " of the Gauss code";
    if (at.size() != 2)
      throw InvalidInput(
          name + " is named " +
          (at.size() == 1 ? std::string("once") : std::to_string(at.size()) + " times") +
          "; every crossing is passed twice, as " + std::to_string(crossing) + " and as -" +
          std::to_string(crossing));
    if (p.above[at[0]] == p.above[at[1]])
      throw InvalidInput(name + " is passed twice " + (p.above[at[0]] ? "above" : "below") +
                         "; one of the two is -" + std::to_string(crossing) + ", below");
    p.crossings.emplace_back(at[0], at[1]);
    names.push_back(crossing);
  }
  return p;
}

}  // namespace

// A crossing is positive if the direction of the strand above, turned counterclockwise, becomes
// that of the strand below: then the one below comes in right behind the one above.
NamedDiagram read_gauss_code(std::string_view text) {
  const GaussCode code = parse_gauss(text);
  std::vector<std::int64_t> names;
  const Positions p = positions_of(code, names);
  NamedDiagram result;
  std::vector<bool> behind;
  if (code.signs.empty()) {
    behind = planar_choice(p);
    result.orientation_known = p.crossings.empty();
    if (!p.crossings.empty())
      result.notes.emplace_back(
          "a Gauss code without the signs of its crossings leaves open which of two mirror images "
          "is meant, of a connected sum for each summand; one was taken");
  } else {
    for (std::size_t c = 0; c < names.size(); ++c)
      behind.push_back((code.signs.at(names[c]) > 0) == p.above[p.crossings[c].first]);
  }
  std::vector<DiagramNode> nodes = nodes_of(p, behind);
  for (std::size_t c = 0; c < nodes.size(); ++c)
    nodes[c].place = "crossing " + std::to_string(names[c]) + " of the Gauss code";
  auto name = static_cast<std::int64_t>(p.following.size());
  for (const auto& component : code.components)
    if (component.empty()) {
      ++name;
      nodes.push_back({NodeKind::kVertex, {name, name}});
    }
  result.diagram = Diagram(nodes);
  return result;
}

}  // namespace tripus::topology::detail
