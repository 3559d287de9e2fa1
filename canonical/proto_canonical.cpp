// The moves at concave faces are those of J. Weeks, Convex hulls and isometries of cusped
// hyperbolic 3-manifolds (1993), carried over to geodesic boundary. Each makes the hull of the
// vertices lower, so that they come to an end; where four vertices of two tetrahedra lie in one
// plane, they may come to it too early.
#include "canonical/proto_canonical.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <queue>
#include <unordered_set>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/tolerances.hpp"
#include "structure/solve.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

using structure::Report;
using topology::Move;
using topology::MoveKind;
using topology::Triangulation;

/// Beyond so many tetrahedra the solver is started from the lengths that are known already. Before
/// that the default start is as good, and cheaper where there is no metric to be found.
constexpr std::size_t kWarmStart = 32;
/// Up to so many tetrahedra the search makes moves everywhere, beyond only around the trouble.
constexpr std::size_t kSmall = 12;
/// Moves at concave faces, and as many more for each tetrahedron, after which they are taken to go
/// in circles.
constexpr std::size_t kMoves = 100, kMovesPerTetrahedron = 20;
/// Tetrahedra that the search may add.
constexpr std::size_t kExtra = 2;

/// A triangulation on the way, with the metric or without.
struct State {
  Triangulation triangulation;
  Report report;
  std::vector<Move> path;
};

class Walker {
 public:
  Walker(const Triangulation& triangulation, const Report& report,
         const ProtoCanonicalOptions& options)
      : options_(options), volume_(report.volume), state_{triangulation, report, {}} {}

  ProtoCanonical run() {
    if (!descend()) search();
    return {std::move(state_.triangulation), std::move(state_.report), std::move(faces_),
            std::move(state_.path), !faces_.has_concave()};
  }

 private:
  /// Moves at concave faces as long as there are any that do; true if no concave face is left.
  bool descend() {
    // In exact arithmetic every such move lowers the hull, so that none comes back; but moves in
    // one plane can go in circles by rounding, and the search knows where it has been.
    std::size_t left = kMoves + kMovesPerTetrahedron * state_.triangulation.tetrahedron_count();
    while (left-- > 0 && !stopped() && improve()) {
    }
    faces_ = face_kinds(state_.triangulation, state_.report.edge_lengths);
    return !faces_.has_concave();
  }

  bool stopped() const {
    return options_.stop_requested != nullptr && options_.stop_requested->load();
  }

  /// Makes one move at a concave face. False if there is no such face, or no such move.
  bool improve() {
    faces_ = face_kinds(state_.triangulation, state_.report.edge_lengths);
    if (!faces_.has_concave()) return false;
    for (const Move& move : moves_at_concave_faces()) {
      auto next = after(state_, move);
      if (!next || next->report.outcome != structure::Outcome::kGeometric) continue;
      state_ = std::move(*next);
      return true;
    }
    return false;
  }

  /// A best-first search from where the moves got stuck, fewest tetrahedra first; from every new
  /// triangulation with the metric the moves go on.
  void search() {
    using Entry = std::pair<std::size_t, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::vector<State> nodes;
    std::unordered_set<std::string> known;
    const State stuck = state_;
    const std::size_t limit = stuck.triangulation.tetrahedron_count() + kExtra;
    const auto add = [&](State state) {
      open.emplace(state.triangulation.tetrahedron_count(), nodes.size());
      nodes.push_back(std::move(state));
    };
    known.insert(topology::isosig(stuck.triangulation.gluings()));
    add(stuck);
    constexpr std::array kKinds{MoveKind::kThreeTwo, MoveKind::kFourFour, MoveKind::kTwoThree};
    while (!open.empty() && solves_ < options_.budget && !stopped()) {
      const State here = nodes[open.top().second];
      open.pop();
      const std::vector<bool> trouble = trouble_of(here);
      for (const Move& move : topology::all_moves(here.triangulation, kKinds)) {
        const bool grows = move.kind == MoveKind::kTwoThree;
        if (here.triangulation.tetrahedron_count() + grows > limit) continue;
        if (!trouble.empty() && !trouble[move.tetrahedron]) continue;
        if (solves_ >= options_.budget || stopped()) break;
        auto next = after(here, move);
        if (!next || !known.insert(topology::isosig(next->triangulation.gluings())).second)
          continue;
        if (next->report.outcome == structure::Outcome::kGeometric) {
          state_ = std::move(*next);
          if (descend()) return;
          known.insert(topology::isosig(state_.triangulation.gluings()));
          next = state_;
        }
        add(std::move(*next));
      }
    }
    state_ = stuck;
    faces_ = face_kinds(state_.triangulation, state_.report.edge_lengths);
  }

