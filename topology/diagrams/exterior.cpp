#include "topology/diagrams/exterior.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <utility>

#include "base/error.hpp"
#include "topology/diagrams/moves.hpp"
#include "topology/disjoint_sets.hpp"

// A *wall* is a face of a tetrahedron with the vertices (strand, P, M), on one side of an arc. The
// walls of an arc's two ends are glued along the arc, left to left and right to right of it. At a
// vertex of the graph the wall goes on along the next arc of the same region: the neighbourhood of
// the graph is one ideal point, so nothing is in between. Hence a vertex costs no tetrahedron.
//
// All is indexed by *joints* 2 d + side: the two sides of the arc end d. To the node, a joint leads
// to the corner of a crossing, or at a vertex to the joint of the neighbouring dart; along the arc
// to the joint at its other end, or to the tetrahedron of a kept arc.

namespace tripus::topology {
namespace {

constexpr std::uint32_t kLeft = 0;
constexpr std::uint32_t kRight = 1;

/// A wall: face opposite to `off` of a tetrahedron; the strand is its vertex `strand`, P is
/// `above`.
struct Wall {
  TetrahedronIndex t;
  int strand, off, above;
};

/// Which strands are kept, by one dart of each.
std::vector<Dart> kept_darts(const Diagram& diagram, std::span<const std::int64_t> kept) {
  std::vector<Dart> darts;
  if (kept.empty()) return darts;
  const Strands all = strands(diagram);
  std::vector<bool> taken(all.all.size(), false);
  for (const std::int64_t name : kept) {
    Dart found = kNoDart;
    for (Dart d = 0; d < diagram.dart_count() && found == kNoDart; ++d)
      if (diagram.arc(d) == name) found = d;
    if (found == kNoDart)
      throw InvalidInput("there is no arc " + std::to_string(name) + " in the diagram");
    if (taken[all.of_dart[found]])
      throw InvalidInput("arc " + std::to_string(name) +
                         " belongs to a strand that has a label already; give one for each strand");
    taken[all.of_dart[found]] = true;
    darts.push_back(all.all[all.of_dart[found]].darts.front());
  }
  return darts;
}

/// Darts of strands to be kinked so that no cycle of the graph, and no knot, lies everywhere above
/// or everywhere below: around such a one the octahedra leave spheres instead of its boundary,
/// since nothing then joins its left side with its right one.
std::vector<Dart> level_cycles(const Diagram& diagram, const std::vector<Dart>& kept) {
  const Strands all = strands(diagram);
  std::vector<bool> done(all.all.size(), false);
  for (const Dart d : kept) done[all.of_dart[d]] = true;
  std::vector<Dart> darts;
  for (const bool above : {true, false}) {
    DisjointSets sets(diagram.node_count());
    for (std::size_t s = 0; s < all.all.size(); ++s) {
      const Strand& strand = all.all[s];
      const auto is_level = [&](Dart d) {
        const Dart end = diagram.mate(d);
        return !diagram.is_at_crossing(end) || diagram.is_under(end) != above;
      };
      if (done[s] || !std::ranges::all_of(strand.darts, is_level)) continue;
      if (!strand.closed && sets.join(diagram.node(strand.darts.front()),
                                      diagram.node(diagram.mate(strand.darts.back()))))
        continue;
      darts.push_back(strand.darts.front());
      done[s] = true;
    }
  }
  return darts;
}

/// One piece, no level cycles, and in every region a crossing (or a kept arc), so that every wall
/// ends somewhere.
Diagram prepared(const Diagram& diagram, const std::vector<Dart>& kept, DiagramExterior& result) {
  const DiagramPieces parts = pieces(diagram);
  result.pieces = parts.count;
  const DiagramRegions areas = regions(diagram);
  std::vector<Dart> kinks = level_cycles(diagram, kept);
  std::vector<bool> has_wall(areas.count(), false);
  const auto mark = [&](Dart d) {
    has_wall[areas.of_dart[d]] = has_wall[areas.of_dart[diagram.mate(d)]] = true;
  };
  for (Dart d = 0; d < diagram.dart_count(); ++d)
    if (diagram.is_at_crossing(d)) has_wall[areas.of_dart[d]] = true;
  std::ranges::for_each(kept, mark);
  std::ranges::for_each(kinks, mark);
  for (std::size_t r = 0; r < areas.count(); ++r) {
    if (has_wall[r]) continue;
    kinks.push_back(areas.start[r]);
    mark(areas.start[r]);
  }
  result.kinks = kinks.size();
  if (parts.count == 1 && kinks.empty()) return diagram;
  DiagramEditor editor(diagram);
  for (const Dart d : kinks) add_kink(editor, d, true);
  std::vector<Dart> sample(parts.count, kNoDart);
  for (Dart d = 0; d < diagram.dart_count(); ++d)
    if (Dart& first = sample[parts.of_node[diagram.node(d)]]; first == kNoDart) first = d;
  for (std::size_t piece = 1; piece < parts.count; ++piece)
    push_across(editor, sample[0], sample[piece]);
  return editor.finished();
}

class Octahedra {
 public:
  Octahedra(const Diagram& diagram, const std::vector<Dart>& kept) : diagram_(&diagram) {
    first_of_node_.assign(diagram.node_count(), kNoTetrahedron);
    for (std::size_t n = 0; n < diagram.node_count(); ++n)
      if (diagram.is_crossing(n)) first_of_node_[n] = std::exchange(count_, count_ + 4);
    for (const Dart d : kept) {
      kept_[d] = {count_, true};
      kept_[diagram.mate(d)] = {count_, false};
      count_ += 2;
    }
    gluings_.resize(count_);
  }

