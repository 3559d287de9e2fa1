#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "studies/detail/paper_tables.hpp"
#include "studies/detail/statistics.hpp"

namespace tripus::studies::detail {
namespace {

/// The bar that the paper sets for its errors.
constexpr double kPaperBar = 1e-8;
/// Volumes closer than this are called equal: far above the errors, far below the gaps.
constexpr double kSameVolume = 1e-10;

std::vector<double> column_of(const Table& table, const char* column) {
  std::vector<double> values;
  for (std::size_t r = 0; r < table.size(); ++r) values.push_back(table.number(r, column));
  return values;
}

/// Part of the manifolds with an error up to x, against x.
Figure error_figure(const Table& table) {
  Figure figure;
  figure.name = "errors";
  figure.title = "Errors against the algebraic route in 50 digits";
  figure.caption =
      "Each line says for how many triangulations (vertical) the error is at most so much "
      "(horizontal): the farther left, the better. The dashed line is the paper's "
      "bar. Errors below 1e-17 are drawn there.";
  figure.x = {"error (lengths; angles in radians; volumes)", true, 3e-18, 1e-7, {}};
  figure.y = {"triangulations with at most this error (%)", false, 0, 102, {}};
  const std::pair<const char*, const char*> lines[] = {
      {"flow, length", "flow_length_error"},   {"flow, angle", "flow_angle_error"},
      {"flow, volume", "flow_volume_error"},   {"Newton, length", "newton_length_error"},
      {"Newton, angle", "newton_angle_error"}, {"Newton, volume", "newton_volume_error"}};
  for (const auto& [label, column] : lines) {
    Series series{label, Mark::kLine, {}, {}, -1};
    const std::vector<double> errors = finite_sorted(column_of(table, column));
    const std::size_t stride = std::max<std::size_t>(1, errors.size() / 400);
    for (std::size_t k = 0; k < errors.size(); k += stride)
      series.points.push_back(
          {std::max(errors[k], 1e-17), 100.0 * double(k + 1) / double(errors.size())});
    if (!errors.empty()) series.points.push_back({std::max(errors.back(), 1e-17), 100.0});
    figure.series.push_back(series);
  }
  figure.guides = {{true, kPaperBar, "the paper's bar 1e-8"}};
  return figure;
}

Figure iterations_figure(const Table& table) {
  Figure figure;
  figure.name = "flow-iterations";
  figure.title = "Steps of the paper's flow and of Newton's method";
  figure.caption =
      "Every mark is one triangulation. The explicit flow pays for short edges, where the problem "
      "is stiff; Newton's method does not.";
  figure.x = {"volume", false, std::nan(""), std::nan(""), {}};
  figure.y = {"steps", true, std::nan(""), std::nan(""), {}};
  Series flow{"flow, Euler, to max|K| <= 1e-10", Mark::kPoint, {}, {}, 1};
  Series newton{"Newton's method, to max|K| <= 1e-12", Mark::kPoint, {}, {}, 0};
  for (std::size_t r = 0; r < table.size(); ++r) {
    if (table.is(r, "flow_found", "yes"))
      flow.points.push_back({table.number(r, "volume"), table.number(r, "flow_iterations")});
    newton.points.push_back(
        {table.number(r, "volume"), std::max(1.0, table.number(r, "newton_iterations"))});
  }
  figure.series = {flow, newton};
  return figure;
}

/// Triangulations with metrics of one volume.
struct VolumeGroup {
  double volume = 0;
  std::size_t triangulations = 0;
  std::set<std::string> kinds;  ///< boundary and homology: what already tells manifolds apart
};

std::vector<VolumeGroup> volume_groups(const Table& table) {
  std::vector<std::pair<double, std::size_t>> volumes;
  for (std::size_t r = 0; r < table.size(); ++r)
    if (table.is(r, "outcome", "geometric")) volumes.push_back({table.number(r, "volume"), r});
  std::sort(volumes.begin(), volumes.end());
  std::vector<VolumeGroup> groups;
  double previous = -1;
  for (const auto& [volume, r] : volumes) {
    if (volume - previous > kSameVolume) groups.push_back({volume, 0, {}});
    previous = volume;
    ++groups.back().triangulations;
    groups.back().kinds.insert(table.text(r, "boundary") + " " + table.text(r, "homology"));
  }
  return groups;
}

Figure volumes_figure(const std::vector<VolumeGroup>& groups) {
  Figure figure;
  figure.name = "volumes";
  figure.title = "Triangulations of one volume";
  figure.caption =
      "Every volume that occurs, with the number of triangulations that share it and the number "
      "of kinds (boundary and first homology) among them. Different volumes tell manifolds apart; "
      "where several kinds share a volume, homology does; the rest needs the canonical "
      "decomposition.";
  figure.x = {"volume", false, std::nan(""), std::nan(""), {}};
  figure.y = {"triangulations or kinds of the same volume", true, 0.8, std::nan(""), {}};
  Series all{"triangulations", Mark::kPoint, {}, {}, 0}, kinds{"kinds", Mark::kPoint, {}, {}, 1};
  for (const VolumeGroup& group : groups) {
    all.points.push_back({group.volume, double(group.triangulations)});
    kinds.points.push_back({group.volume, double(group.kinds.size())});
  }
  figure.series = {all, kinds};
  return figure;
}

double worst_of(const Table& table, std::initializer_list<const char*> columns) {
  double worst = 0;
  for (const char* column : columns)
    for (const double value : finite_sorted(column_of(table, column)))
      worst = std::max(worst, value);
  return worst;
}

std::size_t count(const Table& table, const char* column, const char* value) {
  std::size_t rows = 0;
  for (std::size_t r = 0; r < table.size(); ++r) rows += table.is(r, column, value);
  return rows;
}

}  // namespace

Findings paper_findings(const std::vector<Table>& tables) {
  const Table& table = tables[kManifolds];
  const std::size_t metrics = count(table, "outcome", "geometric"),
                    flows = count(table, "flow_found", "yes"),
                    exact = count(table, "algebraic_found", "yes");
  const double flow_worst =
      worst_of(table, {"flow_length_error", "flow_angle_error", "flow_volume_error"});
  const double newton_worst =
      worst_of(table, {"newton_length_error", "newton_angle_error", "newton_volume_error"});
  const std::vector<VolumeGroup> groups = volume_groups(table);
  std::size_t shared = 0, ambiguous = 0;
  for (const VolumeGroup& group : groups) {
    shared += group.triangulations > 1;
    ambiguous += group.kinds.size() > 1;
  }
  Findings findings;
  findings.facts = {
      {"triangulations", double(table.size()), "triangulations"},
      {"geometric", double(metrics), "of them carry the metric"},
      {"flow_found", double(flows), "reached by the paper's flow from equal lengths 1"},
      {"algebraic_found", double(exact), "reached by the algebraic route by itself"},
      {"flow_error", flow_worst, "largest error of a length, angle or volume, flow"},
      {"newton_error", newton_worst, "largest error of a length, angle or volume, Newton's method"},
      {"residual", worst_of(table, {"residual"}), "largest residual of the algebraic route"},
      {"flow_iterations_median", median(column_of(table, "flow_iterations")),
       "median number of Euler steps"},
      {"newton_iterations_median", median(column_of(table, "newton_iterations")),
       "median number of steps of Newton's method"},
      {"volumes", double(groups.size()), "different volumes"},
      {"shared_volumes", double(shared), "volumes of several triangulations"},
      {"volumes_of_several_kinds", double(ambiguous),
       "volumes shared by manifolds with different boundary or homology"},
  };
  findings.paragraph = fmt::format(
      "Of {} triangulations {} carry the metric. The paper's flow, explicit Euler from equal "
      "lengths 1, reaches it on {} of them, in {:.0f} steps in the median; Newton's method on "
      "all, in {:.0f}. The algebraic route, the gluing equations in cosh l by Newton's method in "
      "60 digits, found {} by itself, with residuals below {:.0e}. Against it the largest error "
      "of a length, an angle or a volume is {:.1e} for the flow (the paper's bar is 1e-8) and "
      "{:.1e} for Newton's method. The metrics have {} different volumes; {} of these belong to "
      "several triangulations, and {} to manifolds with different boundary or homology, which "
      "volume alone does not tell apart.",
      table.size(), metrics, flows, median(column_of(table, "flow_iterations")),
      median(column_of(table, "newton_iterations")), exact,
      std::max(worst_of(table, {"residual"}), 1e-60), flow_worst, newton_worst, groups.size(),
      shared, ambiguous);
  findings.figures = {error_figure(table), iterations_figure(table), volumes_figure(groups)};
  return findings;
}

}  // namespace tripus::studies::detail
