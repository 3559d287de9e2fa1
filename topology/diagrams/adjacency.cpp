// Diagrams given by which node meets which: appcontour's embeddings, KnotPy's own notation.
#include <algorithm>
#include <map>
#include <string>

#include "topology/diagrams/detail/forms.hpp"
#include "topology/diagrams/detail/scanner.hpp"

namespace tripus::topology::detail {
namespace {

/// Enough for every table; a bound, since each choice doubles the work.
constexpr std::size_t kMostWays = 4096;

/// Neighbours of each node, counterclockwise. Where two nodes are joined by several arcs, which
/// dart meets which is not said: it is what can be drawn in the plane.
class Neighbours {
 public:
  explicit Neighbours(std::vector<std::vector<std::size_t>> lists) : lists_(std::move(lists)) {
    for (std::size_t n = 0; n < lists_.size(); ++n)
      for (std::size_t k = 0; k < lists_[n].size(); ++k) {
        const std::size_t other = lists_[n][k];
        if (other >= lists_.size())
          throw InvalidInput("node " + std::to_string(n) + " has the neighbour " +
                             std::to_string(other) + ", which does not exist");
        bundles_[{std::min(n, other), std::max(n, other)}][n > other].push_back({n, k});
      }
    std::size_t ways = 1;
    for (const auto& [ends, bundle] : bundles_) {
      const bool loop = ends.first == ends.second;
      if (loop ? bundle[0].size() % 2 != 0 : bundle[0].size() != bundle[1].size())
        throw InvalidInput("node " + std::to_string(ends.first) + " names node " +
                           std::to_string(ends.second) + " " + std::to_string(bundle[0].size()) +
                           (loop ? " times; a loop takes two places"
                                 : " times, and that one names it " +
                                       std::to_string(bundle[1].size()) + " times"));
      ways = std::min(2 * kMostWays, ways * bundle[0].size());
    }
    if (ways > kMostWays)
      throw InvalidInput("too many nodes are joined by several arcs; write it as PD");
  }

  /// The arcs at each node, in the first way that lies in the plane. Crossings are not looked at.
  Diagram drawn(std::vector<DiagramNode> nodes) {
    for (auto& node : nodes) node.arcs.clear();
    for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n].arcs.resize(lists_[n].size());
    std::vector<std::size_t> turns(bundles_.size(), 0);
    while (true) {
      name_arcs(nodes, turns);
      std::size_t i = 0;
      try {
        return Diagram(nodes);
      } catch (const InvalidInput&) {
        for (auto bundle = bundles_.begin(); bundle != bundles_.end(); ++bundle, ++i) {
          if (++turns[i] < bundle->second[0].size()) break;
          turns[i] = 0;
        }
        if (i == turns.size()) throw;
      }
    }
  }

 private:
  struct Place {
    std::size_t node, slot;
  };

  // Parallel arcs meet the two nodes in opposite orders; a loop's ends are neighbours in the list.
  void name_arcs(std::vector<DiagramNode>& nodes, const std::vector<std::size_t>& turns) const {
    std::int64_t name = 0;
    std::size_t i = 0;
    for (const auto& [ends, bundle] : bundles_) {
      const std::size_t turn = turns[i++];
      const std::size_t count = bundle[0].size();
      const auto give = [&](const Place& at) { nodes[at.node].arcs[at.slot] = name; };
      for (std::size_t k = 0; k < count; ++k) {
        if (ends.first == ends.second) {
          name += k % 2 == 0;
          give(bundle[0][(k + turn) % count]);
        } else {
          ++name;
          give(bundle[0][k]);
          give(bundle[1][(2 * count - 1 - k + turn) % count]);
        }
      }
    }
  }

  std::vector<std::vector<std::size_t>> lists_;
  std::map<std::pair<std::size_t, std::size_t>, std::array<std::vector<Place>, 2>> bundles_;
};

// embedding:4 {0: (4, 5, 6), ...}: bit i of the number belongs to the crossing i, counted among the
// nodes with four neighbours. If it is set, the first and third of its arcs pass below, else above.
// "odd" (or o) before the neighbours sets it too, "even" (or e) does not. A minus sign before the
// brace: all are clockwise. +3 at the end: three circles that meet nothing.
class EmbeddingReader {
 public:
  explicit EmbeddingReader(std::string_view text) : scan_(text) {}

