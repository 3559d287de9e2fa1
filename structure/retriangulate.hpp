#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "structure/solve.hpp"
#include "topology/gluings.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::structure {

struct RetriangulateOptions {
  std::uint64_t seed = 0;    ///< orders moves that look equally good
  std::size_t budget = 500;  ///< triangulations to try at most, > 0
  std::size_t extra = 2;     ///< tetrahedra beyond those of the start (or of its simplification)
};

/// Why a search ended.
enum class SearchEnd {
  kFound,          ///< a triangulation carries the metric
  kBudget,         ///< as many were tried as the budget allows
  kExhausted,      ///< every triangulation was tried that the moves reach within the size allowed
  kNotHyperbolic,  ///< the manifold is not hyperbolic, by one of its triangulations
                   ///< (obstruction.hpp)
  kTimeLimit,      ///< SolveOptions::time_limit
  kInterrupted,    ///< SolveOptions::stop
};
/// "found", "budget", "exhausted", "not hyperbolic", "time limit", "interrupted".
std::string_view to_string(SearchEnd end);

/// A volume of the same manifold from another of its triangulations.
struct OtherVolume {
  std::string isosig;
  Outcome outcome = Outcome::kGeometric;  ///< geometric or degenerate
  double volume = 0;
};

/// What a search through the triangulations of one manifold found.
struct Retriangulation {
  std::string start;          ///< signature of the start
  Report report;              ///< of `gluings`
  topology::Gluings gluings;  ///< carries the metric if report.outcome is geometric, else the start
  std::vector<topology::ConeAngle> cone_angles;  ///< [E] of `gluings`; empty for 2 pi everywhere
  /// Where the path starts: the start, made `oriented`; or a simplification of it.
  topology::Gluings path_start;
  /// Of a simplification, the signature that decodes to path_start, with its sign; else empty.
  std::string simplified;
  std::vector<topology::Move> path;  ///< from path_start to `gluings`, to be applied in order
  std::size_t tried = 0;             ///< triangulations solved on, the start not counted
  SearchEnd end = SearchEnd::kBudget;
  /// If not hyperbolic: why, and the signature of what shows it (empty: the start itself).
  std::string obstruction, obstructed;
  /// If found: the volumes at the minimisers with flat tetrahedra along the path, in its order, and
  /// last that of a neighbour of `gluings` which carries the metric too, if there is one nearby.
  std::vector<OtherVolume> volumes;
};

/// Looks for a triangulation of the same manifold that carries the metric, by moves that keep the
/// manifold: 3-2, 2-0 and 2-1 wherever they can be made, 4-4 and 2-3 around flat tetrahedra, edges
/// of low valence and the support of the certificate (everywhere, if there are few tetrahedra).
/// Triangulations with few tetrahedra are tried first; none is tried twice. A start with more
/// than a handful of tetrahedra is simplified first, in several ways, and the search goes on from
/// there. The orientation is kept, and so are cone angles other than 2 pi (`solve_options`): no
/// move is made that would remove such an edge or merge two, and a start with such edges is not
/// simplified first.
///
/// `start` is the report of `solve` on the triangulation, not geometric. Where nothing is found the
/// result has that report, with its evidence, as "unresolved", and says in the message what was
/// tried: it is no statement about the manifold, unless the search ended with one of the quick
/// proofs that it is not hyperbolic. The time limit of the options is for the whole search, every
/// other limit for each triangulation. The same seed gives the same result, unless time or an
/// interrupt ends it.
///
/// That the manifold is the same is checked as well: the first homology at every step, and the
/// volume at the end, where a second triangulation with a metric must agree (Mostow rigidity).
/// Throws InternalError if one differs, which must not happen.
Retriangulation retriangulate(const topology::Triangulation& triangulation, Report start,
                              const SolveOptions& solve_options,
                              const RetriangulateOptions& options = {});

}  // namespace tripus::structure
