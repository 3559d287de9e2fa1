#include "canonical/canonize.hpp"

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "topology/isosig.hpp"
#include "topology/labelled_isosig.hpp"
#include "topology/orientation.hpp"
#include "topology/requirements.hpp"

namespace tripus::canonical {
namespace {

using structure::Outcome;
using structure::Report;
using topology::Gluings;
using topology::Triangulation;

/// docs/canonical.md (T6): |dV| <= 1/2 sum l |d theta|, and rounding.
double volume_error(const Triangulation& triangulation, const Report& report) {
  double sum = 0;
  for (std::size_t e = 0; e < report.edge_lengths.size(); ++e) {
    const double rounding =
        8 * std::numeric_limits<double>::epsilon() * static_cast<double>(triangulation.valence(e));
    sum += std::fabs(report.edge_lengths[e]) * (report.max_curvature + rounding);
  }
  return sum / 2 + 64 * std::numeric_limits<double>::epsilon() *
                       static_cast<double>(triangulation.tetrahedron_count());
}

}  // namespace

void require_canonizable(const Triangulation& triangulation,
                         std::span<const topology::ConeAngle> cone_angles) {
  topology::require_solvable(triangulation, cone_angles);
  const auto links = topology::orbifold_links(triangulation, cone_angles);
  for (std::size_t v = 0; v < links.size(); ++v) {
    if (links[v].kind != topology::VertexKind::kFinite) continue;
    throw Unsupported(topology::link_place(triangulation, v) +
                      " is a sphere, so this is a finite vertex, and the canonical decomposition "
                      "needs geodesic boundary or cusps; simplify first to remove it, if the "
                      "manifold is not closed");
  }
}

std::optional<CanonicalManifold> canonize_metric(const Triangulation& triangulation,
                                                 const Report& report,
                                                 const ProtoCanonicalOptions& options) {
  ProtoCanonical proto = proto_canonical(triangulation, report, options);
  if (!proto.found) return std::nullopt;
  if (edge_inside_cell(proto.triangulation, proto.faces, proto.cone_angles)) return std::nullopt;
  Decomposition decomposition(proto.triangulation.gluings(), proto.faces, proto.cone_angles);
  CanonicalOrder order = canonical_order(decomposition, options.stop);
  IsometryGroup isometries =
      isometry_group(decomposition, order, proto.triangulation.vertex_count());
  IsometrySignature signature =
      isometry_signature(decomposition, order, isometries.is_amphicheiral);
  std::string cells = describe_cells(decomposition);
  const double error = volume_error(proto.triangulation, proto.report);
  return CanonicalManifold{.triangulation = std::move(proto.triangulation),
                           .report = std::move(proto.report),
                           .cone_angles = std::move(proto.cone_angles),
                           .volume_error = error,
                           .faces = std::move(proto.faces),
                           .simplified = {},
                           .path = std::move(proto.path),
                           .decomposition = std::move(decomposition),
                           .order = std::move(order),
                           .isometries = std::move(isometries),
                           .signature = std::move(signature),
                           .cells = std::move(cells)};
}

std::vector<double> cell_edge_lengths(const CanonicalManifold& manifold) {
  std::vector<double> lengths;
  for (std::size_t e = 0; e < manifold.triangulation.edge_count(); ++e) {
    // Around the edge every face is met from the two tetrahedra beside it.
    std::size_t sides = 0;
    for (const topology::EdgeCorner& corner : manifold.triangulation.corners(e)) {
      const auto& ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
      for (int f = 0; f < 4; ++f) {
        if (f == ends[0] || f == ends[1]) continue;
        sides += manifold.faces.kind[corner.tetrahedron()][static_cast<std::size_t>(f)] ==
                 FaceKind::kTrue;
      }
    }
    const bool labelled = !manifold.cone_angles.empty() && !manifold.cone_angles[e].is_full();
    if (labelled || sides >= 2 * 3) lengths.push_back(manifold.report.edge_lengths[e]);
  }
  std::ranges::sort(lengths);
  return lengths;
}

namespace {

constexpr const char* kNotCanonical =
    "The metric was found, but no triangulation that subdivides the canonical decomposition.";

constexpr const char* kNotDone =
    "The metric was found, but the work was ended before the canonical decomposition was.";

constexpr const char* kSingularEdgeInside =
    "The metric was found, but no triangulation that subdivides the canonical decomposition and "
    "has the singular edges in its faces; they may go through the inside of cells.";

/// A triangulation that carries the metric, and how it was reached.
struct Metric {
  Triangulation triangulation;
  Report report;
  std::string simplified;
  std::vector<topology::Move> path;
  std::vector<topology::ConeAngle> cone_angles;
};

class Canonizer {
 public:
  Canonizer(const Triangulation& input, const CanonizeOptions& options)
      : input_(input), options_(options), solve_(options.solve) {
    solve_.evidence = false;
  }