  NamedDiagram read() {
    scan_.take_word("embedding");
    const bool chosen = scan_.take(':');
    const std::int64_t choice = chosen ? scan_.integer() : 0;
    const bool clockwise = scan_.take('-');
    if (scan_.peek() != '{') scan_.expect('{');
    brackets_.open(scan_);
    while (scan_.peek() != '}') {
      if (scan_.at_end()) brackets_.fail_open(scan_);
      if (scan_.take(',')) continue;
      scan_.peek() == '+' ? circles() : node(chosen);
    }
    brackets_.close(scan_);
    if (!scan_.at_end()) scan_.fail("expected the end" + scan_.found());
    return drawn(choice, clockwise);
  }

 private:
  void circles() {
    const std::size_t at = scan_.position();
    circles_ = scan_.integer();
    if (circles_ > 1000) scan_.fail("more than 1000 circles that meet nothing", at);
  }

  void node(bool chosen) {
    const std::size_t at = scan_.position();
    if (scan_.integer() != static_cast<std::int64_t>(lists_.size()))
      scan_.fail(
          "expected node " + std::to_string(lists_.size()) + "; the nodes come in their order", at);
    scan_.expect(':');
    const std::size_t word_at = scan_.position();
    const std::string_view word = scan_.letters();
    const bool odd = word == "odd" || word == "o";
    if (!odd && !word.empty() && word != "even" && word != "e")
      scan_.fail("expected odd, even or the neighbours in round brackets", word_at);
    if (!word.empty() && chosen)
      scan_.fail("the crossings are given by the number behind \"embedding\" already; take " +
                     quoted(std::string(word)) + " away",
                 word_at);
    if (scan_.peek() != '(') scan_.expect('(');
    brackets_.open(scan_);
    lists_.emplace_back();
    while (!is_closing(scan_.peek())) {
      if (!scan_.at_number()) brackets_.fail_open(scan_);
      const std::size_t neighbour_at = scan_.position();
      const std::int64_t neighbour = scan_.integer();
      if (neighbour < 0) scan_.fail("the nodes are counted from 0", neighbour_at);
      lists_.back().push_back(static_cast<std::size_t>(neighbour));
      if (scan_.peek() != ')') scan_.take(',');
    }
    brackets_.close(scan_);
    odd_.push_back(odd);
    places_.push_back("node " + std::string(scan_.since(at)) + " (" + scan_.place(at) + ")");
    if (!word.empty() && lists_.back().size() != 4)
      scan_.fail(quoted(std::string(word)) + " is for crossings, which have four neighbours",
                 word_at);
  }

  NamedDiagram drawn(std::int64_t choice, bool clockwise) {
    std::vector<DiagramNode> nodes(lists_.size());
    std::vector<std::size_t> above;
    std::size_t crossings = 0;
    for (std::size_t n = 0; n < lists_.size(); ++n) {
      nodes[n].place = places_[n];
      nodes[n].kind = kind_of(lists_[n].size());
      if (nodes[n].kind == NodeKind::kVertex) continue;
      if (crossings >= 62 && choice != 0)
        throw InvalidInput("a number for more than 62 crossings; write \"odd\" before their arcs");
      if (!odd_[n] && (choice >> (choice == 0 ? 0 : crossings) & 1) == 0) above.push_back(n);
      ++crossings;
    }
    if (choice < 0 || (crossings < 62 && choice >> crossings != 0))
      throw InvalidInput("the number " + std::to_string(choice) + " behind \"embedding\" has no " +
                         std::to_string(crossings) + " bits, one a crossing");
    NamedDiagram result;
    if (!lists_.empty() || circles_ == 0) {
      std::vector<DiagramNode> drawn = Neighbours(lists_).drawn(nodes).nodes();
      for (const std::size_t n : above)
        std::rotate(drawn[n].arcs.begin(), drawn[n].arcs.begin() + 1, drawn[n].arcs.end());
      if (clockwise) turn_round(drawn);
      nodes = std::move(drawn);
    }
    auto name = static_cast<std::int64_t>(4 * lists_.size());
    for (std::int64_t k = 0; k < circles_; ++k) {
      ++name;
      nodes.push_back({NodeKind::kVertex, {name, name}});
    }
    result.diagram = Diagram(nodes);
    return result;
  }

