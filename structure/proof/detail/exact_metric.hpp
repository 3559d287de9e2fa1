#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/edge_frames.hpp"
#include "structure/proof/detail/cone_metric.hpp"
#include "structure/proof/detail/number_field.hpp"
#include "structure/proof/detail/precise_tetrahedron.hpp"

namespace tripus::structure::detail {

/// What the Gram matrix of a tetrahedron gives by sums and products alone, for numbers that are
/// known exactly: theory (7), (9) and (77), each as a polynomial in a_ij = -G_ij.
template <class N>
struct ExactGram {
  std::array<N, 6> cofactor;  ///< c_kl at edge ij: its sign is that of the cosine there
  std::array<N, 4> minor;     ///< p_l = -c_ll
  N minus_det;                ///< D = -det G

  ExactGram(const std::array<N, 6>& a, const Diagonal& diagonal) {
    const auto at = [&](int i, int j) -> const N& {
      return a[static_cast<std::size_t>(geometry::kEdgeBetween[i][j])];
    };
    const auto d = [&](int i) { return N(diagonal[static_cast<std::size_t>(i)]); };
    for (int e = 0; e < 6; ++e) {
      const auto [i, j, k, l] = geometry::kEdgeFrames[e];
      cofactor[static_cast<std::size_t>(e)] =
          at(i, j) * (at(i, k) * at(j, l) + at(i, l) * at(j, k)) + d(j) * at(i, k) * at(i, l) +
          d(i) * at(j, k) * at(j, l) - at(k, l) * (at(i, j) * at(i, j) - d(i) * d(j));
    }
    for (int v = 0; v < 4; ++v) {
      const int i = v == 0 ? 1 : 0, j = v <= 1 ? 2 : 1, k = v <= 2 ? 3 : 2;
      minor[static_cast<std::size_t>(v)] = N(2) * at(i, j) * at(i, k) * at(j, k) +
                                           d(i) * at(j, k) * at(j, k) + d(j) * at(i, k) * at(i, k) +
                                           d(k) * (at(i, j) * at(i, j) - d(i) * d(j));
    }
    // Row 0 of G by its cofactors: det G = d_0 (-p_0) + sum_j (-a_0j) c_0j.
    minus_det = d(0) * minor[0];
    for (int j = 1; j < 4; ++j) minus_det = minus_det + at(0, j) * opposite(0, j);
  }

  /// c_ij.
  const N& opposite(int i, int j) const {
    return cofactor[static_cast<std::size_t>(5 - geometry::kEdgeBetween[i][j])];
  }
};

/// The metric in a number field: its Gram entries were guessed from many digits, and then all
/// equations of the metric were shown in exact arithmetic. Horospheres are those whose entries at
/// the pins are 1. Source: docs/theory.md 9.7.
class ExactMetric {
 public:
  /// Nothing where no field of at most this degree is found, or the equations are not shown.
  ///   lengths  [E]  enclosures of those of a proved metric, to nearly the thread's precision
  static std::optional<ExactMetric> find(const ConeMetric& metric, const std::vector<Arb>& lengths,
                                         int most_degree);

  const NumberField& field() const { return field_; }
  const std::vector<Algebraic>& gram() const { return gram_; }  ///< [E] a = -G_ij
  /// sqrt D of a tetrahedron: a factor, and the tetrahedra whose sqrt D it is multiplied by.
  std::pair<Algebraic, std::vector<std::size_t>> root(std::size_t t) const;
  /// [V] what the null vector of a cusp is divided by, so that all areas are that of the first; 1
  /// elsewhere. Empty where it is not known.
  const std::vector<Algebraic>& horospheres() const { return horosphere_; }

  /// Whether the terms of the tilts across face f of tetrahedron t that come from hyperideal
  /// vertices, or those that come from ideal ones, add up to exactly 0: docs/canonical.md (T7).
  bool geodesic_sum_is_zero(std::size_t t, int f) const { return sum_is_zero(t, f, 1); }
  bool cusp_sum_is_zero(std::size_t t, int f) const { return sum_is_zero(t, f, 0); }

 private:
  /// factor * the product of the roots of D that `roots` names, by its bits.
  struct Root {
    Algebraic factor;
    std::uint32_t roots = 0;
  };
  /// A sum of such, one factor for each set of roots.
  using Sum = std::vector<Algebraic>;

  ExactMetric(const ConeMetric& metric, NumberField field)
      : metric_(&metric), field_(std::move(field)) {}

  bool guess_entries(const std::vector<Arb>& entries);
  bool fill_tetrahedra();
  bool add_root(std::size_t t);
  bool all_true() const;
  bool angles_close(std::size_t e) const;
  bool find_horospheres();
  bool sum_is_zero(std::size_t t, int f, int kind) const;
  Algebraic numerator(std::size_t t, int f, int kind) const;

  Sum one() const;
  Sum scaled(const Sum& a, const Algebraic& factor) const;
  Sum times_root(const Sum& a, const Root& root) const;
  Sum sum(const Sum& a, const Sum& b) const;
  Sum product(const Sum& a, const Sum& b) const;

  const ConeMetric* metric_;
  NumberField field_;
  std::vector<Algebraic> gram_;              // [E]
  std::vector<ExactGram<Algebraic>> exact_;  // [T]
  std::vector<ExactGram<Arb>> near_;         // [T] the same, enclosed
  std::vector<Algebraic> radicand_;          // D of the roots that the others are multiples of
  std::vector<std::size_t> first_;           // the first tetrahedra that have them
  std::vector<Root> root_;                   // [T] sqrt D
  /// [V] sqrt(A_0 / A_v), A_v the area of the horosphere: what makes all areas one. Empty where it
  /// is not known.
  std::vector<Algebraic> horosphere_;
};

}  // namespace tripus::structure::detail
