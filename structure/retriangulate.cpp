// A best-first search in the Pachner graph of the manifold. Nodes are triangulations, known by
// their signatures; the next one to be expanded is the one with the fewest tetrahedra, the earliest
// found among those. A triangulation without a metric of its own usually has one nearby that
// carries it, smaller or of the same size: two-thirds of the search is simplification. Of a start
// that is not small the search begins with a few simplifications as well.
#include "structure/retriangulate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/tolerances.hpp"
#include "structure/obstruction.hpp"
#include "topology/homology.hpp"
#include "topology/labelled_isosig.hpp"
#include "topology/moves/best_first.hpp"
#include "topology/moves/edge_images.hpp"
#include "topology/orientation.hpp"
#include "topology/simplify/small_triangulations.hpp"

namespace tripus::structure {
namespace {

using topology::Gluings;
using topology::Move;
using topology::MoveKind;
using topology::Triangulation;

/// Up to so many tetrahedra moves are tried everywhere, beyond only around the trouble.
constexpr std::size_t kSmall = 12;

/// Up to so many tetrahedra the search itself simplifies: it makes all moves that shrink first.
constexpr std::size_t kFew = 5;
/// With up to so many it needs no more help than a quick simplification, which is a hundred times
/// cheaper than a thorough one.
constexpr std::size_t kSeveral = 10;
constexpr double kQuickly = 0.02;
/// In how many ways a start is simplified thoroughly; one where that takes long.
constexpr std::size_t kSimplifications = 4;
constexpr std::size_t kLongToSimplify = 400;

constexpr std::array<MoveKind, 3> kShrinking{MoveKind::kTwoOne, MoveKind::kTwoZeroEdge,
                                             MoveKind::kThreeTwo};
constexpr std::array<MoveKind, 2> kRebuilding{MoveKind::kFourFour, MoveKind::kTwoThree};

struct Node {
  Gluings gluings;
  std::size_t parent = 0;  ///< itself: a root
  Move move;
  std::vector<bool> trouble;  ///< [T] tetrahedra around which moves are made
  Outcome outcome = Outcome::kUnresolved;
  double volume = 0;
  std::vector<topology::ConeAngle> cone_angles;  ///< [E]; empty for 2 pi everywhere
};

using Clock = std::chrono::steady_clock;

/// Random order, the same on every platform, unlike std::shuffle.
void shuffle(std::vector<Move>& moves, std::mt19937_64& random) {
  for (std::size_t i = moves.size(); i > 1; --i) std::swap(moves[i - 1], moves[random() % i]);
}

/// Tetrahedra that are flat, have an edge of low valence or the shortest edge, or carry a
/// certificate.
std::vector<bool> trouble_of(const Triangulation& triangulation, const Report& report) {
  constexpr std::size_t kLowValence = 3;
  std::vector<bool> trouble(triangulation.tetrahedron_count());
  for (const std::size_t t : report.flat_tetrahedra) trouble[t] = true;
  const auto shortest = static_cast<std::size_t>(
      std::min_element(report.edge_lengths.begin(), report.edge_lengths.end()) -
      report.edge_lengths.begin());
  for (std::size_t t = 0; t < trouble.size(); ++t) {
    for (int e = 0; e < 6; ++e) {
      const std::size_t edge = triangulation.edge_class(t, e);
      if (triangulation.valence(edge) <= kLowValence || edge == shortest) trouble[t] = true;
    }
    if (!report.certificate) continue;
    for (const auto& w : report.certificate->vertex[t])
      if (w != 0) trouble[t] = true;
  }
  return trouble;
}

class Search {
 public:
  Search(const Triangulation& triangulation, Report start, const SolveOptions& solve_options,
         const RetriangulateOptions& options)
      : options_(options),
        solve_options_(plain(solve_options)),
        time_limit_(solve_options.time_limit),
        start_(std::move(start)),
        given_(triangulation.gluings()),
        given_cone_angles_(labels_of(solve_options)),
        signature_(topology::labelled_isosig(triangulation, given_cone_angles_)),
        homology_(topology::first_homology(triangulation)),
        random_(options.seed),
        limit_(triangulation.tetrahedron_count() + options.extra) {
    search_.learn(signature_);
    Gluings turned = topology::oriented(given_);
    auto labels =
        topology::oriented_edges(triangulation, given_cone_angles_, Triangulation(turned));
    search_.add(triangulation.tetrahedron_count(), {std::move(turned),
                                                    0,
                                                    {},
                                                    trouble_of(triangulation, start_),
                                                    start_.outcome,
                                                    start_.volume,
                                                    std::move(labels)});
  }