  CanonizeAnswer run() {
    auto metric = find_metric();
    if (!metric) return without_metric();
    answer_.manifold = canonical_of(*metric);
    const bool is_own = metric->simplified.empty() && metric->path.empty();
    if (!answer_.manifold && is_own && options_.retriangulate && !stopped()) {
      // Nearly flat tetrahedra spoil the tilts, whose moves then go in circles: from a smaller
      // triangulation it is another way.
      Report start = metric->report;
      start.outcome = Outcome::kUnresolved;
      auto other = by_moves(metric->triangulation, std::move(start));
      if (other) metric = std::move(other);
      if (metric && !metric->simplified.empty()) answer_.manifold = canonical_of(*metric);
    }
    if (!answer_.manifold) {
      answer_.message = stopped()                                        ? kNotDone
                        : topology::all_full(options_.solve.cone_angles) ? kNotCanonical
                                                                         : kSingularEdgeInside;
      return std::move(answer_);
    }
    answer_.manifold->simplified = std::move(metric->simplified);
    auto& whole = answer_.manifold->path;
    whole.insert(whole.begin(), metric->path.begin(), metric->path.end());
    answer_.message = "The canonical decomposition has " + answer_.manifold->cells + ".";
    return std::move(answer_);
  }

 private:
  bool stopped() const { return solve_.stop.requested(); }

  std::optional<CanonicalManifold> canonical_of(const Metric& metric) const {
    ProtoCanonicalOptions proto = options_.proto_canonical;
    proto.cone_angles = metric.cone_angles;
    if (!proto.stop.possible()) proto.stop = solve_.stop;
    try {
      return canonize_metric(metric.triangulation, metric.report, proto);
    } catch (const Stopped&) {
      return std::nullopt;
    } catch (const InternalError&) {
      // Tilts that contradict each other: by rounding, if another triangulation agrees.
      if (!metric.simplified.empty() || !options_.retriangulate) throw;
      return std::nullopt;
    }
  }

  std::optional<Metric> find_metric() {
    require_canonizable(input_, solve_.cone_angles);
    const Gluings gluings = topology::oriented(input_.gluings());
    // Vertices and edges keep their numbers only if the labels did not change.
    const bool same = gluings == input_.gluings();
    Triangulation triangulation = same ? input_ : Triangulation(gluings);
    if (!same)
      solve_.cone_angles =
          topology::oriented_edges(input_, options_.solve.cone_angles, triangulation);
    answer_.report = structure::solve(triangulation, solve_);
    if (answer_.report.outcome == Outcome::kGeometric)
      return Metric{std::move(triangulation), answer_.report, {}, {}, solve_.cone_angles};
    if (!options_.retriangulate) {
      answer_.message = answer_.report.message;
      return std::nullopt;
    }
    return by_moves(triangulation, answer_.report);
  }

  /// Another triangulation of the manifold that carries the metric.
  std::optional<Metric> by_moves(const Triangulation& triangulation, Report start) {
    structure::Retriangulation found =
        structure::retriangulate(triangulation, std::move(start), solve_, options_.retriangulation);
    if (found.report.outcome != Outcome::kGeometric) {
      answer_.message = found.report.message;
      answer_.advice = found.report.advice;
      return std::nullopt;
    }
    return Metric{Triangulation(std::move(found.gluings)), std::move(found.report),
                  std::move(found.simplified), std::move(found.path), std::move(found.cone_angles)};
  }

  CanonizeAnswer without_metric() {
    if (options_.solve.evidence) answer_.report = structure::solve(input_, options_.solve);
    return std::move(answer_);
  }

  const Triangulation& input_;
  const CanonizeOptions& options_;
  structure::SolveOptions solve_;
  CanonizeAnswer answer_;
};

}  // namespace

CanonizeAnswer canonize(const Triangulation& input, const CanonizeOptions& options) {
  return Canonizer(input, options).run();
}

}  // namespace tripus::canonical
