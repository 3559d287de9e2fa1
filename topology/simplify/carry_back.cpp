#include "topology/simplify/carry_back.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "topology/edge_walk.hpp"
#include "topology/moves/detail/surgery.hpp"
#include "topology/simplify/detail/flattening.hpp"

// A step replaces the tetrahedra R of `before` by the tetrahedra D of `after`; all others, and
// their frames, are in both. There is a map q from the space of `before` to that of `after` that is
// the identity elsewhere and induces an isomorphism of fundamental groups (of the space without its
// ideal vertices). A path of dual edges in `before` gets the value of its image.
//
// D is not empty: R and D are two triangulations of one ball. All of R gets the frame of the first
// tetrahedron of D; inside there is nothing to say, and a face of R on the sphere has the value of
// the same face of D, carried to the first one.
//
// D is empty: R is flattened onto merged faces (detail/flattening.hpp). What is flattened onto one
// of them (collapse, 2-0 at a vertex) gets the frame of its near side. In a 2-0 at an edge the
// tetrahedra are flattened onto two merged faces with a common edge, the hinge, and get the frame
// of the one; to the other one goes around the hinge. In a collapse of ab two neighbours around ab
// share a face abc, which becomes an edge of both of their merged faces: from one to the other one
// goes around that edge. Either way around will do, as the connection is flat; both are tried at
// once, the shorter one ends first, and the cost is that of relabelling the smaller of two classes
// in collapse.cpp.

namespace tripus::topology {
namespace {

using Value = std::uint32_t;
using detail::Port;

/// Values of a greater size make all frames be chosen anew, at most once in so many steps as there
/// are tetrahedra divided by kStepsPerTetrahedron.
constexpr double kFar = 6;
constexpr std::size_t kStepsPerTetrahedron = 8;

class CarryBack final : public WayBack {
 public:
  CarryBack(FlatConnection& connection, NumberedGroup& group) : c_(connection), group_(group) {}

  void renumbered(const Gluings& slots, std::span<const TetrahedronIndex> number) override;
  void step(const StepBack& step) override;

 private:
  struct Written {
    std::size_t slot;
    Value value;
  };

  Value value(std::size_t t, int f) const { return c_.values[slot_of(t, f)]; }
  Value times(Value a, Value b) { return a == 0 ? b : b == 0 ? a : group_.product(a, b); }
  Value inverse(Value a) { return a == 0 ? 0 : group_.inverse(a); }
  /// Sets both sides of a face of `before`.
  void write(const Gluings& before, TetrahedronIndex t, int f, Value value) {
    written_.push_back({slot_of(t, f), value});
    written_.push_back({slot_of(before.neighbour(t, f), before.gluing(t, f)(f)), inverse(value)});
  }

  void relax(const Gluings& table);
  bool is_far(TetrahedronIndex t) const;
  void settle(const Gluings& table, TetrahedronIndex t);
  /// A value across a face of t, when t takes another frame.
  Value changed(Value across, Value frame, bool is_loop) {
    const Value from = times(inverse(frame), across);
    return is_loop ? times(from, frame) : from;
  }

  void take_back_ball(const StepBack& step);
  void take_back_collapse(const StepBack& step);
  void take_back_pillow(const StepBack& step);

  void write_outer(const StepBack& step);
  Value around(const Gluings& after, EdgeWalk from, const EdgeWalk& to);

  FlatConnection& c_;
  NumberedGroup& group_;
  struct Frame {
    TetrahedronIndex t;
    TetrahedronIndex origin;
  };
  /// Tetrahedron t of R has the frame of tetrahedron `of` of `after`.
  void give_frame(TetrahedronIndex t, TetrahedronIndex of) {
    frames_.push_back({t, c_.origins[of]});
  }

