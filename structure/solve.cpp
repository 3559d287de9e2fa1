#include "structure/solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "base/error.hpp"
#include "energies/co_volume.hpp"
#include "energies/volume_in_angles.hpp"
#include "integrators/integrate.hpp"
#include "structure/angle_structure.hpp"
#include "structure/assess.hpp"
#include "structure/method.hpp"
#include "structure/starting_lengths.hpp"
#include "topology/requirements.hpp"

namespace tripus::structure {
namespace {

/// Where a run ended: lengths, and the method's own account.
struct Run {
  std::vector<double> lengths;
  solver::Summary summary;
};

/// The history row of an iterate whose lengths are x; the energy must have been evaluated there.
HistoryRow history_row(const solver::Iterate& iterate, std::span<const double> x,
                       energies::CoVolume& energy) {
  std::vector<double> gradient(x.size());
  HistoryRow row;
  row.iteration = iterate.iteration;
  row.evaluations = iterate.evaluations;
  row.seconds = iterate.seconds;
  energy.evaluate(x, gradient, {.value = &row.energy});
  for (const double g : gradient) row.max_curvature = std::max(row.max_curvature, std::fabs(g));
  row.volume = energy.volume();
  const auto [shortest, longest] = std::minmax_element(x.begin(), x.end());
  row.shortest_edge = *shortest;
  row.longest_edge = *longest;
  return row;
}

/// `lengths_of(x)` gives the edge lengths [E] of a point in the method's own variables.
template <class LengthsOf>
solver::Options solver_options(const topology::Triangulation& triangulation,
                               const SolveOptions& options, LengthsOf lengths_of) {
  solver::Options result;
  result.tolerance = options.tolerance;
  result.max_iterations = options.max_iterations;
  result.time_limit = options.time_limit;
  if (!options.history && !options.on_iteration && options.stop_requested == nullptr) return result;
  // The history has an energy of its own: the solver's keeps the derivatives at its own points.
  auto energy = options.history
                    ? std::make_shared<energies::CoVolume>(triangulation, options.cone_angles)
                    : nullptr;
  result.observer = [&options, energy, lengths_of](const solver::Iterate& iterate) {
    if (options.history) options.history(history_row(iterate, lengths_of(iterate.x), *energy));
    if (options.on_iteration) options.on_iteration(iterate.iteration, iterate.max_gradient);
    return options.stop_requested == nullptr || !*options.stop_requested;
  };
  return result;
}

Run run_in_lengths(const topology::Triangulation& triangulation, const SolveOptions& options,
                   const SolveMethod& method, energies::CoVolume& energy) {
  Run run;
  run.lengths = starting_lengths(triangulation, options);
  const auto as_they_are = [](std::span<const double> x) {
    return std::vector<double>(x.begin(), x.end());
  };
  const solver::Options inner = solver_options(triangulation, options, as_they_are);
  run.summary =
      method.form == SolveMethod::Form::kFlow
          ? integrators::integrate(energy, *method.flow, *method.stepper, run.lengths, inner)
          : method.minimiser->minimise(energy, run.lengths, inner);
  return run;
}

Run run_in_angles(const topology::Triangulation& triangulation, const SolveOptions& options,
                  const SolveMethod& method) {
  Run run;
  run.lengths = starting_lengths(triangulation, options);
  const AngleStructure start = deepest_angle_structure(triangulation, options.cone_angles);
  if (!(start.margin > tolerance::kAngleMargin)) {
    run.summary.termination = solver::Termination::kNumericalFailure;
    run.summary.max_gradient = std::numeric_limits<double>::infinity();
    run.summary.message = fmt::format(
        "no strict angle structure to start from (the widest margin is {:.3g})", start.margin);
    return run;
  }
  energies::VolumeInAngles volume(triangulation, start.angles);
  std::vector<double> y(volume.dimension()), gradient(volume.dimension());
  const auto lengths_at = [&](std::span<const double> point) {
    volume.evaluate(point, gradient, {});
    return volume.mean_edge_lengths();
  };
  solver::Options inner = solver_options(triangulation, options, lengths_at);
  // Its gradient is a mismatch of lengths; a curvature adds the angles of up to dozens of corners.
  inner.tolerance = options.tolerance / 8;
  run.summary = method.minimiser->minimise(volume, y, inner);
  run.lengths = lengths_at(y);
  return run;
}

void require_options(const SolveOptions& options) {
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance)) {
    throw InvalidInput(fmt::format("the tolerance is {}; it must be finite and greater than 0",
                                   options.tolerance));
  }
  if (!(options.time_limit > 0))
    throw InvalidInput(
        fmt::format("the time limit is {} s; it must be greater than 0", options.time_limit));
  if (options.max_iterations < 0) {
    throw InvalidInput(
        fmt::format("the iteration limit is {}; it must not be negative", options.max_iterations));
  }
}

}  // namespace

Report solve(const topology::Triangulation& triangulation, const SolveOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  require_options(options);
  topology::require_solvable(triangulation);
  const SolveMethod method = find_solve_method(options.method, triangulation.edge_count());
  energies::CoVolume energy(triangulation, options.cone_angles);
  const Run run = method.form == SolveMethod::Form::kAngles
                      ? run_in_angles(triangulation, options, method)
                      : run_in_lengths(triangulation, options, method, energy);
  Report report = assess(triangulation, energy, run.lengths, options.tolerance, run.summary);
  report.method = method.name;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace tripus::structure
