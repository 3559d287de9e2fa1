#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "studies/detail/statistics.hpp"
#include "studies/detail/tables.hpp"

namespace tripus::studies::detail {
namespace {

/// Kinds of triangulations, as they are stacked.
const char* const kKinds[] = {"geometric", "degenerate (flat tetrahedra)",
                              "infeasible (semi-angle structures only)",
                              "infeasible (no angle structure)", "unresolved"};
constexpr std::size_t kKindCount = std::size(kKinds);

std::size_t kind_of(const Table& table, std::size_t r) {
  if (table.is(r, "outcome", "geometric")) return 0;
  if (table.is(r, "outcome", "degenerate")) return 1;
  if (table.is(r, "outcome", "unresolved")) return 4;
  return table.is(r, "certificate", "no angle structure") ? 3 : 2;
}

using Counts = std::array<double, kKindCount>;

/// Stacked bars: parts of each kind by the value of a column, in percent.
Figure parts_figure(const Table& table, const char* name, const char* column, const char* title,
                    const char* label, const char* caption) {
  std::map<int, Counts> counts;
  for (std::size_t r = 0; r < table.size(); ++r)
    ++counts.try_emplace(int(table.number(r, column)), Counts{}).first->second[kind_of(table, r)];
  Figure figure;
  figure.name = name;
  figure.title = title;
  figure.caption = caption;
  figure.x.label = label;
  figure.y = {"part of the triangulations (%)", false, 0, 100, {}};
  std::map<int, double> top;
  for (std::size_t k = 0; k < kKindCount; ++k) {
    Series series{kKinds[k], Mark::kBar, {}, {}, int(k)};
    bool any = false;
    for (const auto& [value, part] : counts) {
      double all = 0;
      for (const double count : part) all += count;
      const double base = top[value];
      top[value] = base + 100 * part[k] / all;
      any = any || part[k] > 0;
      series.base.push_back(base);
      series.points.push_back({double(value), top[value]});
    }
    if (any) figure.series.push_back(series);
  }
  return figure;
}

/// The median volume of the manifold of each row's input.
std::map<std::string, double> median_volumes(const Table& table) {
  std::map<std::string, std::vector<double>> volumes;
  for (std::size_t r = 0; r < table.size(); ++r)
    volumes[table.text(r, "input")].push_back(table.number(r, "volume"));
  std::map<std::string, double> medians;
  for (const auto& [input, values] : volumes) medians[input] = median(values);
  return medians;
}

Figure condition_figure(const Table& table) {
  Figure figure;
  figure.name = "condition";
  figure.title = "Condition of the problem where the triangulation carries the metric";
  std::vector<double> longest, logarithm;
  for (std::size_t r = 0; r < table.size(); ++r) {
    if (!(table.number(r, "condition") > 0)) continue;
    longest.push_back(table.number(r, "longest"));
    logarithm.push_back(std::log(table.number(r, "condition")));
  }
  const double rate = slope(longest, logarithm);
  figure.caption = fmt::format(
      "Every mark is one triangulation that carries the metric, by the iterations that Newton's "
      "method "
      "took. {}",
      std::isfinite(rate)
          ? fmt::format("A line fitted to the logarithm has slope {:.2f} a unit of length.", rate)
          : std::string());
  figure.x = {"longest edge of the metric (curvature -1)", false, std::nan(""), std::nan(""), {}};
  figure.y = {"condition number of the Hessian", true, std::nan(""), std::nan(""), {}};
  const std::pair<int, int> groups[] = {{0, 4}, {5, 6}, {7, 8}, {9, 1000}};
  for (const auto& [from, to] : groups) {
    Series series{to == 1000 ? fmt::format("{} iterations or more", from)
                             : fmt::format("{} to {} iterations", from, to),
                  Mark::kPoint,
                  {},
                  {},
                  -1};
    for (std::size_t r = 0; r < table.size(); ++r) {
      const double iterations = table.number(r, "iterations");
      if (iterations >= from && iterations <= to)
        series.points.push_back({table.number(r, "longest"), table.number(r, "condition")});
    }
    if (!series.points.empty()) figure.series.push_back(series);
  }
  return figure;
}

double spread(const Table& table) {
  const auto medians = median_volumes(table);
  double worst = 0;
  for (std::size_t r = 0; r < table.size(); ++r) {
    const double error =
        std::fabs(table.number(r, "volume") / medians.at(table.text(r, "input")) - 1);
    if (std::isfinite(error)) worst = std::max(worst, error);
  }
  return worst;
}

Figure volume_figure(const Table& table) {
  Figure figure;
  figure.name = "volume-spread";
  figure.title = "Agreement of the volumes over the triangulations";
  figure.caption = fmt::format(
      "Every mark is one triangulation that carries the metric; the largest deviation is {:.1e}. "
      "Exact "
      "agreement is drawn at 1e-17.",
      spread(table));
  figure.x = {"condition number of the Hessian", true, std::nan(""), std::nan(""), {}};
  figure.y = {"|volume / median - 1|", true, 5e-18, 1e-12, {}};
  Series series{"", Mark::kPoint, {}, {}, 0};
  const auto medians = median_volumes(table);
  for (std::size_t r = 0; r < table.size(); ++r) {
    const double error =
        std::fabs(table.number(r, "volume") / medians.at(table.text(r, "input")) - 1);
    if (std::isfinite(error))
      series.points.push_back({table.number(r, "condition"), std::max(error, 1e-17)});
  }
  figure.y.upper = std::nan("");
  figure.series.push_back(series);
  return figure;
}

/// Stacked bars: where the minimiser exists, whether it is a metric, by its shortest edge.
Figure shortest_figure(const Table& table) {
  constexpr int kBins = 24;
  std::vector<double> all;
  for (std::size_t r = 0; r < table.size(); ++r) all.push_back(table.number(r, "shortest"));
  const double low = std::log10(least(all)), high = std::log10(greatest(all));
  Figure figure;
  figure.name = "by-shortest-edge";
  figure.title = "Metrics and boundary cases, by their shortest edge";
  figure.caption =
      "Triangulations for which the co-volume has a minimiser, by its shortest edge: the metric, "
      "or "
      "lengths at which some tetrahedra are flat. The others have no lengths to speak of.";
  figure.x.label = "shortest edge of the minimiser (curvature -1)";
  figure.y.label = "triangulations";
  if (!(high >= low)) return figure;
  const double width = std::max((high - low) / kBins, 1e-3);
  for (int k = 0; k <= kBins; ++k)
    figure.x.categories.push_back(
        k % 3 == 0 ? fmt::format("{:.3g}", std::pow(10.0, low + k * width)) : std::string());
  std::array<std::array<double, kBins + 1>, 2> counts{};
  for (std::size_t r = 0; r < table.size(); ++r) {
    const std::size_t kind = kind_of(table, r);
    if (kind > 1 || !(all[r] > 0)) continue;
    const auto bin =
        std::size_t(std::clamp((std::log10(all[r]) - low) / width, 0.0, double(kBins)));
    ++counts[kind][bin];
  }
  for (std::size_t kind = 0; kind < 2; ++kind) {
    Series series{kKinds[kind], Mark::kBar, {}, {}, int(kind)};
    for (std::size_t k = 0; k <= kBins; ++k) {
      const double base = kind == 0 ? 0 : counts[0][k];
      series.base.push_back(base);
      series.points.push_back({double(k), base + counts[kind][k]});
    }
    figure.series.push_back(series);
  }
  return figure;
}

}  // namespace

Findings triangulations_findings(const std::vector<Table>& tables) {
  const Table& table = tables[0];
  Counts counts{};
  std::size_t low = 0, low_metric = 0;
  std::vector<double> condition, iterations, longest, shortest, flat_shortest;
  for (std::size_t r = 0; r < table.size(); ++r) {
    const std::size_t kind = kind_of(table, r);
    ++counts[kind];
    if (table.number(r, "least_valence") <= 2) {
      ++low;
      low_metric += kind == 0;
    }
    condition.push_back(table.number(r, "condition"));
    iterations.push_back(table.number(r, "iterations"));
    if (kind == 0) longest.push_back(table.number(r, "longest"));
    if (kind <= 1) (kind == 0 ? shortest : flat_shortest).push_back(table.number(r, "shortest"));
  }
  const double all = double(table.size()), worst = spread(table);
  Findings findings;
  findings.facts = {
      {"triangulations", all, "distinct triangulations"},
      {"geometric", counts[0], "are geometric"},
      {"boundary_cases", counts[1], "are degenerate: flat tetrahedra at the minimiser"},
      {"semi", counts[2], "are infeasible: semi-angle structures only"},
      {"none", counts[3], "are infeasible: no angle structure"},
      {"unresolved", counts[4], "are unresolved"},
      {"low_valence", double(low), "have an edge of valence 1 or 2"},
      {"low_valence_geometric", double(low_metric), "of these are geometric"},
      {"volume_spread", worst, "largest relative deviation of a volume from the median"},
      {"condition_greatest", greatest(condition), "largest condition number"},
      {"iterations_greatest", greatest(iterations), "most iterations of Newton's method"},
      {"longest_edge", greatest(longest), "longest edge of a metric"},
      {"shortest_edge", least(shortest), "shortest edge of a metric"},
      {"shortest_edge_of_boundary_cases", least(flat_shortest),
       "shortest edge of the minimiser of a boundary case"},
  };
  findings.paragraph = fmt::format(
      "Of {:.0f} distinct triangulations {:.0f} ({:.1f} %) are geometric, {:.0f} are degenerate, "
      "{:.0f} are infeasible with semi-angle structures only and {:.0f} with no angle structure, "
      "by "
      "exact certificates; {:.0f} are unresolved. {} of the {} with an edge of valence 1 or 2 are "
      "geometric. The volumes of all metrics of one input agree within {:.1e}. The "
      "condition number of the Hessian is {:.3g} in the median and {:.3g} at most (the longest "
      "edge being {:.2g}), and Newton's method takes at most {:.0f} iterations. The shortest edge "
      "is "
      "{:.3g} or longer in a metric{}.",
      all, counts[0], all > 0 ? 100 * counts[0] / all : 0.0, counts[1], counts[2], counts[3],
      counts[4], low_metric, low, worst, median(condition), greatest(condition), greatest(longest),
      greatest(iterations), least(shortest),
      flat_shortest.empty() ? std::string()
                            : fmt::format(", {:.3g} in a boundary case", least(flat_shortest)));
  findings.figures = {
      parts_figure(table, "by-tetrahedra", "tetrahedra",
                   "Which triangulations carry the metric, by size", "tetrahedra T",
                   "How the parts change with size. Blue carries the metric; orange is where moves "
                   "around the flat tetrahedra may help."),
      parts_figure(table, "by-valence", "least_valence",
                   "Which triangulations carry the metric, by their least valence",
                   "least valence of an edge class",
                   "An edge of valence 1 or 2 excludes the metric: no blue there. Compare the blue "
                   "parts from there on."),
      parts_figure(table, "by-greatest-valence", "greatest_valence",
                   "Which triangulations carry the metric, by their greatest valence",
                   "greatest valence of an edge class",
                   "How the parts change with the greatest valence, up to 6 times the number of "
                   "tetrahedra."),
      shortest_figure(table),
      condition_figure(table),
      volume_figure(table)};
  return findings;
}

}  // namespace tripus::studies::detail
