#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <tripus/tripus.hpp>

#include "orthospectrum/export/spots_svg.hpp"
#include "orthospectrum/identities.hpp"
#include "orthospectrum/proved_lengths.hpp"
#include "orthospectrum/spectrum.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::python {
namespace {

nb::object pair_of(const std::optional<orthospectrum::Estimate>& estimate) {
  if (!estimate) return nb::none();
  return nb::make_tuple(estimate->value, estimate->uncertainty);
}

nb::dict identity_dict(const orthospectrum::Identity& identity) {
  nb::dict d;
  d["counted"] = identity.counted;
  d["exact"] = identity.exact;
  d["tail"] = pair_of(identity.tail);
  return d;
}

void require_plain(const HeldMetric& self) {
  if (!topology::all_full(self.manifold.cone_angles()))
    throw Unsupported("the orthospectrum does not know cone angles other than 2 pi so far");
  topology::require_boundary_beside_cusps(self.manifold.triangulation());
}

}  // namespace

nb::dict orthospectrum_of(const HeldMetric& self, double length, std::size_t count,
                          double most_arcs, bool prove, const Limits& limits) {
  require_plain(self);
  orthospectrum::SpectrumOptions options;
  options.keep_faces = prove;
  options.length = length;
  options.count = count;
  options.most_arcs = most_arcs;
  const auto& triangulation = self.manifold.triangulation();
  const auto [spectrum, grouping, proved] = run(limits, [&](const Context& context) {
    auto found =
        orthospectrum::orthospectrum(triangulation, self.metric->edge_lengths(), options, context);
    auto groups = orthospectrum::group_arcs(found, triangulation);
    std::optional<orthospectrum::ProvedLengths> proofs;
    if (prove)
      proofs =
          orthospectrum::prove_lengths(triangulation, self.metric->edge_lengths(), found, context);
    return std::tuple(std::move(found), std::move(groups), std::move(proofs));
  });
  std::vector<double> lengths;
  std::vector<std::uint32_t> ends;
  std::vector<std::uint64_t> multiplicities;
  nb::list edges;
  for (const auto& group : grouping.groups) {
    lengths.push_back(group.length);
    ends.insert(ends.end(), group.ends.begin(), group.ends.end());
    multiplicities.push_back(group.multiplicity);
    std::vector<std::uint32_t> classes;
    for (std::size_t i = group.first; i < group.first + group.multiplicity; ++i)
      if (const auto edge = spectrum.arcs[grouping.order[i]].edge; edge != orthospectrum::kNoEdge)
        classes.push_back(edge);
    std::ranges::sort(classes);
    edges.append(classes);
  }
  double area = 0;
  for (const auto& vertex : self.metric->boundary())
    if (vertex.kind == topology::VertexKind::kHyperideal) area += vertex.area;
  const auto identities =
      orthospectrum::identities_of(spectrum.sums, spectrum.length, area, self.metric->volume());
  nb::dict d;
  d["complete"] = spectrum.end == orthospectrum::SpectrumEnd::kComplete;
  d["length"] = spectrum.length;
  d["arc_count"] = spectrum.arc_count;
  d["lengths"] = owned(std::move(lengths));
  d["multiplicities"] = owned(std::move(multiplicities));
  d["ends"] = owned(std::move(ends), {grouping.groups.size(), 2});
  d["edges"] = edges;
  d["area"] = identity_dict(identities.area);
  d["volume"] = identity_dict(identities.volume);
  d["volume_from_area"] = pair_of(identities.volume_from_area);
  d["dimension"] = pair_of(identities.dimension);
  d["return_time"] =
      nb::make_tuple(pair_of(identities.return_time[0]), pair_of(identities.return_time[1]));
  if (!proved) return d;
  nb::list intervals;
  for (const auto& group : grouping.groups) {
    const auto interval = proved->of(grouping, group);
    intervals.append(interval ? nb::object(nb::make_tuple(interval->lower, interval->upper))
                              : nb::object(nb::none()));
  }
  d["proved_lengths"] = intervals;
  d["why_not_proved"] = proved->reason;
  return d;
}

/// For each end of each arc: tetrahedron and vertex of its truncation triangle [n x 2], foot [n x
/// 2] in the projective model of the triangle's plane, length, radius of the disc [n]; the length
/// up to which all are there.
nb::tuple discs_of(const HeldMetric& self, double length, double most_arcs, const Limits& limits) {
  require_plain(self);
  orthospectrum::SpectrumOptions options;
  options.length = length;
  options.most_arcs = most_arcs;
  const auto spectrum = run(limits, [&](const Context& context) {
    return orthospectrum::orthospectrum(self.manifold.triangulation(), self.metric->edge_lengths(),
                                        options, context);
  });
  std::vector<std::uint32_t> tiles;
  std::vector<double> feet, lengths, radii;
  for (const orthospectrum::Arc& arc : spectrum.arcs)
    for (const orthospectrum::ArcEnd& end : {arc.start, arc.end}) {
      tiles.insert(tiles.end(), {end.tile.tetrahedron, end.tile.vertex});
      feet.insert(feet.end(), {end.x, end.y});
      lengths.push_back(arc.length);
      radii.push_back(orthospectrum::disc_radius(arc.length));
    }
  const std::size_t count = lengths.size();
  return nb::make_tuple(owned(std::move(tiles), {count, 2}), owned(std::move(feet), {count, 2}),
                        owned(std::move(lengths)), owned(std::move(radii)), spectrum.length);
}

/// The boundary covered by the discs of the arcs up to a length, as SVG.
nb::str spots_svg(const HeldMetric& self, double length, const Limits& limits) {
  require_plain(self);
  const std::string svg = run(limits, [&](const Context& context) {
    const auto& triangulation = self.manifold.triangulation();
    const auto lengths = self.metric->edge_lengths();
    orthospectrum::SpectrumOptions options;
    options.length = length;
    const auto spectrum = orthospectrum::orthospectrum(triangulation, lengths, options, context);
    return orthospectrum::spots_as_svg(triangulation, lengths, spectrum, self.manifold.label());
  });
  return nb::str(svg.data(), svg.size());
}

}  // namespace tripus::python
