#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
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

/// What a search through the triangulations of one manifold found.
struct Retriangulation {
  std::string start;          ///< signature of the start
  Report report;              ///< of `gluings`
  topology::Gluings gluings;  ///< carries the metric if report.outcome is geometric, else the start
  std::vector<topology::Move> path;  ///< from the start to `gluings`, to be applied in order
  std::size_t tried = 0;             ///< triangulations solved on, the start not counted
};

/// Looks for a triangulation of the same manifold that carries the metric, by moves that keep the
/// manifold: 3-2, 2-0 and 2-1 wherever they can be made, 4-4 and 2-3 around flat tetrahedra, edges
/// of low valence and the support of the certificate (everywhere, if there are few tetrahedra).
/// Triangulations with few tetrahedra are tried first; none is tried twice.
///
/// `start` is the report of `solve` on the triangulation, not geometric. If the budget ends, the
/// result has that report with the outcome unchanged, and says so in the message: it is no
/// statement about the manifold. The same seed gives the same result. Throws InternalError if a
/// move has changed the first homology, which must not happen.
Retriangulation retriangulate(const topology::Triangulation& triangulation, Report start,
                              const SolveOptions& solve_options,
                              const RetriangulateOptions& options = {});

}  // namespace tripus::structure
