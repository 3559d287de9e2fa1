#include <algorithm>
#include <utility>

#include "structure/detail/existence_routes.hpp"
#include "structure/detail/rational_system.hpp"

namespace tripus::structure::detail {
namespace {

using topology::Triangulation;

/// The basis as two square systems: the angles - m and m from the equations of the rows that hold
/// with equality, and the multipliers from those of the columns not at 0.
class BasisSystems {
 public:
  BasisSystems(const Triangulation& triangulation, const AngleConstraints& constraints,
               const AngleProgramme::Basis& basis)
      : triangulation_(triangulation),
        constraints_(constraints),
        basis_(basis),
        edge_count_(triangulation.edge_count()),
        corner_count_(6 * triangulation.tetrahedron_count()),
        row_place_(edge_count_ + 4 * triangulation.tetrahedron_count(), kAbsent),
        column_place_(corner_count_ + 1, kAbsent) {
    for (std::size_t i = 0; i < basis.rows.size(); ++i) row_place_[basis.rows[i]] = i;
    for (std::size_t i = 0; i < basis.columns.size(); ++i) column_place_[basis.columns[i]] = i;
  }

  /// [6 T + 1] angles - m, then m.
  std::optional<std::vector<Rational>> primal() const {
    RationalSystem system = empty_system();
    for_each_coefficient([&](std::size_t row, std::size_t column, long a) {
      system.rows[row].emplace_back(column, a);
    });
    for (std::size_t i = 0; i < basis_.rows.size(); ++i)
      system.right_side[i] =
          basis_.rows[i] < edge_count_ ? constraints_.exact_sum[basis_.rows[i]] : Rational(1);
    return spread(solve(system), basis_.columns, column_place_.size());
  }

  /// [E + 4 T] multipliers of the rows.
  std::optional<std::vector<Rational>> dual() const {
    RationalSystem system = empty_system();
    for_each_coefficient([&](std::size_t row, std::size_t column, long a) {
      system.rows[column].emplace_back(row, a);
    });
    if (column_place_[corner_count_] == kAbsent) return std::nullopt;
    system.right_side[column_place_[corner_count_]] = 1;
    return spread(solve(system), basis_.rows, row_place_.size());
  }

 private:
  static constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);

  RationalSystem empty_system() const {
    const std::size_t size = basis_.rows.size();
    return {std::vector<std::vector<std::pair<std::size_t, long>>>(size),
            std::vector<Rational>(size)};
  }

  /// Calls visit(row place, column place, coefficient) for the entries of the square matrix.
  template <class Visit>
  void for_each_coefficient(const Visit& visit) const {
    const auto visit_if_there = [&](std::size_t row, std::size_t column, long a) {
      if (row_place_[row] != kAbsent && column_place_[column] != kAbsent)
        visit(row_place_[row], column_place_[column], a);
    };
    for (std::size_t e = 0; e < edge_count_; ++e)
      visit_if_there(e, corner_count_, static_cast<long>(triangulation_.valence(e)));
    for (std::size_t t = 0; t < triangulation_.tetrahedron_count(); ++t) {
      for (std::size_t v = 0; v < 4; ++v)
        visit_if_there(edge_count_ + 4 * t + v, corner_count_, margin_coefficient(4 * t + v));
      for (std::size_t e = 0; e < 6; ++e) {
        const std::size_t column = 6 * t + e;
        visit_if_there(triangulation_.edge_class(t, static_cast<int>(e)), column, 1);
        for (const int v : topology::kEdgeEnds[e])
          visit_if_there(edge_count_ + 4 * t + static_cast<std::size_t>(v), column, 1);
      }
    }
  }

  long margin_coefficient(std::size_t vertex) const {
    return constraints_.corners[vertex] + (constraints_.ideal[vertex] ? 0 : 1);
  }

  /// The values at their places among `size`, 0 elsewhere.
  static std::optional<std::vector<Rational>> spread(
      const std::optional<std::vector<Rational>>& values, const std::vector<std::size_t>& places,
      std::size_t size) {
    if (!values) return std::nullopt;
    std::vector<Rational> all(size);
    for (std::size_t i = 0; i < places.size(); ++i) all[places[i]] = (*values)[i];
    return all;
  }

  const Triangulation& triangulation_;
  const AngleConstraints& constraints_;
  const AngleProgramme::Basis& basis_;
  std::size_t edge_count_;
  std::size_t corner_count_;
  std::vector<std::size_t> row_place_;
  std::vector<std::size_t> column_place_;
};

Integer common_denominator(const std::vector<Rational>& values) {
  Integer denominator = 1;
  for (const Rational& value : values) denominator = lcm(denominator, denominator_of(value));
  return denominator;
}

StrictAngles exact_angles(const Triangulation& triangulation, const AngleConstraints& constraints,
                          const std::vector<Rational>& primal) {
  StrictAngles angles;
  angles.denominator = common_denominator(primal);
  angles.numerator.resize(primal.size() / 6);
  const Rational scaled_margin = primal.back() * angles.denominator;
  for (std::size_t c = 0; c + 1 < primal.size(); ++c) {
    if (constraints.parabolic[triangulation.edge_class(c / 6, static_cast<int>(c % 6))]) continue;
    const Rational angle = primal[c] * angles.denominator + scaled_margin;
    angles.numerator[c / 6][c % 6] = numerator_of(angle);
  }
  return angles;
}

/// The vertex multipliers [T x 4] as integers; nothing if one is negative that must not be.
std::optional<std::vector<std::array<Integer, 4>>> exact_multipliers(
    const std::vector<Rational>& dual, const AngleConstraints& constraints) {
  const std::size_t edge_count = constraints.edge_sum.size();
  const std::vector<Rational> w(dual.begin() + static_cast<std::ptrdiff_t>(edge_count), dual.end());
  for (std::size_t v = 0; v < w.size(); ++v)
    if (w[v] < 0 && !constraints.ideal[v]) return std::nullopt;
  const Integer denominator = common_denominator(w);
  std::vector<std::array<Integer, 4>> integers(w.size() / 4);
  for (std::size_t v = 0; v < w.size(); ++v)
    integers[v / 4][v % 4] = numerator_of(Rational(w[v] * denominator));
  return integers;
}

}  // namespace

std::optional<Existence> by_exact_basis(const Triangulation& triangulation,
                                        const AngleProgramme& programme) {
  const AngleConstraints& constraints = programme.constraints();
  const AngleProgramme::Basis basis = programme.basis();
  if (basis.rows.size() != basis.columns.size()) return std::nullopt;
  const BasisSystems systems(triangulation, constraints, basis);
  const auto primal = systems.primal();
  if (!primal) return std::nullopt;
  const StrictAngles angles = exact_angles(triangulation, constraints, *primal);
  if (primal->back() > 0) return angles;
  const auto dual = systems.dual();
  if (!dual) return std::nullopt;
  auto w = exact_multipliers(*dual, constraints);
  if (!w) return std::nullopt;
  auto certificate = certificate_from(triangulation, constraints, *std::move(w));
  if (!certificate) return std::nullopt;
  if (certificate->kind == Certificate::Kind::kSemi &&
      !is_angle_structure(triangulation, constraints, angles))
    return std::nullopt;
  return *std::move(certificate);
}

}  // namespace tripus::structure::detail
