#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "studies/detail/convergence_tables.hpp"
#include "studies/detail/statistics.hpp"

namespace tripus::studies::detail {
namespace {

/// Drawn one by one: as many as there are colours.
const char* const kShown[] = {"newton",
                              "newton-cg",
                              "ceres-lbfgs",
                              "ceres-steepest-descent",
                              "angles:newton",
                              "flow:curvature/euler",
                              "flow:curvature/dopri5"};

/// Methods in the order of the table.
std::vector<std::string> methods(const Table& runs) {
  std::vector<std::string> names;
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (std::find(names.begin(), names.end(), runs.text(r, "method")) == names.end())
      names.push_back(runs.text(r, "method"));
  return names;
}

/// The values of a column over the runs of a method on the inputs themselves (not their covers).
std::vector<double> values_of(const Table& runs, const std::string& method, const char* column) {
  std::vector<double> values;
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (runs.is(r, "method", method) && runs.is(r, "degree", "1"))
      values.push_back(runs.number(r, column));
  return values;
}

Figure history_figure(const std::vector<Table>& tables) {
  const Table& rows = tables[kIterations];
  const std::string input = rows.size() == 0 ? std::string() : rows.text(0, "input");
  Figure figure;
  figure.name = "history";
  figure.title = "Curvature along the iterations, " + input;
  figure.caption =
      "Newton's method falls off a cliff: the digits double at every step. First-order methods "
      "and flows gain digits at a steady rate, which is a straight line against the number of "
      "steps and bends down here, where that number is on a logarithmic axis.";
  figure.x = {"iteration + 1", true, std::nan(""), std::nan(""), {}};
  figure.y = {"max|K| (radians)", true, std::nan(""), std::nan(""), {}};
  for (std::size_t k = 0; k < std::size(kShown); ++k) {
    Series series{kShown[k], Mark::kLine, {}, {}, int(k)};
    for (std::size_t r = 0; r < rows.size(); ++r)
      if (rows.is(r, "input", input) && rows.is(r, "method", kShown[k]))
        series.points.push_back(
            {rows.number(r, "iteration") + 1, std::max(1e-16, rows.number(r, "max_curvature"))});
    if (!series.points.empty()) figure.series.push_back(series);
  }
  return figure;
}

Figure iterations_figure(const Table& runs) {
  Figure figure;
  figure.name = "iterations";
  figure.title = "Iterations to reach a curvature, median over the inputs";
  figure.caption =
      "Second-order methods need a handful of steps, and hardly more for twelve digits than for "
      "four. Flows and first-order methods pay in proportion to the digits. A missing mark: most "
      "runs did not get there.";
  figure.x = {"iterations (a run that starts there counts as 1)", true, 0.8, std::nan(""), {}};
  figure.y.categories = methods(runs);
  std::reverse(figure.y.categories.begin(), figure.y.categories.end());
  const std::pair<const char*, const char*> levels[] = {{"max|K| <= 1e-4", "iterations_to_1e_4"},
                                                        {"max|K| <= 1e-8", "iterations_to_1e_8"},
                                                        {"max|K| <= 1e-12", "iterations_to_1e_12"}};
  for (const auto& [label, column] : levels) {
    Series series{label, Mark::kPoint, {}, {}, -1};
    for (std::size_t k = 0; k < figure.y.categories.size(); ++k) {
      const std::vector<double> all = values_of(runs, figure.y.categories[k], column);
      if (2 * finite_sorted(all).size() > all.size())
        series.points.push_back({std::max(1.0, median(all)), double(k)});
    }
    figure.series.push_back(series);
  }
  return figure;
}

Figure theory_figure(const Table& theory) {
  Figure figure;
  figure.name = "theory";
  figure.title = "Measured against theory";
  figure.caption =
      "Every mark is one triangulation. The order of Newton's method is 2, the longest stable "
      "Euler step 2/lambda_max, the decay rate of the flow lambda_min: all ratios are 1 as far as "
      "the measurement goes. The dashed lines are at 1 % from it.";
  figure.x = {"condition number lambda_max / lambda_min of the Hessian",
              true,
              std::nan(""),
              std::nan(""),
              {}};
  figure.y = {"measured / theory", false, 0.94, 1.06, {}};
  Series order{"order of Newton's method / 2", Mark::kPoint, {}, {}, 0};
  Series euler{"Euler limit / (2 / lambda_max)", Mark::kPoint, {}, {}, 1};
  Series decay{"decay rate / lambda_min", Mark::kPoint, {}, {}, 2};
  for (std::size_t r = 0; r < theory.size(); ++r) {
    const double condition = theory.number(r, "lambda_max") / theory.number(r, "lambda_min");
    order.points.push_back({condition, theory.number(r, "newton_order") / 2});
    euler.points.push_back({condition, theory.number(r, "euler_ratio")});
    decay.points.push_back({condition, theory.number(r, "decay_ratio")});
  }
  figure.series = {order, euler, decay};
  figure.guides = {{false, 1.01, ""}, {false, 0.99, ""}};
  return figure;
}

Figure growth_figure(const Table& runs, const char* name, const char* column, const char* title,
                     const char* label, const char* caption) {
  Figure figure;
  figure.name = name;
  figure.title = title;
  figure.caption = caption;
  figure.x.label = "tetrahedra T of the cover";
  figure.y.label = label;
  figure.x.log = figure.y.log = true;
  for (std::size_t k = 0; k < std::size(kShown); ++k) {
    Series series{kShown[k], Mark::kLineAndPoint, {}, {}, int(k)};
    // The first input and its covers; other inputs follow it with degree 1.
    for (std::size_t r = 0; r < runs.size(); ++r)
      if (runs.is(r, "method", kShown[k]) &&
          (!runs.is(r, "degree", "1") || runs.text(r, "input") == runs.text(0, "input")))
        series.points.push_back({runs.number(r, "tetrahedra"), runs.number(r, column)});
    const bool any = std::any_of(series.points.begin(), series.points.end(),
                                 [](const auto& point) { return point[1] > 0; });
    if (any) figure.series.push_back(series);
  }
  return figure;
}

/// The exponent a of seconds = const T^a over the covers of the first input with 10 tetrahedra or
/// more; NaN if there are fewer than two.
double time_exponent(const Table& runs, const char* method) {
  std::vector<double> size, time;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const double seconds = runs.number(r, "seconds_to_1e_8");
    if (!runs.is(r, "method", method) || runs.is(r, "degree", "1") || !(seconds > 0)) continue;
    if (runs.number(r, "tetrahedra") < 10) continue;
    size.push_back(std::log(runs.number(r, "tetrahedra")));
    time.push_back(std::log(seconds));
  }
  return slope(size, time);
}

/// " (all but 5 of ceres-lm, 3 of ...)", or nothing.
std::string failures(const Table& runs) {
  std::map<std::string, int> counts;
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (!runs.is(r, "outcome", "geometric")) ++counts[runs.text(r, "method")];
  std::string text;
  for (const auto& [method, count] : counts)
    text += fmt::format("{}{} of {}", text.empty() ? " (all but " : ", ", count, method);
  return text.empty() ? text : text + ")";
}

bool has_covers(const Table& runs) {
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (!runs.is(r, "degree", "1")) return true;
  return false;
}

std::vector<double> column_of(const Table& table, const char* column) {
  std::vector<double> values;
  for (std::size_t r = 0; r < table.size(); ++r) values.push_back(table.number(r, column));
  return values;
}

double worst_deviation(const Table& table, const char* column) {
  double worst = 0;
  for (const double value : finite_sorted(column_of(table, column)))
    worst = std::max(worst, std::fabs(value - 1));
  return worst;
}

std::vector<Fact> facts(const std::vector<Table>& tables) {
  const Table& runs = tables[kRuns];
  const Table& theory = tables[kTheory];
  std::size_t solved = 0, increasing = 0, not_monotone = 0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    solved += runs.is(r, "outcome", "geometric");
    increasing += runs.text(r, "method").starts_with("flow:curvature/") &&
                  runs.is(r, "squares_decrease", "no");
  }
  double cover_error = 0;
  for (std::size_t r = 0; r < theory.size(); ++r) {
    not_monotone += theory.is(r, "squares_decrease", "no");
    if (!theory.is(r, "degree", "1"))
      cover_error = std::max(cover_error, std::fabs(theory.number(r, "volume_error")));
  }
  const std::vector<double> order = column_of(theory, "newton_order");
  return {
      {"triangulations", double(theory.size()), "triangulations, covers included"},
      {"runs", double(runs.size()), "runs of a method on a triangulation"},
      {"runs_geometric", double(solved), "of them ended in the metric to max|K| <= 1e-12"},
      {"newton_order_least", least(order), "least measured order of Newton's method"},
      {"newton_order_median", median(order), "median order of Newton's method"},
      {"euler_deviation", worst_deviation(theory, "euler_ratio"),
       "largest relative deviation of the Euler limit from 2/lambda_max"},
      {"decay_deviation", worst_deviation(theory, "decay_ratio"),
       "largest relative deviation of the decay rate from lambda_min"},
      {"flows_not_decreasing", double(not_monotone),
       "accurately followed flows along which sum K^2 increased"},
      {"curvature_runs_not_decreasing", double(increasing),
       "runs of the curvature flow's steppers along which sum K^2 increased"},
      {"cover_volume_error", cover_error,
       "largest relative deviation of a cover's volume from degree times the base's"},
      {"newton_cg_time_exponent", time_exponent(runs, "newton-cg"),
       "a, where the time of newton-cg on covers grows like T^a (timing)"},
  };
}

