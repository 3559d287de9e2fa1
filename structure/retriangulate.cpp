// A best-first search in the Pachner graph of the manifold. Nodes are triangulations, known by
// their signatures; the next one to be expanded is the one with the fewest tetrahedra, the earliest
// found among those. A triangulation without a metric of its own usually has one nearby that
// carries it, smaller or of the same size: two-thirds of the search is simplification.
#include "structure/retriangulate.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <random>
#include <unordered_set>

#include <fmt/format.h>

#include "base/error.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

using topology::Gluings;
using topology::Move;
using topology::MoveKind;
using topology::Triangulation;

/// Up to so many tetrahedra moves are tried everywhere, beyond only around the trouble.
constexpr std::size_t kSmall = 12;

constexpr std::array<MoveKind, 3> kShrinking{MoveKind::kTwoOne, MoveKind::kTwoZeroEdge,
                                             MoveKind::kThreeTwo};
constexpr std::array<MoveKind, 2> kRebuilding{MoveKind::kFourFour, MoveKind::kTwoThree};

struct Node {
  Gluings gluings;
  std::size_t parent = 0;
  Move move;
  std::vector<bool> trouble;  ///< [T] tetrahedra around which moves are made; empty for all
};

/// Tetrahedra that are flat, have an edge of low valence, or carry a certificate.
std::vector<bool> trouble_of(const Triangulation& triangulation, const Report& report) {
  constexpr std::size_t kLowValence = 3;
  std::vector<bool> trouble(triangulation.tetrahedron_count());
  for (const std::size_t t : report.flat_tetrahedra) trouble[t] = true;
  for (std::size_t t = 0; t < trouble.size(); ++t) {
    for (int e = 0; e < 6; ++e)
      if (triangulation.valence(triangulation.edge_class(t, e)) <= kLowValence) trouble[t] = true;
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
        start_(std::move(start)),
        signature_(topology::isosig(triangulation.gluings())),
        homology_(topology::first_homology(triangulation)),
        random_(options.seed),
        limit_(triangulation.tetrahedron_count() + options.extra) {
    known_.insert(signature_);
    nodes_.push_back({triangulation.gluings(), 0, {}, trouble_of(triangulation, start_)});
    open_.push({triangulation.tetrahedron_count(), 0});
  }

  Retriangulation run() {
    while (!open_.empty() && tried_ < options_.budget && !stopped()) {
      const std::size_t node = open_.top().second;
      open_.pop();
      if (expand(node)) return success();
    }
    return failure();
  }

 private:
  /// What the search needs of the caller's options: the tolerance and the limits.
  static SolveOptions plain(const SolveOptions& options) {
    SolveOptions result;
    result.tolerance = options.tolerance;
    result.time_limit = options.time_limit;
    result.stop_requested = options.stop_requested;
    result.evidence = false;
    return result;
  }

  bool stopped() const {
    return solve_options_.stop_requested != nullptr && *solve_options_.stop_requested;
  }

  /// Tries every neighbour of a node; true if one carries the metric: it is then the last node.
  bool expand(std::size_t node) {
    const Triangulation here(nodes_[node].gluings);
    std::vector<Move> moves = topology::all_moves(here, kShrinking);
    // Shrinking moves come first; the others only where the neighbour is not too large.
    std::vector<Move> rest = topology::all_moves(here, kRebuilding);
    std::shuffle(rest.begin(), rest.end(), random_);
    moves.insert(moves.end(), rest.begin(), rest.end());
    for (const Move& move : moves) {
      if (tried_ >= options_.budget || stopped()) return false;
      const auto size = static_cast<std::ptrdiff_t>(here.tetrahedron_count()) +
                        topology::info(move.kind).tetrahedra;
      if (size > static_cast<std::ptrdiff_t>(limit_) || !concerns(node, move)) continue;
      if (try_move(node, move)) return true;
    }
    return false;
  }

  bool concerns(std::size_t node, const Move& move) const {
    const std::vector<bool>& trouble = nodes_[node].trouble;
    return trouble.size() <= kSmall || trouble[move.tetrahedron];
  }

  bool try_move(std::size_t parent, const Move& move) {
    Gluings gluings = nodes_[parent].gluings;
    topology::apply(gluings, move);
    if (!known_.insert(topology::isosig(gluings)).second) return false;
    const Triangulation triangulation(std::move(gluings));
    if (topology::first_homology(triangulation) != homology_) {
      throw InternalError("the move " + topology::to_string(move) + " of " +
                          topology::isosig(nodes_[parent].gluings) + " changed the homology");
    }
    ++tried_;
    report_ = solve(triangulation, solve_options_);
    open_.push({triangulation.tetrahedron_count(), nodes_.size()});
    nodes_.push_back({triangulation.gluings(), parent, move, trouble_of(triangulation, report_)});
    return report_.outcome == Outcome::kGeometric;
  }

  Retriangulation success() {
    Retriangulation result;
    result.start = signature_;
    for (std::size_t node = nodes_.size() - 1; node != 0; node = nodes_[node].parent)
      result.path.push_back(nodes_[node].move);
    std::reverse(result.path.begin(), result.path.end());
    result.report = std::move(report_);
    result.gluings = std::move(nodes_.back().gluings);
    result.tried = tried_;
    return result;
  }

  Retriangulation failure() {
    Retriangulation result;
    result.start = signature_;
    result.report = std::move(start_);
    result.report.outcome = Outcome::kUnresolved;
    result.report.message += fmt::format(
        " {} other triangulations of the manifold were tried, of up to {} tetrahedra, and none was "
        "found to carry the metric; nothing follows about the manifold.",
        tried_, limit_);
    result.report.advice =
        "If the manifold should be hyperbolic, try a larger --budget or another --seed.";
    result.gluings = std::move(nodes_.front().gluings);
    result.tried = tried_;
    return result;
  }

  /// Fewest tetrahedra first, then the earliest.
  using Entry = std::pair<std::size_t, std::size_t>;

  const RetriangulateOptions options_;
  const SolveOptions solve_options_;
  Report start_, report_;
  const std::string signature_;  ///< of the start
  const topology::AbelianGroup homology_;
  std::mt19937_64 random_;
  std::size_t limit_;
  std::size_t tried_ = 0;
  std::vector<Node> nodes_;
  std::unordered_set<std::string> known_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

Retriangulation retriangulate(const Triangulation& triangulation, Report start,
                              const SolveOptions& solve_options,
                              const RetriangulateOptions& options) {
  return Search(triangulation, std::move(start), solve_options, options).run();
}

}  // namespace tripus::structure
