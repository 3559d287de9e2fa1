#include "topology/diagrams/editor.hpp"

#include <algorithm>

namespace tripus::topology {

DiagramEditor::DiagramEditor(const Diagram& diagram)
    : kinds_(diagram.kinds_),
      darts_(diagram.node_count()),
      node_of_(diagram.node_of_),
      mates_(diagram.mates_),
      names_(diagram.names_) {
  for (Dart d = 0; d < diagram.dart_count(); ++d) darts_[node_of_[d]].push_back(d);
}

std::size_t DiagramEditor::slot(Dart d) const {
  const std::vector<Dart>& all = darts_[node_of_[d]];
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), d) - all.begin());
}

std::uint32_t DiagramEditor::add_node(NodeKind kind, std::size_t degree) {
  const auto node = static_cast<std::uint32_t>(darts_.size());
  kinds_.push_back(kind);
  darts_.emplace_back();
  for (std::size_t k = 0; k < degree; ++k) {
    darts_.back().push_back(static_cast<Dart>(mates_.size()));
    node_of_.push_back(node);
    mates_.push_back(kNoDart);
    names_.push_back(0);
  }
  return node;
}

void DiagramEditor::join(Dart one, Dart two, std::int64_t name) {
  mates_[one] = two;
  mates_[two] = one;
  names_[one] = names_[two] = name;
}

void DiagramEditor::remove_dart(Dart d) {
  std::vector<Dart>& all = darts_[node_of_[d]];
  all.erase(std::find(all.begin(), all.end(), d));
}

Dart DiagramEditor::insert_dart_after(Dart d) {
  const auto fresh = static_cast<Dart>(mates_.size());
  std::vector<Dart>& all = darts_[node_of_[d]];
  all.insert(std::find(all.begin(), all.end(), d) + 1, fresh);
  node_of_.push_back(node_of_[d]);
  mates_.push_back(kNoDart);
  names_.push_back(0);
  return fresh;
}

void DiagramEditor::exchange(Dart one, Dart two) {
  std::vector<Dart>& all = darts_[node_of_[one]];
  std::iter_swap(std::find(all.begin(), all.end(), one), std::find(all.begin(), all.end(), two));
}

void DiagramEditor::turn(std::uint32_t node) {
  std::rotate(darts_[node].begin(), darts_[node].begin() + 1, darts_[node].end());
}

Diagram DiagramEditor::finished() const {
  std::vector<NodeKind> kinds;
  std::vector<std::uint32_t> degrees;
  std::vector<Dart> fresh(dart_count(), kNoDart), old;
  for (std::size_t n = 0; n < node_count(); ++n) {
    if (!is_live(n)) continue;
    kinds.push_back(kinds_[n]);
    degrees.push_back(static_cast<std::uint32_t>(darts_[n].size()));
    for (const Dart d : darts_[n]) {
      fresh[d] = static_cast<Dart>(old.size());
      old.push_back(d);
    }
  }
  Diagram diagram;
  diagram.start(kinds, degrees);
  for (Dart d = 0; d < old.size(); ++d) {
    diagram.mates_[d] = fresh[mates_[old[d]]];
    diagram.names_[d] = names_[old[d]];
  }
  diagram.require_planar();
  return diagram;
}

// The strand comes from d into slot i, leaves by i + 2, runs round the loop to its left (so into
// the slot counterclockwise of the one where it left) and goes on by the slot opposite that.
void add_kink(DiagramEditor& editor, Dart d, bool over) {
  const Dart end = editor.mate(d);
  const std::int64_t name = editor.arc(d);
  const std::uint32_t crossing = editor.add_node(NodeKind::kCrossing, 4);
  const std::vector<Dart> at = editor.darts(crossing);
  const std::size_t in = over ? 1 : 0;
  editor.join(d, at[in], name);
  editor.join(at[(in + 2) % 4], at[(in + 3) % 4], name);
  editor.join(at[(in + 1) % 4], end, name);
}

// Seen with `under` running east and the common region north of it, `over` comes from the north and
// runs west: it bulges southwards and crosses `under` twice, first (in its direction) further east.
void push_across(DiagramEditor& editor, Dart over, Dart under) {
  const Dart over_end = editor.mate(over), under_end = editor.mate(under);
  const std::int64_t over_name = editor.arc(over), under_name = editor.arc(under);
  const std::uint32_t west_node = editor.add_node(NodeKind::kCrossing, 4);
  const std::uint32_t east_node = editor.add_node(NodeKind::kCrossing, 4);
  // Slots counterclockwise from the incoming under-strand: west, south, east, north.
  const std::vector<Dart> west = editor.darts(west_node), east = editor.darts(east_node);
  editor.join(under, west[0], under_name);
  editor.join(west[2], east[0], under_name);
  editor.join(east[2], under_end, under_name);
  editor.join(over, east[3], over_name);
  editor.join(east[1], west[1], over_name);
  editor.join(west[3], over_end, over_name);
}

}  // namespace tripus::topology
