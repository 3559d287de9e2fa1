#pragma once

#include <cstdint>
#include <span>

#include "solver/extreme_eigenvalues.hpp"
#include "studies/study.hpp"
#include "topology/triangulation.hpp"

// What theory says about a strictly convex functional near its minimiser x*, measured there. H is
// its Hessian at x*, with eigenvalues lambda_min .. lambda_max. All return early, with anything,
// once `stop` is set.

namespace tripus::studies::detail {

/// Extreme eigenvalues of the Hessian of the co-volume at lengths [E].
using Spectrum = solver::ExtremeEigenvalues;
Spectrum spectrum(const topology::Triangulation& triangulation, std::span<const double> lengths);

/// Order of Newton's method: the slope of log |x - x*| after one step on that before it, over
/// starts at relative distances 10^-2.5 .. 10^-4.5, above rounding. Theory: 2, in the limit: there
/// are directions in which the quadratic term nearly vanishes, and at 10^-1.5 the cubic one shows.
double newton_order(const topology::Triangulation& triangulation, std::span<const double> metric,
                    std::uint64_t seed, const Stop& stop);

/// Longest stable step of Euler's method on dx/dt = K, by bisection on 1000 steps from next to the
/// metric. Theory: 2 / lambda_max. `largest` is lambda_max and sets the bracket only.
double euler_limit(const topology::Triangulation& triangulation, std::span<const double> metric,
                   double largest, std::uint64_t seed, const Stop& stop);

/// The flow dx/dt = K from near the metric, displaced mostly along the slowest mode, by steps of
/// 0.2 / lambda_max of the fourth-order Runge-Kutta method.
struct Decay {
  double rate = 0;       ///< of |K| at the end, where max|K| goes below 1e-9. Theory: lambda_min
  bool monotone = true;  ///< whether sum K^2 decreased in every step
  double steps = 0;
};
Decay flow_decay(const topology::Triangulation& triangulation, std::span<const double> metric,
                 const Spectrum& spectrum, std::uint64_t seed, const Stop& stop);

}  // namespace tripus::studies::detail