  std::size_t steps_since_relaxed_ = 0;
  std::vector<Written> written_;
  std::vector<Frame> frames_;
  detail::Flattening flat_;  // empty between two steps
  std::vector<EdgeWalk> corners_;
};

void CarryBack::renumbered(const Gluings& slots, std::span<const TetrahedronIndex> number) {
  std::vector<Value> values(4 * slots.tetrahedron_count(), 0);
  std::vector<TetrahedronIndex> origins(number.size(), kNoTetrahedron);
  for (std::size_t t = 0; t < number.size(); ++t) {
    if (number[t] == kNoTetrahedron) continue;
    origins[t] = c_.origins[number[t]];
    for (int f = 0; f < 4; ++f) values[slot_of(t, f)] = value(number[t], f);
  }
  c_.values = std::move(values);
  c_.origins = std::move(origins);
  flat_.reset(c_.values.size());
  for (TetrahedronIndex t = 0; t < number.size(); ++t)
    if (number[t] != kNoTetrahedron) settle(slots, t);
}

void CarryBack::step(const StepBack& step) {
  written_.clear();
  frames_.clear();
  if (step.step.is_collapse)
    take_back_collapse(step);
  else if (step.made.empty())
    take_back_pillow(step);
  else
    take_back_ball(step);
  for (const auto& [slot, value] : written_) c_.values[slot] = value;
  for (const auto& [t, origin] : frames_) c_.origins[t] = origin;
  for (const auto& [t, origin] : frames_) settle(step.before, t);
  ++steps_since_relaxed_;
  if (steps_since_relaxed_ * kStepsPerTetrahedron >= step.before.tetrahedron_count() &&
      std::ranges::any_of(frames_, [&](const Frame& each) { return is_far(each.t); }))
    relax(step.before);
}

bool CarryBack::is_far(TetrahedronIndex t) const {
  for (int f = 0; f < 4; ++f)
    if (group_.size(value(t, f)) > kFar) return true;
  return false;
}

/// New frames for all tetrahedra, as the group proposes: greedy steps from neighbour to neighbour
/// end where no single one helps.
void CarryBack::relax(const Gluings& table) {
  steps_since_relaxed_ = 0;
  std::vector<NumberedGroup::Link> links;
  std::vector<std::size_t> slots;
  for (std::uint32_t t = 0; t < table.tetrahedron_count(); ++t)
    for (int f = 0; f < 4; ++f)
      if (!table.is_open(t, f)) {
        links.push_back({t, static_cast<std::uint32_t>(table.neighbour(t, f)), value(t, f)});
        slots.push_back(slot_of(t, f));
      }
  const std::vector<Value> change = group_.better_frames(links, table.tetrahedron_count());
  for (std::size_t n = 0; n < links.size() && !change.empty(); ++n)
    c_.values[slots[n]] =
        group_.conjugate(change[links[n].from], links[n].element, change[links[n].to]);
}

/// Gives t the frame of that neighbour which makes the sum of the sizes of its values least, if
/// that is less than now.
void CarryBack::settle(const Gluings& table, TetrahedronIndex t) {
  double now = 0;
  for (int f = 0; f < 4; ++f) now += group_.size(value(t, f));
  int best = -1;
  double least = now * (1 - 1e-9);
  for (int g = 0; g < 4 && now > 0; ++g) {
    const Value frame = value(t, g);
    if (frame == 0 || table.neighbour(t, g) == t) continue;
    double sum = 0;
    for (int f = 0; f < 4 && sum < least; ++f) {
      const Value across = value(t, f);
      const bool is_loop = table.neighbour(t, f) == t;
      // What cannot be held is not small.
      if (!group_.can_hold_product(frame, across) ||
          (is_loop && !group_.can_hold_product(frame, times(inverse(frame), across))))
        sum = least;
      else
        sum += group_.size(changed(across, frame, is_loop));
    }
    if (sum >= least) continue;
    least = sum;
    best = g;
  }
  if (best < 0) return;
  const Value frame = value(t, best);
  c_.origins[t] = c_.origins[table.neighbour(t, best)];
  std::array<Value, 4> values{};
  for (int f = 0; f < 4; ++f)
    values[static_cast<std::size_t>(f)] = changed(value(t, f), frame, table.neighbour(t, f) == t);
  for (int f = 0; f < 4; ++f) {
    const Value across = values[static_cast<std::size_t>(f)];
    c_.values[slot_of(t, f)] = across;
    if (table.neighbour(t, f) != t)
      c_.values[slot_of(table.neighbour(t, f), table.gluing(t, f)(f))] = inverse(across);
  }
}

/// The piece of `fresh` that has the face with these points, and which of its faces that is.
struct SameFace {
  std::size_t piece;
  int f;
};
SameFace same_face(const detail::MoveBall& ball, const detail::Points& points, int f) {
  const unsigned face = detail::point_mask(points) & ~(1u << points[static_cast<std::size_t>(f)]);
  for (std::size_t k = 0; k < ball.fresh.size(); ++k) {
    const unsigned rest = detail::point_mask(ball.fresh[k]) & ~face;
    if ((detail::point_mask(ball.fresh[k]) & face) == face)
      for (int g = 0; g < 4; ++g)
        if (rest == 1u << ball.fresh[k][static_cast<std::size_t>(g)]) return {k, g};
  }
  throw InternalError("a face of a ball is not in the ball that replaced it");
}

void CarryBack::take_back_ball(const StepBack& step) {
  const Gluings& before = step.before;
  detail::MoveBall ball = info(step.step.move.kind).ball(before, step.step.move);
  detail::plan_ball(before, ball);  // turns the new tetrahedra as they were made
  // Frames of the new tetrahedra in that of the first. Inside the ball any path does.
  std::array<Value, 4> to_first{};
  std::array<bool, 4> known{true};
  for (std::size_t round = 0; round < step.made.size(); ++round)
    for (std::size_t k = 0; k < step.made.size(); ++k)
      for (std::size_t j = 0; j < step.made.size() && known[k]; ++j)
        for (int f = 0; f < 4 && !known[j]; ++f) {
          // The face inside that pieces k and j share, by its points.
          const unsigned shared =
              detail::point_mask(ball.fresh[k]) & detail::point_mask(ball.fresh[j]);
          if ((detail::point_mask(ball.fresh[k]) & ~shared) !=
                  1u << ball.fresh[k][static_cast<std::size_t>(f)] ||
              step.after.neighbour(step.made[k], f) != step.made[j])
            continue;
          to_first[j] = times(to_first[k], value(step.made[k], f));
          known[j] = true;
        }
  const auto piece_of = [&](TetrahedronIndex t) -> const detail::Piece* {
    for (const detail::Piece& piece : ball.old)
      if (piece.t == t) return &piece;
    return nullptr;
  };
  for (const auto& [t, points] : ball.old) {
    give_frame(t, step.made[0]);
    for (int f = 0; f < 4; ++f) {
      const unsigned face =
          detail::point_mask(points) & ~(1u << points[static_cast<std::size_t>(f)]);
      if ((face & ball.core) == ball.core) {
        write(before, t, f, 0);
        continue;
      }
      const SameFace here = same_face(ball, points, f);
      Value across = times(to_first[here.piece], value(step.made[here.piece], here.f));
      const TetrahedronIndex other = before.neighbour(t, f);
      if (const detail::Piece* behind = piece_of(other)) {
        const SameFace there = same_face(ball, behind->points, before.gluing(t, f)(f));
        across = times(across, inverse(to_first[there.piece]));
      }
      write(before, t, f, across);
    }
  }
}

void CarryBack::write_outer(const StepBack& step) {
  for (const Port& at : flat_.ports()) {
    const TetrahedronIndex other = step.before.neighbour(at.t, at.f);
    const int entered = step.before.gluing(at.t, at.f)(at.f);
    Value across = at.to_frame;
    if (const Port* behind = flat_.port(other, entered))
      across = times(across, inverse(behind->to_frame));
    else if (other != at.near || entered != at.to_near(at.f))  // the far side
      across = times(across, value(at.near, at.to_near(at.f)));
    write(step.before, at.t, at.f, across);
  }
}

/// The value of the way around an edge of `after` from one corner of it to another.
Value CarryBack::around(const Gluings& after, EdgeWalk from, const EdgeWalk& to) {
  const auto there = [&](const EdgeWalk& walk) {
    return walk.t == to.t && walk.a == to.a && walk.b == to.b;
  };
  std::array<EdgeWalk, 2> walks{from, from};
  std::swap(walks[1].c, walks[1].d);
  std::array<Value, 2> products{};
  if (there(from)) return 0;
  while (true)
    for (std::size_t way = 0; way < 2; ++way) {
      products[way] = times(products[way], value(walks[way].t, walks[way].c));
      walks[way].step(after);
      if (there(walks[way])) return products[way];
    }
}

namespace {

/// The corner at the image of edge uv of a port's tetrahedron, in the near side of its merged face.
EdgeWalk near_corner(const Port& at, int u, int v) {
  const int a = at.to_near(u), b = at.to_near(v), face = at.to_near(at.f);
  return {at.near, a, b, 6 - a - b - face, face};
}

}  // namespace

void CarryBack::take_back_collapse(const StepBack& step) {
  const Gluings& before = step.before;
  const Move& move = step.step.move;
  corners_.clear();
  const auto start = EdgeWalk::start(move.tetrahedron, move.place);
  EdgeWalk walk = start;
  do {
    corners_.push_back(walk);
    walk.step(before);
  } while (walk.t != start.t || walk.a != start.a || walk.b != start.b);
  for (const EdgeWalk& at : corners_) {
    const auto t = static_cast<TetrahedronIndex>(at.t);
    flat_.lay(t, at.a, t, Perm4::transposition(at.a, at.b));
    flat_.lay(t, at.b, t, Perm4::transposition(at.a, at.b));
  }
  flat_.find_near(before);
  // From each corner to the next, through the face opposite c, which contains a, b and d.
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const EdgeWalk& at = corners_[i];
    const EdgeWalk& next = corners_[(i + 1) % corners_.size()];
    const Port& here = *flat_.port(static_cast<TetrahedronIndex>(at.t), at.b);
    const Port& there = *flat_.port(static_cast<TetrahedronIndex>(next.t), next.b);
    // d here is c there.
    write(before, static_cast<TetrahedronIndex>(at.t), at.c,
          around(step.after, near_corner(here, at.a, at.d), near_corner(there, next.a, next.c)));
  }
  for (const EdgeWalk& at : corners_) {
    const auto t = static_cast<TetrahedronIndex>(at.t);
    give_frame(t, flat_.port(t, at.b)->near);
  }
  write_outer(step);
  flat_.clear();
}

void CarryBack::take_back_pillow(const StepBack& step) {
  const Gluings& before = step.before;
  const detail::MoveBall ball = info(step.step.move.kind).ball(before, step.step.move);
  const auto& one = ball.old[0];
  const auto& two = ball.old[1];
  std::array<int, 4> images{};
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const unsigned common = detail::point_mask(one.points) & detail::point_mask(two.points);
  int left = 6;
  for (int v = 0; v < 4; ++v)
    if ((common >> one.points[at(v)] & 1) != 0)
      left -= images[at(v)] = detail::vertex_at(two.points, one.points[at(v)]);
  for (int v = 0; v < 4; ++v)
    if ((common >> one.points[at(v)] & 1) == 0) images[at(v)] = left;
  const Perm4 map = Perm4::from_images(images[0], images[1], images[2], images[3]);
  for (int f = 0; f < 4; ++f) {
    const unsigned face = detail::point_mask(one.points) & ~(1u << one.points[at(f)]);
    if ((face & ball.core) == ball.core) {
      write(before, one.t, f, 0);
      continue;
    }
    flat_.lay(one.t, f, two.t, map);
    flat_.lay(two.t, map(f), one.t, map.inverse());
  }
  flat_.find_near(before);
  std::vector<Port>& ports = flat_.ports();
  if (ports.size() == 4) {
    // The hinge of the first tetrahedron lies opposite the edge around which the two are.
    const int a = ports[0].f, b = ports[2].f;
    const auto [c, d] = kEdgeEnds[at(5 - kEdgeNumber[at(a)][at(b)])];
    const Value hinge =
        around(step.after, near_corner(ports[0], c, d), near_corner(ports[2], c, d));
    ports[2].to_frame = ports[3].to_frame = hinge;
  }
  give_frame(one.t, ports[0].near);
  give_frame(two.t, ports[0].near);
  write_outer(step);
  flat_.clear();
}

}  // namespace