double fact(const std::vector<Fact>& facts, const char* name) {
  for (const Fact& f : facts)
    if (f.name == name) return f.value;
  return std::nan("");
}

std::string newton_against_flow(const Table& runs) {
  const auto at = [&](const char* method, const char* column) {
    return median(values_of(runs, method, column));
  };
  const double flow = at("flow:curvature/dopri5", "iterations_to_1e_8");
  const double newton = at("newton", "iterations_to_1e_8");
  if (!std::isfinite(flow) || !std::isfinite(newton)) return {};
  return fmt::format(
      " To max|K| <= 1e-8 Newton's method takes {:.0f} steps (median), the curvature flow by "
      "dopri5 {:.0f}; evaluations of the gradient a decimal digit: {:.2f} and {:.1f}.",
      newton, flow, at("newton", "evaluations_per_digit"),
      at("flow:curvature/dopri5", "evaluations_per_digit"));
}

}  // namespace

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
        {"seconds", "seconds", "of the whole run", true}}},
      {"iterations",
       "One iterate of a run: every one up to the 100th, then those 2 % apart.",
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
       "What theory says about a triangulation, measured at its metric. Empty above 400 edge "
       "classes.",
       {input,
        degree,
        tetrahedra,
        edges,
        {"outcome", "", "of Newton's method"},
        {"lambda_min", "", "least eigenvalue of the Hessian of H"},
        {"lambda_max", "", "greatest eigenvalue"},
        {"newton_order", "", "slope of log error after a step on log error before it"},
        {"euler_limit", "", "longest stable Euler step, by bisection"},
        {"euler_ratio", "", "euler_limit / (2 / lambda_max)"},
        {"decay_rate", "", "of |K| along dx/dt = K near the metric"},
        {"decay_ratio", "", "decay_rate / lambda_min"},
        {"squares_decrease", "", "whether sum K^2 decreased all along that flow"},
        {"volume_error", "", "volume / (degree x volume of the base) - 1"}}},
  };
}

