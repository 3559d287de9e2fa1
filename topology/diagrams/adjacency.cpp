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

  /// The arcs at each node, in the first way that lies in the plane.
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

}  // namespace

// embedding:4 {0: (4, 5, 6), ...}: bit i of the number belongs to the crossing i, counted among the
// nodes with four neighbours. If it is set, the first and third of its arcs pass below, else above.
NamedDiagram read_embedding(std::string_view text) {
  Scanner scan(text);
  scan.take_word("embedding");
  const std::int64_t choice = scan.take(':') ? scan.integer() : 0;
  scan.expect('{');
  std::vector<std::vector<std::size_t>> lists;
  while (!scan.take('}')) {
    scan.take(',');
    const std::size_t at = scan.position();
    if (scan.integer() != static_cast<std::int64_t>(lists.size()))
      scan.fail("expected node " + std::to_string(lists.size()) + "; the nodes come in their order",
                at);
    scan.expect(':');
    scan.expect('(');
    lists.emplace_back();
    while (!scan.take(')')) {
      lists.back().push_back(static_cast<std::size_t>(scan.integer()));
      if (scan.peek() != ')') scan.expect(',');
    }
  }
  std::vector<DiagramNode> nodes(lists.size());
  std::vector<std::size_t> turned;
  std::size_t crossings = 0;
  for (std::size_t n = 0; n < lists.size(); ++n) {
    nodes[n].kind = lists[n].size() == 4 ? NodeKind::kCrossing : NodeKind::kVertex;
    if (nodes[n].kind == NodeKind::kVertex) continue;
    if (crossings >= 62)
      throw InvalidInput("an embedding of more than 62 crossings; write it as PD");
    if ((choice >> crossings++ & 1) == 0) turned.push_back(n);
  }
  std::vector<DiagramNode> drawn = Neighbours(std::move(lists)).drawn(std::move(nodes)).nodes();
  for (const std::size_t n : turned)
    std::rotate(drawn[n].arcs.begin(), drawn[n].arcs.begin() + 1, drawn[n].arcs.end());
  NamedDiagram result;
  result.diagram = Diagram(drawn);
  return result;
}

// a=V(b0 c0 d3) b=V(a0 d2 c1) c=X(a1 b2 d1 d0): each dart with the node and the slot that it meets.
NamedDiagram read_knotpy(std::string_view text) {
  Scanner scan(text);
  std::map<std::string, std::size_t, std::less<>> numbers;
  struct End {
    std::string node;
    std::int64_t slot;
    std::size_t at;
  };
  std::vector<DiagramNode> nodes;
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
    ends.emplace_back();
    while (!scan.take(')')) {
      if (scan.take(',')) continue;
      const std::size_t here = scan.position();
      const std::string other(scan.letters());
      if (other.empty())
        scan.fail("expected an arc end such as b0, a node and a place" + scan.found());
      ends.back().push_back({other, scan.integer(), here});
    }
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
        scan.fail("node " + end.node + " has no arc end " + std::to_string(end.slot), end.at);
      const End& back = ends[other->second][slot];
      const auto back_node = numbers.find(back.node);
      if (back_node == numbers.end() || back_node->second != n ||
          back.slot != static_cast<std::int64_t>(k))
        scan.fail("this end is not met from the other side: " + end.node + " names " + back.node +
                      std::to_string(back.slot) + " there",
                  end.at);
      if (nodes[n].arcs[k] == 0) nodes[n].arcs[k] = nodes[other->second].arcs[slot] = ++names;
    }
  NamedDiagram result;
  result.diagram = Diagram(nodes);
  return result;
}

}  // namespace tripus::topology::detail
