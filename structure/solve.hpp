#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/stop.hpp"
#include "base/tolerances.hpp"
#include "structure/report.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure {

/// One line of a run's history.
struct HistoryRow {
  int iteration = 0;
  int evaluations = 0;
  double seconds = 0;
  double max_curvature = 0;  ///< max|K|
  double energy = 0;         ///< H, the co-volume functional
  double volume = 0;
  double shortest_edge = 0;
  double longest_edge = 0;
};

struct SolveOptions {
  /// A name from method_names(); "auto" is Newton, by a direct factorisation for small
  /// triangulations and by conjugate gradients for large ones.
  std::string method = "auto";
  /// Lengths to start from [E], finite, and > 0 unless an end is ideal; empty for `initial_length`
  /// everywhere. A parabolic edge always has the length 0.
  std::vector<double> initial_lengths;
  /// One length for all edges between hyperideal vertices, > 0; 0 for the length at which the mean
  /// edge curvature vanishes if all tetrahedra are regular.
  double initial_length = 0;
  double tolerance = tolerance::kMaxCurvature;                  ///< on max|K|; > 0
  int max_iterations = 0;                                       ///< 0: the method's default
  double time_limit = std::numeric_limits<double>::infinity();  ///< seconds
  std::vector<topology::ConeAngle> cone_angles;                 ///< [E]; empty for 2 pi
  /// Called at every iteration if set; costs an evaluation of the energy and the volume each time.
  std::function<void(const HistoryRow&)> history;
  /// Called at every iteration if set, with its number and max|gradient|; cheap.
  std::function<void(int iteration, double max_gradient)> on_iteration;
  Stop stop{};  ///< polled at every iteration
  /// Whether to decide exactly about angle structures where no metric is found, and to look for a
  /// surface that proves the manifold not hyperbolic (closed_bigon.hpp).
  bool evidence = true;
  bool angle_structure = false;  ///< also decide on exact strict angles where a metric was found
};

/// Finds the complete hyperbolic metric with totally geodesic boundary, cusps at ideal vertices and
/// the given cone angles, or says with evidence why this triangulation carries none.
///
/// Lengths at cusps are measured from horospheres of area sqrt(3)/2 each. These are embedded and
/// disjoint in a manifold, as the shortest translation along them is at most 1.
///
/// The outcome depends on the triangulation alone, not on method, start or labels, unless a limit
/// that the options set ends the run: what does not end in a metric is settled by Newton's method
/// from the default start and by an exact decision about angle structures (docs/theory.md section
/// 5). There is no exact decision with cone angles that are not rational multiples of pi, nor
/// beyond 10,000 tetrahedra, nor where a vertex is finite: there the problem is not convex, and
/// what is not geometric is unresolved. Throws InvalidInput for a triangulation outside the domain
/// (see topology::require_solvable) and for options out of range. A triangulation that carries no
/// metric is an answer, not an error.
Report solve(const topology::Triangulation& triangulation, const SolveOptions& options = {});

}  // namespace tripus::structure
