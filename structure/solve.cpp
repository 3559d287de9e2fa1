#include "structure/solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "base/error.hpp"
#include "energies/co_volume.hpp"
#include "energies/energies.hpp"
#include "structure/angle_structure.hpp"
#include "structure/assess.hpp"
#include "structure/closed_bigon.hpp"
#include "structure/detail/angle_programme.hpp"
#include "structure/detail/other_ways.hpp"
#include "structure/detail/small_decision.hpp"
#include "structure/existence.hpp"
#include "structure/method.hpp"
#include "structure/starting_lengths.hpp"
#include "topology/requirements.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::structure {
namespace {

/// Iterations after which Newton's method is not going to find a metric: from random starts over
/// ten decades of lengths, metrics took at most 14.
constexpr int kNewtonPatience = 100;

/// Steps in which nearly every metric of a few tetrahedra is found from the default start: the mean
/// for four is 3.4.
constexpr int kFewSteps = 8;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Where a run ended: lengths, and the method's own account.
struct Run {
  std::vector<double> lengths;
  solver::Summary summary;
  std::unique_ptr<energies::Functional> functional;  ///< what was minimised; null if nothing was
};

/// The history row of an iterate whose lengths are x.
HistoryRow history_row(const solver::Iterate& iterate, std::span<const double> x,
                       const energies::CoVolume& energy) {
  const auto at = energy.at(x);
  HistoryRow row;
  row.iteration = iterate.iteration;
  row.evaluations = iterate.evaluations;
  row.seconds = iterate.seconds;
  row.energy = at.value();
  for (const double g : at.gradient())
    row.max_curvature = std::max(row.max_curvature, std::fabs(g));
  row.volume = at.volume();
  const auto [shortest, longest] = std::minmax_element(x.begin(), x.end());
  row.shortest_edge = *shortest;
  row.longest_edge = *longest;
  return row;
}

solver::Options solver_options(const topology::Triangulation& triangulation,
                               const SolveOptions& options, energies::Functional& functional) {
  solver::Options result;
  result.tolerance = options.tolerance;
  result.max_iterations = options.max_iterations;
  result.time_limit = options.time_limit;
  if (!options.history && !options.on_iteration && !options.stop.possible()) return result;
  auto energy = options.history
                    ? std::make_shared<energies::CoVolume>(triangulation, options.cone_angles)
                    : nullptr;
  result.observer = [&options, energy, &functional](const solver::Iterate& iterate) {
    if (options.history) {
      std::vector<double> lengths(iterate.x.begin(), iterate.x.end());
      functional.to_lengths(lengths);
      options.history(history_row(iterate, lengths, *energy));
    }
    if (options.on_iteration) options.on_iteration(iterate.iteration, iterate.max_gradient);
    return !options.stop.requested();
  };
  return result;
}

/// Throws Unsupported where the energy of a method is not defined.
void require_energy(const topology::Triangulation& triangulation, const SolveOptions& options,
                    const SolveMethod& method) {
  if (!method.energy->hyperideal_only) return;
  const auto links = topology::orbifold_links(triangulation, options.cone_angles);
  const bool hyperideal = std::ranges::all_of(
      links, [](const auto& link) { return link.kind == topology::VertexKind::kHyperideal; });
  const bool parabolic =
      std::ranges::any_of(options.cone_angles, &topology::ConeAngle::is_parabolic);
  if (!hyperideal || parabolic)
    throw Unsupported(fmt::format(
        "the method {} works with geodesic boundary only so far, not with {}; use a method in "
        "lengths, such as newton",
        method.name, hyperideal ? "parabolic edges" : "cusps and finite vertices"));
}

Run run_method(const topology::Triangulation& triangulation, const SolveOptions& options,
               const SolveMethod& method) {
  require_energy(triangulation, options, method);
  Run run;
  run.lengths = starting_lengths(triangulation, options);
  double margin = 0;
  const auto angles = [&]() -> std::optional<std::vector<double>> {
    AngleStructure deepest = deepest_angle_structure(triangulation, options.cone_angles);
    margin = deepest.margin;
    if (!(margin > tolerance::kAngleMargin)) return std::nullopt;
    return std::move(deepest.angles);
  };
  run.functional =
      method.energy->begin(triangulation, options.cone_angles, std::cref(angles), run.lengths);
  if (!run.functional) {
    run.summary.termination = solver::Termination::kNumericalFailure;
    run.summary.max_gradient = std::numeric_limits<double>::infinity();
    run.summary.message = fmt::format(
        "no strict angle structure to start from (the widest margin is {:.3g})", margin);
    return run;
  }
  solver::Options inner = solver_options(triangulation, options, *run.functional);
  inner.tolerance *= method.energy->tolerance;
  run.summary = structure::run(method, *run.functional, run.lengths, inner);
  run.functional->to_lengths(run.lengths);
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

bool any_finite_vertex(const topology::Triangulation& triangulation, const SolveOptions& options) {
  if (topology::all_full(options.cone_angles)) {
    for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
      if (triangulation.link(v).euler_characteristic > 0) return true;
    return false;
  }
  return std::ranges::any_of(
      topology::orbifold_links(triangulation, options.cone_angles),
      [](const auto& link) { return link.kind == topology::VertexKind::kFinite; });
}

/// There every method is the one that can do it.
Report run_with_finite_vertices(const topology::Triangulation& triangulation,
                                const SolveOptions& options) {
  if (options.method != "auto" && options.method != "newton")
    throw Unsupported("the method " + options.method +
                      " does not work with finite vertices, where the problem is not convex; leave "
                      "the method out");
  energies::CoVolume energy(triangulation, options.cone_angles);
  std::vector<double> lengths = starting_lengths(triangulation, options);
  const auto summary = detail::gauss_newton(triangulation, energy, options, lengths);
  Report report = assess(triangulation, energy, lengths, options.tolerance, summary);
  report.method = "gauss-newton";
  return report;
}

/// One run of a method, judged. Without a limit of the user's, Newton's method gets one that
/// metrics do not need: what is still running then is on its way to infinity.
Report judged_run(const topology::Triangulation& triangulation, const SolveOptions& options) {
  if (any_finite_vertex(triangulation, options))
    return run_with_finite_vertices(triangulation, options);
  const SolveMethod method = find_solve_method(options.method, triangulation.edge_count());
  SolveOptions limited = options;
  if (options.max_iterations == 0 && method.minimiser != nullptr && method.minimiser->second_order)
    limited.max_iterations = kNewtonPatience;
  const Run run = run_method(triangulation, limited, method);
  std::optional<energies::CoVolume> other;
  auto* energy = run.functional
                     ? dynamic_cast<const energies::CoVolume*>(&run.functional->problem())
                     : nullptr;
  if (energy == nullptr) energy = &other.emplace(triangulation, options.cone_angles);
  Report report = assess(triangulation, *energy, run.lengths, options.tolerance, run.summary);
  report.method = method.name;
  return detail::settled_if_thin(triangulation, options, std::move(report),
                                 options.time_limit - run.summary.seconds);
}

/// Whether a limit that the user set, or the user, ended the run.
bool was_cut_short(const Report& report, const SolveOptions& options) {
  switch (report.termination) {
    case solver::Termination::kTimeLimit:
    case solver::Termination::kInterrupted:
      return true;
    case solver::Termination::kIterationLimit:
      return options.max_iterations > 0;
    default:
      return false;
  }
}

/// The run that the outcome rests on where the user's own did not find a metric: Newton's method
/// from the default start. Limits of time, and the wish to stop, remain.
Report settling_run(const topology::Triangulation& triangulation, const SolveOptions& options,
                    Report report) {
  const bool was_default = (options.method == "auto" || options.method == "newton") &&
                           options.initial_lengths.empty() && options.initial_length == 0 &&
                           options.tolerance <= tolerance::kMaxCurvature;
  if (was_default) return report;
  SolveOptions settling;
  settling.cone_angles = options.cone_angles;
  settling.tolerance = std::min(options.tolerance, tolerance::kMaxCurvature);
  settling.time_limit =
      std::max(options.time_limit - report.seconds, std::numeric_limits<double>::min());
  settling.stop = options.stop;
  Report settled = judged_run(triangulation, settling);
  settled.iterations += report.iterations;
  settled.evaluations += report.evaluations;
  settled.linear_iterations += report.linear_iterations;
  return settled;
}

/// The sentence for a certificate.
std::string certificate_message(const Certificate& certificate) {
  return certificate.kind == Certificate::Kind::kNone
             ? "There is no angle structure on this triangulation (exact certificate), so it "
               "carries no metric; its manifold may."
             : "Every angle structure on this triangulation has an angle 0 or a vertex sum pi "
               "(exact certificate), so it carries no metric; its manifold may.";
}

/// Turns the report of a run that found no metric into a verdict with evidence.
Report settle(const topology::Triangulation& triangulation, const SolveOptions& options,
              Clock::time_point start, Report report) {
  report.advice = Advice::kRetriangulate;
  if (triangulation.tetrahedron_count() > detail::most_tetrahedra_decided()) {
    report.message += fmt::format(
        " Whether it has angle structures is decided exactly for up to {} tetrahedra only.",
        detail::most_tetrahedra_decided());
    return report;
  }
  auto decided = existence_within(options.time_limit - seconds_since(start), triangulation,
                                  options.cone_angles);
  if (!decided) {
    report.advice = Advice::kMoreTime;
    report.message += " The time was over before it was decided whether it has angle structures.";
    return report;
  }
  Existence found = *std::move(decided);
  if (auto* certificate = std::get_if<Certificate>(&found)) {
    if (certificate->kind == Certificate::Kind::kSemi && report.outcome == Outcome::kUnresolved)
      report = detail::settled_if_thin(
          triangulation, options,
          detail::flat_minimiser(triangulation, options, report).value_or(report),
          options.time_limit - seconds_since(start));
    // A flat minimiser is more than a certificate says; it contradicts one of kind "none".
    if (certificate->kind == Certificate::Kind::kNone || report.outcome != Outcome::kDegenerate) {
      report.outcome = Outcome::kInfeasible;
      report.message = certificate_message(*certificate);
    }
    report.certificate = std::move(*certificate);
  } else {
    if (report.outcome == Outcome::kUnresolved)
      report = detail::flat_minimiser(triangulation, options, report).value_or(report);
    if (report.outcome == Outcome::kUnresolved)
      report = detail::precise_minimiser(triangulation, options, report).value_or(report);
    report.strict_angles = std::move(std::get<StrictAngles>(found));
    if (report.outcome == Outcome::kUnresolved)
      report.message += " A strict angle structure exists, so the co-volume has a minimiser.";
  }
  return report;
}

/// A run that found a metric, but not to the tolerance that was asked for, which doubles do not
/// reach; nothing if it is not one.
std::optional<Report> metric_above_tolerance(const topology::Triangulation& triangulation,
                                             const SolveOptions& options, const Report& report) {
  if (!(options.tolerance < tolerance::kMaxCurvature)) return std::nullopt;
  energies::CoVolume energy(triangulation, options.cone_angles);
  solver::Summary summary;
  summary.termination = report.termination;
  summary.iterations = report.iterations;
  summary.evaluations = report.evaluations;
  summary.linear_iterations = report.linear_iterations;
  Report judged =
      assess(triangulation, energy, report.edge_lengths, tolerance::kMaxCurvature, summary);
  judged = detail::settled_if_thin(triangulation, options, std::move(judged),
                                   options.time_limit - report.seconds);
  if (judged.outcome != Outcome::kGeometric) return std::nullopt;
  judged.method = report.method;
  judged.outcome = Outcome::kUnresolved;
  judged.advice = Advice::kLooserTolerance;
  judged.message = fmt::format(
      "A metric was found, but its largest edge curvature {:.3g} is above the tolerance {:.3g}: "
      "rounding alone leaves some 1e-15 to 1e-14.",
      judged.max_curvature, options.tolerance);
  return judged;
}

/// Whether angle structures decide, and can be decided exactly.
bool is_decidable(const topology::Triangulation& triangulation, const SolveOptions& options) {
  const auto links = topology::orbifold_links(triangulation, options.cone_angles);
  return std::ranges::all_of(options.cone_angles, &topology::ConeAngle::is_rational) &&
         std::ranges::none_of(
             links, [](const auto& link) { return link.kind == topology::VertexKind::kFinite; });
}

/// Whether nothing is asked for but the outcome, by the method that decides it in any case.
bool asks_for_outcome_only(const SolveOptions& options) {
  return (options.method == "auto" || options.method == "newton") &&
         options.initial_lengths.empty() && options.initial_length == 0 &&
         options.tolerance <= tolerance::kMaxCurvature && options.max_iterations == 0 &&
         !options.history && !options.on_iteration && !options.angle_structure;
}

/// The answer by a certificate where there is no minimiser; the numbers are those of `report`.
Report without_minimiser(const topology::Triangulation& triangulation, const SolveOptions& options,
                         detail::SmallDecision decided, Report report) {
  report.outcome = Outcome::kUnresolved;
  report.advice = Advice::kRetriangulate;
  report.message = "No metric was found; whether there is one is decided where evidence is wanted.";
  if (!options.evidence) return report;
  if (const CheckResult valid = check(triangulation, *decided.certificate); !valid)
    throw InternalError("a proof about angle structures does not pass its check: " + valid.reason);
  report.outcome = Outcome::kInfeasible;
  report.message = certificate_message(*decided.certificate);
  report.certificate = std::move(decided.certificate);
  return report;
}

/// The answer where a few steps find a metric, or an exact decision follows that there is none and
/// no minimiser either. Most triangulations without metric send Newton's method to infinity, which
/// takes long to be seen; the decision takes microseconds. Nothing: look further.
std::optional<Report> quick_outcome(const topology::Triangulation& triangulation,
                                    const SolveOptions& options) {
  if (triangulation.tetrahedron_count() > detail::SmallProgramme::kMostTetrahedra ||
      !asks_for_outcome_only(options))
    return std::nullopt;
  if (detail::has_low_valence(triangulation)) {
    auto decided = detail::decide_small(triangulation, options.cone_angles);
    if (!decided || !decided->certificate || decided->may_be_degenerate) return std::nullopt;
    energies::CoVolume energy(triangulation);
    Report report = report_at(triangulation, energy, starting_lengths(triangulation, options));
    report.method = "newton";
    report.termination = solver::Termination::kUnbounded;
    return without_minimiser(triangulation, options, *std::move(decided), std::move(report));
  }
  SolveOptions few = options;
  few.max_iterations = kFewSteps;
  Report report = judged_run(triangulation, few);
  // At the limit of steps it may be a metric without all the digits that the method would reach.
  if (report.outcome == Outcome::kGeometric) {
    if (report.iterations >= kFewSteps) return std::nullopt;
    return report;
  }
  if (report.termination == solver::Termination::kTimeLimit ||
      report.termination == solver::Termination::kInterrupted)
    return std::nullopt;
  auto decided = detail::decide_small(triangulation, options.cone_angles);
  if (!decided || !decided->certificate || decided->may_be_degenerate) return std::nullopt;
  return without_minimiser(triangulation, options, *std::move(decided), std::move(report));
}

Report find_outcome(const topology::Triangulation& triangulation, const SolveOptions& options,
                    Clock::time_point start) {
  if (auto quick = quick_outcome(triangulation, options)) return *std::move(quick);
  Report report = judged_run(triangulation, options);
  if (report.outcome != Outcome::kGeometric && was_cut_short(report, options)) {
    report.advice = Advice::kMoreTime;
    return report;
  }
  if (report.outcome != Outcome::kGeometric) {
    if (auto found = metric_above_tolerance(triangulation, options, report)) return *found;
  }
  if (report.outcome != Outcome::kGeometric) {
    report = settling_run(triangulation, options, std::move(report));
    if (report.outcome != Outcome::kGeometric && was_cut_short(report, options)) {
      report.advice = Advice::kMoreTime;
      return report;
    }
  }
  if (!options.evidence || !is_decidable(triangulation, options)) return report;
  if (report.outcome != Outcome::kGeometric)
    return settle(triangulation, options, start, std::move(report));
  if (options.angle_structure) {
    Existence found = existence(triangulation, options.cone_angles);
    if (auto* strict = std::get_if<StrictAngles>(&found)) report.strict_angles = std::move(*strict);
  }
  return report;
}

/// What the triangulation shows about its manifold, beside the outcome, where it carries no metric.
void look_at_manifold(const topology::Triangulation& triangulation, const SolveOptions& options,
                      Report& report) {
  if (report.outcome == Outcome::kGeometric || !options.evidence ||
      !topology::all_full(options.cone_angles))
    return;
  report.closed_bigon = closed_bigon(triangulation);
  if (!report.closed_bigon || !report.closed_bigon->decides()) return;
  const std::string_view open_end = "; its manifold may.";
  if (report.message.ends_with(open_end))
    report.message.replace(report.message.size() - open_end.size(), open_end.size(), ".");
  report.message += " " + message(*report.closed_bigon);
  if (report.advice == Advice::kRetriangulate) report.advice = Advice::kNone;
}

}  // namespace

Report solve(const topology::Triangulation& triangulation, const SolveOptions& options) {
  const Clock::time_point start = Clock::now();
  require_options(options);
  topology::require_solvable(triangulation, options.cone_angles);
  Report report = find_outcome(triangulation, options, start);
  look_at_manifold(triangulation, options, report);
  report.seconds = seconds_since(start);
  return report;
}

}  // namespace tripus::structure
