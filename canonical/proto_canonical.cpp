// The moves at concave faces are those of J. Weeks, Convex hulls and isometries of cusped
// hyperbolic 3-manifolds (1993), carried over to geodesic boundary. Each makes the hull of the
// vertices lower, so that they come to an end; where four vertices of two tetrahedra lie in one
// plane, they may come to it too early.
#include "canonical/proto_canonical.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <optional>
#include <unordered_set>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/tolerances.hpp"
#include "canonical/detail/carried_metric.hpp"
#include "canonical/detail/flat_passage.hpp"
#include "structure/solve.hpp"
#include "topology/labelled_isosig.hpp"
#include "topology/moves/best_first.hpp"

namespace tripus::canonical {
namespace {

using structure::Report;
using topology::Move;
using topology::MoveKind;
using topology::Triangulation;

/// Up to so many tetrahedra the search makes moves everywhere, beyond only around the trouble.
constexpr std::size_t kSmall = 12;
/// Tetrahedra that the search through triangulations with the metric may add.
constexpr std::size_t kSpread = 4;
/// Where there is a metric and its lengths are known, a solution takes a step or none.
constexpr std::size_t kCheap = 4;
/// Moves at concave faces, and as many more for each tetrahedron, after which they are taken to go
/// in circles.
constexpr std::size_t kMoves = 100, kMovesPerTetrahedron = 20;
/// Times that the way may lead through flat tetrahedra, and as many more as there are tetrahedra.
constexpr std::size_t kPassages = 10;
/// On it nothing is solved, so that the budget goes so many times as far.
constexpr std::size_t kPassageShare = 30;
/// Tetrahedra that the other search may add.
constexpr std::size_t kExtra = 2;

using detail::CarriedMetric;
using State = detail::MetricState;

FaceKinds faces_of(const State& state) {
  return face_kinds(state.triangulation, state.report.edge_lengths, state.cone_angles);
}

class Walker {
 public:
  Walker(const Triangulation& triangulation, const Report& report,
         const ProtoCanonicalOptions& options)
      : options_(options),
        volume_(report.volume),
        state_{triangulation, report, {}, options.cone_angles, true} {}

  ProtoCanonical run() {
    if (!descend() && !through_planes() && !spread()) search();
    const bool found = !faces_.has_concave();
    return {std::move(state_.triangulation), std::move(state_.report),      std::move(faces_),
            std::move(state_.path),          std::move(state_.cone_angles), found};
  }

 private:
  /// Moves at concave faces as long as there are any that do, and lead to something new; true if no
  /// concave face is left.
  bool descend() {
    // In exact arithmetic every such move lowers the hull, so that none comes back; but moves in
    // one plane can go in circles by rounding, and the search knows where it has been.
    std::size_t left = kMoves + kMovesPerTetrahedron * state_.triangulation.tetrahedron_count();
    while (left-- > 0 && !stopped() && improve()) {
      if (known_.empty()) continue;
      if (!known_.insert(key(state_)).second) return false;
      open_.push_back(state_);
    }
    faces_ = faces_of(state_);
    return !faces_.has_concave();
  }

  bool stopped() const { return options_.stop.requested(); }

  /// Makes one move at a concave face. False if there is no such face, or no such move.
  bool improve() {
    faces_ = faces_of(state_);
    if (!faces_.has_concave()) return false;
    for (const Move& move : moves_at_concave_faces()) {
      auto next = detail::carried_metric(state_, move);
      if (!next || !detail::has_true_tetrahedra(*next)) continue;
      solve(*next);
      if (next->state.report.outcome != structure::Outcome::kGeometric) continue;
      state_ = std::move(next->state);
      return true;
    }
    return false;
  }

  /// From where the moves got stuck through triangulations with flat tetrahedra, and from each that
  /// has none again moves at concave faces.
  bool through_planes() {
    const State stuck = state_;
    std::unordered_set<std::string> seen{key(stuck)};
    const auto go_on = [&](CarriedMetric& next) {
      if (stopped()) return true;
      solve(next);
      if (next.state.report.outcome != structure::Outcome::kGeometric) return false;
      state_ = std::move(next.state);
      return descend() || seen.insert(key(state_)).second;
    };
    std::size_t budget = kPassageShare * options_.budget;
    const std::size_t most = kPassages + state_.triangulation.tetrahedron_count();
    for (std::size_t k = 0; k < most && budget > 0 && !stopped(); ++k) {
      const State here = state_;
      const FaceKinds faces = faces_;
      if (!detail::pass_through_planes(here, faces, go_on, options_.stop, budget)) break;
      if (!faces_.has_concave()) return true;
    }
    state_ = stuck;
    faces_ = faces_of(state_);
    return false;
  }

  /// Breadth first from where the moves got stuck through triangulations that carry the metric, and
  /// from each again moves at concave faces until they come to one that is known. Cheap, as there
  /// is nothing is solved for in vain, so that the budget goes kCheap times as far. Up to kSmall
  /// tetrahedra.
  bool spread() {
    const State stuck = state_;
    const std::size_t limit = stuck.triangulation.tetrahedron_count() + kSpread;
    if (limit > kSmall + kSpread) return false;
    constexpr std::array kKinds{MoveKind::kThreeTwo, MoveKind::kFourFour, MoveKind::kTwoThree};
    known_.insert(key(stuck));
    open_.assign(1, stuck);
    while (!open_.empty() && solves_ < kCheap * options_.budget && !stopped()) {
      const State here = std::move(open_.front());
      open_.pop_front();
      for (const Move& move : topology::all_moves(here.triangulation, kKinds)) {
        if (solves_ >= kCheap * options_.budget) break;
        const bool grows = move.kind == MoveKind::kTwoThree;
        if (here.triangulation.tetrahedron_count() + grows > limit) continue;
        auto next = detail::carried_metric(here, move);
        if (!next || !detail::has_true_tetrahedra(*next)) continue;
        if (!known_.insert(key(next->state)).second) continue;
        solve(*next);
        if (next->state.report.outcome != structure::Outcome::kGeometric) continue;
        open_.push_back(next->state);
        state_ = std::move(next->state);
        if (descend()) return true;
      }
    }
    known_.clear();
    open_.clear();
    solves_ = 0;
    state_ = stuck;
    faces_ = faces_of(state_);
    return false;
  }

