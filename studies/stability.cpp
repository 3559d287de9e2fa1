// Which starting lengths converge: the paper's formulae with its explicit flow and with Newton's
// method, in three precisions, and Tripus's kernel with its solvers.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "base/stop.hpp"
#include "geometry/paper_formulae.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "structure/solve.hpp"
#include "studies/detail/algebraic_route.hpp"
#include "studies/detail/method_run.hpp"
#include "studies/detail/paper_route.hpp"
#include "studies/detail/tables.hpp"
#include "studies/detail/theory_measurements.hpp"
#include "studies/detail/thresholds.hpp"

namespace tripus::studies::detail {
namespace {

constexpr double kShortest = 1e-8, kLongest = 1e6;
constexpr int kDecades = 14, kPerDecade = 4;
constexpr int kPaperSteps = 20000;
constexpr double kFlowTolerance = 1e-9;
const char* const kPrecisions[] = {"float", "double", "long double"};

/// An input that carries a metric, with what is known about it.
struct MetricSubject {
  std::string name;
  topology::Triangulation triangulation;
  std::vector<double> lengths;
  double step;  ///< of the paper's flow: half of what is stable at the metric
};

std::shared_ptr<const MetricSubject> make_subject(const StudyInput& input) {
  topology::Triangulation triangulation(input.gluings);
  const structure::Report metric = require_metric(triangulation, input.name);
  const double largest = spectrum(triangulation, metric.edge_lengths).largest;
  return std::make_shared<MetricSubject>(
      MetricSubject{input.name, std::move(triangulation), metric.edge_lengths, 1 / largest});
}

bool near_metric(const MetricSubject& subject, const std::vector<double>& lengths,
                 double distance) {
  for (std::size_t e = 0; e < lengths.size(); ++e)
    if (!(std::fabs(lengths[e] - subject.lengths[e]) <= distance)) return false;
  return true;
}

/// Loosest max|K| that rounding of angles lets a precision reach.
template <class Real>
constexpr Real kTolerance = Real(sizeof(Real) == sizeof(float) ? 1e-4 : kFlowTolerance);

template <class Real>
PaperRun paper_flow(const MetricSubject& subject, const std::vector<double>& start,
                    const Stop& stop) {
  return PaperRoute<Real>(subject.triangulation, stop)
      .flow(std::vector<Real>(start.begin(), start.end()), Real(subject.step), kTolerance<Real>,
            kPaperSteps);
}

template <class Real>
PaperRun paper_newton(const MetricSubject& subject, const std::vector<double>& start,
                      const Stop& stop) {
  return PaperRoute<Real>(subject.triangulation, stop)
      .newton(std::vector<Real>(start.begin(), start.end()), kTolerance<Real>, 200);
}

/// One start, all methods.
class StartRows {
 public:
  StartRows(const MetricSubject& subject, std::string kind, std::size_t number,
            const std::vector<std::string>& methods, const Stop& stop)
      : subject_(subject),
        kind_(std::move(kind)),
        number_(number),
        methods_(methods),
        stop_(stop) {}

  std::vector<Row> operator()(const std::vector<double>& start) {
    add(start, "paper flow, float", paper_flow<float>(subject_, start, stop_), 1e-2);
    add(start, "paper flow, double", paper_flow<double>(subject_, start, stop_), 1e-6);
    add(start, "paper flow, long double", paper_flow<long double>(subject_, start, stop_), 1e-6);
    add(start, "paper Newton, double", paper_newton<double>(subject_, start, stop_), 1e-6);
    add(start, "Tripus solve", solve_from(start), 1e-6);
    for (const std::string& method : methods_) {
      const MethodRun run =
          run_method(subject_.triangulation, method, start, {.tolerance = 1e-11, .stop = stop_});
      const bool found = run.report.outcome == structure::Outcome::kGeometric;
      add(start, "Tripus " + method,
          {found ? "metric" : "no convergence", run.report.iterations, run.report.edge_lengths},
          1e-6);
    }
    return std::move(rows_);
  }

 private:
  /// What a user gets: where the method by itself does not get there from this start, another run
  /// settles the outcome.
  PaperRun solve_from(const std::vector<double>& start) const {
    structure::SolveOptions options;
    options.initial_lengths = start;
    options.stop = stop_;
    const structure::Report report = structure::solve(subject_.triangulation, options);
    const bool found = report.outcome == structure::Outcome::kGeometric;
    return {found ? "metric" : "no convergence", report.iterations, report.edge_lengths};
  }

  void add(const std::vector<double>& start, const std::string& solver, PaperRun run,
           double distance) {
    if (run.outcome == "metric" && !near_metric(subject_, run.lengths, distance))
      run.outcome = "elsewhere";
    const auto [shortest, longest] = std::minmax_element(start.begin(), start.end());
    rows_.push_back({kStarts, cells(subject_.name, kind_, number_, *shortest, *longest, solver,
                                    run.outcome, run.iterations)});
  }

