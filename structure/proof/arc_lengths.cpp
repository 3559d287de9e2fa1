// The pole of the first plane is carried along by its products with the four vertices of each
// tetrahedron: across a face, the vertex beyond is a combination of the four before it.
#include "structure/proof/arc_lengths.hpp"

#include <array>

#include "base/error.hpp"
#include "structure/proof/detail/arb_number.hpp"
#include "structure/proof/detail/cone_metric.hpp"
#include "structure/proof/digits.hpp"

namespace tripus::structure {
namespace {

using detail::Arb;
using topology::Triangulation;

constexpr int kManyDigits = 50;
constexpr long kManyBits = 256;

using Row4 = std::array<Arb, 4>;
using Gram = std::array<Row4, 4>;

Gram gram_of(const detail::ConeMetric& metric, const std::vector<Arb>& lengths, std::size_t t) {
  const detail::Diagonal diagonal = metric.diagonal(t);
  const detail::GramEntries entries =
      detail::gram_entries(detail::lengths_of(metric.triangulation(), lengths, t), diagonal);
  Gram gram;
  for (std::size_t i = 0; i < 4; ++i) gram[i][i] = Arb(diagonal[i]);
  for (std::size_t e = 0; e < 6; ++e) {
    const auto i = static_cast<std::size_t>(topology::kEdgeEnds[e][0]);
    const auto j = static_cast<std::size_t>(topology::kEdgeEnds[e][1]);
    gram[i][j] = gram[j][i] = -entries.c[e];
  }
  return gram;
}

std::array<std::size_t, 3> without(std::size_t i) {
  std::array<std::size_t, 3> rest{};
  for (std::size_t k = 0, n = 0; k < 4; ++k)
    if (k != i) rest[n++] = k;
  return rest;
}

/// The cofactor of row i and column j.
Arb cofactor(const Gram& g, std::size_t i, std::size_t j) {
  const auto r = without(i), c = without(j);
  const Arb minor =
      g[r[0]][c[0]] * (g[r[1]][c[1]] * g[r[2]][c[2]] - g[r[1]][c[2]] * g[r[2]][c[1]]) -
      g[r[0]][c[1]] * (g[r[1]][c[0]] * g[r[2]][c[2]] - g[r[1]][c[2]] * g[r[2]][c[0]]) +
      g[r[0]][c[2]] * (g[r[1]][c[0]] * g[r[2]][c[1]] - g[r[1]][c[1]] * g[r[2]][c[0]]);
  return (i + j) % 2 == 0 ? minor : -minor;
}

Arb determinant(const Gram& g) {
  Arb sum;
  for (std::size_t j = 0; j < 4; ++j) sum = sum + g[0][j] * cofactor(g, 0, j);
  return sum;
}

class Carrier {
 public:
  Carrier(const Triangulation& triangulation, const Proof& proof, std::vector<Arb> lengths)
      : triangulation_(triangulation),
        metric_(triangulation, proof.cone_angles),
        lengths_(std::move(lengths)),
        steps_(4 * triangulation.tetrahedron_count()) {}

  std::optional<Interval> length_of(const ArcPath& path) {
    std::size_t t = path.tetrahedron;
    if (t >= triangulation_.tetrahedron_count()) refuse();
    require_label(path.start);
    require_label(path.end);
    Row4 products = gram_of(metric_, lengths_, t)[static_cast<std::size_t>(path.start)];
    for (const std::uint8_t face : path.faces) {
      require_label(face);
      const auto f = static_cast<std::size_t>(face);
      const Row4& step = step_across(t, f);
      const topology::Perm4 p = triangulation_.gluings().gluing(t, face);
      Row4 next;
      Arb apex;
      for (std::size_t i = 0; i < 4; ++i) {
        apex = apex + step[i] * products[i];
        if (i != f) next[static_cast<std::size_t>(p(static_cast<int>(i)))] = products[i];
      }
      next[static_cast<std::size_t>(p(face))] = std::move(apex);
      products = std::move(next);
      t = triangulation_.gluings().neighbour(t, face);
    }
    const Arb cosh = -products[static_cast<std::size_t>(path.end)];
    if (!(cosh - Arb(1.0)).positive()) return std::nullopt;
    Arb length;
    arb_acosh(length.get(), cosh.get(), detail::Precision::bits());
    if (!length.finite()) return std::nullopt;
    return Interval{length.lower(), length.upper()};
  }

