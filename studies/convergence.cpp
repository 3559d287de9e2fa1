#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "structure/method.hpp"
#include "structure/solve.hpp"
#include "studies/detail/method_run.hpp"
#include "studies/detail/statistics.hpp"
#include "studies/detail/tables.hpp"
#include "studies/detail/theory_measurements.hpp"
#include "topology/cyclic_cover.hpp"

// Every method and flow from the same start: iterations, time, order; and what theory says about
// Newton's method, Euler's and the flow, measured.

namespace tripus::studies::detail {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kLevels[] = {1e-4, 1e-8, 1e-12};
constexpr int kFirstOrderSteps = 100000;
/// Inputs whose iterates are kept: the first with its covers, and this many more.
constexpr std::size_t kTraced = 20;
/// Above so many edge classes only the methods for large problems are tried.
constexpr std::size_t kManyEdges = 400;

struct Subject {
  std::string name;
  std::size_t degree = 1;  ///< of the cover; 1: the input itself
  topology::Triangulation triangulation;
  double base_volume = kNone;  ///< of what it covers
  bool traced = false;         ///< whether the table of iterates has it
};
using SubjectPointer = std::shared_ptr<const Subject>;

/// The first iterate at or below a level of max|K|.
struct Reached {
  double iterations = kNone, seconds = kNone;
};
Reached reached(const MethodRun& run, const std::vector<Measures>& measures, double level) {
  for (std::size_t k = 0; k < run.trace.size(); ++k)
    if (measures[k].max_curvature <= level)
      return {double(run.trace[k].iteration), run.trace[k].seconds};
  return {};
}

/// Order of convergence from the last three iterates above rounding: log(e2/e1) / log(e1/e0) of
/// max|K|. It needs iterates that follow each other.
double measured_order(const MethodRun& run, const std::vector<Measures>& measures) {
  double order = kNone;
  for (std::size_t k = 2; k < measures.size(); ++k) {
    const double e0 = measures[k - 2].max_curvature, e1 = measures[k - 1].max_curvature,
                 e2 = measures[k].max_curvature;
    const bool consecutive = run.trace[k].iteration == run.trace[k - 2].iteration + 2;
    if (consecutive && e2 > 1e-13 && e2 < e1 && e1 < e0 && e1 < 0.5)
      order = std::log(e2 / e1) / std::log(e1 / e0);
  }
  return order;
}

/// What a decimal digit of max|K| costs, from the first to the last iterate.
struct DigitCost {
  double evaluations = kNone, seconds = kNone;
};
DigitCost digit_cost(const MethodRun& run, const std::vector<Measures>& measures) {
  if (measures.size() < 2) return {};
  const double last = std::max(measures.back().max_curvature, 1e-15);
  const double digits = std::log10(measures.front().max_curvature / last);
  if (!(digits > 0)) return {};
  return {double(run.trace.back().evaluations) / digits, run.trace.back().seconds / digits};
}

/// Whether sum K^2 decreased from row to row, up to rounding.
bool squares_decrease(const std::vector<Measures>& measures) {
  for (std::size_t k = 1; k < measures.size(); ++k)
    if (measures[k].sum_squared_curvature > measures[k - 1].sum_squared_curvature + 1e-24)
      return false;
  return true;
}

std::vector<Row> run_rows(const Subject& subject, const std::string& method,
                          const std::vector<double>& start, const Stop& stop) {
  const topology::Triangulation& m = subject.triangulation;
  const bool flow = method.starts_with("flow:") || method.find("ceres") != std::string::npos;
  const MethodRun run = run_method(m, method, start,
                                   {.tolerance = 1e-12,
                                    .max_iterations = flow ? kFirstOrderSteps : 200,
                                    .trace = true,
                                    .stop = stop});
  const energies::CoVolume energy(m);
  std::vector<Measures> measures;
  std::vector<Row> rows;
  for (const TracePoint& point : run.trace) {
    if (stop) return {};
    measures.push_back(measure(energy, point.lengths));
    if (!subject.traced) continue;
    const Measures& now = measures.back();
    rows.push_back({kIterations, cells(subject.name, method, point.iteration, point.evaluations,
                                       now.max_curvature, now.sum_squared_curvature, now.energy,
                                       now.volume, point.time, point.seconds)});
  }
  const DigitCost cost = digit_cost(run, measures);
  std::vector<std::string> row =
      cells(subject.name, subject.degree, m.tetrahedron_count(), m.edge_count(), method,
            structure::to_string(run.report.outcome), run.report.iterations, run.report.evaluations,
            run.report.linear_iterations, run.report.max_curvature, run.report.volume,
            measured_order(run, measures), cost.evaluations, squares_decrease(measures));
  std::vector<std::string> times;
  for (const double level : kLevels) {
    const Reached at = reached(run, measures, level);
    row.push_back(cell(at.iterations));
    times.push_back(cell(at.seconds));
  }
  row.insert(row.end(), times.begin(), times.end());
  row.push_back(cell(cost.seconds));
  row.push_back(cell(run.report.seconds));
  rows.push_back({kRuns, row});
  return rows;
}

std::vector<Row> theory_rows(const Subject& subject, std::uint64_t seed, const Stop& stop) {
  const topology::Triangulation& m = subject.triangulation;
  structure::SolveOptions options;
  options.stop = stop;
  const structure::Report metric = structure::solve(m, options);
  const bool found = metric.outcome == structure::Outcome::kGeometric;
  double values[8];
  std::fill(std::begin(values), std::end(values), kNone);
  bool monotone = false;
  if (found) {
    const Spectrum s = spectrum(m, metric.edge_lengths);
    const Decay decay = flow_decay(m, metric.edge_lengths, s, seed, stop);
    values[0] = s.smallest, values[1] = s.largest;
    values[2] = newton_order(m, metric.edge_lengths, seed, stop);
    values[3] = euler_limit(m, metric.edge_lengths, s.largest, seed, stop);
    values[4] = values[3] * s.largest / 2;
    values[5] = decay.rate;
    values[6] = decay.rate / s.smallest;
    monotone = decay.monotone;
  }
  if (found) values[7] = metric.volume / (double(subject.degree) * subject.base_volume) - 1;
  return {{kTheory, cells(subject.name, subject.degree, m.tetrahedron_count(), m.edge_count(),
                          structure::to_string(metric.outcome), values[0], values[1], values[2],
                          values[3], values[4], values[5], values[6],
                          std::isfinite(values[0]) ? cell(monotone) : std::string(), values[7])}};
}

/// The input and the covers of it that were asked for. Lists of a census also hold triangulations
/// that carry no metric; only the first input must.
void add_subjects(const StudyInput& input, const std::vector<std::size_t>& covers,
                  std::vector<SubjectPointer>& subjects) {
  const topology::Triangulation base(input.gluings);
  structure::SolveOptions quick;
  quick.evidence = false;
  const structure::Report metric =
      subjects.empty() ? require_metric(base, input.name) : structure::solve(base, quick);
  if (metric.outcome != structure::Outcome::kGeometric) return;
  const auto inputs = std::ranges::count(subjects, 1u, [](const auto& s) { return s->degree; });
  const bool traced = inputs <= std::ptrdiff_t(kTraced);
  subjects.push_back(
      std::make_shared<Subject>(Subject{input.name, 1, base, metric.volume, traced}));
  if (covers.empty()) return;
  const auto shifts = topology::primitive_class(base);
  if (!shifts)
    throw InvalidInput(tripus::quoted(input.name) +
                       " has finite first homology: it has no cyclic covers of every degree");
  for (const std::size_t degree : covers) {
    if (degree < 2) continue;
    topology::Triangulation cover(topology::cyclic_cover(input.gluings, *shifts, degree));
    subjects.push_back(
        std::make_shared<Subject>(Subject{fmt::format("{} cover {}", input.name, degree), degree,
                                          std::move(cover), metric.volume, true}));
  }
}

/// The start of all methods in lengths: between 1/3 and 3, at random.
std::vector<double> common_start(const Subject& subject, std::uint64_t seed) {
  Random random(item_seed(seed, subject.name));
  std::vector<double> start(subject.triangulation.edge_count());
  for (double& length : start) length = std::pow(3.0, random.uniform(-1, 1));
  return start;
}

bool suits(const std::string& method, const Subject& subject) {
  if (subject.triangulation.edge_count() <= kManyEdges) return true;
  return method == "newton" || method == "newton-cg" || method == "newton-cg-block" ||
         method == "ceres-lbfgs" || method == "ceres-cg" || method == "flow:curvature/dopri5";
}

}  // namespace