  Retriangulation run() {
    if (ended() || is_obstructed(given_)) return failure();
    if (begin_small()) return success();
    while (search_.has_open() && !ended()) {
      const std::size_t node = search_.next();
      if (node > 0 && is_obstructed(search_[node].gluings)) break;
      if (expand(node)) return success();
    }
    return failure();
  }

 private:
  /// Whether a triangulation shows that the manifold is not hyperbolic: no search finds a metric.
  bool is_obstructed(const Gluings& gluings) {
    if (!given_cone_angles_.empty()) return false;
    obstruction_ = obstruction(Triangulation(gluings));
    if (obstruction_.empty()) return false;
    end_ = SearchEnd::kNotHyperbolic;
    if (gluings == given_) return true;
    // Edge classes are those of the signature, which is all that is told of the triangulation.
    obstructed_ = topology::full_isosig(gluings).oriented();
    obstruction_ = obstruction(Triangulation(topology::decode_isosig(obstructed_))) + " (Seen on " +
                   obstructed_ + ".)";
    return true;
  }

  static std::vector<topology::ConeAngle> labels_of(const SolveOptions& options) {
    if (topology::all_full(options.cone_angles)) return {};
    return options.cone_angles;
  }

  /// The caller's options for one of many triangulations: without history, without evidence.
  static SolveOptions plain(const SolveOptions& options) {
    SolveOptions result;
    result.tolerance = options.tolerance;
    result.max_iterations = options.max_iterations;
    result.stop = options.stop;
    result.evidence = false;
    return result;
  }

  double time_left() const {
    return time_limit_ - std::chrono::duration<double>(Clock::now() - began_).count();
  }

  /// Whether a limit has been reached, and which.
  bool ended() {
    if (solve_options_.stop.requested()) {
      end_ = SearchEnd::kInterrupted;
    } else if (!(time_left() > 0)) {
      end_ = SearchEnd::kTimeLimit;
    } else if (tried_ >= options_.budget) {
      end_ = SearchEnd::kBudget;
    } else {
      return false;
    }
    return true;
  }

  /// Solves within what is left of the time.
  Report solve_in_time(const Triangulation& triangulation,
                       const std::vector<topology::ConeAngle>& cone_angles) {
    SolveOptions options = solve_options_;
    options.cone_angles = cone_angles;
    options.time_limit = std::max(time_left(), std::numeric_limits<double>::min());
    return solve(triangulation, options);
  }

  /// Tries every neighbour of a node; true if one carries the metric: it is then the last node.
  bool expand(std::size_t node) {
    const Triangulation here(search_[node].gluings);
    std::vector<Move> moves = topology::all_moves(here, kShrinking);
    // Shrinking moves come first; the others only where the neighbour is not too large.
    std::vector<Move> rest = topology::all_moves(here, kRebuilding);
    shuffle(rest, random_);
    moves.insert(moves.end(), rest.begin(), rest.end());
    for (const Move& move : moves) {
      if (ended()) return false;
      const auto size = static_cast<std::ptrdiff_t>(here.tetrahedron_count()) +
                        topology::info(move.kind).tetrahedra;
      if (size > static_cast<std::ptrdiff_t>(limit_) || !concerns(node, move)) continue;
      if (try_move(here, node, move)) return true;
    }
    return false;
  }

  /// Begins with simplifications of the start as well, the cheaper ones first; true if one carries
  /// the metric: it is then the last node.
  bool begin_small() {
    const std::size_t size = given_.tetrahedron_count();
    if (size <= kFew || !given_cone_angles_.empty()) return false;
    if (try_simplified(1, kQuickly)) return true;
    return size > kSeveral && try_simplified(size > kLongToSimplify ? 1 : kSimplifications, 1.0);
  }

