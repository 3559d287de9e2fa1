#include "topology/diagrams/random_diagram.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace tripus::topology {
namespace {

/// A random binary tree in preorder: true an inner node, false a leaf. By the cycle lemma: of the
/// rotations of any word of n nodes and n + 1 leaves exactly one is a tree.
std::vector<bool> random_tree(std::size_t nodes, std::mt19937_64& engine) {
  std::vector<bool> word(2 * nodes + 1, false);
  std::fill_n(word.begin(), nodes, true);
  for (std::size_t i = word.size() - 1; i > 0; --i) {
    const std::size_t j = engine() % (i + 1);
    const bool other = word[j];
    word[j] = word[i];
    word[i] = other;
  }
  std::ptrdiff_t height = 0, lowest = 1;
  std::size_t start = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    height += word[i] ? 1 : -1;
    if (height < lowest) {
      lowest = height;
      start = (i + 1) % word.size();
    }
  }
  std::rotate(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(start), word.end());
  return word;
}

/// Ends to be joined, in the order in which a walk around the tree meets them.
struct LooseEnd {
  std::size_t node, slot;
  bool bud;
};

}  // namespace

// Slot 0 of a node leads to its parent, slots 1 to 3 to its children and the bud.
Diagram random_diagram(std::size_t nodes, std::uint64_t seed, std::size_t vertices) {
  if (nodes == 0 || vertices > nodes)
    throw InvalidInput("a random diagram of " + std::to_string(nodes) + " nodes with " +
                       std::to_string(vertices) +
                       " vertices; give at least one node, and no more "
                       "vertices than nodes");
  std::mt19937_64 engine(seed);
  const std::vector<bool> tree = random_tree(nodes, engine);
  std::vector<DiagramNode> result(nodes, {NodeKind::kCrossing, std::vector<std::int64_t>(4, 0)});
  std::vector<LooseEnd> ends{{0, 0, false}};
  std::int64_t names = 0;
  const auto join = [&](std::size_t a, std::size_t i, std::size_t b, std::size_t j) {
    result[a].arcs[i] = result[b].arcs[j] = ++names;
  };
  struct Open {
    std::size_t node, next, bud;
  };
  std::vector<Open> path;
  std::size_t made = 0;
  for (const bool inner : tree) {
    while (!path.empty()) {  // on to the slot where this belongs, past buds and what is full
      Open& top = path.back();
      if (top.next == top.bud) ends.push_back({top.node, top.next++, true});
      if (top.next <= 3) break;
      path.pop_back();
    }
    if (inner) {
      if (!path.empty()) join(path.back().node, path.back().next++, made, 0);
      path.push_back({made++, 1, static_cast<std::size_t>(1 + engine() % 3)});
    } else {
      ends.push_back({path.back().node, path.back().next++, false});
    }
  }
  for (; !path.empty(); path.pop_back())
    if (path.back().next == path.back().bud)
      ends.push_back({path.back().node, path.back().next, true});
  // Twice around, since a bud may be closed by a leaf behind the beginning.
  std::vector<std::size_t> buds;
  std::vector<bool> used(ends.size(), false);
  for (std::size_t i = 0; i < 2 * ends.size(); ++i) {
    const std::size_t at = i % ends.size();
    const LooseEnd& end = ends[at];
    if (used[at]) continue;
    if (end.bud) {
      if (i < ends.size()) buds.push_back(at);
    } else if (!buds.empty()) {
      const LooseEnd& bud = ends[buds.back()];
      used[at] = used[buds.back()] = true;
      join(bud.node, bud.slot, end.node, end.slot);
      buds.pop_back();
    }
  }
  std::vector<LooseEnd> left;
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (!used[i]) left.push_back(ends[i]);
  join(left[0].node, left[0].slot, left[1].node, left[1].slot);
  for (std::size_t n = 0; n < nodes; ++n) {
    if (n < vertices) result[n].kind = NodeKind::kVertex;
    if (engine() % 2 == 0)
      std::rotate(result[n].arcs.begin(), result[n].arcs.begin() + 1, result[n].arcs.end());
  }
  return Diagram(result);
}

}  // namespace tripus::topology
