#include "parameterise/harmonic_map.hpp"

#include <algorithm>
#include <chrono>

#include "base/error.hpp"
#include "solver/run.hpp"

namespace tripus::parameterise {
namespace {

using Clock = std::chrono::steady_clock;

/// Newton steps until the charts are moved: near the minimum one chart does for all of them.
constexpr int kStepsInAChart = 4;
constexpr int kFirstCharts = 4;  ///< with one step each
/// So many charts in a row that do not halve the gradient: rounding rules.
constexpr int kIdleCharts = 6;
/// Where frames are chosen anew, in parts of the first gradient.
constexpr double kRough = 1e-4;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

const char* method_of(Minimiser minimiser) {
  return minimiser == Minimiser::kDescent ? "ceres-steepest-descent" : "newton-cg";
}

}  // namespace

std::string_view to_string(Minimiser minimiser) {
  switch (minimiser) {
    case Minimiser::kNewton:
      return "newton";
    case Minimiser::kCeres:
      return "ceres";
    case Minimiser::kDescent:
      break;
  }
  return "descent";
}

energies::HarmonicEnergy energy_of(const MarkedSolid& solid, const WeightedEdges& edges,
                                   std::span<const Vector4> points) {
  return {edges.edges, solid.group->matrices(), points, solid.poles};
}

HarmonicMap minimised(energies::HarmonicEnergy& energy, const MapOptions& options,
                      const Context& context) {
  const solver::Method& method = *solver::find_method(method_of(options.minimiser));
  const bool is_newton = options.minimiser == Minimiser::kNewton;
  HarmonicMap map;
  std::vector<double> x(energy.dimension(), 0.0), gradient(energy.dimension());
  const auto start = Clock::now();
  const auto measure = [&] {
    energy.evaluate(x, gradient, {.value = &map.energy});
    map.max_gradient = solver::max_abs(gradient);
    map.history.push_back({map.iterations, seconds_since(start), map.energy, map.max_gradient});
  };
  measure();
  solver::Options solving;
  solving.tolerance = options.tolerance;
  solving.observer = [&](const solver::Iterate&) {
    return !context.stop_requested() && !context.expired();
  };
  int idle = 0;
  for (int chart = 0;; ++chart) {
    const int left = options.max_iterations - map.iterations;
    if (left <= 0) {
      map.termination = solver::Termination::kIterationLimit;
      break;
    }
    const int steps = chart < kFirstCharts ? 1 : kStepsInAChart;
    solving.max_iterations = is_newton ? std::min(left, steps) : left;
    solving.time_limit = options.time_limit - seconds_since(start);
    if (!(solving.time_limit > 0)) {
      map.termination = solver::Termination::kTimeLimit;
      break;
    }
    const solver::Summary summary = method.minimise(energy, x, solving);
    map.iterations += summary.iterations;
    map.evaluations += summary.evaluations;
    map.linear_iterations += summary.linear_iterations;
    map.termination = summary.termination;
    energy.recentre(x);
    std::fill(x.begin(), x.end(), 0.0);
    const double before = map.max_gradient;
    measure();
    context.report("minimising the energy", energy.point_count());
    const bool goes_on = summary.termination == solver::Termination::kIterationLimit ||
                         summary.termination == solver::Termination::kStalled;
    if (!is_newton || !goes_on) break;
    idle = map.max_gradient < 0.5 * before ? 0 : idle + 1;
    if (idle < kIdleCharts || chart < kFirstCharts) continue;
    map.termination = solver::Termination::kStalled;
    break;
  }
  map.points = energy.points(x);
  map.seconds = seconds_since(start);
  return map;
}

/// Goes on from the end of `map` with another energy or in other frames.
void go_on(HarmonicMap& map, HarmonicMap next) {
  for (MapStep& step : next.history) {
    step.iteration += map.iterations;
    step.seconds += map.seconds;
  }
  next.history.insert(next.history.begin(), map.history.begin(), map.history.end() - 1);
  next.iterations += map.iterations;
  next.evaluations += map.evaluations;
  next.linear_iterations += map.linear_iterations;
  next.seconds += map.seconds;
  map = std::move(next);
}

HarmonicMap harmonic_map(MarkedSolid& solid, Weights weights, const MapOptions& options,
                         const Context& context, std::vector<Vector4> begin) {
  if (begin.empty()) begin = solid.start;
  HarmonicMap map;
  const auto minimise = [&](Weights which, std::span<const Vector4> points, double part) {
    energies::HarmonicEnergy energy = energy_of(solid, weighted_edges(solid, which), points);
    MapOptions how = options;
    how.max_iterations -= map.iterations;
    how.time_limit -= map.seconds;
    if (part > 0) {
      std::vector<double> x(energy.dimension(), 0.0), gradient(energy.dimension());
      energy.evaluate(x, gradient, {});
      how.tolerance = std::max(options.tolerance, part * solver::max_abs(gradient));
    }
    HarmonicMap next = options.minimiser == Minimiser::kCeres
                           ? minimised_by_ceres(energy, how, context)
                           : minimised(energy, how, context);
    if (map.history.empty())
      map = std::move(next);
    else
      go_on(map, std::move(next));
    // Rounding ends it too, and less than one step is left then.
    return map.termination == solver::Termination::kConverged ||
           map.termination == solver::Termination::kStalled;
  };
  const Weights convex = weights == Weights::kFiniteElements ? Weights::kCotangent : weights;
  choose_frames(solid, begin);
  if (!minimise(convex, begin, kRough)) return map;
  choose_frames(solid, map.points);
  if (!minimise(convex, std::vector<Vector4>(map.points), weights == convex ? 0 : kRough))
    return map;
  if (weights == convex) return map;
  // It may lead far from there, and frames that are far off cost digits.
  if (!minimise(weights, std::vector<Vector4>(map.points), kRough)) return map;
  choose_frames(solid, map.points);
  minimise(weights, std::vector<Vector4>(map.points), 0);
  return map;
}

}  // namespace tripus::parameterise