  bool try_simplified(std::size_t seeds, double effort) {
    auto small =
        topology::small_triangulations(search_.front().gluings, seeds, solve_options_.stop, effort);
    for (Gluings& gluings : small) {
      limit_ = std::min(limit_, gluings.tetrahedron_count() + options_.extra);
      if (ended()) return false;
      if (try_table(Triangulation(std::move(gluings)), {}, search_.size(), {})) return true;
    }
    return false;
  }

  bool concerns(std::size_t node, const Move& move) const {
    const std::vector<bool>& trouble = search_[node].trouble;
    return trouble.size() <= kSmall || trouble[move.tetrahedron];
  }

  bool try_move(const Triangulation& here, std::size_t parent, const Move& move) {
    auto moved = after(here, search_[parent].cone_angles, move);
    return moved &&
           try_table(std::move(moved->triangulation), std::move(moved->cone_angles), parent, move);
  }

  struct Moved {
    Triangulation triangulation;
    std::vector<topology::ConeAngle> cone_angles;
  };
  /// Nothing if the move does not keep the labels.
  static std::optional<Moved> after(const Triangulation& here,
                                    const std::vector<topology::ConeAngle>& cone_angles,
                                    const Move& move) {
    Gluings gluings = here.gluings();
    const topology::MoveChange change = topology::apply(gluings, move);
    Triangulation next(std::move(gluings));
    if (cone_angles.empty()) return Moved{std::move(next), {}};
    auto labels = topology::carried_labels(
        cone_angles, topology::edge_images(here, move, change, next), next.edge_count());
    if (!labels) return std::nullopt;
    return Moved{std::move(next), *std::move(labels)};
  }

  bool try_table(Triangulation triangulation, std::vector<topology::ConeAngle> cone_angles,
                 std::size_t parent, const Move& move) {
    if (!search_.learn(topology::labelled_isosig(triangulation, cone_angles))) return false;
    if (topology::first_homology(triangulation) != homology_) {
      throw InternalError("a simplification of " + signature_ + ", or the move " +
                          topology::to_string(move) + " on the way, changed the homology");
    }
    ++tried_;
    report_ = solve_in_time(triangulation, cone_angles);
    search_.add(triangulation.tetrahedron_count(),
                {triangulation.gluings(), parent, move, trouble_of(triangulation, report_),
                 report_.outcome, report_.volume, std::move(cone_angles)});
    return report_.outcome == Outcome::kGeometric;
  }

  Retriangulation success() {
    Retriangulation result;
    result.start = signature_;
    std::size_t node = search_.size() - 1;
    for (; search_[node].parent != node; node = search_[node].parent) {
      result.path.push_back(search_[node].move);
      add_flat_volume(search_[search_[node].parent], result.volumes);
    }
    result.path_start = search_[node].gluings;
    if (node != 0) result.simplified = topology::full_isosig(result.path_start).oriented();
    std::reverse(result.path.begin(), result.path.end());
    std::reverse(result.volumes.begin(), result.volumes.end());
    result.report = std::move(report_);
    result.gluings = std::move(search_.back().gluings);
    result.cone_angles = std::move(search_.back().cone_angles);
    result.tried = tried_;
    result.end = SearchEnd::kFound;
    compare_with_neighbour(result);
    return result;
  }

  static void add_flat_volume(const Node& node, std::vector<OtherVolume>& volumes) {
    if (node.outcome == Outcome::kDegenerate)
      volumes.push_back({topology::labelled_isosig(Triangulation(node.gluings), node.cone_angles),
                         node.outcome, node.volume});
  }

