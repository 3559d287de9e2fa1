// Triangulations all of whose edge classes have valence 6 or more: do they carry the metric?
// Costantino, Frigerio, Martelli and Petronio asked, and proved that the manifold is hyperbolic.
// Every answer "yes" here is a proof for that triangulation (docs/theory.md section 9).
#include <algorithm>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "structure/proof/proof.hpp"
#include "structure/solve.hpp"
#include "studies/detail/tables.hpp"
#include "topology/requirements.hpp"
#include "topology/triangulation.hpp"

namespace tripus::studies::detail {
namespace {

std::size_t least_valence(const topology::Triangulation& triangulation) {
  std::size_t least = triangulation.valence(0);
  for (std::size_t e = 1; e < triangulation.edge_count(); ++e)
    least = std::min(least, triangulation.valence(e));
  return least;
}

std::vector<Row> prove_row(const StudyInput& input, const Stop& stop) {
  const topology::Triangulation triangulation(input.gluings);
  structure::SolveOptions options;
  options.stop = stop;
  const structure::Report report = structure::solve(triangulation, options);
  structure::Proof proof;
  proof.reason = report.message;
  if (report.outcome == structure::Outcome::kGeometric) {
    Context context;
    context.stop = stop;
    context.threads = 1;
    proof = structure::prove(triangulation, report.edge_lengths, {}, context);
  }
  return {{0, cells(input.name, triangulation.tetrahedron_count(), triangulation.edge_count(),
                    least_valence(triangulation), structure::to_string(report.outcome),
                    proof.proved, proof.proved ? cell(proof.bits) : std::string(),
                    proof.proved ? cell(proof.largest_radius()) : std::string(),
                    proof.proved ? cell(proof.volume.lower) : std::string(),
                    proof.proved ? cell(proof.volume.upper) : std::string(), proof.reason)}};
}

TableLayout valence_layout() {
  return {"valence",
          "One triangulation whose edge classes all have at least the valence asked for.",
          {{"isosig", "", "the triangulation, as it was given"},
           {"tetrahedra", "", "T"},
           {"edges", "", "edge classes E"},
           {"least_valence", "", "of an edge class"},
           {"outcome", "", "in floating point"},
           {"proved", "", "whether it is proved to carry the metric"},
           {"bits", "", "of the arithmetic that was enough for the proof"},
           {"radius", "", "the true lengths are proved to be within this of those found"},
           {"volume_lower", "", "proved lower bound of the volume"},
           {"volume_upper", "", "proved upper bound of the volume"},
           {"reason", "", "why it is not proved"}}};
}

struct ValenceCounts {
  std::size_t all = 0, proved = 0, in_doubles = 0;
};

/// Each mark is a proof: the volume, and how well the lengths are known.
Figure radius_figure(const Table& table) {
  Figure figure;
  figure.name = "radii";
  figure.title = "How well the lengths are known";
  figure.x.label = "volume";
  figure.y = {"proved distance from the true lengths, at most", true, {}, {}, {}};
  figure.y.lower = figure.y.upper = std::numeric_limits<double>::quiet_NaN();
  Series series{"", Mark::kPoint, {}, {}, 0};
  double widest = 0;
  for (std::size_t r = 0; r < table.size(); ++r) {
    if (!table.is(r, "proved", "yes")) continue;
    series.points.push_back({table.number(r, "volume_lower"), table.number(r, "radius")});
    widest = std::max(widest, table.number(r, "radius"));
  }
  figure.caption = fmt::format(
      "Every mark is one of the {} proofs; no length is known worse than to within {:.2g}.",
      series.points.size(), widest);
  figure.series.push_back(std::move(series));
  return figure;
}

Findings valence_findings(const std::vector<Table>& tables) {
  const Table& table = tables.at(0);
  std::map<int, ValenceCounts> counts;
  ValenceCounts total;
  for (std::size_t r = 0; r < table.size(); ++r) {
    const bool proved = table.text(r, "proved") == "yes";
    const bool in_doubles = proved && table.number(r, "bits") == 53;
    for (ValenceCounts* of : {&counts[int(table.number(r, "tetrahedra"))], &total}) {
      ++of->all;
      of->proved += proved;
      of->in_doubles += in_doubles;
    }
  }
  Findings findings;
  Table summary({"counts",
                 "Triangulations by number of tetrahedra.",
                 {{"tetrahedra", "", "T"},
                  {"triangulations", "", "of the inputs, with the valences asked for"},
                  {"proved", "", "proved to carry the metric"},
                  {"in_doubles", "", "of these, in doubles alone"}}});
  std::string by_size;
  for (const auto& [tetrahedra, of] : counts) {
    summary.add(cells(tetrahedra, of.all, of.proved, of.in_doubles));
    by_size += fmt::format("{}{} of {} with {} tetrahedra", by_size.empty() ? "" : ", ", of.proved,
                           of.all, tetrahedra);
  }
  findings.tables.push_back(std::move(summary));
  findings.figures.push_back(radius_figure(table));
  findings.facts = {{"triangulations", double(total.all), "with the valences asked for"},
                    {"proved", double(total.proved), "proved to carry the metric"},
                    {"in_doubles", double(total.in_doubles), "proved in doubles alone"}};
  findings.paragraph =
      total.all == 0
          ? "No input has edge classes of these valences only."
          : fmt::format(
                "Of the triangulations whose edge classes all have the valences asked for, "
                "{} are proved to carry the metric: {}.{}",
                total.proved == total.all ? "all" : "not all", by_size,
                total.proved == total.all
                    ? ""
                    : " The table says for each of the others why it is not proved.");
  return findings;
}

}  // namespace

Plan plan_valence(const StudyOptions& options) {
  Plan plan;
  plan.tables = {valence_layout()};
  for (const StudyInput& input : options.inputs) {
    const topology::Triangulation triangulation(input.gluings);
    try {
      topology::require_geodesic_boundary(triangulation);
    } catch (const InvalidInput& error) {
      throw InvalidInput(tripus::quoted(input.name) + ": " + error.what());
    }
    if (least_valence(triangulation) < options.samples) continue;
    plan.items.push_back(
        {input.name, [input](const Stop& stop) { return prove_row(input, stop); }});
  }
  plan.conclude = valence_findings;
  return plan;
}

}  // namespace tripus::studies::detail
