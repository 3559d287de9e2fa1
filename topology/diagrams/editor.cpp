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

void DiagramEditor::set_darts(std::uint32_t node, const std::vector<Dart>& darts) {
  darts_[node] = darts;
  for (const Dart d : darts) node_of_[d] = node;
}

void DiagramEditor::dissolve(std::uint32_t crossing) {
  const std::vector<Dart> at = darts_[crossing];
  for (const std::size_t slot : {std::size_t{0}, std::size_t{1}}) {
    const Dart from = at[slot], to = at[slot + 2];
    const std::int64_t name = names_[from];
    if (mates_[from] == to) {
      const std::vector<Dart> circle = darts_[add_node(NodeKind::kVertex, 2)];
      join(circle[0], circle[1], name);
    } else {
      join(mates_[from], mates_[to], name);
    }
  }
  remove_node(crossing);
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

}  // namespace tripus::topology