FlatConnection carried_back(const Gluings& start, const SimplificationRecord& record,
                            FlatConnection connection, NumberedGroup& group) {
  if (connection.origins.empty()) {
    connection.origins.resize(connection.values.size() / 4);
    std::iota(connection.origins.begin(), connection.origins.end(), TetrahedronIndex{0});
  }
  CarryBack way(connection, group);
  replay_backwards(start, record, way);
  connection.values.resize(4 * start.tetrahedron_count());
  connection.origins.resize(start.tetrahedron_count());
  return connection;
}

std::vector<std::pair<TetrahedronIndex, int>> curved_edges(const Gluings& gluings,
                                                           std::span<const std::uint32_t> values,
                                                           NumberedGroup& group) {
  std::vector<std::pair<TetrahedronIndex, int>> curved;
  std::vector<bool> seen(6 * gluings.tetrahedron_count(), false);
  for (TetrahedronIndex t = 0; t < gluings.tetrahedron_count(); ++t)
    for (int e = 0; e < 6; ++e) {
      if (seen[6 * t + static_cast<std::size_t>(e)]) continue;
      const auto start = EdgeWalk::start(t, e);
      EdgeWalk walk = start;
      Value product = 0;
      bool is_closed = true;
      do {
        seen[6 * walk.t + static_cast<std::size_t>(walk.edge())] = true;
        if (gluings.is_open(walk.t, walk.c)) {
          is_closed = false;
          break;
        }
        const Value across = values[slot_of(walk.t, walk.c)];
        if (across != 0) product = product == 0 ? across : group.product(product, across);
        walk.step(gluings);
      } while (walk.t != start.t || walk.a != start.a || walk.b != start.b);
      if (is_closed && product != 0) curved.emplace_back(t, e);
    }
  return curved;
}

}  // namespace tripus::topology
