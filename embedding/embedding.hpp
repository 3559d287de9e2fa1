#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/hyperboloid_tetrahedron.hpp"
#include "topology/triangulation.hpp"

/// A hyperbolic metric in hyperbolic space: its tetrahedra, how they are glued, and the universal
/// cover that they fill.
namespace tripus::embedding {

using geometry::HyperboloidTetrahedron;
using geometry::Matrix4;
using geometry::Vector4;

/// The tetrahedra of a metric, each in its own frame, and their gluings as isometries.
struct Embedding {
  std::vector<HyperboloidTetrahedron> tetrahedra;  ///< [T]
  /// [T x 4] for face f of tetrahedron t: the isometry that carries the neighbour across the face
  /// from its own frame to its place beside t, in the frame of t. The two sides of a gluing have
  /// inverse isometries.
  std::vector<std::array<Matrix4, 4>> face_pairings;
};

/// Places every tetrahedron of a metric. The orientations of the frames are chosen along a spanning
/// tree of the dual graph, so that all pairings of an orientable manifold keep orientation.
///   edge_lengths  [E]  of the metric, as structure::solve finds them
/// Throws InvalidInput, naming the place, for a wrong number of lengths, a length that is not
/// finite and positive, a flat tetrahedron, and an edge class whose angles do not sum to 2 pi
/// within tolerance::kEmbeddedCurvature: such a space does not develop. O(T). Source:
/// docs/theory.md (56) to (60), (63).
Embedding embed(const topology::Triangulation& triangulation, std::span<const double> edge_lengths);

/// Largest entry of (product of the face pairings around the edge) - identity, for each edge class
/// [E]: how well the space closes up around its edges.
std::vector<double> edge_defects(const Embedding& embedding,
                                 const topology::Triangulation& triangulation);

}  // namespace tripus::embedding
