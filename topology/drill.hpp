#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "topology/cone_angle.hpp"
#include "topology/gluings.hpp"
#include "topology/simplify/mutable_triangulation.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {

/// Drills edges out: takes a neighbourhood of each away. The vertices at its ends become one, and
/// their links are joined by a tube; an edge from a vertex to itself gives that link a handle, so
/// that a loop at a finite vertex leaves a torus. The reverse fills a 2-handle in along the edge's
/// meridian, and the edge is its cocore: a strand that a diagram keeps (`exterior`), or an edge
/// that `simplify_keeping` keeps, is a boundary curve that stays known.
/// Four tetrahedra more for each edge, and two finite vertices; the given ones keep their numbers
/// and labels, and oriented tables stay oriented. O(T). Throws InvalidInput for an edge that does
/// not exist, for one that is given twice, and for one in an open face.
Gluings drilled(const Gluings& closed, std::span<const EdgePlace> edges);

/// A place of each of these edge classes, for `drilled`. All that have a label must be among them,
/// as what is drilled keeps none.
///   cone_angles  [E]; empty for 2 pi everywhere
/// Throws InvalidInput for a class that there is not, and for a label that would be lost.
std::vector<EdgePlace> places_to_drill(const Triangulation& triangulation,
                                       std::span<const std::size_t> edge_classes,
                                       std::span<const ConeAngle> cone_angles = {});

}  // namespace tripus::topology
