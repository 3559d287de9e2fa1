#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "studies/detail/statistics.hpp"
#include "studies/detail/tables.hpp"

namespace tripus::studies::detail {
namespace {

/// The bar that the paper sets for its errors.
constexpr double kPaperBar = 1e-8;

/// Part of the manifolds with an error up to x, against x.
Figure error_figure(const Table& table) {
  Figure figure;
  figure.name = "errors";
  figure.title = "Errors against the algebraic route in 60 digits";
  figure.caption =
      "Each line says for how many triangulations (vertical) the error is at most so much "
      "(horizontal): the farther left, the better. The dashed line is the paper's "
      "bar. Errors below 1e-17 are drawn there.";
  figure.x = {"error (lengths; angles in radians; volumes)", true, 3e-18, 1e-7, {}};
  figure.y = {"triangulations with at most this error (%)", false, 0, 110, {}};
  const std::pair<const char*, const char*> lines[] = {
      {"flow, length", "flow_length_error"},   {"flow, angle", "flow_angle_error"},
      {"flow, volume", "flow_volume_error"},   {"Newton, length", "newton_length_error"},
      {"Newton, angle", "newton_angle_error"}, {"Newton, volume", "newton_volume_error"}};
  for (const auto& [label, column] : lines) {
    Series series{label, Mark::kLine, {}, {}, -1};
    const std::vector<double> errors = finite_sorted(table.numbers(column));
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

Figure paper_iterations_figure(const Table& table) {
  Figure figure;
  figure.name = "flow-iterations";
  figure.title = "Steps of the paper's flow and of Newton's method";
  figure.caption = fmt::format(
      "Every mark is one triangulation. The flow takes between {:.0f} and {:.0f} steps, Newton's "
      "method between {:.0f} and {:.0f}.",
      least(table.numbers("flow_iterations")), greatest(table.numbers("flow_iterations")),
      least(table.numbers("newton_iterations")), greatest(table.numbers("newton_iterations")));
  figure.x = {"volume", false, std::nan(""), std::nan(""), {}};
  figure.y = {"steps", true, std::nan(""), std::nan(""), {}};
  Series flow{"flow, Euler, to max|K| <= 1e-10", Mark::kPoint, {}, {}, 1};
  Series newton{"Newton's method, to max|K| <= 1e-12", Mark::kPoint, {}, {}, 0};
  for (std::size_t r = 0; r < table.size(); ++r) {
    if (table.is(r, "flow_found", "yes"))
      flow.points.push_back({table.number(r, "volume"), table.number(r, "flow_iterations")});
    if (table.is(r, "outcome", "geometric"))
      newton.points.push_back(
          {table.number(r, "volume"), std::max(1.0, table.number(r, "newton_iterations"))});
  }
  figure.series = {flow, newton};
  return figure;
}

Figure volumes_figure(const std::vector<VolumeGroup>& groups) {
  Figure figure;
  figure.name = "volumes";
  figure.title = "Triangulations and manifolds of one volume";
  std::size_t most = 0;
  for (const VolumeGroup& group : groups) most = std::max(most, group.size());
  figure.caption = fmt::format(
      "One circle and one square for every volume that occurs: the number of inputs that are "
      "triangulations of a manifold of this volume, and the number of different manifolds among "
      "them, at most {}. A square at 1 is a manifold that its volume tells apart from all others "
      "here.",
      most);
  figure.x = {"volume", false, std::nan(""), std::nan(""), {}};
  figure.y = {"number of the same volume", true, 0.8, std::nan(""), {}};
  Series all{"triangulations", Mark::kPoint, {}, {}, 0},
      different{"manifolds", Mark::kPoint, {}, {}, 1};
  for (const VolumeGroup& group : groups) {
    double triangulations = 0;
    for (const StudiedManifold& m : group) triangulations += double(m.triangulations);
    all.points.push_back({group.front().volume, triangulations});
    different.points.push_back({group.front().volume, double(group.size())});
  }
  figure.series = {all, different};
  return figure;
}

double worst_of(const Table& table, std::initializer_list<const char*> columns) {
  double worst = 0;
  for (const char* column : columns)
    for (const double value : finite_sorted(table.numbers(column))) worst = std::max(worst, value);
  return worst;
}

std::size_t count(const Table& table, const char* column, const char* value) {
  std::size_t rows = 0;
  for (std::size_t r = 0; r < table.size(); ++r) rows += table.is(r, column, value);
  return rows;
}

/// The worst of all triangulations.
struct WorstErrors {
  double flow = 0, newton = 0, residual = 0;
};
WorstErrors worst_errors(const Table& table) {
  return {worst_of(table, {"flow_length_error", "flow_angle_error", "flow_volume_error"}),
          worst_of(table, {"newton_length_error", "newton_angle_error", "newton_volume_error"}),
          worst_of(table, {"residual"})};
}

/// What volumes do not tell apart.
struct Sharing {
  std::size_t volumes = 0, manifolds = 0, need_canonical = 0;
  double least_gap = std::nan("");
};
Sharing sharing_of(const std::vector<VolumeGroup>& groups) {
  Sharing sharing;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const VolumeGroup& group = groups[k];
    if (k > 0)
      sharing.least_gap =
          std::fmin(sharing.least_gap, group.front().volume - groups[k - 1].front().volume);
    if (group.size() < 2) continue;
    ++sharing.volumes;
    sharing.manifolds += group.size();
    for (const StudiedManifold& m : group) sharing.need_canonical += of_same_kind(group, m) > 1;
  }
  return sharing;
}

}  // namespace

Findings paper_findings(const std::vector<Table>& tables) {
  const Table& table = tables[kTriangulations];
  const std::vector<StudiedManifold> manifolds = manifolds_of(table);
  const std::vector<VolumeGroup> groups = volume_groups(manifolds);
  const WorstErrors errors = worst_errors(table);
  const Sharing sharing = sharing_of(groups);
  const std::size_t metrics = count(table, "outcome", "geometric"),
                    flows = count(table, "flow_found", "yes"),
                    exact = count(table, "algebraic_found", "yes");
  std::size_t by_moves = 0;
  for (const StudiedManifold& m : manifolds) by_moves += m.geometric == 0;
  Findings findings;
  findings.facts = {
      {"triangulations", double(table.size()), "triangulations"},
      {"geometric", double(metrics), "of them carry the metric"},
      {"flow_found", double(flows), "reached by the paper's flow from equal lengths 1"},
      {"algebraic_found", double(exact), "reached by the algebraic route by itself"},
      {"flow_error", errors.flow, "largest error of a length, angle or volume, flow"},
      {"newton_error", errors.newton,
       "largest error of a length, angle or volume, Newton's method"},
      {"residual", errors.residual, "largest residual of the algebraic route"},
      {"flow_iterations_median", median(table.numbers("flow_iterations")),
       "median number of Euler steps"},
      {"newton_iterations_median", median(table.numbers("newton_iterations")),
       "median number of steps of Newton's method"},
      {"manifolds", double(manifolds.size()), "different manifolds, by isometry signature"},
      {"manifolds_by_moves", double(by_moves),
       "of them found on another triangulation only, by moves"},
      {"volumes", double(groups.size()), "different volumes"},
      {"least_gap", sharing.least_gap, "least difference of two different volumes"},
      {"shared_volumes", double(sharing.volumes), "volumes of several manifolds"},
      {"manifolds_sharing", double(sharing.manifolds),
       "manifolds whose volume is not theirs alone"},
      {"need_canonical", double(sharing.need_canonical),
       "of them have the boundary and homology of another of their volume"},
  };
  findings.paragraph = fmt::format(
      "{} of {} triangulations carry the metric. The paper's flow, explicit Euler from equal "
      "lengths "
      "1, reaches it on {} of them, in {:.0f} steps in the median; Newton's method takes {:.0f}. "
      "The "
      "algebraic route, the gluing equations in cosh l by Newton's method in 60 digits, found {} "
      "by "
      "itself, with residuals below {:.0e}. Against it the largest error of a length, an angle or "
      "a "
      "volume is {:.1e} for the flow (the paper's bar is 1e-8) and {:.1e} for Newton's method. The "
      "triangulations belong to {} different manifolds, by their canonical decompositions{}, with "
      "{} "
      "different volumes. {} volumes belong to several manifolds, {} in all; boundary and homology "
      "tell {} of these from the others of their volume, and {} need the canonical decomposition.",
      metrics, table.size(), flows, median(table.numbers("flow_iterations")),
      median(table.numbers("newton_iterations")), exact, std::max(errors.residual, 1e-60),
      errors.flow, errors.newton, manifolds.size(),
      by_moves == 0
          ? std::string()
          : fmt::format(" ({} of them seen on another triangulation only, a few moves away)",
                        by_moves),
      groups.size(), sharing.volumes, sharing.manifolds, sharing.manifolds - sharing.need_canonical,
      sharing.need_canonical);
  findings.figures = {error_figure(table), paper_iterations_figure(table), volumes_figure(groups)};
  findings.tables = manifold_tables(manifolds, groups);
  return findings;
}

}  // namespace tripus::studies::detail