  const MetricSubject& subject_;
  std::string kind_;
  std::size_t number_;
  const std::vector<std::string>& methods_;
  Stop stop_;
  std::vector<Row> rows_;
};

double log_uniform(Random& random, double lower, double upper) {
  return std::pow(10.0, random.uniform(std::log10(lower), std::log10(upper)));
}

/// Half of the starts have lengths anywhere in the range, half within a decade of each other.
std::vector<double> random_start(Random random, std::size_t edges, bool close) {
  std::vector<double> start(edges);
  double lower = kShortest, upper = kLongest;
  if (close) {
    lower = log_uniform(random, kShortest, kLongest / 10);
    upper = 10 * lower;
  }
  for (double& length : start) length = log_uniform(random, lower, upper);
  return start;
}

std::vector<Row> threshold_rows(const std::string& precision) {
  std::vector<Row> rows;
  for (const Threshold& t : thresholds(precision))
    rows.push_back(
        {kThresholds, cells(t.precision, t.digits, t.event, t.length, t.predicted, t.meaning)});
  return rows;
}

/// Errors of the regular tetrahedron's angle over the whole range.
std::vector<Row> angle_rows(const std::string& kernel) {
  std::vector<Row> rows;
  for (int k = 0; k <= 20 * kDecades; ++k) {
    const double length = kShortest * std::pow(10.0, k / 20.0);
    const long double exact = exact_regular_angle(length);
    long double angle = 0;
    if (kernel == "Tripus") {
      const std::array<double, 6> l{length, length, length, length, length, length};
      std::array<double, 6> theta{};
      geometry::dihedral_angles(l, theta);
      angle = theta[0];
    } else {
      angle = paper_regular_angle(kernel, length);
    }
    rows.push_back(
        {kAngles, cells(kernel, length, double(angle), double(std::fabs(angle - exact) / exact))});
  }
  return rows;
}

/// Lengths of a tetrahedron without symmetry whose edges are all about L long.
std::array<double, 6> irregular_lengths(double L, Random& random) {
  std::array<double, 6> l;
  for (double& x : l)
    x = L > 1 ? L + random.uniform(-0.3, 0.3) : L * (1 + random.uniform(-0.3, 0.3));
  return l;
}

template <class Real>
std::array<double, 6> paper_angles(const std::array<double, 6>& lengths) {
  Real l[6], theta[6];
  std::copy(lengths.begin(), lengths.end(), l);
  std::array<double, 6> result;
  if (!geometry::paper_dihedral_angles(l, theta))
    result.fill(std::nan(""));
  else
    std::copy(theta, theta + 6, result.begin());
  return result;
}

/// What rounding the lengths to the nearest double may do to the angles, relatively.
double effect_of_rounding(const std::array<double, 6>& l) {
  std::array<double, 6> theta;
  std::array<double, 36> J;
  geometry::dihedral_angles(l, theta, J);
  double worst = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < 6; ++j) sum += std::fabs(J[6 * i + j]) * l[j];
    worst = std::max(worst, sum / theta[i]);
  }
  return worst * std::numeric_limits<double>::epsilon() / 2;
}

/// Errors of the angles of irregular tetrahedra of one size: the largest of all angles.
std::vector<Row> irregular_rows(int k, std::uint64_t seed) {
  constexpr int kSamples = 10;
  const double L = kShortest * std::pow(10.0, double(k) / kPerDecade);
  Random random(item_seed(seed, fmt::format("irregular {}", k)));
  double worst[5] = {};  // float, double, long double, Tripus; rounding
  for (int n = 0; n < kSamples; ++n) {
    const std::array<double, 6> l = irregular_lengths(L, random);
    const auto exact = dihedral_angles_in_60_digits(l);
    if (!exact) continue;
    std::array<double, 6> tripus;
    geometry::dihedral_angles(l, tripus);
    const std::array<double, 6> angles[4] = {paper_angles<float>(l), paper_angles<double>(l),
                                             paper_angles<long double>(l), tripus};
    for (std::size_t kernel = 0; kernel < 4; ++kernel) {
      for (std::size_t i = 0; i < 6; ++i) {
        const double error = std::fabs(angles[kernel][i] - (*exact)[i]) / (*exact)[i];
        worst[kernel] = error <= worst[kernel] ? worst[kernel] : error;  // not a number stays
      }
    }
    worst[4] = std::max(worst[4], effect_of_rounding(l));
  }
  return {{kIrregular, cells(L, worst[0], worst[1], worst[2], worst[3], worst[4])}};
}

/// The longest equal lengths from which the paper's flow reaches the metric.
template <class Real>
double flow_threshold(const MetricSubject& subject, const Stop& stop) {
  const auto reaches = [&](double length) {
    const std::vector<double> start(subject.lengths.size(), length);
    return paper_flow<Real>(subject, start, stop).outcome == "metric";
  };
  const double base = subject.lengths.front();
  if (!reaches(base)) return std::numeric_limits<double>::quiet_NaN();
  if (reaches(kLongest)) return kLongest;
  return bisect(base, 200, reaches);
}

std::vector<Row> flow_threshold_rows(const MetricSubject& subject, const Stop& stop) {
  const double found[] = {flow_threshold<float>(subject, stop),
                          flow_threshold<double>(subject, stop),
                          flow_threshold<long double>(subject, stop)};
  std::vector<Row> rows;
  for (int k = 0; k < 3; ++k)
    rows.push_back({kFlowThresholds, cells(subject.name, kPrecisions[k], subject.step, found[k])});
  return rows;
}