  DiagramScanner scan_;
  Brackets brackets_;
  std::vector<std::vector<std::size_t>> lists_;
  std::vector<bool> odd_;
  std::vector<std::string> places_;
  std::int64_t circles_ = 0;
};

}  // namespace

NamedDiagram read_embedding(std::string_view text) { return EmbeddingReader(text).read(); }

// a=V(b0 c0 d3) b=V(a0 d2 c1) c=X(a1 b2 d1 d0): each dart with the node and the slot that it meets.
NamedDiagram read_knotpy(std::string_view text) {
  DiagramScanner scan(text);
  std::map<std::string, std::size_t, std::less<>> numbers;
  struct End {
    std::string node;
    std::int64_t slot;
    std::size_t at;
  };
  std::vector<DiagramNode> nodes;
  std::vector<std::string> written;
  std::vector<std::vector<End>> ends;
  while (!scan.at_end() && scan.peek() != '[') {  // [...] are attributes
    if (scan.take(',')) continue;
    const std::size_t at = scan.position();
    const std::string name(scan.letters());
    if (name.empty() || !scan.take('=')) scan.fail("expected a node such as a=X(b0 c1 d2 d3)", at);
    const std::string kind(scan.letters());
    if (kind != "X" && kind != "V")
      scan.fail(quoted(kind) + " is no kind of node; X is a crossing, V a vertex", at);
    if (!numbers.emplace(name, nodes.size()).second)
      scan.fail("there are two nodes " + quoted(name), at);
    scan.expect('(');
    nodes.push_back({kind == "X" ? NodeKind::kCrossing : NodeKind::kVertex});
    written.push_back(name);
    ends.emplace_back();
    while (!scan.take(')')) {
      if (scan.take(',')) continue;
      const std::size_t here = scan.position();
      const std::string other(scan.letters());
      if (other.empty())
        scan.fail("expected an arc end such as b0, a node and a place" + scan.found());
      ends.back().push_back({other, scan.integer(), here});
    }
    nodes.back().place = std::string(scan.since(at)) + " (" + scan.place(at) + ")";
  }
  std::int64_t names = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n].arcs.assign(ends[n].size(), 0);
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (std::size_t k = 0; k < ends[n].size(); ++k) {
      const End& end = ends[n][k];
      const auto other = numbers.find(end.node);
      if (other == numbers.end()) scan.fail("there is no node " + quoted(end.node), end.at);
      const auto slot = static_cast<std::size_t>(end.slot);
      if (end.slot < 0 || slot >= ends[other->second].size())
        scan.fail("node " + end.node + " has no arc end " + std::to_string(end.slot) + ": its " +
                      std::to_string(ends[other->second].size()) + " are counted from 0",
                  end.at);
      const End& back = ends[other->second][slot];
      const auto back_node = numbers.find(back.node);
      if (back_node == numbers.end() || back_node->second != n ||
          back.slot != static_cast<std::int64_t>(k))
        scan.fail("node " + written[n] + " names " + end.node + std::to_string(end.slot) +
                      ", which is not met from the other side: there stands " + back.node +
                      std::to_string(back.slot) + ", not " + written[n] + std::to_string(k),
                  end.at);
      if (nodes[n].arcs[k] == 0) nodes[n].arcs[k] = nodes[other->second].arcs[slot] = ++names;
    }
  NamedDiagram result;
  result.diagram = Diagram(nodes);
  return result;
}

}  // namespace tripus::topology::detail
