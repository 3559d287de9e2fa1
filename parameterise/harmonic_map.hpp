#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/context.hpp"
#include "parameterise/edges.hpp"
#include "solver/method.hpp"

namespace tripus::parameterise {

/// Who looks for the minimiser.
enum class Minimiser {
  kNewton,   ///< newton-cg in charts that are moved along; the project's own
  kCeres,    ///< Levenberg-Marquardt of Ceres on a product of hyperboloids and planes
  kDescent,  ///< steepest descent with Ceres' line search, for comparison
};
/// "newton", "ceres", "descent".
std::string_view to_string(Minimiser minimiser);

struct MapOptions {
  Minimiser minimiser = Minimiser::kNewton;
  double tolerance = 1e-11;  ///< on max|gradient|; finite, > 0
  int max_iterations = 200;
  double time_limit = std::numeric_limits<double>::infinity();
};

struct MapStep {
  int iteration = 0;
  double seconds = 0;
  double energy = 0;
  double max_gradient = 0;
};

/// A map of the mesh, equivariant by its marking: for each point of the mesh a point of H^3 in the
/// point's own frame.
struct HarmonicMap {
  std::vector<Vector4> points = {};  ///< [V]
  double energy = 0;
  double max_gradient = 0;
  solver::Termination termination = solver::Termination::kNumericalFailure;
  int iterations = 0;
  int evaluations = 0;
  long linear_iterations = 0;
  double seconds = 0;
  std::vector<MapStep> history = {};
};

/// The map with least energy: minimises from the points where the energy stands. A stop or a limit
/// leaves the best so far; `termination` says which. Throws InvalidInput for options out of range.
HarmonicMap minimised(energies::HarmonicEnergy& energy, const MapOptions& options = {},
                      const Context& context = {});

/// The same by Ceres: residuals log(f_a, g_ab f_b), whose squares are the squares of the distances.
/// `energy` gives edges, isometries and points, and judges the result.
HarmonicMap minimised_by_ceres(energies::HarmonicEnergy& energy, const MapOptions& options = {},
                               const Context& context = {});

/// The harmonic map of a solid: from where the simplification sent its points to rough convergence,
/// then, in frames chosen by that (choose_frames), to the end. With kFiniteElements first that of
/// kCotangent, which is unique, and from there to the minimum next to it. The solid has these
/// frames afterwards. `begin` [V]: other points to begin with, in the frames that the points have;
/// empty for the start.
HarmonicMap harmonic_map(MarkedSolid& solid, Weights weights, const MapOptions& options = {},
                         const Context& context = {}, std::vector<Vector4> begin = {});

/// The same on a mesh that is refined where the map stretches it (refine.hpp), until it has so many
/// tetrahedra: by rough maps with positive weights, each on a mesh twice as fine as the last. The
/// solid has the fine mesh afterwards, or, if a stop or a limit ended it before, that of the map.
/// Throws InvalidInput for more than kMostRefined.
HarmonicMap refined_map(MarkedSolid& solid, Weights weights, std::size_t tetrahedra,
                        const MapOptions& options = {}, const Context& context = {});

/// The energy of maps of a marked solid, at these points.
energies::HarmonicEnergy energy_of(const MarkedSolid& solid, const WeightedEdges& edges,
                                   std::span<const Vector4> points);

}  // namespace tripus::parameterise
