#include "studies/detail/method_run.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/tolerances.hpp"
#include "energies/volume_in_angles.hpp"
#include "integrators/integrate.hpp"
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
  if (!options.trace && options.stop == nullptr) return result;
  result.observer = [&options, &trace,
                     thinning = Thinning()](const solver::Iterate& iterate) mutable {
    if (options.trace && thinning.keeps(iterate.iteration)) {
      trace.push_back({iterate.iteration, iterate.evaluations, iterate.seconds,
                       iterate.max_gradient, iterate.time,
                       std::vector<double>(iterate.x.begin(), iterate.x.end())});
    }
    return options.stop == nullptr || !*options.stop;
  };
  return result;
}

/// In angles: the lengths are found afterwards, so that the run's clock does not see it.
solver::Summary run_in_angles(const topology::Triangulation& triangulation,
                              const structure::SolveMethod& method, solver::Options options,
                              std::vector<double>& lengths, std::vector<TracePoint>& trace) {
  solver::Summary summary;
  const auto start = structure::deepest_angle_structure(triangulation);
  if (!(start.margin > tolerance::kAngleMargin)) return summary;
  energies::VolumeInAngles volume(triangulation, start.angles);
  std::vector<double> y(volume.dimension()), gradient(volume.dimension());
  options.tolerance /= 8;  // of lengths, as structure::solve asks for
  summary = method.minimiser->minimise(volume, y, options);
  const auto lengths_at = [&](std::span<const double> point) {
    volume.evaluate(point, gradient, {});
    return volume.mean_edge_lengths();
  };
  for (TracePoint& point : trace) point.lengths = lengths_at(point.lengths);
  lengths = lengths_at(y);
  return summary;
}

}  // namespace

MethodRun run_method(const topology::Triangulation& triangulation, const std::string& name,
                     std::span<const double> start, const MethodRunOptions& options) {
  const structure::SolveMethod method =
      structure::find_solve_method(name, triangulation.edge_count());
  MethodRun run;
  energies::CoVolume energy(triangulation);
  std::vector<double> x(start.begin(), start.end());
  const solver::Options inner = with_trace(options, run.trace);
  solver::Summary summary;
  if (method.form == structure::SolveMethod::Form::kAngles) {
    summary = run_in_angles(triangulation, method, inner, x, run.trace);
  } else if (method.form == structure::SolveMethod::Form::kFlow) {
    summary = integrators::integrate(energy, *method.flow, *method.stepper, x, inner);
  } else {
    summary = method.minimiser->minimise(energy, x, inner);
  }
  run.report = structure::assess(triangulation, energy, x, options.tolerance, summary);
  run.report.method = method.name;
  return run;
}

Measures measure(energies::CoVolume& energy, std::span<const double> lengths) {
  Measures result;
  std::vector<double> gradient(lengths.size());
  energy.evaluate(lengths, gradient, {.value = &result.energy});
  for (const double g : gradient) {
    result.max_curvature = std::max(result.max_curvature, std::fabs(g));
    result.sum_squared_curvature += g * g;
  }
  result.volume = energy.volume();
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
