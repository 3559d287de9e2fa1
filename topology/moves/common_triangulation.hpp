#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/stop.hpp"
#include "topology/gluings.hpp"

namespace tripus::topology {

struct CommonTriangulationOptions {
  std::size_t budget = 3000;  ///< triangulations to look at on each side
  std::size_t extra = 2;      ///< tetrahedra beyond those of the larger of the two starts
  Stop stop{};
};

/// A triangulation that moves reach from both of two others, so that all three are of one manifold.
struct CommonTriangulation {
  std::string isosig;  ///< without a sign
  /// For orientable ones: whether the moves keep the orientations of the two (those of the labels
  /// of their tetrahedra 0), reverse them, or, if it is its own mirror image, both.
  bool keeps_orientation = false, reverses_orientation = false;
};

/// Looks for one: the neighbourhoods of both grow by moves, smallest triangulations first, until
/// they meet. Nothing found says nothing.
/// Throws InvalidInput, as the constructor of Triangulation, for tables that are not closed up.
std::optional<CommonTriangulation> common_triangulation(
    const Gluings& first, const Gluings& second, const CommonTriangulationOptions& options = {});

}  // namespace tripus::topology
