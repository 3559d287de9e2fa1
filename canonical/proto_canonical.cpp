#include "canonical/proto_canonical.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/tolerances.hpp"
#include "structure/solve.hpp"

namespace tripus::canonical {
namespace {

using structure::Report;
using topology::Move;
using topology::MoveKind;
using topology::Triangulation;

/// Beyond so many tetrahedra the solver is started from the lengths that are known already. Before
/// that the default start is as good, and cheaper where there is no metric to be found.
constexpr std::size_t kWarmStart = 32;
/// Moves of one random walk, and tetrahedra that it may add.
constexpr std::size_t kWalk = 6;
constexpr std::size_t kExtra = 3;

class Walker {
 public:
  Walker(const Triangulation& triangulation, const Report& report,
         const ProtoCanonicalOptions& options)
      : options_(options),
        random_(options.seed),
        volume_(report.volume),
        start_size_(triangulation.tetrahedron_count()),
        state_{triangulation, report, {}, {}, false} {}

  ProtoCanonical run() {
    for (std::size_t attempt = 0;; ++attempt) {
      while (improve()) {
      }
      if (state_.found || attempt == options_.max_attempts) return std::move(state_);
      shake();
    }
  }

 private:
  /// Makes one move at a concave face. False if there is no such face, or no such move.
  bool improve() {
    state_.faces = face_kinds(state_.triangulation, state_.report.edge_lengths);
    state_.found = !state_.faces.has_concave();
    if (state_.found) return false;
    for (const Move& move : moves_at_concave_faces())
      if (try_move(move)) return true;
    return false;
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
          faces.push_back({state_.faces.sum[t][static_cast<std::size_t>(f)], t, f});
    std::ranges::stable_sort(faces, std::greater<>{}, &Face::sum);
    std::vector<Move> moves;
    for (const Face& face : faces) add_edge_moves(face.t, face.f, 3, moves);
    for (const Face& face : faces)
      if (is_crossed(face.t, face.f)) moves.push_back(two_three(face.t, face.f));
    for (const Face& face : faces) add_edge_moves(face.t, face.f, 4, moves);
    return moves;
  }

  FaceKind kind(std::size_t t, int f) const {
    return state_.faces.kind[t][static_cast<std::size_t>(f)];
  }

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
      for (std::uint8_t axis = 0; axis < (valence == 3 ? 1 : 2); ++axis)
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

  /// Makes the move if it is legal and leads to a triangulation with the metric.
  bool try_move(const Move& move) {
    topology::Gluings gluings = state_.triangulation.gluings();
    if (!topology::can_apply(gluings, move)) return false;
    const topology::MoveChange change = topology::apply(gluings, move);
    Triangulation next(std::move(gluings));
    for (std::size_t e = 0; e < next.edge_count(); ++e)
      if (next.valence(e) < 3) return false;  // never geometric
    structure::SolveOptions solve;
    solve.evidence = false;
    if (next.tetrahedron_count() > kWarmStart) solve.initial_lengths = carried_over(next, change);
    Report report = structure::solve(next, solve);
    if (report.outcome != structure::Outcome::kGeometric) return false;
    if (!(std::fabs(report.volume - volume_) <= tolerance::kVolumeAgreement * volume_)) {
      throw InternalError(fmt::format("{} changed the volume from {} to {}",
                                      topology::to_string(move), volume_, report.volume));
    }
    state_.triangulation = std::move(next);
    state_.report = std::move(report);
    state_.path.push_back(move);
    return true;
  }

  /// Lengths for the triangulation after a move: edges that were there keep theirs.
  std::vector<double> carried_over(const Triangulation& next,
                                   const topology::MoveChange& change) const {
    constexpr auto kNew = topology::kNoTetrahedron;
    std::vector<topology::TetrahedronIndex> old(next.tetrahedron_count());
    for (std::size_t t = 0; t < old.size(); ++t)
      old[t] = static_cast<topology::TetrahedronIndex>(t);
    for (const auto& [from, to] : change.renumbered) old[to] = from;
    for (const auto t : change.added) old[t] = kNew;
    const auto& lengths = state_.report.edge_lengths;
    double mean = 0;
    for (const double l : lengths) mean += l / static_cast<double>(lengths.size());
    std::vector<double> result(next.edge_count(), mean);
    for (std::size_t t = 0; t < old.size(); ++t) {
      if (old[t] == kNew) continue;
      for (int e = 0; e < 6; ++e)
        result[next.edge_class(t, e)] = lengths[state_.triangulation.edge_class(old[t], e)];
    }
    return result;
  }

  void shake() {
    const auto below = [&](std::size_t n) {
      return static_cast<std::size_t>(random_() % static_cast<std::uint64_t>(n));
    };
    constexpr std::array kKinds{MoveKind::kTwoThree, MoveKind::kThreeTwo, MoveKind::kFourFour};
    for (std::size_t made = 0; made < kWalk; ++made) {
      auto moves = topology::all_moves(state_.triangulation, kKinds);
      while (!moves.empty()) {
        const std::size_t k = below(moves.size());
        const bool grows = moves[k].kind == MoveKind::kTwoThree;
        const bool may =
            !grows || (state_.triangulation.tetrahedron_count() < start_size_ + kExtra &&
                       is_crossed(moves[k].tetrahedron, moves[k].place));
        if (may && try_move(moves[k])) break;
        moves.erase(moves.begin() + static_cast<std::ptrdiff_t>(k));
      }
    }
  }

  const ProtoCanonicalOptions options_;
  std::mt19937_64 random_;
  const double volume_;
  const std::size_t start_size_;
  ProtoCanonical state_;
};

}  // namespace

ProtoCanonical proto_canonical(const Triangulation& triangulation, const Report& report,
                               const ProtoCanonicalOptions& options) {
  return Walker(triangulation, report, options).run();
}

}  // namespace tripus::canonical
