#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "meshing/surface_mesh.hpp"
#include "topology/disjoint_sets.hpp"

namespace tripus::meshing::detail {

/// What keeps triangles from being a closed oriented manifold, such as "edge 3-5 is open"; empty if
/// they are one: every side is there once in each direction, and the triangles at a point form one
/// fan. Corners are below point_count; points may be unused.
std::string manifold_fault(const std::vector<Triangle>& triangles, std::size_t point_count);

/// Euler characteristics of the components of a closed surface, doubled, each at the root of its
/// points, which are joined in `sets` [points].
std::map<std::uint32_t, long> doubled_characteristics(const std::vector<Triangle>& triangles,
                                                      topology::DisjointSets& sets);

}  // namespace tripus::meshing::detail
