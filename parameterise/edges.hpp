#pragma once

#include <cstddef>
#include <vector>

#include "energies/harmonic.hpp"
#include "parameterise/solid.hpp"

namespace tripus::parameterise {

/// What weighs the edges of the mesh in the energy.
enum class Weights {
  /// Those of linear finite elements on the solid, scaled to volume 1: the energy is then that of
  /// the map, whatever the mesh. Where obtuse dihedral angles make a weight small or negative it is
  /// raised to kLeastWeight of the mean.
  kCotangent,
  kUniform,  ///< 1
};
inline constexpr double kLeastWeight = 1e-2;

/// The edges of the mesh, each once, with what carries its end b beside its end a, and weights.
struct WeightedEdges {
  std::vector<energies::HarmonicEdge> edges;
  std::size_t clipped = 0;  ///< weights that were raised
};
WeightedEdges weighted_edges(MarkedSolid& solid, Weights weights);

/// For every edge ab of the mesh, how far g_ab from the tetrahedra around it differ, as matrices,
/// and how far g_ab g_bc is from g_ac at the triangles.
double equivariance_defect(MarkedSolid& solid);

}  // namespace tripus::parameterise
