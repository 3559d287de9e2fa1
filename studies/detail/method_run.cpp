#include "studies/detail/method_run.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/tolerances.hpp"
#include "energies/energies.hpp"
#include "structure/angle_structure.hpp"
#include "structure/assess.hpp"
#include "structure/method.hpp"
#include "structure/solve.hpp"
#include "topology/requirements.hpp"

namespace tripus::studies::detail {
namespace {

/// Whether an iterate is among those that a trace keeps.
class Thinning {
 public:
  bool keeps(int iteration) {
    if (iteration < next_) return false;
    next_ = std::max(iteration + 1, iteration < 100 ? 0 : iteration + iteration / 50);
    return true;
  }

 private:
  int next_ = 0;
};

/// Copies of the iterates, in the variables of the method.
solver::Options with_trace(const MethodRunOptions& options, std::vector<TracePoint>& trace) {
  solver::Options result;
  result.tolerance = options.tolerance;
  result.max_iterations = options.max_iterations;
  if (!options.trace && !options.stop.possible()) return result;
  result.observer = [&options, &trace,
                     thinning = Thinning()](const solver::Iterate& iterate) mutable {
    if (options.trace && thinning.keeps(iterate.iteration)) {
      trace.push_back({iterate.iteration, iterate.evaluations, iterate.seconds,
                       iterate.max_gradient, iterate.time,
                       std::vector<double>(iterate.x.begin(), iterate.x.end())});
    }
    return !options.stop;
  };
  return result;
}

}  // namespace

MethodRun run_method(const topology::Triangulation& triangulation, const std::string& name,
                     std::span<const double> start, const MethodRunOptions& options) {
  const structure::SolveMethod method =
      structure::find_solve_method(name, triangulation.edge_count());
  MethodRun run;
  const auto angles = [&]() -> std::optional<std::vector<double>> {
    auto deepest = structure::deepest_angle_structure(triangulation);
    if (!(deepest.margin > tolerance::kAngleMargin)) return std::nullopt;
    return std::move(deepest.angles);
  };
  std::vector<double> x(start.begin(), start.end());
  solver::Summary summary;
  if (const auto functional = method.energy->begin(triangulation, {}, angles, x)) {
    solver::Options inner = with_trace(options, run.trace);
    inner.tolerance *= method.energy->tolerance;
    summary = structure::run(method, *functional, x, inner);
    // The lengths are found afterwards, so that the run's clock does not see it.
    for (TracePoint& point : run.trace) functional->to_lengths(point.lengths);
    functional->to_lengths(x);
  }
  const energies::CoVolume energy(triangulation);
  run.report = structure::assess(triangulation, energy, x, options.tolerance, summary);
  run.report.method = method.name;
  return run;
}

Measures measure(const energies::CoVolume& energy, std::span<const double> lengths) {
  Measures result;
  const auto at = energy.at(lengths);
  result.energy = at.value();
  for (const double g : at.gradient()) {
    result.max_curvature = std::max(result.max_curvature, std::fabs(g));
    result.sum_squared_curvature += g * g;
  }
  result.volume = at.volume();
  return result;
}

structure::Report require_metric(const topology::Triangulation& triangulation,
                                 const std::string& name) {
  structure::Report report;
  try {
    topology::require_geodesic_boundary(triangulation);
    report = structure::solve(triangulation);
  } catch (const InvalidInput& error) {
    throw InvalidInput(tripus::quoted(name) + ": " + error.what());
  }
  if (report.outcome != structure::Outcome::kGeometric)
    throw InvalidInput(tripus::quoted(name) +
                       " carries no metric to compare with: " + report.message);
  return report;
}

}  // namespace tripus::studies::detail
