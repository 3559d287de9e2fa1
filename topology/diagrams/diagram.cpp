#include "topology/diagrams/diagram.hpp"

#include <algorithm>
#include <numeric>

#include "base/error.hpp"

namespace tripus::topology {
namespace {

std::string place_of(const DiagramNode& node) {
  return node.place.empty() ? to_text(node) : node.place;
}

void require_degrees(const std::vector<DiagramNode>& nodes) {
  if (nodes.empty())
    throw InvalidInput(
        "the diagram has no nodes; write V[1,2,3] for vertices, X[4,2,5,1] for crossings");
  for (const DiagramNode& node : nodes) {
    if (node.kind == NodeKind::kCrossing && node.arcs.size() != 4)
      throw InvalidInput(place_of(node) + " has " + std::to_string(node.arcs.size()) +
                         " arcs; a crossing X has four, a vertex is written V");
    if (node.arcs.empty())
      throw InvalidInput(place_of(node) + " has no arcs; leave out points without arcs");
  }
}

/// An end of an arc as it was named.
struct NamedEnd {
  std::int64_t name;
  Dart dart;
};

}  // namespace

void Diagram::start(const std::vector<NodeKind>& kinds, const std::vector<std::uint32_t>& degrees) {
  kinds_ = kinds;
  first_.assign(1, 0);
  for (std::size_t n = 0; n < kinds.size(); ++n) {
    first_.push_back(first_.back() + degrees[n]);
    node_of_.insert(node_of_.end(), degrees[n], static_cast<std::uint32_t>(n));
    crossing_count_ += kinds[n] == NodeKind::kCrossing;
  }
  mates_.assign(node_of_.size(), kNoDart);
  names_.assign(node_of_.size(), 0);
}

Diagram::Diagram(const std::vector<DiagramNode>& nodes) {
  require_degrees(nodes);
  std::vector<NodeKind> kinds;
  std::vector<std::uint32_t> degrees;
  for (const DiagramNode& node : nodes) {
    kinds.push_back(node.kind);
    degrees.push_back(static_cast<std::uint32_t>(node.arcs.size()));
  }
  start(kinds, degrees);
  std::vector<NamedEnd> ends;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (std::size_t k = 0; k < nodes[n].arcs.size(); ++k)
      ends.push_back({nodes[n].arcs[k], first_[n] + static_cast<Dart>(k)});
  std::ranges::stable_sort(ends, {}, &NamedEnd::name);
  for (std::size_t i = 0; i < ends.size();) {
    std::size_t j = i;
    while (j < ends.size() && ends[j].name == ends[i].name) ++j;
    if (j - i != 2) {
      const DiagramNode& node = nodes[node_of_[ends[j - 1].dart]];
      throw InvalidInput("arc " + std::to_string(ends[i].name) + " is named " +
                         (j - i == 1 ? std::string("once") : std::to_string(j - i) + " times") +
                         (j - i == 1 ? ", in " : ", the last time in ") + place_of(node) +
                         "; every arc has two ends");
    }
    mates_[ends[i].dart] = ends[i + 1].dart;
    mates_[ends[i + 1].dart] = ends[i].dart;
    names_[ends[i].dart] = names_[ends[i + 1].dart] = ends[i].name;
    i = j;
  }
  require_planar();
}

// Euler's formula for each piece, on a sphere of its own.
void Diagram::require_planar() const {
  const DiagramPieces parts = pieces(*this);
  const DiagramRegions areas = regions(*this);
  std::vector<std::int64_t> euler(parts.count, 0);
  std::vector<Dart> sample(parts.count, kNoDart), longest(parts.count, kNoDart);
  std::vector<std::size_t> length(areas.count(), 0), best(parts.count, 0);
  for (std::size_t n = 0; n < node_count(); ++n) ++euler[parts.of_node[n]];
  for (Dart d = 0; d < dart_count(); ++d) {
    const std::size_t part = parts.of_node[node_of_[d]];
    if (d < mates_[d]) --euler[part];
    if (sample[part] == kNoDart) sample[part] = d;
    ++length[areas.of_dart[d]];
  }
  for (std::size_t r = 0; r < areas.count(); ++r) {
    const std::size_t part = parts.of_node[node_of_[areas.start[r]]];
    ++euler[part];
    if (length[r] > best[part]) best[part] = length[r], longest[part] = areas.start[r];
  }
  for (std::size_t part = 0; part < parts.count; ++part) {
    if (euler[part] == 2) continue;
    std::string walk;
    Dart d = longest[part];
    for (std::size_t i = 0; i < std::min<std::size_t>(best[part], 8); ++i, d = along_region(d))
      walk += (i == 0 ? "" : ", ") + std::to_string(names_[d]);
    throw InvalidInput(
        "the arcs cannot be drawn in the plane in these orders: the piece with arc " +
        std::to_string(names_[sample[part]]) + " has genus " +
        std::to_string((2 - euler[part]) / 2) + ", not 0. Look along the region with the arcs " +
        walk + (best[part] > 8 ? ", ..." : "") +
        ": at one of its nodes two arcs are out of their counterclockwise order");
  }
}

std::vector<DiagramNode> Diagram::nodes() const {
  std::vector<DiagramNode> all(node_count());
  for (std::size_t n = 0; n < node_count(); ++n) {
    all[n].kind = kinds_[n];
    all[n].arcs.assign(names_.begin() + first_[n], names_.begin() + first_[n + 1]);
  }
  return all;
}

// Slot k becomes slot -k: the incoming under-strand stays first, the order is reversed.
Diagram Diagram::mirror_image() const {
  const auto image = [&](Dart d) {
    return first_[node_of_[d]] + (degree(node_of_[d]) - slot(d)) % degree(node_of_[d]);
  };
  Diagram mirror = *this;
  for (Dart d = 0; d < dart_count(); ++d) {
    mirror.mates_[image(d)] = image(mates_[d]);
    mirror.names_[image(d)] = names_[d];
  }
  return mirror;
}

DiagramRegions regions(const Diagram& diagram) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  DiagramRegions result;
  result.of_dart.assign(diagram.dart_count(), kNone);
  for (Dart first = 0; first < diagram.dart_count(); ++first) {
    if (result.of_dart[first] != kNone) continue;
    const auto region = static_cast<std::uint32_t>(result.start.size());
    result.start.push_back(first);
    for (Dart d = first; result.of_dart[d] == kNone; d = diagram.along_region(d))
      result.of_dart[d] = region;
  }
  return result;
}

