#include "parameterise/harmonic_map.hpp"

#include <algorithm>
#include <chrono>

#include "base/error.hpp"
#include "parameterise/refine.hpp"
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
  std::vector<double> x(energy.dimension(), 0.0);
  std::unique_ptr<solver::Evaluation> at;
  const auto start = Clock::now();
  const auto measure = [&] {
    energy.evaluate(x, solver::Order::kFirst, at);
    map.energy = at->value();
    map.max_gradient = solver::max_abs(at->gradient());
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

namespace {

/// Goes on from the end of `map` with another energy or in other frames.
void append(HarmonicMap& map, HarmonicMap next) {
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

/// The way to the map of a solid, along several energies and in frames that are chosen by the way.
class Minimising {
 public:
  Minimising(MarkedSolid& solid, const MapOptions& options, const Context& context)
      : solid_(solid), options_(options), context_(context) {}

  /// Goes on to where the gradient is `part` of the first one there, or for 0 to the tolerance.
  /// Says no if a stop or a limit has ended it.
  bool go_on(Weights weights, std::vector<Vector4> points, double part) {
    choose_frames(solid_, points);
    energies::HarmonicEnergy energy = energy_of(solid_, weighted_edges(solid_, weights), points);
    MapOptions how = options_;
    how.max_iterations -= map.iterations;
    how.time_limit -= map.seconds;
    if (part > 0) {
      const auto at = energy.at(std::vector<double>(energy.dimension(), 0.0));
      how.tolerance = std::max(options_.tolerance, part * solver::max_abs(at->gradient()));
    }
    HarmonicMap next = options_.minimiser == Minimiser::kCeres
                           ? minimised_by_ceres(energy, how, context_)
                           : minimised(energy, how, context_);
    if (map.history.empty())
      map = std::move(next);
    else
      append(map, std::move(next));
    // Rounding ends it too, and less than one step is left then.
    return map.termination == solver::Termination::kConverged ||
           map.termination == solver::Termination::kStalled;
  }

  HarmonicMap map;

 private:
  MarkedSolid& solid_;
  const MapOptions& options_;
  const Context& context_;
};

}  // namespace

HarmonicMap harmonic_map(MarkedSolid& solid, Weights weights, const MapOptions& options,
                         const Context& context, std::vector<Vector4> begin) {
  if (begin.empty()) begin = solid.start;
  Minimising way(solid, options, context);
  const Weights convex = weights == Weights::kFiniteElements ? Weights::kCotangent : weights;
  const bool is_done = weights == convex;
  if (way.go_on(convex, std::move(begin), kRough) &&
      way.go_on(convex, way.map.points, is_done ? 0 : kRough) && !is_done &&
      // It may lead far from there, and frames that are far off cost digits.
      way.go_on(weights, way.map.points, kRough))
    way.go_on(weights, way.map.points, 0);
  return std::move(way.map);
}

HarmonicMap refined_map(MarkedSolid& solid, Weights weights, std::size_t tetrahedra,
                        const MapOptions& options, const Context& context) {
  require_refinable(tetrahedra);
  const auto start = Clock::now();
  const Weights convex = weights == Weights::kUniform ? weights : Weights::kCotangent;
  MapOptions left = options;
  const auto time_left = [&] { return options.time_limit - seconds_since(start); };
  for (std::size_t count = solid.mesh.tetrahedra.size(); count < tetrahedra;) {
    left.time_limit = time_left();
    Minimising way(solid, left, context);
    if (!way.go_on(convex, solid.start, kRough) ||
        (weights != convex && !way.go_on(weights, way.map.points, kRough)))
      return std::move(way.map);
    refine(solid, way.map.points, std::min(2 * count, tetrahedra));
    if (solid.mesh.tetrahedra.size() == count) break;
    count = solid.mesh.tetrahedra.size();
    context.report("refining the mesh", count);
  }
  left.time_limit = time_left();
  HarmonicMap map = harmonic_map(solid, weights, left, context);
  map.seconds = seconds_since(start);
  return map;
}

}  // namespace tripus::parameterise
