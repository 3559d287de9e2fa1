#include "structure/proof/tilt_signs.hpp"

#include <algorithm>
#include <optional>

#include "geometry/edge_frames.hpp"
#include "geometry/enclosure_formulae.hpp"
#include "structure/proof/detail/decimal.hpp"
#include "structure/proof/detail/horosphere_areas.hpp"
#include "structure/proof/digits.hpp"

namespace tripus::structure {
namespace {

using detail::Arb;
using topology::Triangulation;

constexpr int kFewBits = 96;
constexpr int kManyDigits = 50;
constexpr int kManyBits = 256;

using Signs = std::vector<std::array<ProvedSign, 4>>;

/// A tilt as horospheres shrink, docs/canonical.md (T7). Without hyperideal vertices `geodesic` is
/// exactly 0, without ideal ones `cusp`.
struct Tilt {
  Arb geodesic, cusp;
};
using Tilts = std::array<Tilt, 4>;

/// t_i = (p_i - sum_j c_ij) / sqrt(p_i D), docs/canonical.md (T3), by the kinds of the vertices j.
Tilts tilts_of(const std::array<Arb, 6>& l, const detail::Diagonal& diagonal) {
  const detail::GramEntries entries = detail::gram_entries(l, diagonal);
  const auto gram = geometry::gram_enclosure(entries.c, entries.s, detail::gram_diagonal(diagonal));
  Tilts tilts;
  for (int i = 0; i < 4; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Arb scale = Arb(1.0) / square_root(gram.minor[at] * gram.minus_det);
    for (int j = 0; j < 4; ++j) {
      Arb& sum = diagonal[static_cast<std::size_t>(j)] == 1 ? tilts[at].geodesic : tilts[at].cusp;
      // The cofactor c_ij belongs to the edge opposite ij.
      sum = sum +
            scale * (j == i ? gram.minor[at] : -gram.cofactor[5 - geometry::kEdgeBetween[i][j]]);
    }
  }
  return tilts;
}

/// The class of the edges that join the vertex v of tetrahedron t, which is ideal, to the three
/// others, if these are hyperideal and the edges of one class.
std::optional<std::uint32_t> class_of_spokes(const detail::ConeMetric& metric, std::size_t t,
                                             int v) {
  const detail::Diagonal diagonal = metric.diagonal(t);
  std::optional<std::uint32_t> common;
  for (int j = 0; j < 4; ++j) {
    if (j == v) {
      if (diagonal[static_cast<std::size_t>(j)] != 0) return std::nullopt;
      continue;
    }
    const std::uint32_t edge = metric.triangulation().edge_class(t, geometry::kEdgeBetween[v][j]);
    if (diagonal[static_cast<std::size_t>(j)] != 1 || common.value_or(edge) != edge)
      return std::nullopt;
    common = edge;
  }
  return common;
}

/// Whether the first terms across face f of tetrahedron t are known to add up to 0: all vertices
/// on both sides are hyperideal and equally far from one cusp of the face. docs/theory.md (102).
bool is_flat_in_the_limit(const detail::ConeMetric& metric, std::size_t t, int f) {
  const topology::Gluings& gluings = metric.triangulation().gluings();
  const topology::Perm4 gluing = gluings.gluing(t, f);
  for (int v = 0; v < 4; ++v) {
    if (v == f) continue;
    const auto here = class_of_spokes(metric, t, v);
    if (here && here == class_of_spokes(metric, gluings.neighbour(t, f), gluing(v))) return true;
  }
  return false;
}

ProvedSign sign_of(const Tilt& a, const Tilt& b, bool flat_in_the_limit) {
  const Arb geodesic = a.geodesic + b.geodesic, cusp = a.cusp + b.cusp;
  const Arb& first = flat_in_the_limit || arb_is_zero(geodesic.get()) != 0 ? cusp : geodesic;
  return first.negative()   ? ProvedSign::kNegative
         : first.positive() ? ProvedSign::kPositive
                            : ProvedSign::kUnknown;
}

/// Settles what is unknown from lengths [E] for horospheres of one area. Returns whether all is
/// known then.
bool settle(const detail::ConeMetric& metric, const std::vector<Arb>& lengths,
            const Context& context, Signs& signs) {
  const Triangulation& triangulation = metric.triangulation();
  std::vector<Tilts> tilts(signs.size());
  std::vector<char> known(signs.size());
  const auto tilt = [&](std::size_t t, int f) -> const Tilt& {
    if (known[t] == 0) {
      tilts[t] = tilts_of(detail::lengths_of(triangulation, lengths, t), metric.diagonal(t));
      known[t] = 1;
    }
    return tilts[t][static_cast<std::size_t>(f)];
  };
  bool all = true;
  const topology::Gluings& gluings = triangulation.gluings();
  for (std::size_t t = 0; t < signs.size(); ++t) {
    if (context.stop_requested() || context.expired()) return true;
    for (int f = 0; f < 4; ++f) {
      ProvedSign& here = signs[t][static_cast<std::size_t>(f)];
      if (here != ProvedSign::kUnknown) continue;
      const std::size_t other = gluings.neighbour(t, f);
      const int face = gluings.gluing(t, f)(f);
      here = sign_of(tilt(t, f), tilt(other, face), is_flat_in_the_limit(metric, t, f));
      signs[other][static_cast<std::size_t>(face)] = here;
      all = all && here != ProvedSign::kUnknown;
    }
  }
  return all;
}

}  // namespace

Signs tilt_signs(const Triangulation& triangulation, const Proof& proof, const Context& context) {
  Signs signs(triangulation.tetrahedron_count());
  if (!proof.proved || proof.claim != Proof::Claim::kMetric) return signs;
  const detail::ConeMetric metric(triangulation, proof.cone_angles);
  {
    const detail::Precision precision(kFewBits);
    std::vector<Arb> lengths;
    for (std::size_t e = 0; e < proof.lengths.size(); ++e)
      lengths.push_back(Arb(proof.lengths[e]).widened(proof.radii[e]));
    detail::equalise_horospheres(metric, lengths);
    if (settle(metric, lengths, context, signs)) return signs;
  }
  const Digits digits = prove_digits(triangulation, proof, kManyDigits, context);
  if (!digits.proved) return signs;
  const detail::Precision precision(kManyBits);
  std::vector<Arb> lengths;
  for (std::size_t e = 0; e < digits.lengths.size(); ++e)
    lengths.push_back(
        detail::from_decimal(digits.lengths[e]).widened_by(detail::from_decimal(digits.radii[e])));
  detail::equalise_horospheres(metric, lengths);
  settle(metric, lengths, context, signs);
  return signs;
}

}  // namespace tripus::structure
