#include "orthospectrum/proved_lengths.hpp"

#include <algorithm>

#include "structure/proof/arc_lengths.hpp"

namespace tripus::orthospectrum {

std::optional<structure::Interval> ProvedLengths::of(const Grouping& grouping,
                                                     const ArcGroup& group) const {
  std::optional<structure::Interval> hull;
  for (std::size_t n = group.first; n < group.first + group.multiplicity; ++n) {
    const std::size_t arc = grouping.order[n];
    if (arc >= arcs.size() || !arcs[arc]) return std::nullopt;
    if (!hull) hull = arcs[arc];
    hull->lower = std::min(hull->lower, arcs[arc]->lower);
    hull->upper = std::max(hull->upper, arcs[arc]->upper);
  }
  return hull;
}

ProvedLengths prove_lengths(const topology::Triangulation& triangulation,
                            std::span<const double> edge_lengths, const Spectrum& spectrum,
                            const Context& context) {
  structure::ProveOptions options;
  options.volume = false;
  const structure::Proof proof = structure::prove(triangulation, edge_lengths, options, context);
  ProvedLengths result;
  if (!proof.proved) {
    result.reason = "the metric is not proved: " + proof.reason;
    return result;
  }
  std::vector<structure::ArcPath> paths;
  paths.reserve(spectrum.arcs.size());
  for (const Arc& arc : spectrum.arcs)
    paths.push_back({arc.start.tile.tetrahedron, static_cast<int>(arc.start.tile.vertex),
                     std::span(spectrum.faces).subspan(arc.first_face, arc.face_count),
                     static_cast<int>(arc.end.tile.vertex)});
  result.arcs = structure::prove_arc_lengths(triangulation, proof, paths, context);
  const auto open = std::ranges::count_if(result.arcs, [](const auto& arc) { return !arc; });
  result.proved = open == 0;
  if (!result.proved)
    result.reason = std::to_string(open) + " of " + std::to_string(result.arcs.size()) +
                    " lengths are not proved: the rounding does not tell their planes apart, or "
                    "the time was over";
  return result;
}

}  // namespace tripus::orthospectrum