  /// [T] tetrahedra around which the search makes moves; empty for all.
  static std::vector<bool> trouble_of(const State& state) {
    const std::size_t count = state.triangulation.tetrahedron_count();
    if (count <= kSmall) return {};
    std::vector<bool> trouble(count);
    if (state.report.outcome == structure::Outcome::kGeometric) {
      const FaceKinds faces = face_kinds(state.triangulation, state.report.edge_lengths);
      for (std::size_t t = 0; t < count; ++t)
        trouble[t] = std::ranges::find(faces.kind[t], FaceKind::kConcave) != faces.kind[t].end();
    }
    for (const std::size_t t : state.report.flat_tetrahedra) trouble[t] = true;
    for (std::size_t t = 0; t < count; ++t)
      for (int e = 0; e < 6; ++e)
        if (state.triangulation.valence(state.triangulation.edge_class(t, e)) < 4)
          trouble[t] = true;
    return trouble;
  }

  /// 3-2 first, then 2-3, then 4-4; the most concave face first.
  std::vector<Move> moves_at_concave_faces() const {
    struct Face {
      double sum;
      std::size_t t;
      int f;
    };
    std::vector<Face> faces;
    for (std::size_t t = 0; t < state_.triangulation.tetrahedron_count(); ++t)
      for (int f = 0; f < 4; ++f)
        if (kind(t, f) == FaceKind::kConcave)
          faces.push_back({faces_.sum[t][static_cast<std::size_t>(f)], t, f});
    std::ranges::stable_sort(faces, std::greater<>{}, &Face::sum);
    std::vector<Move> moves;
    for (const Face& face : faces) add_edge_moves(face.t, face.f, 3, moves);
    for (const Face& face : faces)
      if (is_crossed(face.t, face.f)) moves.push_back(two_three(face.t, face.f));
    for (const Face& face : faces) add_edge_moves(face.t, face.f, 4, moves);
    return moves;
  }

  FaceKind kind(std::size_t t, int f) const { return faces_.kind[t][static_cast<std::size_t>(f)]; }

  static Move two_three(std::size_t t, int f) {
    return {MoveKind::kTwoThree, static_cast<topology::TetrahedronIndex>(t),
            static_cast<std::uint8_t>(f), 0, 0};
  }

  /// The moves at edges of the face with valence 3 or 4.
  void add_edge_moves(std::size_t t, int f, std::size_t valence, std::vector<Move>& moves) const {
    for (int e = 0; e < 6; ++e) {
      const auto ends = topology::kEdgeEnds[static_cast<std::size_t>(e)];
      if (ends[0] == f || ends[1] == f) continue;
      if (state_.triangulation.valence(state_.triangulation.edge_class(t, e)) != valence) continue;
      const auto kind = valence == 3 ? MoveKind::kThreeTwo : MoveKind::kFourFour;
      const std::uint8_t axes = valence == 3 ? 1 : 2;
      for (std::uint8_t axis = 0; axis < axes; ++axis)
        moves.push_back({kind, static_cast<topology::TetrahedronIndex>(t),
                         static_cast<std::uint8_t>(e), axis, 0});
    }
  }

