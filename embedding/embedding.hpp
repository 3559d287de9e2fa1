#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/hyperboloid_tetrahedron.hpp"
#include "topology/cone_angle.hpp"
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
  /// [E] the cone angles around the edge classes.
  std::vector<topology::ConeAngle> cone_angles;
  /// [T] bit e is set where edge e (0..5) of the tetrahedron is singular: its cone angle is not
  /// 2 pi.
  std::vector<std::uint8_t> singular_edges;
  /// Area of the horospheres at every cusp (HyperboloidTetrahedron::vertices); 0 without cusps.
  double horosphere_area = 0;

  /// Whether every cone angle is 2 pi / n or 0, so that the tetrahedra develop into a tiling of
  /// space: the universal cover of a manifold or of an orbifold.
  bool develops() const;
};

struct EmbedOptions {
  /// [E], empty for 2 pi everywhere.
  std::vector<topology::ConeAngle> cone_angles;
  /// Area of the horosphere at each cusp, > 0. 0: structure::kHorosphereArea, or less where that
  /// comes near the opposite face or another vertex of a tetrahedron (kHoroballClearance), so that
  /// each cell is its tetrahedron with the corners cut off.
  double horosphere_area = 0;
};

/// How far a horoball stays from the opposite face and from the planes and points of other
/// vertices, where its area is not chosen.
inline constexpr double kHoroballClearance = 0.1;

/// Places every tetrahedron of a metric. The orientations of the frames are chosen along a spanning
/// tree of the dual graph, so that all pairings of an orientable manifold keep orientation.
///   edge_lengths  [E]  of the metric, as structure::solve finds them
/// Vertices are of the kinds that the cone angles make them (docs/theory.md (76)).
/// Throws InvalidInput, naming the place, for what topology::require_solvable refuses, a wrong
/// number of lengths, a length that is not finite, or not positive between hyperideal vertices, a
/// flat tetrahedron, an edge class whose angles do not sum to its cone angle within
/// tolerance::kEmbeddedCurvature (such a space does not develop), and a horosphere area at which
/// horoballs meet. O(T). Source: docs/theory.md (56) to (60), (63), (113) to (116).
Embedding embed(const topology::Triangulation& triangulation, std::span<const double> edge_lengths,
                const EmbedOptions& options = {});

/// Areas of the horospheres [V], 0 at vertices that are not ideal: the sums of the Euclidean
/// triangles that they cut off.
std::vector<double> horosphere_areas(const Embedding& embedding,
                                     const topology::Triangulation& triangulation);

/// Largest entry of (product of the face pairings around the edge) - (the rotation about it by its
/// cone angle), for each edge class [E]: how well the space closes up around its edges. Around a
/// parabolic edge the product is parabolic: by how much it moves the poles of the edge's two
/// planes.
std::vector<double> edge_defects(const Embedding& embedding,
                                 const topology::Triangulation& triangulation);

}  // namespace tripus::embedding
