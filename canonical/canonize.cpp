#include "canonical/canonize.hpp"

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "topology/isosig.hpp"
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
    sum += report.edge_lengths[e] * (report.max_curvature + rounding);
  }
  return sum / 2 + 64 * std::numeric_limits<double>::epsilon() *
                       static_cast<double>(triangulation.tetrahedron_count());
}

}  // namespace

std::optional<CanonicalManifold> canonize_metric(const Triangulation& triangulation,
                                                 const Report& report,
                                                 const ProtoCanonicalOptions& options) {
  ProtoCanonical proto = proto_canonical(triangulation, report, options);
  if (!proto.found) return std::nullopt;
  Decomposition decomposition(proto.triangulation.gluings(), proto.faces);
  CanonicalOrder order = canonical_order(decomposition);
  IsometryGroup isometries =
      isometry_group(decomposition, order, proto.triangulation.vertex_count());
  IsometrySignature signature =
      isometry_signature(decomposition, order, isometries.is_amphicheiral);
  std::string cells = describe_cells(decomposition);
  const double error = volume_error(proto.triangulation, proto.report);
  return CanonicalManifold{.triangulation = std::move(proto.triangulation),
                           .report = std::move(proto.report),
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
    if (sides >= 2 * 3) lengths.push_back(manifold.report.edge_lengths[e]);
  }
  std::ranges::sort(lengths);
  return lengths;
}

namespace {

constexpr const char* kNotCanonical =
    "The metric was found, but no triangulation that subdivides the canonical decomposition.";

/// A triangulation that carries the metric, and how it was reached.
struct Metric {
  Triangulation triangulation;
  Report report;
  std::string simplified;
  std::vector<topology::Move> path;
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
      answer_.message = kNotCanonical;
      return std::move(answer_);
    }
    answer_.manifold->simplified = std::move(metric->simplified);
    auto& whole = answer_.manifold->path;
    whole.insert(whole.begin(), metric->path.begin(), metric->path.end());
    answer_.message = "The canonical decomposition has " + answer_.manifold->cells + ".";
    return std::move(answer_);
  }

 private:
  bool stopped() const { return solve_.stop_requested != nullptr && solve_.stop_requested->load(); }

  std::optional<CanonicalManifold> canonical_of(const Metric& metric) const {
    ProtoCanonicalOptions proto = options_.proto_canonical;
    if (proto.stop_requested == nullptr) proto.stop_requested = solve_.stop_requested;
    try {
      return canonize_metric(metric.triangulation, metric.report, proto);
    } catch (const InternalError&) {
      // Tilts that contradict each other: by rounding, if another triangulation agrees.
      if (!metric.simplified.empty() || !options_.retriangulate) throw;
      return std::nullopt;
    }
  }

  std::optional<Metric> find_metric() {
    topology::require_geodesic_boundary(input_);
    const Gluings gluings = topology::oriented(input_.gluings());
    // Vertices and edges keep their numbers only if the labels did not change.
    Triangulation triangulation = gluings == input_.gluings() ? input_ : Triangulation(gluings);
    answer_.report = structure::solve(triangulation, solve_);
    if (answer_.report.outcome == Outcome::kGeometric)
      return Metric{std::move(triangulation), answer_.report, {}, {}};
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
                  std::move(found.simplified), std::move(found.path)};
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