  Gluings glued() {
    for (std::size_t n = 0; n < diagram_->node_count(); ++n)
      if (diagram_->is_crossing(n)) glue_around_crossing(first_of_node_[n]);
    for (const auto& [d, arc] : kept_)
      if (arc.forward) glue_around_arc(arc.first);
    for (Dart d = 0; d < diagram_->dart_count(); ++d)
      for (const std::uint32_t side : {kLeft, kRight}) {
        if (const auto wall = wall_at_node(d, side)) glue(*wall, far_end(d, side, Way::kArc));
        if (const auto wall = wall_at_arc(d, side)) glue(*wall, far_end(d, side, Way::kNode));
      }
    return std::move(gluings_);
  }

 private:
  enum class Way : std::uint8_t { kArc, kNode };
  struct Arc {
    TetrahedronIndex first = 0;  ///< the tetrahedron to the left, seen forwards
    bool forward = true;         ///< vertex 0 is at this dart
  };

  /// Labels: over, under, M, P at even corners and over, under, P, M at odd ones, so that every
  /// gluing is odd and the orientation that of space, as for meshes. The line over-under, P and M
  /// above an under-strand, M below an over-strand.
  void glue_around_crossing(TetrahedronIndex first) {
    for (TetrahedronIndex k = 0; k < 4; ++k) {
      const TetrahedronIndex next = (k + 1) % 4;
      const int below = k % 2 == 0 ? 2 : 3;  // M in corner k, P in the next one
      const bool under = next % 2 == 0;      // the slot between them
      gluings_.glue(first + k, under ? below : 5 - below, first + next,
                    Perm4::from_images(0, 1, 3, 2));
    }
  }
  void glue_around_arc(TetrahedronIndex first) {
    gluings_.glue(first, 2, first + 1, Perm4::from_images(0, 1, 3, 2));
    gluings_.glue(first, 3, first + 1, Perm4::from_images(0, 1, 3, 2));
  }

  std::optional<Wall> wall_at_node(Dart d, std::uint32_t side) const {
    if (!diagram_->is_at_crossing(d)) return std::nullopt;
    const std::uint32_t k = diagram_->slot(d);
    const std::uint32_t corner = side == kLeft ? k : (k + 3) % 4;
    const int strand = diagram_->is_under(d) ? 1 : 0;
    return Wall{first_of_node_[diagram_->node(d)] + corner, strand, 1 - strand,
                corner % 2 == 0 ? 3 : 2};
  }
  std::optional<Wall> wall_at_arc(Dart d, std::uint32_t side) const {
    const auto found = kept_.find(d);
    if (found == kept_.end()) return std::nullopt;
    const auto [first, forward] = found->second;
    const bool left = (side == kLeft) == forward;
    const int strand = forward ? 0 : 1;
    return Wall{first + (left ? 0 : 1), strand, 1 - strand, left ? 3 : 2};
  }

  /// The wall at the other end of the way that begins at a joint, along its arc or to its node.
  Wall far_end(Dart d, std::uint32_t side, Way way) const {
    for (std::size_t steps = 0; steps <= 4 * diagram_->dart_count(); ++steps) {
      if (way == Way::kArc) {
        if (const auto wall = wall_at_arc(d, side)) return *wall;
        d = diagram_->mate(d);
        side = 1 - side;
        way = Way::kNode;
      } else {
        if (const auto wall = wall_at_node(d, side)) return *wall;
        d = side == kLeft ? diagram_->next(d) : diagram_->previous(d);
        side = 1 - side;
        way = Way::kArc;
      }
    }
    throw InternalError("a region of the diagram has no crossing");
  }

  void glue(const Wall& a, const Wall& b) {
    std::array<int, 4> image{};
    const auto set = [&](int from, int to) { image[static_cast<std::size_t>(from)] = to; };
    set(a.strand, b.strand);
    set(a.off, b.off);
    set(a.above, b.above);
    set(5 - a.above, 5 - b.above);
    gluings_.set_one_side(a.t, a.off, b.t,
                          Perm4::from_images(image[0], image[1], image[2], image[3]));
  }

  const Diagram* diagram_;
  std::vector<TetrahedronIndex> first_of_node_;
  std::unordered_map<Dart, Arc> kept_;
  TetrahedronIndex count_ = 0;
  Gluings gluings_;
};

}  // namespace

DiagramExterior exterior(const Diagram& diagram, std::span<const std::int64_t> kept) {
  DiagramExterior result;
  std::vector<Dart> darts = kept_darts(diagram, kept);
  const Diagram ready = prepared(diagram, darts, result);
  if (ready.crossing_count() != diagram.crossing_count()) darts = kept_darts(ready, kept);
  result.gluings = Octahedra(ready, darts).glued();
  for (std::size_t i = 0; i < darts.size(); ++i)
    result.kept.push_back(
        {kept[i], static_cast<TetrahedronIndex>(4 * ready.crossing_count() + 2 * i), 0});
  return result;
}

}  // namespace tripus::topology
