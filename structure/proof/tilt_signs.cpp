#include "structure/proof/tilt_signs.hpp"

#include <algorithm>

#include "geometry/edge_frames.hpp"
#include "geometry/enclosure_formulae.hpp"
#include "structure/proof/detail/decimal.hpp"
#include "structure/proof/digits.hpp"

namespace tripus::structure {
namespace {

using detail::Arb;
using topology::Triangulation;

constexpr int kFewBits = 96;
constexpr int kManyDigits = 50;
constexpr int kManyBits = 256;

using Tilts = std::array<Arb, 4>;
using Signs = std::vector<std::array<ProvedSign, 4>>;

/// t_i = (p_i - sum_j c_ij) / sqrt(p_i D), docs/canonical.md (T3).
Tilts tilts_of(const std::array<Arb, 6>& l) {
  Arb cosh[6], sinh[6];
  for (std::size_t e = 0; e < 6; ++e)
    arb_sinh_cosh(sinh[e].get(), cosh[e].get(), l[e].get(), detail::Precision::bits());
  const auto gram = geometry::gram_enclosure(cosh, sinh);
  Tilts tilts;
  for (int i = 0; i < 4; ++i) {
    const auto at = static_cast<std::size_t>(i);
    Arb row = gram.minor[at];
    for (int j = 0; j < 4; ++j)
      // The cofactor c_ij belongs to the edge opposite ij.
      if (j != i) row = row - gram.cofactor[5 - geometry::kEdgeBetween[i][j]];
    tilts[at] = row / square_root(gram.minor[at] * gram.minus_det);
  }
  return tilts;
}

/// Settles what is unknown from lengths [E]. Returns whether all is known then.
bool settle(const Triangulation& triangulation, const std::vector<Arb>& lengths,
            const Context& context, Signs& signs) {
  std::vector<Tilts> tilts(signs.size());
  std::vector<char> known(signs.size());
  const auto tilt = [&](std::size_t t, int f) -> const Arb& {
    if (known[t] == 0) {
      std::array<Arb, 6> l;
      for (std::size_t e = 0; e < 6; ++e)
        l[e] = lengths[triangulation.edge_class(t, static_cast<int>(e))];
      tilts[t] = tilts_of(l);
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
      const Arb sum = tilt(t, f) + tilt(other, face);
      here = sum.negative()   ? ProvedSign::kNegative
             : sum.positive() ? ProvedSign::kPositive
                              : ProvedSign::kUnknown;
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
  {
    const detail::Precision precision(kFewBits);
    std::vector<Arb> lengths;
    for (std::size_t e = 0; e < proof.lengths.size(); ++e)
      lengths.push_back(Arb(proof.lengths[e]).widened(proof.radii[e]));
    if (settle(triangulation, lengths, context, signs)) return signs;
  }
  const Digits digits = prove_digits(triangulation, proof, kManyDigits, context);
  if (!digits.proved) return signs;
  const detail::Precision precision(kManyBits);
  std::vector<Arb> lengths;
  for (std::size_t e = 0; e < digits.lengths.size(); ++e)
    lengths.push_back(
        detail::from_decimal(digits.lengths[e]).widened_by(detail::from_decimal(digits.radii[e])));
  settle(triangulation, lengths, context, signs);
  return signs;
}

}  // namespace tripus::structure
