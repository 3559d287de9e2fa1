#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "canonical/tilts.hpp"
#include "structure/report.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::canonical {

struct ProtoCanonicalOptions {
  std::uint64_t seed = 0;           ///< of the random walks, where the moves get stuck
  std::size_t max_attempts = 1000;  ///< random walks at most
};

/// A geometric triangulation without concave faces: it subdivides the canonical decomposition.
struct ProtoCanonical {
  topology::Triangulation triangulation;
  structure::Report report;  ///< the metric on it
  FaceKinds faces;
  std::vector<topology::Move> path;  ///< moves from the start to here
  bool found = false;                ///< false: attempts ran out, concave faces are left
};

/// Moves at concave faces until there are none: 3-2 at an edge of the face, else 2-3 at the face,
/// else 4-4 at an edge of it; what is reached must carry the metric with the same volume. Where no
/// such move is possible, a random walk of a few moves through triangulations with the metric
/// shakes it.
///   report  of `triangulation`, geometric
/// Throws InternalError if a move changes the volume, which must not happen.
ProtoCanonical proto_canonical(const topology::Triangulation& triangulation,
                               const structure::Report& report,
                               const ProtoCanonicalOptions& options = {});

}  // namespace tripus::canonical