std::vector<TableLayout> layouts() {
  return {
      {"thresholds",
       "Where the paper's formulae lose a regular tetrahedron of edge length L, and to which "
       "rounding.",
       {{"precision", "", "floating-point type"},
        {"bits", "", "p, bits of its significand"},
        {"event", "", "what happens from that length on (up to it, for angle zero)"},
        {"length", "", "L, by bisection to the last digit"},
        {"predicted_length", "", "L as the analysis says; for angle zero its order of magnitude"},
        {"meaning", "", "the rounding"}}},
      {"angles",
       "Dihedral angle of the regular tetrahedron by four kernels against the closed form in long "
       "double.",
       {{"kernel", "", "the paper's formulae in a precision, or Tripus (double)"},
        {"length", "", "L"},
        {"angle", "radians", "as the kernel gives it; empty where it is not a number"},
        {"relative_error", "", "|angle - exact| / exact"}}},
      {"starts",
       "One run of one solver from one start.",
       {{"input", "", "the triangulation"},
        {"start", "", "uniform, random within a decade, or random over the whole range"},
        {"number", "", "of the start"},
        {"shortest", "", "least starting length"},
        {"longest", "", "greatest starting length"},
        {"solver", "",
         "the paper's flow or Newton's method on its formulae, tripus solve, or a method of Tripus "
         "by itself"},
        {"outcome", "", "metric, not a number, length not positive, no convergence, elsewhere"},
        {"iterations", "", "steps taken"}}},
      {"irregular_angles",
       "Dihedral angles of ten irregular tetrahedra with edges of about one length, against 60 "
       "digits: the largest relative error of an angle, as a double.",
       {{"length", "", "L; the edges lie within 30 % of it, and within 0.3 if L > 1"},
        {"float", "", "error of the paper's formulae; empty where an angle is not a number"},
        {"double", "", "the same"},
        {"long_double", "", "the same"},
        {"tripus", "", "error of Tripus's kernel"},
        {"rounding", "", "what rounding the lengths to doubles may do to an angle, relatively"}}},
      {"flow_thresholds",
       "Longest equal starting lengths from which the paper's explicit flow reaches the metric.",
       {{"input", "", "the triangulation"},
        {"precision", "", "floating-point type"},
        {"step", "", "length of a step in flow time: half the stability limit at the metric"},
        {"length", "", "by bisection to the last digit"}}},
  };
}

void add_start_items(Plan& plan, const std::shared_ptr<const MetricSubject>& subject,
                     const StudyOptions& options,
                     const std::shared_ptr<const std::vector<std::string>>& methods) {
  for (std::size_t k = 0; k <= kDecades * kPerDecade; ++k) {
    plan.items.push_back({fmt::format("{} uniform {}", subject->name, k), [=](const Stop& stop) {
                            const double length =
                                kShortest * std::pow(10.0, double(k) / kPerDecade);
                            return StartRows(*subject, "uniform", k, *methods, stop)(
                                std::vector<double>(subject->lengths.size(), length));
                          }});
  }
  for (std::size_t k = 0; k < options.samples; ++k) {
    const std::string id = fmt::format("{} random {}", subject->name, k);
    const Random random(item_seed(options.seed, id));
    plan.items.push_back({id, [=](const Stop& stop) {
                            const bool close = k % 2 == 0;
                            return StartRows(
                                *subject, close ? "random decade" : "random range", k, *methods,
                                stop)(random_start(random, subject->lengths.size(), close));
                          }});
  }
}

}  // namespace

Plan plan_stability(const StudyOptions& options) {
  Plan plan;
  plan.tables = layouts();
  for (const char* precision : kPrecisions)
    plan.items.push_back({fmt::format("thresholds {}", precision),
                          [=](const Stop&) { return threshold_rows(precision); }});
  for (const char* kernel : {"float", "double", "long double", "Tripus"})
    plan.items.push_back(
        {fmt::format("angles {}", kernel), [=](const Stop&) { return angle_rows(kernel); }});
  for (int k = 0; k <= kDecades * kPerDecade; ++k)
    plan.items.push_back({fmt::format("irregular {}", k), [=, seed = options.seed](const Stop&) {
                            return irregular_rows(k, seed);
                          }});
  const auto methods = std::make_shared<const std::vector<std::string>>(
      options.methods.empty()
          ? std::vector<std::string>{"newton", "newton-cg", "flow:curvature/dopri5",
                                     "flow:newton-flow/dopri5"}
          : options.methods);
  for (const StudyInput& input : options.inputs) {
    if (options.stop.requested()) return {};
    const auto subject = make_subject(input);
    plan.items.push_back({fmt::format("{} flow thresholds", subject->name),
                          [=](const Stop& stop) { return flow_threshold_rows(*subject, stop); }});
    add_start_items(plan, subject, options, methods);
  }
  plan.conclude = stability_findings;
  return plan;
}

}  // namespace tripus::studies::detail
