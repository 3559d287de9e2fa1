#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "energies/harmonic.hpp"
#include "parameterise/solid.hpp"

namespace tripus::parameterise {

/// What weighs the edges of the mesh in the energy.
enum class Weights {
  /// Those of linear finite elements on the solid, scaled to volume 1: the energy is then the
  /// Dirichlet energy of the map, up to the mesh's order, on whatever mesh. Some are negative.
  kFiniteElements,
  /// The same, raised to kLeastWeight of the mean where obtuse dihedral angles make them smaller or
  /// negative: the energy is convex, and too large.
  kCotangent,
  kUniform,  ///< 1
};
inline constexpr double kLeastWeight = 1e-2;
/// "finite-elements", "cotangent", "uniform". Throws InvalidInput for another name.
Weights weights_of(std::string_view name);

/// The edges of the mesh, each once, with what carries its end b beside its end a, and weights.
struct WeightedEdges {
  std::vector<energies::HarmonicEdge> edges;
  std::size_t clipped = 0;  ///< weights that were raised
};
WeightedEdges weighted_edges(MarkedSolid& solid, Weights weights);

/// Of linear finite elements on one tetrahedron: -V grad(lambda_i) . grad(lambda_j) for each edge
/// ij, and the volume V.
std::array<double, 6> element_weights(const std::array<geometry::Vector3, 4>& x, double& volume);

/// For every edge ab of the mesh, how far g_ab from the tetrahedra around it differ, as matrices,
/// and how far g_ab g_bc is from g_ac at the triangles.
double equivariance_defect(MarkedSolid& solid);

}  // namespace tripus::parameterise
