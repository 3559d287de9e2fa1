#include "topology/diagrams/moves.hpp"

#include <algorithm>
#include <random>
#include <vector>

namespace tripus::topology {
namespace {

/// The darts of the region to the left of one, if it has exactly so many, all at crossings.
std::vector<Dart> small_region(const DiagramEditor& editor, Dart at, std::size_t corners) {
  std::vector<Dart> region;
  Dart d = at;
  do {
    if (region.size() == corners || !editor.is_crossing(editor.node(d))) return {};
    region.push_back(d);
    d = editor.along_region(d);
  } while (d != at);
  if (region.size() != corners) return {};
  for (std::size_t i = 0; i < corners; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (editor.node(region[i]) == editor.node(region[j])) return {};
  return region;
}

bool same_region(const DiagramEditor& editor, Dart one, Dart two) {
  Dart d = one;
  do {
    if (d == two) return true;
    d = editor.along_region(d);
  } while (d != one);
  return false;
}

/// Whether the arc passes above, or below, at both its ends.
bool is_level(const DiagramEditor& editor, Dart d) {
  return editor.is_under(d) == editor.is_under(editor.mate(d));
}

bool unkink(DiagramEditor& editor, Dart at) {
  const std::vector<Dart> loop = small_region(editor, at, 1);
  if (loop.empty()) return false;
  editor.dissolve(editor.node(at));
  return true;
}

bool push(DiagramEditor& editor, Dart at, Dart other, bool over) {
  if (at == other || editor.mate(at) == other || !same_region(editor, at, other)) return false;
  over ? push_across(editor, at, other) : push_across(editor, other, at);
  return true;
}

bool pull(DiagramEditor& editor, Dart at) {
  const std::vector<Dart> bigon = small_region(editor, at, 2);
  if (bigon.empty() || !is_level(editor, at)) return false;
  const std::uint32_t one = editor.node(bigon[0]), two = editor.node(bigon[1]);
  editor.dissolve(one);
  editor.dissolve(two);
  return true;
}

// Each of the three strands meets its two crossings in the other order afterwards. Seen along it:
// it came in by `in`, went from d to m along the side of the triangle and out by `out`. Now it
// comes in by m, goes from out to in, and leaves by d. Outer ends may be joined to each other.
bool slide(DiagramEditor& editor, Dart at) {
  const std::vector<Dart> triangle = small_region(editor, at, 3);
  if (triangle.empty() ||
      std::ranges::none_of(triangle, [&](Dart d) { return is_level(editor, d); }))
    return false;
  struct Port {
    Dart old, now, partner;
    std::int64_t name;
  };
  std::vector<Port> ports;
  struct Side {
    Dart in, out;
    std::int64_t name;
  };
  std::vector<Side> sides;
  for (const Dart d : triangle) {
    const Dart m = editor.mate(d), in = editor.across(d), out = editor.across(m);
    ports.push_back({in, m, editor.mate(in), editor.arc(in)});
    ports.push_back({out, d, editor.mate(out), editor.arc(out)});
    sides.push_back({in, out, editor.arc(d)});
  }
  for (const Port& port : ports) {
    const auto partner = std::ranges::find(ports, port.partner, &Port::old);
    editor.join(port.now, partner == ports.end() ? port.partner : partner->now, port.name);
  }
  for (const Side& side : sides) editor.join(side.in, side.out, side.name);
  return true;
}

// The strand runs clockwise around the vertex, from the arc `corner` on. At each crossing,
// counterclockwise: the arc outwards, the strand coming, the arc inwards, the strand going.
bool surround(DiagramEditor& editor, Dart at, Dart corner, bool over) {
  const std::uint32_t vertex = editor.node(corner);
  if (editor.is_crossing(vertex) || editor.node(at) == vertex ||
      editor.node(editor.mate(at)) == vertex || !same_region(editor, at, corner))
    return false;
  const Dart end = editor.mate(at);
  const std::int64_t name = editor.arc(at);
  std::vector<Dart> around = editor.darts(vertex);
  const auto first = static_cast<std::ptrdiff_t>(editor.slot(corner));
  std::rotate(around.begin(), around.begin() + first + 1, around.end());
  std::ranges::reverse(around);
  Dart strand = at;
  for (const Dart d : around) {
    const std::vector<Dart> x = editor.darts(editor.add_node(NodeKind::kCrossing, 4));
    const std::size_t outwards = over ? 0 : 3;
    const auto slot = [&](std::size_t k) { return x[(outwards + k) % 4]; };
    const Dart far = editor.mate(d);
    editor.join(slot(0), far, editor.arc(d));
    editor.join(d, slot(2), editor.arc(d));
    editor.join(strand, slot(1), name);
    strand = slot(3);
  }
  editor.join(strand, end, name);
  return true;
}

bool release(DiagramEditor& editor, Dart at) {
  const std::uint32_t vertex = editor.node(at);
  if (editor.is_crossing(vertex)) return false;
  const std::vector<Dart> around = editor.darts(vertex);
  std::vector<std::uint32_t> crossings;
  std::size_t gaps = 0;
  for (const Dart d : around) {
    const Dart m = editor.mate(d);
    if (!editor.is_crossing(editor.node(m)) ||
        std::ranges::find(crossings, editor.node(m)) != crossings.end() ||
        editor.is_under(m) != editor.is_under(editor.mate(around.front())))
      return false;
    crossings.push_back(editor.node(m));
    const Dart following = editor.mate(editor.next(d));  // counterclockwise
    gaps += editor.mate(editor.previous(m)) != editor.next(following);
  }
  if (gaps > 1) return false;
  for (const std::uint32_t crossing : crossings) editor.dissolve(crossing);
  return true;
}

// Counterclockwise at the crossing: lower right, upper right, upper left, lower left; the vertex is
// below it, `right` its dart towards it on the right.
bool twist(DiagramEditor& editor, Dart right, bool over) {
  const Dart left = editor.next(right);
  if (editor.is_crossing(editor.node(right)) || left == right) return false;
  const Dart far_right = editor.mate(right), far_left = editor.mate(left);
  const std::int64_t name_right = editor.arc(right), name_left = editor.arc(left);
  const std::vector<Dart> x = editor.darts(editor.add_node(NodeKind::kCrossing, 4));
  const auto slot = [&](std::size_t k) { return x[(k + (over ? 1 : 0)) % 4]; };
  editor.join(right, slot(0), name_left);
  editor.join(left, slot(3), name_right);
  if (far_right == left) {
    editor.join(slot(1), slot(2), name_right);
  } else {
    editor.join(slot(1), far_right, name_right);
    editor.join(slot(2), far_left, name_left);
  }
  return true;
}

bool untwist(DiagramEditor& editor, Dart right) {
  const Dart left = editor.next(right);
  const Dart lower_right = editor.mate(right), lower_left = editor.mate(left);
  if (editor.is_crossing(editor.node(right)) || left == right || lower_right == left ||
      !editor.is_crossing(editor.node(lower_right)) || editor.previous(lower_right) != lower_left)
    return false;
  const Dart upper_right = editor.next(lower_right), upper_left = editor.next(upper_right);
  const Dart far_right = editor.mate(upper_right), far_left = editor.mate(upper_left);
  const std::int64_t name_right = editor.arc(upper_right), name_left = editor.arc(upper_left);
  editor.remove_node(editor.node(lower_right));
  if (far_right == upper_left) {
    editor.join(right, left, name_right);
  } else {
    editor.join(right, far_right, name_right);
    editor.join(left, far_left, name_left);
  }
  return true;
}

// Around the arc as around a point, counterclockwise: two arcs of the one vertex, two of the other.
bool exchange_neighbours(DiagramEditor& editor, Dart at) {
  const Dart back = editor.mate(at);
  const std::uint32_t one = editor.node(at), two = editor.node(back);
  if (editor.is_crossing(one) || editor.is_crossing(two) || one == two ||
      editor.darts(one).size() != 3 || editor.darts(two).size() != 3)
    return false;
  const Dart a = editor.next(at), b = editor.next(a), c = editor.next(back), d = editor.next(c);
  editor.set_darts(one, {at, b, c});
  editor.set_darts(two, {back, d, a});
  return true;
}

}  // namespace

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

std::string_view to_string(DiagramMove move) {
  constexpr std::array<std::string_view, kDiagramMoves.size()> kNames{
      "kink", "unkink", "push", "pull", "slide", "surround", "release", "twist", "untwist", "IH"};
  return kNames[static_cast<std::size_t>(move)];
}

bool try_move(DiagramEditor& editor, DiagramMove move, Dart at, Dart other, bool over) {
  switch (move) {
    case DiagramMove::kKink:
      add_kink(editor, at, over);
      return true;
    case DiagramMove::kUnkink:
      return unkink(editor, at);
    case DiagramMove::kPush:
      return push(editor, at, other, over);
    case DiagramMove::kPull:
      return pull(editor, at);
    case DiagramMove::kSlide:
      return slide(editor, at);
    case DiagramMove::kSurround:
      return surround(editor, at, other, over);
    case DiagramMove::kRelease:
      return release(editor, at);
    case DiagramMove::kTwist:
      return twist(editor, at, over);
    case DiagramMove::kUntwist:
      return untwist(editor, at);
    case DiagramMove::kIh:
      break;
  }
  return exchange_neighbours(editor, at);
}

// The standard distributions differ between libraries; the engine does not. The second place is
// drawn from the region of the first, or hardly any push would be legal.
MovedDiagram random_moves(const Diagram& diagram, const RandomDiagramMoves& options) {
  std::mt19937_64 engine(options.seed);
  MovedDiagram result{.diagram = diagram};
  const std::size_t kinds = kDiagramMoves.size() - (options.ih ? 0 : 1);
  std::size_t made = 0;
  for (std::size_t tries = 0; made < options.count && tries < 1000 * options.count; ++tries) {
    const DiagramMove move = kDiagramMoves[engine() % kinds];
    const bool grows = move == DiagramMove::kKink || move == DiagramMove::kPush ||
                       move == DiagramMove::kSurround || move == DiagramMove::kTwist;
    const auto at = static_cast<Dart>(engine() % result.diagram.dart_count());
    auto other = at;
    for (std::uint64_t steps = engine() % 16; steps > 0; --steps)
      other = result.diagram.along_region(other);
    const bool over = engine() % 2 == 0;
    if (grows && result.diagram.crossing_count() >= options.max_crossings) continue;
    DiagramEditor editor(result.diagram);
    if (!try_move(editor, move, at, other, over)) continue;
    result.diagram = editor.finished();
    ++result.made[static_cast<std::size_t>(move)];
    ++made;
  }
  return result;
}

}  // namespace tripus::topology
