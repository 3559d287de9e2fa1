#pragma once

#include <cstddef>
#include <vector>

#include "base/stop.hpp"
#include "canonical/tilts.hpp"
#include "structure/report.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::canonical {

struct ProtoCanonicalOptions {
  /// Triangulations to solve on at most where the moves get stuck; ways through flat tetrahedra,
  /// where nothing is solved, get thirty times as many. 0: the moves alone.
  std::size_t budget = 2000;
  /// [E] of the metric; empty for 2 pi. No move takes an edge away that has another angle.
  std::vector<topology::ConeAngle> cone_angles = {};
  Stop stop{};  ///< ends it soon, with nothing found
};

/// A geometric triangulation without concave faces: it subdivides the canonical decomposition.
struct ProtoCanonical {
  topology::Triangulation triangulation;
  structure::Report report;  ///< the metric on it
  FaceKinds faces;
  std::vector<topology::Move> path;              ///< moves from the start to here
  std::vector<topology::ConeAngle> cone_angles;  ///< [E] here; empty for 2 pi
  bool found = false;  ///< false: the budget ran out, concave faces are left
};

/// Moves at concave faces until there are none: 3-2 at an edge of the face, else 2-3 at the face,
/// else 4-4 at an edge of it; what is reached must carry the metric with the same volume. Where no
/// such move is possible (points in one plane can make that happen), moves at flat tetrahedra in
/// such a plane, or else a search through neighbouring triangulations, with the metric or without,
/// find the next one with the metric to go on from.
///   report  of `triangulation`, geometric, without finite vertices
/// Deterministic. Throws InternalError if moves change the volume, which must not happen.
ProtoCanonical proto_canonical(const topology::Triangulation& triangulation,
                               const structure::Report& report,
                               const ProtoCanonicalOptions& options = {});

}  // namespace tripus::canonical
