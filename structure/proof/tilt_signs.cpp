#include "structure/proof/tilt_signs.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/edge_frames.hpp"
#include "geometry/enclosure_formulae.hpp"
#include "structure/proof/detail/arb_number.hpp"
#include "structure/proof/detail/cone_metric.hpp"
#include "structure/proof/detail/exact_metric.hpp"
#include "structure/proof/digits.hpp"

namespace tripus::structure {
namespace {

using detail::Arb;
using topology::Triangulation;

constexpr int kFewBits = 96;
constexpr int kManyDigits = 50;
constexpr int kManyBits = 256;
/// Degrees of number fields and digits with which they are looked for. A number of degree n with
/// coefficients of h digits takes some n h digits to be told from chance.
struct Rung {
  int degree, digits;
};
constexpr std::array<Rung, 4> kRungs = {{{4, 80}, {8, 240}, {16, 700}, {24, 1500}}};
constexpr double kBitsOfDigit = 3.32192809488736235;

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

ProvedSign sign_of(const Arb& x) {
  return x.negative()   ? ProvedSign::kNegative
         : x.positive() ? ProvedSign::kPositive
                        : ProvedSign::kUnknown;
}

/// What is unknown of the signs [T x 4], settled by one face after the other.
class Settler {
 public:
  Settler(const detail::ConeMetric& metric, Signs& signs) : metric_(metric), signs_(signs) {}

  /// From lengths [E] for horospheres of one area, and where the metric is known exactly from that.
  /// Returns whether all is known then.
  bool settle(const std::vector<Arb>& lengths, const detail::ExactMetric* exact,
              const Context& context) {
    const Triangulation& triangulation = metric_.triangulation();
    tilts_.assign(signs_.size(), std::nullopt);
    bool all = true;
    const topology::Gluings& gluings = triangulation.gluings();
    for (std::size_t t = 0; t < signs_.size(); ++t) {
      if (context.stop_requested() || context.expired()) return true;
      for (int f = 0; f < 4; ++f) {
        ProvedSign& here = signs_[t][static_cast<std::size_t>(f)];
        if (here != ProvedSign::kUnknown) continue;
        here = sign(t, f, lengths, exact);
        const auto face = static_cast<std::size_t>(gluings.gluing(t, f)(f));
        signs_[gluings.neighbour(t, f)][face] = here;
        all = all && here != ProvedSign::kUnknown;
      }
    }
    return all;
  }

 private:
  ProvedSign sign(std::size_t t, int f, const std::vector<Arb>& lengths,
                  const detail::ExactMetric* exact) {
    const topology::Gluings& gluings = metric_.triangulation().gluings();
    const Tilt& a = tilt(t, f, lengths);
    const Tilt& b = tilt(gluings.neighbour(t, f), gluings.gluing(t, f)(f), lengths);
    const Arb geodesic = a.geodesic + b.geodesic, cusp = a.cusp + b.cusp;
    const bool zero = arb_is_zero(geodesic.get()) != 0 || is_flat_in_the_limit(metric_, t, f) ||
                      (exact != nullptr && exact->geodesic_sum_is_zero(t, f));
    if (!zero) return sign_of(geodesic);
    if (exact != nullptr && exact->cusp_sum_is_zero(t, f)) return ProvedSign::kZero;
    return sign_of(cusp);
  }

  const Tilt& tilt(std::size_t t, int f, const std::vector<Arb>& lengths) {
    if (!tilts_[t])
      tilts_[t] =
          tilts_of(detail::lengths_of(metric_.triangulation(), lengths, t), metric_.diagonal(t));
    return (*tilts_[t])[static_cast<std::size_t>(f)];
  }

  const detail::ConeMetric& metric_;
  Signs& signs_;
  std::vector<std::optional<Tilts>> tilts_;
};

/// Lengths to so many digits, enclosed; nothing if they are not proved.
std::optional<std::vector<Arb>> precise_lengths(const Triangulation& triangulation,
                                                const Proof& proof, int many,
                                                const Context& context) {
  const Digits digits = prove_digits(triangulation, proof, many, context);
  if (!digits.proved) return std::nullopt;
  std::vector<Arb> lengths;
  for (std::size_t e = 0; e < digits.lengths.size(); ++e)
    lengths.push_back(
        detail::from_decimal(digits.lengths[e]).widened_by(detail::from_decimal(digits.radii[e])));
  return lengths;
}

ExactField text_of(const detail::ConeMetric& metric, const detail::ExactMetric& exact) {
  ExactField text;
  text.polynomial = exact.field().polynomial();
  const Arb& root = exact.field().root();
  text.root = {detail::decimal_below(root, kManyDigits), detail::decimal_above(root, kManyDigits)};
  for (const detail::Algebraic& entry : exact.gram()) text.gram.push_back(entry.text());
  for (std::size_t t = 0; t < metric.triangulation().tetrahedron_count(); ++t) {
    auto [factor, of] = exact.root(t);
    text.roots.push_back({factor.text(), std::move(of)});
  }
  if (!metric.pins().empty())
    for (const detail::Algebraic& factor : exact.horospheres())
      text.horospheres.push_back(factor.text());
  return text;
}

}  // namespace

TiltSigns tilt_signs(const Triangulation& triangulation, const Proof& proof,
                     const TiltOptions& options, const Context& context) {
  TiltSigns result;
  result.sign.resize(triangulation.tetrahedron_count());
  if (!proof.proved || proof.claim != Proof::Claim::kMetric) return result;
  const detail::ConeMetric metric(triangulation, proof.cone_angles);
  Settler settler(metric, result.sign);
  {
    const detail::Precision precision(kFewBits);
    std::vector<Arb> lengths;
    for (std::size_t e = 0; e < proof.lengths.size(); ++e)
      lengths.push_back(Arb(proof.lengths[e]).widened(proof.radii[e]));
    detail::equalise_horospheres(metric, lengths);
    if (settler.settle(lengths, nullptr, context)) return result;
  }
  const detail::Precision precision(kManyBits);
  auto fifty = precise_lengths(triangulation, proof, kManyDigits, context);
  if (!fifty) return result;
  detail::equalise_horospheres(metric, *fifty);
  if (settler.settle(*fifty, nullptr, context) || !options.exact) return result;
  int tried = 0;
  for (const Rung& rung : kRungs) {
    const int degree = std::min(rung.degree, options.most_degree);
    if (degree <= tried || context.stop_requested() || context.expired()) break;
    const detail::Precision more(static_cast<long>(rung.digits * kBitsOfDigit));
    const auto lengths = precise_lengths(triangulation, proof, rung.digits, context);
    if (!lengths) break;
    const auto exact = detail::ExactMetric::find(metric, *lengths, degree);
    tried = degree;
    if (!exact) continue;
    result.field = text_of(metric, *exact);
    settler.settle(*fifty, &*exact, context);
    break;
  }
  return result;
}

}  // namespace tripus::structure
