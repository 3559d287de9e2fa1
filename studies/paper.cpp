// The experiment of the paper's section 4, larger: does the flow from equal lengths converge, and
// how far are lengths, angles and volumes from an independent algebraic route?
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "canonical/canonize.hpp"
#include "canonical/census.hpp"
#include "structure/solve.hpp"
#include "studies/detail/algebraic_route.hpp"
#include "studies/detail/method_run.hpp"
#include "studies/detail/tables.hpp"
#include "topology/homology.hpp"
#include "topology/requirements.hpp"

namespace tripus::studies::detail {
namespace {

/// Largest errors of a report against the algebraic route; NaN where there is nothing to compare.
struct Errors {
  double length = std::numeric_limits<double>::quiet_NaN();
  double angle = length;
  double volume = length;
};

Errors errors_of(const structure::Report& report, const AlgebraicMetric& exact) {
  Errors errors;
  if (!exact.found || report.outcome != structure::Outcome::kGeometric) return errors;
  errors = {0, 0, std::fabs(report.volume - exact.volume)};
  for (std::size_t e = 0; e < exact.lengths.size(); ++e)
    errors.length = std::max(errors.length, std::fabs(report.edge_lengths[e] - exact.lengths[e]));
  for (std::size_t k = 0; k < exact.angles.size(); ++k)
    errors.angle =
        std::max(errors.angle, std::fabs(report.dihedral_angles[k / 6][k % 6] - exact.angles[k]));
  return errors;
}

std::string boundary_of(const topology::Triangulation& m) {
  std::vector<int> genera;
  for (std::size_t v = 0; v < m.vertex_count(); ++v) genera.push_back(m.link(v).genus());
  std::sort(genera.begin(), genera.end());
  std::string text;
  for (const int genus : genera) text += fmt::format("{}g{}", text.empty() ? "" : "+", genus);
  return text;
}

/// Which manifold it is, by the isometry signature; where the triangulation carries no metric, by
/// one that a few moves lead to. Empty if none was found.
struct Identity {
  std::string signature, cells, isometries;
  double volume = std::numeric_limits<double>::quiet_NaN();
};

Identity identify(const topology::Triangulation& m, const Stop& stop) {
  canonical::CanonizeOptions options;
  options.solve.stop = stop;
  options.solve.evidence = false;
  options.retriangulation.budget = canonical::kCensusBudget;
  const canonical::CanonizeAnswer answer = canonical::canonize(m, options);
  if (!answer.manifold) return {};
  const canonical::IsometryGroup& group = answer.manifold->isometries;
  return {answer.manifold->signature.unoriented, answer.manifold->cells,
          fmt::format("{} + {}", group.orientation_preserving,
                      group.order - group.orientation_preserving),
          answer.manifold->report.volume};
}

std::vector<Row> triangulation_rows(const StudyInput& input, const Stop& stop) {
  const topology::Triangulation m(input.gluings);
  structure::SolveOptions solve_options;
  solve_options.stop = stop;
  const structure::Report verdict = structure::solve(m, solve_options);
  const bool metric = verdict.outcome == structure::Outcome::kGeometric;
  const double none = std::numeric_limits<double>::quiet_NaN();
  structure::Report flow, newton;
  AlgebraicMetric exact;
  if (metric) {
    const std::vector<double> ones(m.edge_count(), 1.0);
    newton = run_method(m, "newton", ones, {.stop = stop}).report;
    // The paper's: explicit steps of dl/dt = K from equal lengths 1, to max|K| <= 1e-10.
    flow = run_method(m, "flow:curvature/euler", ones,
                      {.tolerance = 1e-10, .max_iterations = 100000, .stop = stop})
               .report;
    if (stop) return {};
    exact = solve_algebraically(m, stop);
  }
  if (stop) return {};
  const Identity identity = identify(m, stop);
  const Errors of_flow = metric ? errors_of(flow, exact) : Errors();
  const Errors of_newton = metric ? errors_of(newton, exact) : Errors();
  const bool flow_found = flow.outcome == structure::Outcome::kGeometric;
  return {{kTriangulations,
           cells(input.name, m.tetrahedron_count(), m.edge_count(), boundary_of(m),
                 topology::to_string(topology::first_homology(m)),
                 structure::to_string(verdict.outcome), metric ? (flow_found ? "yes" : "no") : "",
                 metric ? cell(flow.iterations) : std::string(),
                 metric ? cell(newton.iterations) : std::string(),
                 metric ? (exact.found ? "yes" : "no") : "", exact.found ? exact.residual : none,
                 exact.found ? exact.distance_bound : none,
                 exact.found ? exact.volume : (metric ? verdict.volume : identity.volume),
                 of_flow.length, of_flow.angle, of_flow.volume, of_newton.length, of_newton.angle,
                 of_newton.volume, identity.signature, identity.cells, identity.isometries)}};
}

TableLayout paper_layout() {
  return {
      "triangulations",
      "One triangulation. Where it carries a metric: the paper's flow and Newton's method "
      "against the algebraic route.",
      {{"input", "", "the triangulation"},
       {"tetrahedra", "", "T"},
       {"edges", "", "edge classes E"},
       {"boundary", "", "genera of the boundary components"},
       {"homology", "", "H1"},
       {"outcome", "", "of structure::solve"},
       {"flow_found", "", "whether the curvature flow from equal lengths 1 reached the metric"},
       {"flow_iterations", "", "explicit Euler steps to max|K| <= 1e-10"},
       {"newton_iterations", "",
        "steps of Newton's method from equal lengths 1 to max|K| <= 1e-12"},
       {"algebraic_found", "", "whether the algebraic route reached a solution by itself"},
       {"residual", "", "of the gluing equations in 60 digits"},
       {"distance_bound", "", "first-order bound of the distance in cosh l to a solution"},
       {"volume", "",
        "of the manifold, by the algebraic route; by Newton's method where that failed, and on a "
        "triangulation reached by moves where this one carries no metric"},
       {"flow_length_error", "", "largest error of a length, flow"},
       {"flow_angle_error", "radians", "largest error of an angle, flow"},
       {"flow_volume_error", "", "error of the volume, flow"},
       {"newton_length_error", "", "largest error of a length, Newton's method"},
       {"newton_angle_error", "radians", "largest error of an angle, Newton's method"},
       {"newton_volume_error", "", "error of the volume, Newton's method"},
       {"manifold", "", "isometry signature; empty if no metric was found by a few moves"},
       {"cells", "", "of the canonical decomposition"},
       {"isometries", "", "that keep + that reverse the orientation"}}};
}

}  // namespace

Plan plan_paper(const StudyOptions& options) {
  Plan plan;
  plan.tables = {paper_layout()};
  // A sample of the inputs, in their order.
  std::vector<std::size_t> chosen(options.inputs.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = i;
  Random random(item_seed(options.seed, "inputs"));
  for (std::size_t i = chosen.size(); i > 1; --i)
    std::swap(chosen[i - 1], chosen[random.bits() % i]);
  if (chosen.size() > options.samples) chosen.resize(options.samples);
  std::sort(chosen.begin(), chosen.end());
  for (const std::size_t i : chosen) {
    if (options.stop.requested()) return {};
    const StudyInput& input = options.inputs[i];
    try {
      topology::require_geodesic_boundary(topology::Triangulation(input.gluings));
    } catch (const InvalidInput& error) {
      throw InvalidInput(tripus::quoted(input.name) + ": " + error.what());
    }
    plan.items.push_back(
        {input.name, [input](const Stop& stop) { return triangulation_rows(input, stop); }});
  }
  plan.conclude = paper_findings;
  return plan;
}

}  // namespace tripus::studies::detail