DiagramPieces pieces(const Diagram& diagram) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  DiagramPieces result;
  result.of_node.assign(diagram.node_count(), kNone);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t first = 0; first < diagram.node_count(); ++first) {
    if (result.of_node[first] != kNone) continue;
    const auto piece = static_cast<std::uint32_t>(result.count++);
    result.of_node[first] = piece;
    stack.push_back(first);
    while (!stack.empty()) {
      const std::uint32_t n = stack.back();
      stack.pop_back();
      for (std::uint32_t k = 0; k < diagram.degree(n); ++k) {
        const std::uint32_t other = diagram.node(diagram.mate(diagram.first_dart(n) + k));
        if (result.of_node[other] != kNone) continue;
        result.of_node[other] = piece;
        stack.push_back(other);
      }
    }
  }
  return result;
}

Strands strands(const Diagram& diagram) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  Strands result;
  result.of_dart.assign(diagram.dart_count(), kNone);
  const auto follow = [&](Dart first) {
    Strand strand;
    const auto number = static_cast<std::uint32_t>(result.all.size());
    Dart d = first;
    while (true) {
      const Dart end = diagram.mate(d);
      strand.darts.push_back(d);
      result.of_dart[d] = result.of_dart[end] = number;
      if (!diagram.is_at_crossing(end)) break;
      d = diagram.across(end);
      if (d == first) {
        strand.closed = true;
        break;
      }
    }
    result.all.push_back(std::move(strand));
  };
  for (Dart d = 0; d < diagram.dart_count(); ++d)
    if (result.of_dart[d] == kNone && !diagram.is_at_crossing(d)) follow(d);
  for (Dart d = 0; d < diagram.dart_count(); ++d)  // slot 2: the outgoing under-strand
    if (result.of_dart[d] == kNone && diagram.is_at_crossing(d) && diagram.slot(d) == 2) follow(d);
  for (Dart d = 0; d < diagram.dart_count(); ++d)
    if (result.of_dart[d] == kNone) follow(d);
  return result;
}

std::string to_text(const DiagramNode& node) {
  std::string text = node.kind == NodeKind::kCrossing ? "X[" : "V[";
  for (std::size_t k = 0; k < node.arcs.size(); ++k)
    text += (k == 0 ? "" : ",") + std::to_string(node.arcs[k]);
  return text + "]";
}

std::string to_text(const Diagram& diagram) {
  std::string text;
  for (const DiagramNode& node : diagram.nodes()) text += (text.empty() ? "" : " ") + to_text(node);
  return text;
}

}  // namespace tripus::topology
