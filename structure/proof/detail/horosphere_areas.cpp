#include "structure/proof/detail/horosphere_areas.hpp"

#include <array>

#include "geometry/edge_frames.hpp"
#include "structure/horospheres.hpp"

namespace tripus::structure::detail {
namespace {

using geometry::kEdgeBetween;

/// The square of the arc in which the horosphere at vertex i meets the face ijk, theory (80).
Arb arc_squared(const GramEntries& g, const Diagonal& d, int i, int j, int k) {
  const Arb &ij = g.c[kEdgeBetween[i][j]], &ik = g.c[kEdgeBetween[i][k]],
            &jk = g.c[kEdgeBetween[j][k]];
  const auto at = [&](int v) { return static_cast<double>(d[static_cast<std::size_t>(v)]); };
  return at(j) * (Arb(1.0) / square(ij)) + at(k) * (Arb(1.0) / square(ik)) + 2.0 * (jk / (ij * ik));
}

/// The area of the link triangle at an ideal vertex, from its three sides a, b, c (Heron):
/// 16 area^2 = 4 a^2 b^2 - (a^2 + b^2 - c^2)^2.
Arb link_area(const GramEntries& g, const Diagonal& d, int i) {
  const int j = i == 0 ? 1 : 0, k = i <= 1 ? 2 : 1, l = i <= 2 ? 3 : 2;
  const Arb a = arc_squared(g, d, i, j, k), b = arc_squared(g, d, i, k, l);
  const Arb c = arc_squared(g, d, i, j, l);
  return 0.25 * square_root(4.0 * (a * b) - square(a + b - c));
}

}  // namespace

void equalise_horospheres(const ConeMetric& metric, std::vector<Arb>& lengths) {
  const topology::Triangulation& triangulation = metric.triangulation();
  if (metric.pins().empty()) return;
  std::vector<Arb> area(triangulation.vertex_count());
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    const Diagonal diagonal = metric.diagonal(t);
    const GramEntries entries = gram_entries(lengths_of(triangulation, lengths, t), diagonal);
    for (int v = 0; v < 4; ++v) {
      if (diagonal[static_cast<std::size_t>(v)] != 0) continue;
      Arb& sum = area[triangulation.vertex_class(t, v)];
      sum = sum + link_area(entries, diagonal, v);
    }
  }
  // Moving a horosphere by s takes e^(-2 s) from its area.
  for (Arb& a : area) {
    if (arb_is_zero(a.get()) != 0) continue;
    a = a / Arb(kHorosphereArea);
    arb_log(a.get(), a.get(), Precision::bits());
    a = 0.5 * a;
  }
  for (std::size_t e = 0; e < lengths.size(); ++e)
    for (const std::size_t v : metric.ends(e)) lengths[e] = lengths[e] + area[v];
}

}  // namespace tripus::structure::detail