Findings convergence_findings(const std::vector<Table>& tables) {
  const Table& runs = tables[kRuns];
  Findings findings;
  findings.facts = facts(tables);
  const auto value = [&](const char* name) { return fact(findings.facts, name); };
  const bool covers = has_covers(runs);
  findings.paragraph = fmt::format(
      "{:.0f} of {:.0f} runs on {:.0f} triangulations ended in the metric with max|K| <= "
      "1e-12{}.{} The measured order of Newton's method is {:.3f} in the median and at least "
      "{:.3f}; the longest stable Euler step is 2/lambda_max within {:.2g} %, the decay rate of "
      "the flow lambda_min within {:.2g} %, and sum K^2 decreased along {}.{}",
      value("runs_geometric"), value("runs"), value("triangulations"), failures(runs),
      newton_against_flow(runs), value("newton_order_median"), value("newton_order_least"),
      100 * value("euler_deviation"), 100 * value("decay_deviation"),
      value("flows_not_decreasing") == 0
          ? std::string("every flow")
          : fmt::format("all flows but {:.0f}", value("flows_not_decreasing")),
      covers
          ? fmt::format(" The volume of every cover is its degree times that of the base, within "
                        "{:.1e}.",
                        value("cover_volume_error"))
          : std::string());
  findings.figures = {history_figure(tables), iterations_figure(runs),
                      theory_figure(tables[kTheory])};
  if (covers) {
    findings.figures.push_back(growth_figure(
        runs, "cover-iterations", "iterations_to_1e_8", "Iterations on covers of growing size",
        "iterations to max|K| <= 1e-8",
        "The number of steps hardly grows with the triangulation: the condition of the problem is "
        "that of its tetrahedra. Random lengths on more edges are a start a little farther away."));
    findings.figures.push_back(growth_figure(
        runs, "cover-seconds", "seconds_to_1e_8", "Time on covers of growing size",
        "seconds to max|K| <= 1e-8",
        "Time grows linearly with the number of tetrahedra where the factors of the Hessian do "
        "not fill in. (Timings of this machine.)"));
  }
  return findings;
}

}  // namespace tripus::studies::detail