  /// A best-first search from where the moves got stuck, fewest tetrahedra first; from every new
  /// triangulation with the metric the moves go on.
  void search() {
    topology::BestFirst<State> book;
    const State stuck = state_;
    const std::size_t limit = stuck.triangulation.tetrahedron_count() + kExtra;
    const auto add = [&](State state) {
      book.add(state.triangulation.tetrahedron_count(), std::move(state));
    };
    book.learn(key(stuck));
    add(stuck);
    constexpr std::array kKinds{MoveKind::kThreeTwo, MoveKind::kFourFour, MoveKind::kTwoThree};
    while (book.has_open() && solves_ < kCheap * options_.budget && !stopped()) {
      const State here = book[book.next()];
      const std::size_t size = here.triangulation.tetrahedron_count();
      const std::vector<bool> trouble = trouble_of(here);
      for (const Move& move : topology::all_moves(here.triangulation, kKinds)) {
        const bool grows = move.kind == MoveKind::kTwoThree;
        if (size + grows > limit) continue;
        if (!trouble.empty() && !trouble[move.tetrahedron]) continue;
        if (solves_ >= kCheap * options_.budget || stopped()) break;
        auto next = detail::carried_metric(here, move);
        if (!next || !book.learn(key(next->state))) continue;
        const bool was_geometric = here.report.outcome == structure::Outcome::kGeometric;
        if (!was_geometric || detail::has_true_tetrahedra(*next)) solve(*next);
        if (next->state.report.outcome == structure::Outcome::kGeometric) {
          state_ = std::move(next->state);
          if (descend()) return;
          if (!book.learn(key(state_))) continue;
          next->state = state_;
        }
        add(std::move(next->state));
      }
    }
    state_ = stuck;
    faces_ = faces_of(state_);
  }

  static std::string key(const State& state) {
    return topology::labelled_isosig(state.triangulation, state.cone_angles);
  }

  /// [T] tetrahedra around which the search makes moves; empty for all.
  static std::vector<bool> trouble_of(const State& state) {
    const std::size_t count = state.triangulation.tetrahedron_count();
    if (count <= kSmall) return {};
    std::vector<bool> trouble(count);
    if (state.report.outcome == structure::Outcome::kGeometric) {
      const FaceKinds faces = faces_of(state);
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
      if (is_crossed(state_, face.t, face.f)) moves.push_back(two_three(face.t, face.f));
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
  static bool is_crossed(const State& state, std::size_t t, int f) {
    const auto& gluings = state.triangulation.gluings();
    const std::size_t other = gluings.neighbour(t, f);
    const auto p = gluings.gluing(t, f);
    for (int e = 0; e < 6; ++e) {
      const auto ends = topology::kEdgeEnds[static_cast<std::size_t>(e)];
      if (ends[0] == f || ends[1] == f) continue;
      const int image = topology::kEdgeNumber[static_cast<std::size_t>(p(ends[0]))]
                                             [static_cast<std::size_t>(p(ends[1]))];
      const auto& angles = state.report.dihedral_angles;
      if (angles[t][static_cast<std::size_t>(e)] + angles[other][static_cast<std::size_t>(image)] >
          std::numbers::pi - tolerance::kFlatAngleMargin)
        return false;
    }
    return true;
  }

  /// Looks for the metric. Edges of valence 1 and 2 without a label, which no metric has, are not
  /// solved on.
  void solve(CarriedMetric& next) {
    State& state = next.state;
    for (std::size_t e = 0; e < state.triangulation.edge_count(); ++e)
      if (state.triangulation.valence(e) < 3 && is_full(state, e)) return;
    structure::SolveOptions solve;
    solve.evidence = false;
    solve.stop = options_.stop;
    solve.cone_angles = state.cone_angles;
    solve.initial_lengths = next.lengths;
    state.report = structure::solve(state.triangulation, solve);
    state.has_metric = state.report.outcome == structure::Outcome::kGeometric;
    ++solves_;
    if (state.report.outcome == structure::Outcome::kGeometric &&
        !(std::fabs(state.report.volume - volume_) <= tolerance::kVolumeAgreement * volume_)) {
      throw InternalError(fmt::format("{} changed the volume from {} to {}",
                                      topology::to_string(state.path.back()), volume_,
                                      state.report.volume));
    }
  }

  static bool is_full(const State& state, std::size_t edge) {
    return state.cone_angles.empty() || state.cone_angles[edge].is_full();
  }

  const ProtoCanonicalOptions options_;
  const double volume_;
  State state_;
  FaceKinds faces_;  // of state_
  std::size_t solves_ = 0;
  /// Triangulations from which moves at concave faces get stuck; empty while there is no search.
  std::unordered_set<std::string> known_;
  std::deque<State> open_;  ///< those of them whose neighbours were not looked at so far
};

}  // namespace

ProtoCanonical proto_canonical(const Triangulation& triangulation, const Report& report,
                               const ProtoCanonicalOptions& options) {
  return Walker(triangulation, report, options).run();
}

}  // namespace tripus::canonical
