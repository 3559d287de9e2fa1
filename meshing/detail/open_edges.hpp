#pragma once

#include <cstdint>
#include <vector>

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing::detail {

/// A side k of a triangle, from corner k to corner k+1, that no other triangle has.
struct OpenEdge {
  std::uint32_t triangle = 0, side = 0;
};

struct Edges {
  std::vector<OpenEdge> open;
  bool is_crowded = false;  ///< an edge is in three triangles or more

  bool is_closed() const { return open.empty() && !is_crowded; }
};

/// Corners of a triangle are different. In O(T log T).
Edges edges_of(const std::vector<Triangle>& triangles);

/// Gives ends of the open edges that are at most so far apart one number, that of the first;
/// returns how many got another.
std::size_t weld(SurfaceMesh& mesh, const std::vector<OpenEdge>& open, double distance);

/// Splits triangles where an end of some open edge is at most so far from the inside of theirs;
/// the parts come last in `mesh`, and `cell_of` [triangles] is what they inherit. Returns how many
/// were split; does nothing where there are too many open edges to compare.
std::size_t split_at_points(SurfaceMesh& mesh, std::vector<std::uint32_t>& cell_of,
                            const std::vector<OpenEdge>& open, double distance);

}  // namespace tripus::meshing::detail
