#include "structure/proof/detail/precise_tetrahedron.hpp"

#include <algorithm>

#include <Eigen/Dense>

namespace tripus::structure::detail {
namespace {

using geometry::packed_index;

geometry::GramEnclosure<Arb> gram_of(const std::array<Arb, 6>& l, const Diagonal& diagonal) {
  const GramEntries g = gram_entries(l, diagonal);
  return geometry::gram_enclosure(g.c, g.s, gram_diagonal(diagonal));
}

/// Whether the tetrahedron is a true one.
bool is_true(const geometry::GramEnclosure<Arb>& gram, const Diagonal& diagonal) {
  if (!gram.minus_det.positive()) return false;
  return std::ranges::find(diagonal, -1) == diagonal.end() ||
         std::ranges::all_of(gram.minor, [](const Arb& minor) { return minor.positive(); });
}

}  // namespace

geometry::GramDiagonal gram_diagonal(const Diagonal& diagonal) {
  geometry::GramDiagonal result;
  std::ranges::copy(diagonal, result.d);
  return result;
}

std::array<Arb, 6> lengths_of(const topology::Triangulation& triangulation,
                              const std::vector<Arb>& lengths, std::size_t t) {
  std::array<Arb, 6> l;
  for (std::size_t e = 0; e < 6; ++e)
    l[e] = lengths[triangulation.edge_class(t, static_cast<int>(e))];
  return l;
}

GramEntries gram_entries(const std::array<Arb, 6>& l, const Diagonal& diagonal) {
  GramEntries entries;
  auto& [c, s] = entries;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto& [i, j] = topology::kEdgeEnds[e];
    const int a = diagonal[static_cast<std::size_t>(i)], b = diagonal[static_cast<std::size_t>(j)];
    if (a * b == 1) {
      arb_sinh_cosh(s[e].get(), c[e].get(), l[e].get(), Precision::bits());
    } else if (a * b == -1) {
      arb_sinh_cosh(c[e].get(), s[e].get(), l[e].get(), Precision::bits());
    } else {
      arb_exp(c[e].get(), l[e].get(), Precision::bits());
      if (a == 0 && b == 0) arb_mul_2exp_si(c[e].get(), c[e].get(), 1);
      s[e] = c[e];
    }
  }
  return entries;
}

std::optional<PreciseTetrahedron> precise_tetrahedron(const std::array<Arb, 6>& l, bool with_volume,
                                                      const Diagonal& diagonal) {
  const auto gram = gram_of(l, diagonal);
  if (!is_true(gram, diagonal)) return std::nullopt;
  const Arb root = square_root(gram.minus_det);
  Arb theta[6];
  geometry::angle_enclosures(gram, root, theta);
  PreciseTetrahedron result;
  if (with_volume) result.volume = geometry::volume_enclosure(gram, root, theta);
  std::move(theta, theta + 6, result.angles.begin());
  return result;
}

std::optional<std::array<Arb, 21>> precise_jacobian(const std::array<Arb, 6>& l,
                                                    const Diagonal& diagonal) {
  const auto gram = gram_of(l, diagonal);
  if (!is_true(gram, diagonal)) return std::nullopt;
  std::array<Arb, 21> jacobian;
  geometry::jacobian_enclosure(gram, square_root(gram.minus_det), jacobian.data(),
                               gram_diagonal(diagonal));
  return jacobian;
}

std::optional<std::array<double, 6>> precise_weights(const std::array<Arb, 6>& l) {
  for (const Arb& length : l)
    if (!length.positive()) return std::nullopt;
  const auto jacobian = precise_jacobian(l);
  if (!jacobian) return std::nullopt;
  // S J S - lambda I > 0 with any S and lambda; these make lambda nearly as large as can be.
  std::array<double, 6> S;
  std::array<Arb, 21> scaled;
  Eigen::Matrix<double, 6, 6> middle;
  for (int i = 0; i < 6; ++i) {
    const double entry = (*jacobian)[static_cast<std::size_t>(packed_index(i, i))].mid();
    if (!(entry > 0) || !std::isfinite(entry)) return std::nullopt;
    S[static_cast<std::size_t>(i)] = 1 / std::sqrt(entry);
  }
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j) {
      const auto at = static_cast<std::size_t>(packed_index(i, j));
      scaled[at] =
          S[static_cast<std::size_t>(i)] * (S[static_cast<std::size_t>(j)] * (*jacobian)[at]);
      middle(i, j) = middle(j, i) = scaled[at].mid();
    }
  if (!middle.allFinite()) return std::nullopt;
  const double least =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(middle, Eigen::EigenvaluesOnly)
          .eigenvalues()
          .minCoeff();
  const double lambda = 0.9 * least;
  if (!(lambda > 0)) return std::nullopt;
  const double pivot =
      geometry::smallest_pivot(scaled.data(), Arb(lambda), [](const Arb& x) { return x.lower(); });
  if (!(pivot > 0)) return std::nullopt;
  std::array<double, 6> weights;
  for (std::size_t i = 0; i < 6; ++i) weights[i] = (Arb(lambda) / (Arb(S[i]) * Arb(S[i]))).lower();
  return weights;
}

std::optional<geometry::TetrahedronKind> proved_flat(const std::array<Arb, 6>& l,
                                                     const Diagonal& diagonal) {
  using geometry::TetrahedronKind;
  constexpr std::array kKinds = {TetrahedronKind::kFlat01_23, TetrahedronKind::kFlat02_13,
                                 TetrahedronKind::kFlat03_12};
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [i, j] = topology::kEdgeEnds[e];
    const bool between_planes = diagonal[static_cast<std::size_t>(i)] == 1 &&
                                diagonal[static_cast<std::size_t>(j)] == 1;
    if (between_planes && !l[e].positive()) return std::nullopt;
  }
  const auto gram = gram_of(l, diagonal);
  if (!gram.minus_det.negative()) return std::nullopt;
  // |cos| > 1 at every edge, and it is negative at one pair only.
  for (std::size_t e = 0; e < 3; ++e)
    if (gram.cofactor[e].negative()) return kKinds[e];
  return std::nullopt;
}

}  // namespace tripus::structure::detail
