#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/circle_packing.hpp"
#include "geometry/moebius.hpp"
#include "topology/triangulation.hpp"

/// The paper's route to the gluings (its section 3.3.3): Moebius maps from three points on circles.
/// A second route to Embedding::face_pairings, which uses neither lengths nor 4x4 matrices.
namespace tripus::embedding {

/// Three points of the circle of one face: for its vertices a, b, c in this order, the points where
/// it meets the circles of the truncations of a, b and c, on the sides of the edges ab, bc and ca.
/// A gluing that takes a, b, c to vertices a', b', c' takes these points to theirs. Source:
/// docs/theory.md (69).
std::array<geometry::BoundaryPoint, 3> face_circle_points(const geometry::CirclePacking& packing,
                                                          const std::array<int, 3>& vertices);

/// The map that carries `there`, whose face p(f) is glued to face f of `here` by p, to its place
/// beside `here`. `reverses`: whether it must reverse orientation, as it must where the tetrahedra
/// have one orientation and p is even, or different ones and p is odd.
/// Source: docs/theory.md (70).
geometry::MoebiusMap moebius_face_pairing(const geometry::CirclePacking& here,
                                          const geometry::CirclePacking& there, topology::Perm4 p,
                                          int f, bool reverses);

/// A metric by circles: the tetrahedra in the paper's places and their gluings as Moebius maps.
struct CircleEmbedding {
  std::vector<geometry::CirclePacking> tetrahedra;                 ///< [T]
  std::vector<std::array<geometry::MoebiusMap, 4>> face_pairings;  ///< [T x 4]
};

/// The whole embedding by the paper's route. The tetrahedra are oriented as those of `embed`.
///   dihedral_angles  [T] radians, as structure::Report has them
/// Throws InvalidInput, naming the tetrahedron, where the angles are not those of a truncated one.
CircleEmbedding embed_by_circles(const topology::Triangulation& triangulation,
                                 std::span<const std::array<double, 6>> dihedral_angles);

}  // namespace tripus::embedding