  /// The volume once more, on a neighbour that carries the metric. Not every triangulation has one:
  /// then there is nothing to compare.
  void compare_with_neighbour(Retriangulation& result) {
    constexpr std::size_t kNeighbours = 24;
    const Triangulation found(result.gluings);
    std::vector<Move> moves = topology::all_moves(found, kRebuilding);
    shuffle(moves, random_);
    if (moves.size() > kNeighbours) moves.resize(kNeighbours);
    for (const Move& move : moves) {
      if (ended_by_force()) return;
      const auto moved = after(found, result.cone_angles, move);
      if (!moved) continue;
      const Report report = solve_in_time(moved->triangulation, moved->cone_angles);
      if (report.outcome != Outcome::kGeometric) continue;
      const std::string isosig =
          topology::labelled_isosig(moved->triangulation, moved->cone_angles);
      result.volumes.push_back({isosig, report.outcome, report.volume});
      if (!(std::fabs(report.volume - result.report.volume) <=
            tolerance::kVolumeAgreement * result.report.volume)) {
        throw InternalError(fmt::format(
            "the move {} of {} changed the volume from {} to {}", topology::to_string(move),
            topology::isosig(found.gluings()), result.report.volume, report.volume));
      }
      return;
    }
  }

  bool ended_by_force() { return ended() && end_ != SearchEnd::kBudget; }

  Retriangulation failure() {
    Retriangulation result;
    result.start = signature_;
    result.report = std::move(start_);
    const bool is_decided = end_ == SearchEnd::kNotHyperbolic;
    result.report.message = why_not_the_start(result.report);
    if (tried_ > 0)
      result.report.message +=
          fmt::format(", nor on {} other triangulation{} of the manifold with up to {} tetrahedra",
                      tried_, tried_ == 1 ? "" : "s", limit_);
    result.report.message +=
        is_decided ? ". " + obstruction_
                   : fmt::format(" ({}); nothing follows about the manifold.", reason(end_));
    result.report.outcome = Outcome::kUnresolved;
    result.report.advice = is_decided ? Advice::kNone : advice(end_);
    result.obstruction = std::move(obstruction_);
    result.obstructed = std::move(obstructed_);
    result.gluings = std::move(given_);
    result.cone_angles = std::move(given_cone_angles_);
    result.path_start = std::move(search_.front().gluings);
    result.tried = tried_;
    result.end = end_;
    return result;
  }

  static const char* reason(SearchEnd end) {
    switch (end) {
      case SearchEnd::kBudget:
        return "the budget is used up";
      case SearchEnd::kTimeLimit:
        return "the time limit was reached";
      case SearchEnd::kInterrupted:
        return "interrupted";
      default:
        return "these are all that the moves reach";
    }
  }

  static std::string why_not_the_start(const Report& report) {
    if (report.certificate)
      return "No metric was found on this triangulation, which carries none (exact certificate)";
    if (report.outcome == Outcome::kDegenerate)
      return "No metric was found on this triangulation, where the minimiser has flat tetrahedra";
    return "No metric was found on this triangulation";
  }

  static Advice advice(SearchEnd end) {
    switch (end) {
      case SearchEnd::kBudget:
        return Advice::kLargerSearch;
      case SearchEnd::kTimeLimit:
      case SearchEnd::kInterrupted:
        return Advice::kMoreSearchTime;
      default:
        return Advice::kLargerTriangulation;
    }
  }

  const RetriangulateOptions options_;
  const SolveOptions solve_options_;
  const double time_limit_;
  const Clock::time_point began_ = Clock::now();
  Report start_, report_;
  Gluings given_;
  std::vector<topology::ConeAngle> given_cone_angles_;  ///< empty for 2 pi everywhere
  const std::string signature_;                         ///< of the start
  const topology::AbelianGroup homology_;
  std::mt19937_64 random_;
  std::size_t limit_;
  std::size_t tried_ = 0;
  SearchEnd end_ = SearchEnd::kExhausted;
  std::string obstruction_, obstructed_;
  topology::BestFirst<Node> search_;
};

}  // namespace

std::string_view to_string(SearchEnd end) {
  switch (end) {
    case SearchEnd::kFound:
      return "found";
    case SearchEnd::kBudget:
      return "budget";
    case SearchEnd::kExhausted:
      return "exhausted";
    case SearchEnd::kNotHyperbolic:
      return "not hyperbolic";
    case SearchEnd::kTimeLimit:
      return "time limit";
    case SearchEnd::kInterrupted:
      return "interrupted";
  }
  return "budget";
}

Retriangulation retriangulate(const Triangulation& triangulation, Report start,
                              const SolveOptions& solve_options,
                              const RetriangulateOptions& options) {
  return Search(triangulation, std::move(start), solve_options, options).run();
}

}  // namespace tripus::structure
