#include "canonical/canonize.hpp"

#include <cmath>
#include <limits>

#include "topology/isomorphism.hpp"

namespace tripus::canonical {
namespace {

using structure::Outcome;
using structure::Report;
using topology::Gluings;
using topology::Perm4;
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

Gluings oriented(const Gluings& gluings) {
  constexpr Perm4 kSwap = Perm4::from_images(0, 1, 3, 2);
  const std::size_t count = gluings.tetrahedron_count();
  topology::Isomorphism relabelling;
  relabelling.perms.resize(count);
  std::vector<char> seen(count);
  std::vector<std::size_t> todo;
  for (std::size_t t = 0; t < count; ++t)
    relabelling.tetrahedron_images.push_back(static_cast<topology::TetrahedronIndex>(t));
  for (std::size_t start = 0; start < count; ++start) {
    if (seen[start]) continue;
    seen[start] = 1;
    todo.push_back(start);
    while (!todo.empty()) {
      const std::size_t t = todo.back();
      todo.pop_back();
      for (int f = 0; f < 4; ++f) {
        const std::size_t other = gluings.neighbour(t, f);
        const bool same = gluings.gluing(t, f).is_odd();
        const Perm4 wanted = same == (relabelling.perms[t] == Perm4()) ? Perm4() : kSwap;
        if (seen[other] && relabelling.perms[other] != wanted) return gluings;
        if (!seen[other]) todo.push_back(other);
        seen[other] = 1;
        relabelling.perms[other] = wanted;
      }
    }
  }
  return topology::relabelled(gluings, relabelling);
}

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
  return CanonicalManifold{std::move(proto.triangulation),
                           std::move(proto.report),
                           error,
                           std::move(proto.faces),
                           std::move(proto.path),
                           std::move(decomposition),
                           std::move(order),
                           std::move(isometries),
                           std::move(signature),
                           std::move(cells)};
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

CanonizeAnswer canonize(const Triangulation& input, const CanonizeOptions& options) {
  CanonizeAnswer answer;
  structure::SolveOptions solve = options.solve;
  solve.evidence = false;
  const Gluings gluings = oriented(input.gluings());
  // Vertices and edges keep their numbers only if the labels did not change.
  const Triangulation triangulation = gluings == input.gluings() ? input : Triangulation(gluings);
  answer.report = structure::solve(triangulation, solve);
  std::vector<topology::Move> path;
  if (answer.report.outcome == Outcome::kGeometric) {
    answer.manifold = canonize_metric(triangulation, answer.report, options.proto_canonical);
  } else if (options.retriangulate) {
    structure::Retriangulation found =
        structure::retriangulate(triangulation, answer.report, solve, options.retriangulation);
    if (found.report.outcome != Outcome::kGeometric) {
      answer.message = found.report.message;
      return answer;
    }
    answer.manifold = canonize_metric(Triangulation(std::move(found.gluings)), found.report,
                                      options.proto_canonical);
    path = std::move(found.path);
  } else {
    answer.message = answer.report.message;
    return answer;
  }
  if (!answer.manifold) {
    answer.message =
        "The metric was found, but no triangulation that subdivides the canonical decomposition.";
    return answer;
  }
  auto& whole = answer.manifold->path;
  whole.insert(whole.begin(), path.begin(), path.end());
  answer.message = "The canonical decomposition has " + answer.manifold->cells + ".";
  return answer;
}

}  // namespace tripus::canonical
