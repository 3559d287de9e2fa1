#pragma once

#include <span>
#include <vector>

#include "topology/simplify/mutable_triangulation.hpp"
#include "topology/simplify/simplify.hpp"

namespace tripus::topology {

/// What became of a triangulation in which some edges were kept.
struct SimplifiedKeeping {
  Simplified result;
  std::vector<EdgePlace> kept;  ///< the edges in result.gluings, in the order given
};

/// `simplify` that keeps edges: the manifold with the graph that these form in it stays what it is,
/// so that they can carry cone angles. Their ends are no finite vertices here, and stay.
/// Throws what `simplify` throws, and InvalidInput for two places of one edge class.
SimplifiedKeeping simplify_keeping(const Gluings& closed, std::span<const EdgePlace> kept,
                                   const SimplifyOptions& options = {});

}  // namespace tripus::topology