  /// Whether the edge that a 2-3 move makes crosses the inside of the face: exactly when the two
  /// tetrahedra have angles of sum less than pi at each edge of it.
  bool is_crossed(std::size_t t, int f) const {
    const auto& gluings = state_.triangulation.gluings();
    const std::size_t other = gluings.neighbour(t, f);
    const auto p = gluings.gluing(t, f);
    for (int e = 0; e < 6; ++e) {
      const auto ends = topology::kEdgeEnds[static_cast<std::size_t>(e)];
      if (ends[0] == f || ends[1] == f) continue;
      const int image = topology::kEdgeNumber[static_cast<std::size_t>(p(ends[0]))]
                                             [static_cast<std::size_t>(p(ends[1]))];
      const auto& angles = state_.report.dihedral_angles;
      if (angles[t][static_cast<std::size_t>(e)] + angles[other][static_cast<std::size_t>(image)] >
          std::numbers::pi - tolerance::kFlatAngleMargin)
        return false;
    }
    return true;
  }

  /// The state after a move, solved; nothing if it is not legal. Edges of valence 1 and 2, which no
  /// metric has, are not solved on.
  std::optional<State> after(const State& from, const Move& move) {
    topology::Gluings gluings = from.triangulation.gluings();
    if (!topology::can_apply(gluings, move)) return std::nullopt;
    const topology::MoveChange change = topology::apply(gluings, move);
    State next{Triangulation(std::move(gluings)), {}, from.path};
    next.path.push_back(move);
    for (std::size_t e = 0; e < next.triangulation.edge_count(); ++e)
      if (next.triangulation.valence(e) < 3) return next;
    structure::SolveOptions solve;
    solve.evidence = false;
    solve.stop_requested = options_.stop_requested;
    if (next.triangulation.tetrahedron_count() > kWarmStart &&
        from.report.outcome == structure::Outcome::kGeometric)
      solve.initial_lengths = carried_over(from, next.triangulation, change);
    next.report = structure::solve(next.triangulation, solve);
    ++solves_;
    if (next.report.outcome == structure::Outcome::kGeometric &&
        !(std::fabs(next.report.volume - volume_) <= tolerance::kVolumeAgreement * volume_)) {
      throw InternalError(fmt::format("{} changed the volume from {} to {}",
                                      topology::to_string(move), volume_, next.report.volume));
    }
    return next;
  }

  /// Lengths for the triangulation after a move: edges that were there keep theirs.
  static std::vector<double> carried_over(const State& from, const Triangulation& next,
                                          const topology::MoveChange& change) {
    constexpr auto kNew = topology::kNoTetrahedron;
    std::vector<topology::TetrahedronIndex> old(next.tetrahedron_count());
    for (std::size_t t = 0; t < old.size(); ++t)
      old[t] = static_cast<topology::TetrahedronIndex>(t);
    for (const auto& renumbered : change.renumbered) old[renumbered.to] = renumbered.from;
    for (const auto t : change.added) old[t] = kNew;
    const auto& lengths = from.report.edge_lengths;
    double mean = 0;
    for (const double l : lengths) mean += l / static_cast<double>(lengths.size());
    std::vector<double> result(next.edge_count(), mean);
    for (std::size_t t = 0; t < old.size(); ++t) {
      if (old[t] == kNew) continue;
      for (int e = 0; e < 6; ++e)
        result[next.edge_class(t, e)] = lengths[from.triangulation.edge_class(old[t], e)];
    }
    return result;
  }

  const ProtoCanonicalOptions options_;
  const double volume_;
  State state_;
  FaceKinds faces_;  // of state_
  std::size_t solves_ = 0;
};

}  // namespace

ProtoCanonical proto_canonical(const Triangulation& triangulation, const Report& report,
                               const ProtoCanonicalOptions& options) {
  return Walker(triangulation, report, options).run();
}

}  // namespace tripus::canonical
