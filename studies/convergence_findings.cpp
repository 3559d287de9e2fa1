#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "studies/detail/statistics.hpp"
#include "studies/detail/tables.hpp"

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

/// Largest |value / theory - 1|.
double worst_deviation(const Table& table, const char* column, double theory = 1) {
  double worst = 0;
  for (const double value : finite_sorted(table.numbers(column)))
    worst = std::max(worst, std::fabs(value / theory - 1));
  return worst;
}

Figure history_figure(const std::vector<Table>& tables) {
  const Table& rows = tables[kIterations];
  const std::string input = rows.size() == 0 ? std::string() : rows.text(0, "input");
  Figure figure;
  figure.name = "history";
  figure.title = "Curvature along the iterations, " + input;
  figure.caption =
      "max|K| after every step, from the start that the methods in lengths share (those in angles "
      "have one of their own). On these axes a method that gains the same number of digits in "
      "every "
      "step bends down, and one that doubles them drops like a stone. Rounding is at some 1e-15.";
  figure.x = {"iteration + 1", true, std::nan(""), std::nan(""), {}};
  figure.y = {"max|K| (radians)", true, std::nan(""), std::nan(""), {}};
  for (std::size_t k = 0; k < std::size(kShown); ++k) {
    Series series{kShown[k], Mark::kLine, {}, {}, int(k)};
    for (std::size_t r = 0; r < rows.size(); ++r)
      if (rows.is(r, "input", input) && rows.is(r, "method", kShown[k]))
        series.points.push_back(
            {rows.number(r, "iteration") + 1, std::max(1e-16, rows.number(r, "max_curvature"))});
    if (series.points.size() <= 20) series.mark = Mark::kLineAndPoint;  // one point is no line
    if (!series.points.empty()) figure.series.push_back(series);
  }
  return figure;
}

Figure iterations_figure(const Table& runs) {
  Figure figure;
  figure.name = "iterations";
  figure.title = "Iterations to reach a curvature, median over the inputs";
  figure.caption =
      "Marks of a row that lie close together: the last digits cost little. Marks at equal "
      "distances "
      "in steps: every digit costs the same. A missing mark: most runs did not get there.";
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
  const double worst[] = {worst_deviation(theory, "newton_order", 2),
                          worst_deviation(theory, "euler_ratio"),
                          worst_deviation(theory, "decay_ratio")};
  figure.caption = fmt::format(
      "Every mark is one triangulation. Theory gives 1 for all three ratios; the dashed lines are "
      "at "
      "1 % from it. The largest deviations are {:.2g} % for the order, {:.2g} % for the Euler "
      "limit "
      "and {:.2g} % for the decay rate.",
      100 * worst[0], 100 * worst[1], 100 * worst[2]);
  figure.x = {"condition number lambda_max / lambda_min of the Hessian",
              true,
              std::nan(""),
              std::nan(""),
              {}};
  const double reach = std::max(0.02, 1.1 * std::max({worst[0], worst[1], worst[2]}));
  figure.y = {"measured / theory", false, 1 - reach, 1 + reach, {}};
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

/// What a decimal digit of max|K| costs, by method: a mark at the median, and the quarters.
Figure cost_figure(const Table& runs, const char* name, const char* column, double unit,
                   const char* title, const char* label) {
  Figure figure;
  figure.name = name;
  figure.title = title;
  figure.x = {label, true, std::nan(""), std::nan(""), {}};
  figure.y.categories = methods(runs);
  std::reverse(figure.y.categories.begin(), figure.y.categories.end());
  const std::pair<const char*, double> parts[] = {
      {"lower quarter", 0.25}, {"median", 0.5}, {"upper quarter", 0.75}};
  std::pair<double, std::string> cheapest{INFINITY, ""}, dearest{0, ""};
  for (const auto& [part_label, part] : parts) {
    Series series{part_label, Mark::kPoint, {}, {}, -1};
    for (std::size_t k = 0; k < figure.y.categories.size(); ++k) {
      const std::string& method = figure.y.categories[k];
      const double value = unit * quantile(values_of(runs, method, column), part);
      if (!std::isfinite(value)) continue;
      series.points.push_back({value, double(k)});
      if (part != 0.5) continue;
      cheapest = std::min(cheapest, {value, method});
      dearest = std::max(dearest, {value, method});
    }
    figure.series.push_back(series);
  }
  figure.caption = fmt::format(
      "Over the inputs, from the first to the last iterate of a run. The least median is {:.3g} "
      "({}), the greatest {:.3g} ({}).",
      cheapest.first, cheapest.second, dearest.first, dearest.second);
  return figure;
}

/// The exponent a of value = const T^a over the covers of the first input with 10 tetrahedra or
/// more; NaN if there are fewer than two.
double growth_exponent(const Table& runs, const char* method, const char* column) {
  std::vector<double> size, value;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const double v = runs.number(r, column);
    if (!runs.is(r, "method", method) || runs.is(r, "degree", "1") || !(v > 0)) continue;
    if (runs.number(r, "tetrahedra") < 10) continue;
    size.push_back(std::log(runs.number(r, "tetrahedra")));
    value.push_back(std::log(v));
  }
  return slope(size, value);
}

