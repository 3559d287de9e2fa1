// Closed braids.
#include <algorithm>

#include "topology/diagrams/detail/forms.hpp"
#include "topology/diagrams/detail/scanner.hpp"

namespace tripus::topology::detail {
namespace {

/// More strands than that no one writes by hand; it bounds what a short text makes.
constexpr std::int64_t kMostStrands = 100'000;

}  // namespace

// The strands run upwards. At a positive crossing the strand from the lower left passes above.
NamedDiagram read_braid(std::string_view text) {
  Scanner scan(text);
  scan.letters();
  scan.take(':');
  std::vector<std::int64_t> letters;
  std::int64_t strands = 1;
  char last_open = '\0';
  while (!scan.at_end()) {
    const char c = scan.peek();
    if (c == ',' || is_opening(c)) {
      if (is_opening(c)) last_open = c;
      scan.take_any();
      continue;
    }
    if (is_closing(c)) {
      if (last_open == '\0') scan.fail("this bracket closes nothing that is open");
      scan.take_any();
      continue;
    }
    const std::size_t at = scan.position();
    const std::int64_t letter = scan.integer();
    if (letter == 0 || std::abs(letter) >= kMostStrands)
      scan.fail("the letter " + std::to_string(letter) +
                    " is no generator; write 1, -1, 2, -2, ... for crossings of neighbours",
                at);
    letters.push_back(letter);
    strands = std::max(strands, std::abs(letter) + 1);
  }
  if (letters.empty()) scan.fail("the braid has no letters; write Braid: 1 -2 1 -2");
  std::vector<std::int64_t> at(static_cast<std::size_t>(strands));
  std::vector<std::vector<std::size_t>> uses(at.size());
  for (std::size_t i = 0; i < letters.size(); ++i)
    for (const std::int64_t s : {std::abs(letters[i]) - 1, std::abs(letters[i])})
      uses[static_cast<std::size_t>(s)].push_back(i);
  std::vector<DiagramNode> nodes(letters.size());
  std::int64_t fresh = 0;
  for (std::int64_t& arc : at) arc = ++fresh;
  const std::vector<std::int64_t> bottom = at;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const auto left = static_cast<std::size_t>(std::abs(letters[i]) - 1);
    const auto up = [&](std::size_t s) { return uses[s].back() == i ? bottom[s] : ++fresh; };
    const std::int64_t lower_left = at[left], lower_right = at[left + 1];
    const std::int64_t upper_left = up(left), upper_right = up(left + 1);
    nodes[i].arcs = letters[i] > 0 ? std::vector{lower_right, upper_right, upper_left, lower_left}
                                   : std::vector{lower_left, lower_right, upper_right, upper_left};
    at[left] = upper_left;
    at[left + 1] = upper_right;
  }
  for (std::size_t s = 0; s < uses.size(); ++s)
    if (uses[s].empty()) nodes.push_back({NodeKind::kVertex, {bottom[s], bottom[s]}});
  NamedDiagram result;
  result.diagram = Diagram(nodes);
  return result;
}

}  // namespace tripus::topology::detail
