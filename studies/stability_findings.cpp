#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "studies/detail/stability_tables.hpp"

namespace tripus::studies::detail {
namespace {

const char* const kOutcomes[] = {"metric", "not a number", "length not positive", "no convergence",
                                 "elsewhere"};

double threshold(const Table& table, const char* precision, const char* event, const char* column) {
  for (std::size_t r = 0; r < table.size(); ++r)
    if (table.is(r, "precision", precision) && table.is(r, "event", event))
      return table.number(r, column);
  return std::nan("");
}

Figure error_figure(const std::vector<Table>& tables) {
  const Table& table = tables[kAngles];
  Figure figure;
  figure.name = "angle-error";
  figure.title = "Dihedral angle of a regular tetrahedron: error against the closed form";
  figure.caption =
      "The lines of the paper's formulae stop on the right where the side of the vertex triangle "
      "rounds to zero; before that they have a hump, and for short edges their error grows like "
      "1/L^2 until the angle rounds to 0 (relative error 1) or is not a number (gaps). Tripus's "
      "kernel stays at the rounding of double precision over fourteen decades. Errors below 1e-20 "
      "are drawn there.";
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
  figure.caption =
      "The measured breakdown lies on (p + 3/2) ln 2, where cosh^2 L + cosh L rounds to cosh^2 L; "
      "exact arithmetic followed by one rounding would fail a little earlier, at (p + 1) ln 2.";
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

Figure map_figure(const Table& starts, bool uniform) {
  Figure figure;
  figure.name = uniform ? "uniform-starts" : "random-starts";
  figure.title =
      uniform ? "Outcomes from equal starting lengths" : "Outcomes from random starting lengths";
  figure.caption =
      uniform ? "Each mark is one run, a blue circle where it reached the metric. Within a row the "
                "inputs lie one above the other. Long edges end the "
                "paper's formulae, a little later in higher precision."
              : "Each mark is one run, a blue circle where it reached the metric, placed by the "
                "longest of its starting lengths and spread within its row to keep them apart. The "
                "paper's formulae are undefined wherever the start makes a tetrahedron flat or an "
                "edge too long.";
  figure.x = {
      uniform ? "starting length of all edges" : "longest starting length", true, 5e-9, 2e6, {}};
  figure.y.categories = values_of(starts, "solver");
  std::reverse(figure.y.categories.begin(), figure.y.categories.end());
  const auto& names = figure.y.categories;
  const std::vector<std::string> inputs = values_of(starts, "input");
  for (std::size_t k = 0; k < std::size(kOutcomes); ++k) {
    Series series{kOutcomes[k], Mark::kPoint, {}, {}, int(k)};
    for (std::size_t r = 0; r < starts.size(); ++r) {
      if (!starts.is(r, "outcome", kOutcomes[k]) || starts.is(r, "start", "uniform") != uniform)
        continue;
      const auto row = std::find(names.begin(), names.end(), starts.text(r, "solver"));
      // Inputs one above the other; random starts spread by a fraction that is fixed by the start.
      const auto input = std::find(inputs.begin(), inputs.end(), starts.text(r, "input"));
      const double part = uniform ? (double(input - inputs.begin()) + 0.5) / double(inputs.size())
                                  : std::fmod(starts.number(r, "number") * 0.618034, 1);
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

/// Largest relative error of Tripus's kernel.
double worst_error(const Table& angles) {
  double worst = 0;
  for (std::size_t r = 0; r < angles.size(); ++r)
    if (angles.is(r, "kernel", "Tripus"))
      worst = std::max(worst, angles.number(r, "relative_error"));
  return worst;
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
  const Table& flow = tables[kFlowThresholds];
  std::string flow_text;
  for (std::size_t r = 0; r < std::min<std::size_t>(3, flow.size()); ++r)
    flow_text += fmt::format("{}{:.4f} in {}", r == 0 ? "" : ", ", flow.number(r, "length"),
                             flow.text(r, "precision"));
  const double worst = worst_error(tables[kAngles]);
  const Worst hump = worst_paper_error(tables[kAngles]);
  findings.facts.push_back(
      {"kernel_error", worst, "largest relative error of an angle by Tripus's kernel"});
  findings.facts.push_back(
      {"paper_error", hump.error, "largest relative error of the paper's angle in double, L >= 1"});
  findings.paragraph = fmt::format(
      "For equal lengths L the paper's formulae break down at L = {:.4f} in float, {:.4f} in "
      "double and {:.4f} in long double, within {:.0e} of (p + 3/2) ln 2 for p bits. The cause is "
      "one addition: from there on cosh^2 L + cosh L rounds to cosh^2 L, so the hexagon law gives "
      "cosh y = 1 and y = 0, and the triangle law divides 0 by 0. (The exact cosh y would round "
      "to 1 from {:.4f} on in double; the sum is rounded up for a little longer.) Before that the "
      "error of the angle in double has a maximum of {:.1e} at L = {:.3g}; on short edges it "
      "rounds to 0 up to L = {:.2g} in double. The paper's explicit flow reaches the metric of {} "
      "from equal lengths up to {}. Of all starts between 1e-8 and 1e6, these reach it: {}. "
      "Tripus's kernel has a relative error of at most {:.1e} over the whole range, and of the "
      "same starts its methods bring to the metric: {}.",
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
      at("double", "angle zero"), flow.size() == 0 ? "" : flow.text(0, "input"), flow_text, paper,
      worst, ours);
  findings.figures = {error_figure(tables), threshold_figure(tables), map_figure(starts, true),
                      map_figure(starts, false)};
  return findings;
}

}  // namespace tripus::studies::detail
