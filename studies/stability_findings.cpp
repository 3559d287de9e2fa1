#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "studies/detail/tables.hpp"

namespace tripus::studies::detail {
namespace {

const char* const kOutcomes[] = {"metric", "not a number", "length not positive", "no convergence",
                                 "elsewhere"};

/// Inputs whose outcomes are drawn.
constexpr std::size_t kMaps = 6;

double threshold(const Table& table, const char* precision, const char* event, const char* column) {
  for (std::size_t r = 0; r < table.size(); ++r)
    if (table.is(r, "precision", precision) && table.is(r, "event", event))
      return table.number(r, column);
  return std::nan("");
}

/// Largest relative error of Tripus's kernel.
double worst_error(const Table& angles) {
  double worst = 0;
  for (std::size_t r = 0; r < angles.size(); ++r)
    if (angles.is(r, "kernel", "Tripus"))
      worst = std::max(worst, angles.number(r, "relative_error"));
  return worst;
}

/// Largest distance of a measured breakdown from the predicted one.
double worst_distance(const Table& table) {
  double worst = 0;
  for (std::size_t r = 0; r < table.size(); ++r)
    if (table.is(r, "event", "angle not a number"))
      worst = std::max(worst,
                       std::fabs(table.number(r, "length") - table.number(r, "predicted_length")));
  return worst;
}

/// Largest ratio of the kernel's error on irregular tetrahedra to what rounding their lengths does.
double worst_ratio(const Table& irregular) {
  double worst = 0;
  for (std::size_t r = 0; r < irregular.size(); ++r)
    worst = std::fmax(worst, irregular.number(r, "tripus") / irregular.number(r, "rounding"));
  return worst;
}

Figure irregular_figure(const Table& table) {
  Figure figure;
  figure.name = "irregular-angle-error";
  figure.title = "Dihedral angles of irregular tetrahedra: error against 60 digits";
  figure.caption = fmt::format(
      "The largest error of an angle among ten tetrahedra of a size. The last line says what "
      "rounding the lengths to doubles may do to an angle: it grows, because long edges matter by "
      "their differences. Tripus's errors are at most {:.2g} times that. A gap: an angle is not a "
      "number, or the error is 0.",
      worst_ratio(table));
  figure.x = {"edge length L (curvature -1)", true, 1e-8, 1e6, {}};
  figure.y = {"largest relative error of an angle", true, 1e-20, 10, {}};
  const std::pair<const char*, const char*> lines[] = {{"paper, float", "float"},
                                                       {"paper, double", "double"},
                                                       {"paper, long double", "long_double"},
                                                       {"Tripus (double)", "tripus"},
                                                       {"rounding of the lengths", "rounding"}};
  for (const auto& [label, column] : lines) {
    Series series{label, Mark::kLine, {}, {}, -1};
    for (std::size_t r = 0; r < table.size(); ++r)
      series.points.push_back({table.number(r, "length"), table.number(r, column)});
    figure.series.push_back(series);
  }
  return figure;
}

/// How many runs ended in which way, by input, solver and kind of start.
Table outcome_table(const Table& starts) {
  Table table({"outcomes",
               "How many runs ended in one way, by input, solver and kind of start.",
               {{"input", "", "the triangulation"},
                {"solver", "", "as in starts.csv"},
                {"start", "", "as in starts.csv"},
                {"outcome", "", "as in starts.csv"},
                {"runs", "", "that ended so"},
                {"shortest", "", "least starting length among them"},
                {"longest", "", "greatest starting length among them"}}});
  struct Group {
    std::size_t runs = 0;
    double shortest = INFINITY, longest = 0;
  };
  std::map<std::array<std::string, 4>, Group> groups;
  for (std::size_t r = 0; r < starts.size(); ++r) {
    Group& group = groups[{starts.text(r, "input"), starts.text(r, "solver"),
                           starts.text(r, "start"), starts.text(r, "outcome")}];
    ++group.runs;
    group.shortest = std::min(group.shortest, starts.number(r, "shortest"));
    group.longest = std::max(group.longest, starts.number(r, "longest"));
  }
  for (const auto& [key, group] : groups)
    table.add(cells(key[0], key[1], key[2], key[3], group.runs, group.shortest, group.longest));
  return table;
}

Figure error_figure(const std::vector<Table>& tables) {
  const Table& table = tables[kAngles];
  Figure figure;
  figure.name = "angle-error";
  figure.title = "Dihedral angle of a regular tetrahedron: error against the closed form";
  figure.caption = fmt::format(
      "A gap: the angle is not a number. An error of 1: it is 0. The rounding of a double is at "
      "1e-16, "
      "and the largest error of Tripus's kernel {:.1e}. Errors below 1e-20 are drawn there.",
      worst_error(table));
  figure.x = {"edge length L (curvature -1)", true, 1e-8, 1e6, {}};
  figure.y = {"relative error of the angle", true, 1e-21, 10, {}};
  for (const char* kernel : {"float", "double", "long double", "Tripus"}) {
    Series series{
        std::string(kernel) == "Tripus" ? "Tripus (double)" : fmt::format("paper, {}", kernel),
        Mark::kLine,
        {},
        {},
        -1};
    for (std::size_t r = 0; r < table.size(); ++r) {
      if (!table.is(r, "kernel", kernel)) continue;
      const double error = table.number(r, "relative_error");
      series.points.push_back({table.number(r, "length"), std::max(error, 1e-20)});
      if (std::isnan(error)) series.points.back()[1] = error;
    }
    figure.series.push_back(series);
  }
  return figure;
}

Figure threshold_figure(const std::vector<Table>& tables) {
  const Table& table = tables[kThresholds];
  Figure figure;
  figure.name = "breakdown";
  figure.title = "Edge length at which the paper's formulae break down";
  figure.caption = fmt::format(
      "The line is where cosh^2 L + cosh L rounds to cosh^2 L. The largest distance of a mark from "
      "it "
      "is {:.2g}. The side itself, computed exactly, would round to 0 from (p + 1) ln 2 on.",
      worst_distance(table));
  figure.x = {"bits p of the significand", false, 16, 72, {}};
  figure.y = {"edge length L (curvature -1)", false, 0, 56, {}};
  Series law{"(p + 3/2) ln 2", Mark::kLine, {}, {}, 0};
  for (const double p : {16.0, 72.0}) law.points.push_back({p, (p + 1.5) * std::log(2.0)});
  Series measured{"measured: angle not a number", Mark::kPoint, {}, {}, 1};
  for (std::size_t r = 0; r < table.size(); ++r)
    if (table.is(r, "event", "angle not a number"))
      measured.points.push_back({table.number(r, "bits"), table.number(r, "length")});
  figure.series = {law, measured};
  return figure;
}

/// The values of a column in the order in which they appear.
std::vector<std::string> values_of(const Table& starts, const char* column) {
  std::vector<std::string> names;
  for (std::size_t r = 0; r < starts.size(); ++r) {
    const std::string& name = starts.text(r, column);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

/// Marks of one input's runs; `number` is its place among the inputs, or 0 if it is the only one.
Figure map_figure(const Table& starts, const std::string& input, std::size_t number, bool uniform) {
  Figure figure;
  figure.name = uniform ? "uniform-starts" : "random-starts";
  if (number > 0) figure.name += fmt::format("-{}", number);
  figure.title =
      fmt::format("Outcomes from {} starting lengths, {}", uniform ? "equal" : "random", input);
  figure.caption =
      uniform ? "Each mark is one run, a blue circle where it reached the metric. Starting lengths "
                "grow from left to right by the factor 1.78."
              : "Each mark is one run, a blue circle where it reached the metric, placed by the "
                "longest of its starting lengths and spread within its row to keep them apart. The "
                "lengths of a start lie within a decade, or anywhere in the range.";
  figure.x = {
      uniform ? "starting length of all edges" : "longest starting length", true, 5e-9, 2e6, {}};
  figure.y.categories = values_of(starts, "solver");
  std::reverse(figure.y.categories.begin(), figure.y.categories.end());
  const auto& names = figure.y.categories;
  for (std::size_t k = 0; k < std::size(kOutcomes); ++k) {
    Series series{kOutcomes[k], Mark::kPoint, {}, {}, int(k)};
    for (std::size_t r = 0; r < starts.size(); ++r) {
      if (!starts.is(r, "outcome", kOutcomes[k]) || !starts.is(r, "input", input) ||
          starts.is(r, "start", "uniform") != uniform)
        continue;
      const auto row = std::find(names.begin(), names.end(), starts.text(r, "solver"));
      // Random starts are spread by a fraction that the number of the start fixes.
      const double part = uniform ? 0.5 : std::fmod(starts.number(r, "number") * 0.618034, 1);
      const double spread = 0.7 * (0.5 - part);
      series.points.push_back({starts.number(r, "longest"), double(row - names.begin()) + spread});
    }
    if (!series.points.empty()) figure.series.push_back(series);
  }
  return figure;
}

std::string fact_name(std::string text) {
  std::erase(text, ',');
  for (char& c : text)
    if (c == ' ' || c == '-' || c == ':' || c == '/') c = '_';
  return text;
}

struct Count {
  std::size_t metric = 0, all = 0;
};

std::map<std::string, Count> successes(const Table& starts) {
  std::map<std::string, Count> counts;
  for (std::size_t r = 0; r < starts.size(); ++r) {
    Count& count = counts[starts.text(r, "solver")];
    ++count.all;
    count.metric += starts.is(r, "outcome", "metric");
  }
  return counts;
}

/// Where the paper's angle in double is worst between length 1 and its breakdown.
struct Worst {
  double length = 0, error = 0;
};
Worst worst_paper_error(const Table& angles) {
  Worst worst;
  for (std::size_t r = 0; r < angles.size(); ++r) {
    if (!angles.is(r, "kernel", "double") || angles.number(r, "length") < 1) continue;
    const double error = angles.number(r, "relative_error");
    if (error > worst.error) worst = {angles.number(r, "length"), error};
  }
  return worst;
}

std::vector<Fact> threshold_facts(const Table& table) {
  std::vector<Fact> facts;
  const std::pair<const char*, const char*> precisions[] = {
      {"float", "float"}, {"double", "double"}, {"long double", "long_double"}};
  for (const auto& [precision, name] : precisions) {
    facts.push_back(
        {fmt::format("breakdown_{}", name),
         threshold(table, precision, "angle not a number", "length"),
         fmt::format("edge length at which the paper's formulae break down, {}", precision)});
    facts.push_back({fmt::format("predicted_breakdown_{}", name),
                     threshold(table, precision, "angle not a number", "predicted_length"),
                     fmt::format("the same from (p + 3/2) ln 2, {}", precision)});
    facts.push_back(
        {fmt::format("angle_zero_{}", name), threshold(table, precision, "angle zero", "length"),
         fmt::format("edge length up to which their angle rounds to 0, {}", precision)});
  }
  return facts;
}

/// "The paper's explicit flow reaches the metric from equal lengths up to ... ", input by input.
std::string flow_sentence(const Table& flow) {
  std::string text;
  for (const std::string& input : values_of(flow, "input")) {
    std::string lengths;
    for (std::size_t r = 0; r < flow.size(); ++r) {
      if (!flow.is(r, "input", input)) continue;
      lengths += fmt::format("{}{:.4f} in {}", lengths.empty() ? "" : ", ",
                             flow.number(r, "length"), flow.text(r, "precision"));
    }
    text += fmt::format("{} up to {} on {}", text.empty() ? "" : ";", lengths, input);
  }
  return text.empty()
             ? text
             : "The paper's explicit flow reaches the metric from equal lengths" + text + ".";
}

}  // namespace

Findings stability_findings(const std::vector<Table>& tables) {
  const Table& starts = tables[kStarts];
  const Table& rounding = tables[kThresholds];
  Findings findings;
  findings.facts = threshold_facts(rounding);
  const auto at = [&](const char* precision, const char* event) {
    return threshold(rounding, precision, event, "length");
  };
  std::string paper, ours;
  for (const auto& [solver, count] : successes(starts)) {
    findings.facts.push_back(
        {fact_name("found " + solver), double(count.metric) / double(count.all),
         fmt::format("part of {} starts that {} brings to the metric", count.all, solver)});
    std::string& list = solver.starts_with("Tripus") ? ours : paper;
    list += fmt::format("{}{} {} of {}", list.empty() ? "" : ", ", solver, count.metric, count.all);
  }
  const double worst = worst_error(tables[kAngles]);
  const double ratio = worst_ratio(tables[kIrregular]);
  const Worst hump = worst_paper_error(tables[kAngles]);
  findings.facts.push_back(
      {"kernel_error", worst, "largest relative error of an angle by Tripus's kernel"});
  findings.facts.push_back(
      {"irregular_ratio", ratio,
       "largest error on irregular tetrahedra, in units of what rounding their lengths does"});
  findings.facts.push_back(
      {"paper_error", hump.error, "largest relative error of the paper's angle in double, L >= 1"});
  findings.paragraph = fmt::format(
      "For equal lengths L the paper's formulae break down at L = {:.4f} in float, {:.4f} in "
      "double and {:.4f} in long double, within {:.0e} of (p + 3/2) ln 2 for p bits. The cause is "
      "one addition: from there on cosh^2 L + cosh L rounds to cosh^2 L, so the hexagon law gives "
      "cosh y = 1 and y = 0, and the triangle law divides 0 by 0. (The exact cosh y would round "
      "to 1 from {:.4f} on in double; the sum is rounded up for a little longer.) Before that the "
      "error of the angle in double has a maximum of {:.1e} at L = {:.3g}; on short edges it "
      "rounds to 0 up to L = {:.2g} in double. {} Of all starts between 1e-8 and 1e6, these reach "
      "the "
      "metric: {}. Tripus's kernel has a relative error of at most {:.1e} on regular tetrahedra "
      "over "
      "the whole range, and on irregular ones at most {:.2g} times what rounding their lengths "
      "does; "
      "of the same starts its methods bring to the metric: {}.",
      at("float", "angle not a number"), at("double", "angle not a number"),
      at("long double", "angle not a number"),
      std::max({std::fabs(at("float", "angle not a number") -
                          threshold(rounding, "float", "angle not a number", "predicted_length")),
                std::fabs(at("double", "angle not a number") -
                          threshold(rounding, "double", "angle not a number", "predicted_length")),
                std::fabs(
                    at("long double", "angle not a number") -
                    threshold(rounding, "long double", "angle not a number", "predicted_length"))}),
      at("double", "exact side rounds to zero"), hump.error, hump.length,
      at("double", "angle zero"), flow_sentence(tables[kFlowThresholds]), paper, worst, ratio,
      ours);
  findings.figures = {error_figure(tables), irregular_figure(tables[kIrregular]),
                      threshold_figure(tables)};
  const std::vector<std::string> inputs = values_of(starts, "input");
  for (std::size_t k = 0; k < std::min(inputs.size(), kMaps); ++k)
    for (const bool uniform : {true, false})
      findings.figures.push_back(
          map_figure(starts, inputs[k], inputs.size() == 1 ? 0 : k + 1, uniform));
  findings.tables = {outcome_table(starts)};
  return findings;
}

}  // namespace tripus::studies::detail