Plan plan_convergence(const StudyOptions& options) {
  std::vector<SubjectPointer> subjects;
  // `samples` inputs besides the first, chosen by the seed if there are more.
  std::vector<std::size_t> chosen(options.inputs.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = i;
  Random random(item_seed(options.seed, "inputs"));
  for (std::size_t i = chosen.size(); i > 2; --i)
    std::swap(chosen[i - 1], chosen[1 + random.bits() % (i - 1)]);
  if (chosen.size() > options.samples + 1) chosen.resize(options.samples + 1);
  std::sort(chosen.begin(), chosen.end());
  for (const std::size_t i : chosen) {
    if (options.stop.requested()) return {};
    add_subjects(options.inputs[i], i == 0 ? options.covers : std::vector<std::size_t>{}, subjects);
  }
  const std::vector<std::string> methods =
      options.methods.empty() ? structure::solve_method_names() : options.methods;
  for (const std::string& method : methods) structure::find_solve_method(method, 1);

  Plan plan;
  plan.tables = convergence_layouts();
  for (const SubjectPointer& subject : subjects) {
    const std::string id = "theory " + subject->name;
    const std::uint64_t seed = item_seed(options.seed, id);
    plan.items.push_back({id, [=](const Stop& stop) { return theory_rows(*subject, seed, stop); }});
    const auto start =
        std::make_shared<const std::vector<double>>(common_start(*subject, options.seed));
    for (const std::string& method : methods)
      if (suits(method, *subject))
        plan.items.push_back(
            {fmt::format("{} by {}", subject->name, method),
             [=](const Stop& stop) { return run_rows(*subject, method, *start, stop); }});
  }
  plan.conclude = convergence_findings;
  return plan;
}

std::vector<TableLayout> convergence_layouts() {
  const Column input{"input", "", "the triangulation"},
      degree{"degree", "", "of the cover; 1: none"}, tetrahedra{"tetrahedra", "", "T"},
      edges{"edges", "", "edge classes E"};
  return {
      {"runs",
       "One run of a method from the start that all share: random lengths between 1/3 and 3. The "
       "methods in angles start from angles deep inside their polytope instead.",
       {input,
        degree,
        tetrahedra,
        edges,
        {"method", "", "as after --method"},
        {"outcome", "", "what the run by itself ended with"},
        {"iterations", "", "steps"},
        {"evaluations", "", "of the gradient"},
        {"linear_iterations", "", "conjugate-gradient steps"},
        {"max_curvature", "radians", "max|K| at the end"},
        {"volume", "", "at the end"},
        {"order", "", "log(e2/e1) / log(e1/e0) of the last three max|K| above rounding"},
        {"evaluations_per_digit", "", "evaluations a decimal digit of max|K|"},
        {"squares_decrease", "", "whether sum K^2 decreased from iterate to iterate"},
        {"iterations_to_1e_4", "", "steps to max|K| <= 1e-4; empty: not reached"},
        {"iterations_to_1e_8", "", "steps to max|K| <= 1e-8"},
        {"iterations_to_1e_12", "", "steps to max|K| <= 1e-12"},
        {"seconds_to_1e_4", "seconds", "time to max|K| <= 1e-4", true},
        {"seconds_to_1e_8", "seconds", "time to max|K| <= 1e-8", true},
        {"seconds_to_1e_12", "seconds", "time to max|K| <= 1e-12", true},
        {"seconds_per_digit", "seconds", "time a decimal digit of max|K|", true},
        {"seconds", "seconds", "of the whole run", true}}},
      {"iterations",
       "One iterate of a run on the first input, its covers and up to 20 other inputs: every one "
       "up "
       "to the 100th, then those 2 % apart.",
       {input,
        {"method", "", "as after --method"},
        {"iteration", "", "0 is the start"},
        {"evaluations", "", "of the gradient so far"},
        {"max_curvature", "radians", "max|K|"},
        {"sum_squared_curvature", "radians^2", "sum K^2"},
        {"energy", "", "the co-volume functional H"},
        {"volume", "", "sum over the tetrahedra"},
        {"time", "", "flow time t; 0 for minimisers"},
        {"seconds", "seconds", "since the start of the run", true}}},
      {"theory",
       "What theory says about a triangulation, measured at its metric.",
       {input,
        degree,
        tetrahedra,
        edges,
        {"outcome", "", "of Newton's method"},
        {"lambda_min", "", "least eigenvalue of the Hessian of H, by Lanczos iterations"},
        {"lambda_max", "", "greatest eigenvalue, the same"},
        {"newton_order", "", "slope of log error after a step on log error before it"},
        {"euler_limit", "", "longest stable Euler step, by bisection"},
        {"euler_ratio", "", "euler_limit / (2 / lambda_max)"},
        {"decay_rate", "", "of |K| along dx/dt = K near the metric"},
        {"decay_ratio", "", "decay_rate / lambda_min"},
        {"squares_decrease", "", "whether sum K^2 decreased all along that flow"},
        {"volume_error", "", "volume / (degree x volume of the base) - 1"}}},
  };
}

}  // namespace tripus::studies::detail
