// Many triangulations of one manifold, distinct by signature: which carry the metric, and how well.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "structure/solve.hpp"
#include "studies/detail/tables.hpp"
#include "studies/detail/theory_measurements.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"
#include "topology/requirements.hpp"

namespace tripus::studies::detail {
namespace {

/// Tetrahedra that the walks may add to those of the input.
constexpr std::size_t kExtra = 8;
constexpr std::size_t kWalksPerSample = 40;

/// A triangulation that a walk came to.
struct Found {
  std::string signature;
  std::size_t moves;
};

/// Distinct triangulations of the manifold by random walks of 1 to 3 T + 30 usual moves, each with
/// its own bound on T, so that small triangulations are not swamped by large ones.
std::vector<Found> find_triangulations(const StudyInput& input, const StudyOptions& options) {
  std::set<std::string> known;
  std::vector<Found> found;
  const std::size_t T = input.gluings.tetrahedron_count();
  for (std::size_t walk = 0;
       walk < kWalksPerSample * options.samples && found.size() < options.samples; ++walk) {
    if (options.stop.requested()) return {};
    Random random(item_seed(options.seed, fmt::format("{} walk {}", input.name, walk)));
    topology::Gluings gluings = input.gluings;
    std::size_t moves = 0;
    if (walk > 0) {
      topology::RandomMovesOptions moves_options;
      moves_options.count = 1 + random.bits() % (3 * T + 30);
      moves_options.seed = random.bits();
      moves_options.max_tetrahedra = T + 1 + random.bits() % kExtra;
      moves = topology::randomize(gluings, moves_options).size();
    }
    std::string signature = topology::isosig(gluings);
    if (known.insert(signature).second) found.push_back({std::move(signature), moves});
  }
  return found;
}

std::vector<Row> solve_rows(const std::string& input, const Found& found, const Stop& stop) {
  const topology::Triangulation m(topology::decode_isosig(found.signature));
  structure::SolveOptions options;
  options.stop = stop;
  const structure::Report report = structure::solve(m, options);
  std::size_t least = std::numeric_limits<std::size_t>::max(), most = 0, low = 0;
  for (std::size_t e = 0; e < m.edge_count(); ++e) {
    least = std::min(least, m.valence(e));
    most = std::max(most, m.valence(e));
    low += m.valence(e) <= 3;
  }
  const bool metric = report.outcome == structure::Outcome::kGeometric;
  const double none = std::numeric_limits<double>::quiet_NaN();
  double condition = none, shortest = none, longest = none, deepest = none;
  if (metric || report.outcome == structure::Outcome::kDegenerate) {
    const auto [low_end, high_end] =
        std::minmax_element(report.edge_lengths.begin(), report.edge_lengths.end());
    shortest = *low_end, longest = *high_end;
  }
  if (metric) {
    condition = spectrum(m, report.edge_lengths).condition();
    for (const auto& theta : report.dihedral_angles)
      for (const double angle : theta) deepest = std::fmin(deepest, angle);
  }
  std::string certificate = "none needed";
  if (report.certificate)
    certificate = report.certificate->kind == structure::Certificate::Kind::kNone
                      ? "no angle structure"
                      : "semi-angle structures only";
  return {{0, cells(input, found.signature, found.moves, m.tetrahedron_count(), m.edge_count(),
                    least, most, low, structure::to_string(report.outcome), certificate,
                    report.flat_tetrahedra.size(), metric ? cell(report.iterations) : std::string(),
                    metric ? report.volume : none, shortest, longest, deepest, condition,
                    report.seconds)}};
}

TableLayout triangulations_layout() {
  return {"triangulations",
          "One triangulation of the manifold, distinct from the others by its signature.",
          {{"input", "", "the triangulation that the walk started from"},
           {"isosig", "", "isomorphism signature"},
           {"moves", "", "random moves made"},
           {"tetrahedra", "", "T"},
           {"edges", "", "edge classes E"},
           {"least_valence", "", "of an edge class"},
           {"greatest_valence", "", "of an edge class"},
           {"low_valence_edges", "", "edge classes of valence 1, 2 or 3"},
           {"outcome", "", "geometric, degenerate (the boundary case), infeasible, unresolved"},
           {"certificate", "", "what was proved about angle structures"},
           {"flat_tetrahedra", "", "of the minimiser"},
           {"iterations", "", "of Newton's method, where there is a metric"},
           {"volume", "", "of the metric"},
           {"shortest", "", "shortest edge of the metric, or of the minimiser of a boundary case"},
           {"longest", "", "longest edge, the same"},
           {"least_angle", "radians", "least dihedral angle of the metric"},
           {"condition", "", "condition number of the Hessian of H at the metric"},
           {"seconds", "seconds", "to solve and decide", true}}};
}

}  // namespace

Plan plan_triangulations(const StudyOptions& options) {
  Plan plan;
  plan.tables = {triangulations_layout()};
  for (const StudyInput& input : options.inputs) {
    try {
      topology::require_geodesic_boundary(topology::Triangulation(input.gluings));
    } catch (const InvalidInput& error) {
      throw InvalidInput(tripus::quoted(input.name) + ": " + error.what());
    }
    for (const Found& found : find_triangulations(input, options)) {
      plan.items.push_back(
          {fmt::format("{} as {}", input.name, found.signature),
           [name = input.name, found](const Stop& stop) { return solve_rows(name, found, stop); }});
    }
  }
  plan.conclude = triangulations_findings;
  return plan;
}

}  // namespace tripus::studies::detail