Figure growth_figure(const Table& runs, const char* name, const char* column, const char* title,
                     const char* label) {
  Figure figure;
  figure.name = name;
  figure.title = title;
  figure.x.label = "tetrahedra T of the cover";
  figure.y.label = label;
  figure.x.log = figure.y.log = true;
  std::string growth;
  for (std::size_t k = 0; k < std::size(kShown); ++k) {
    Series series{kShown[k], Mark::kLineAndPoint, {}, {}, int(k)};
    // The first input and its covers; other inputs follow it with degree 1.
    for (std::size_t r = 0; r < runs.size(); ++r)
      if (runs.is(r, "method", kShown[k]) &&
          (!runs.is(r, "degree", "1") || runs.text(r, "input") == runs.text(0, "input")))
        series.points.push_back({runs.number(r, "tetrahedra"), runs.number(r, column)});
    const bool any = std::any_of(series.points.begin(), series.points.end(),
                                 [](const auto& point) { return point[1] > 0; });
    if (!any) continue;
    figure.series.push_back(series);
    growth += fmt::format("{}{} T^{:.2f}", growth.empty() ? "" : ", ", kShown[k],
                          growth_exponent(runs, kShown[k], column));
  }
  figure.caption = fmt::format(
      "The first input and its cyclic covers, each from random lengths. Both axes are logarithmic: "
      "a "
      "slope of 1 is growth in proportion to T, a level line none. Fitted to the covers with 10 "
      "tetrahedra or more: {}.",
      growth);
  return figure;
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
  const std::vector<double> order = theory.numbers("newton_order");
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
      {"newton_cg_time_exponent", growth_exponent(runs, "newton-cg", "seconds_to_1e_8"),
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
      "dopri5 {:.0f}. A decimal digit costs {:.2f} and {:.1f} evaluations of the gradient, {:.2g} "
      "and "
      "{:.2g} microseconds.",
      newton, flow, at("newton", "evaluations_per_digit"),
      at("flow:curvature/dopri5", "evaluations_per_digit"), 1e6 * at("newton", "seconds_per_digit"),
      1e6 * at("flow:curvature/dopri5", "seconds_per_digit"));
}

/// What has to hold, what was measured, and whether it does.
struct Law {
  const char* statement;
  double bound;
  double measured;
  bool holds;
};

std::vector<Law> laws(const std::vector<Fact>& facts, bool covers) {
  const auto at_most = [&](const char* statement, double bound, const char* name) {
    return Law{statement, bound, fact(facts, name), fact(facts, name) <= bound};
  };
  const double order = fact(facts, "newton_order_least");
  std::vector<Law> result = {
      {"least measured order of Newton's method is at least the bound", 1.9, order, order >= 1.9},
      at_most("Euler limit / (2 / lambda_max) is 1 within the bound", 0.01, "euler_deviation"),
      at_most("decay rate / lambda_min is 1 within the bound", 0.02, "decay_deviation"),
      at_most("flows along which sum K^2 increases", 0, "flows_not_decreasing")};
  if (covers)
    result.push_back(at_most("volume of a cover / (degree x volume) is 1 within the bound", 1e-13,
                             "cover_volume_error"));
  return result;
}

Table law_table(const std::vector<Law>& laws) {
  Table table({"laws",
               "What theory demands of the measurements.",
               {{"law", "", "the demand"},
                {"bound", "", "in it"},
                {"measured", "", "the worst over all triangulations"},
                {"holds", "", "yes or no"}}});
  for (const Law& law : laws) table.add(cells(law.statement, law.bound, law.measured, law.holds));
  return table;
}

/// How well two numbers agree, for a sentence.
std::string within(double error) {
  return error > 0 ? fmt::format("within {:.1e}", error) : "to the last digit of a double";
}

}  // namespace

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
      covers ? fmt::format(
                   " The volume of every cover, up to {:.0f} tetrahedra, is its degree times that "
                   "of the base, {}.",
                   greatest(tables[kTheory].numbers("tetrahedra")),
                   within(value("cover_volume_error")))
             : std::string());
  const std::vector<Law> demands = laws(findings.facts, covers);
  const auto broken = std::ranges::count(demands, false, &Law::holds);
  findings.facts.push_back({"laws_broken", double(broken), "demands of theory that do not hold"});
  findings.paragraph +=
      broken == 0 ? fmt::format(" All {} demands of theory (laws.csv) hold.", demands.size())
                  : fmt::format(" {} of the {} demands of theory (laws.csv) do not hold.", broken,
                                demands.size());
  findings.tables = {law_table(demands)};
  findings.figures = {history_figure(tables), iterations_figure(runs),
                      theory_figure(tables[kTheory]),
                      cost_figure(runs, "evaluations-per-digit", "evaluations_per_digit", 1,
                                  "Cost of a decimal digit of max|K| in evaluations",
                                  "evaluations of the gradient a decimal digit"),
                      cost_figure(runs, "seconds-per-digit", "seconds_per_digit", 1e6,
                                  "Cost of a decimal digit of max|K| in time",
                                  "microseconds a decimal digit (this machine)")};
  if (covers) {
    findings.figures.push_back(growth_figure(runs, "cover-iterations", "iterations_to_1e_8",
                                             "Iterations on covers of growing size",
                                             "iterations to max|K| <= 1e-8"));
    findings.figures.push_back(growth_figure(runs, "cover-seconds", "seconds_to_1e_8",
                                             "Time on covers of growing size",
                                             "seconds to max|K| <= 1e-8 (this machine)"));
  }
  return findings;
}

}  // namespace tripus::studies::detail
