// Closed braids.
#include <algorithm>
#include <cstdlib>
#include <string>

#include "topology/diagrams/detail/forms.hpp"
#include "topology/diagrams/detail/scanner.hpp"

namespace tripus::topology::detail {
namespace {

/// More strands than that no one writes by hand; it bounds what a short text makes.
constexpr std::int64_t kMostStrands = 100'000;

struct Word {
  std::vector<std::int64_t> letters;
  std::int64_t strands = 1;
};

/// KnotTheory's BR[3, {1,-2,...}] has the number of strands in front; it is not a letter.
void take_strands(Word& word, const DiagramScanner& scan) {
  if (word.letters.size() != 1 || word.letters[0] < 1)
    scan.fail("a bracket among the letters; before it stands at most the number of strands");
  word.strands = word.letters[0];
  word.letters.clear();
}

Word parse(std::string_view text) {
  DiagramScanner scan(text);
  scan.letters();
  scan.take(':');
  scan.take('=');
  Brackets brackets;
  Word word;
  bool counted = false;
  while (!scan.at_end()) {
    const char c = scan.peek();
    const std::size_t at = scan.position();
    if (scan.take(',')) continue;
    if (is_opening(c)) {
      if (!word.letters.empty()) {
        take_strands(word, scan);
        counted = true;
      }
      brackets.open(scan);
    } else if (is_closing(c)) {
      brackets.close(scan);
    } else if (DiagramScanner::is_letter(c)) {  // a, A: 1, -1
      for (const char letter : scan.letters())
        word.letters.push_back(letter >= 'a' ? letter - 'a' + 1 : -(letter - 'A' + 1));
    } else {
      word.letters.push_back(scan.integer());
    }
    if (!word.letters.empty() && (word.letters.back() == 0 || word.letters.back() >= kMostStrands ||
                                  word.letters.back() <= -kMostStrands))
      scan.fail("the letter " + std::to_string(word.letters.back()) +
                    " is no generator; write 1, -1, 2, -2, ... for crossings of neighbours",
                at);
  }
  brackets.require_closed(scan);
  if (word.letters.empty() && !counted)
    scan.fail("the braid has no letters; write Braid: 1 -2 1 -2");
  for (const std::int64_t letter : word.letters) {
    if (counted && std::abs(letter) >= word.strands)
      scan.fail("the letter " + std::to_string(letter) + " needs more strands than the " +
                std::to_string(word.strands) + " that are announced");
    word.strands = std::max(word.strands, std::abs(letter) + 1);
  }
  return word;
}

}  // namespace

// The strands run upwards. At a positive crossing the strand from the lower left passes above.
NamedDiagram read_braid(std::string_view text) {
  const auto [letters, strands] = parse(text);
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