 private:
  [[noreturn]] static void refuse() {
    throw InvalidInput("the way of an arc leads to a tetrahedron or a face that there is not");
  }
  static void require_label(int label) {
    if (label < 0 || label > 3) refuse();
  }

  /// The vertex beyond face f as a combination of the four of tetrahedron t: in the plane of the
  /// face it has the products that its own tetrahedron says, and its height over that plane is
  /// that of the vertex opposite to the face there.
  const Row4& step_across(std::size_t t, std::size_t f) {
    std::optional<Row4>& step = steps_[4 * t + f];
    if (step) return *step;
    const int face = static_cast<int>(f);
    const topology::Perm4 p = triangulation_.gluings().gluing(t, face);
    const Gram here = gram_of(metric_, lengths_, t);
    const Gram there = gram_of(metric_, lengths_, triangulation_.gluings().neighbour(t, face));
    const auto apex = static_cast<std::size_t>(p(face));
    // Where column f of `here` holds the products instead, Cramer's rule for the three others.
    const Arb minor = cofactor(here, f, f);
    step.emplace();
    for (const std::size_t i : without(f)) {
      Gram swapped = here;
      for (const std::size_t r : without(f))
        swapped[r][i] = there[apex][static_cast<std::size_t>(p(static_cast<int>(r)))];
      (*step)[i] = cofactor(swapped, f, f) / minor;
    }
    // <w', n> = 1 / sqrt(N'_ff) and n = - sum_i N_fi w_i / sqrt(N_ff), N = G^-1.
    const Arb det = determinant(here), height = minor / det;
    const Arb height_there = cofactor(there, apex, apex) / determinant(there);
    const Arb scale = -(Arb(1.0) / square_root(height * height_there));
    for (std::size_t i = 0; i < 4; ++i)
      (*step)[i] = (*step)[i] + scale * (cofactor(here, f, i) / det);
    return *step;
  }

  const Triangulation& triangulation_;
  detail::ConeMetric metric_;
  std::vector<Arb> lengths_;                // [E]
  std::vector<std::optional<Row4>> steps_;  // [T x 4]
};

/// With more digits where that is possible.
std::vector<Arb> proved_lengths(const Triangulation& triangulation, const Proof& proof,
                                const Context& context) {
  std::vector<Arb> lengths;
  if (triangulation.edge_count() <= kMostEdgesForDigits) {
    const Digits digits = prove_digits(triangulation, proof, kManyDigits, context);
    for (std::size_t e = 0; digits.proved && e < digits.lengths.size(); ++e)
      lengths.push_back(detail::from_decimal(digits.lengths[e])
                            .widened_by(detail::from_decimal(digits.radii[e])));
  }
  if (!lengths.empty()) return lengths;
  for (std::size_t e = 0; e < proof.lengths.size(); ++e)
    lengths.push_back(Arb(proof.lengths[e]).widened(proof.radii[e]));
  return lengths;
}

}  // namespace

std::vector<std::optional<Interval>> prove_arc_lengths(const Triangulation& triangulation,
                                                       const Proof& proof,
                                                       std::span<const ArcPath> paths,
                                                       const Context& context) {
  std::vector<std::optional<Interval>> result(paths.size());
  if (!proof.proved || proof.claim != Proof::Claim::kMetric) return result;
  const detail::Precision precision(kManyBits);
  Carrier carrier(triangulation, proof, proved_lengths(triangulation, proof, context));
  for (std::size_t n = 0; n < paths.size(); ++n) {
    if (context.stop_requested() || context.expired()) break;
    result[n] = carrier.length_of(paths[n]);
  }
  return result;
}

}  // namespace tripus::structure
